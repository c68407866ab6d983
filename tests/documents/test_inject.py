"""Marked places are found where a reader of the document would see them, and nothing else is touched."""

from __future__ import annotations

import re
import subprocess

import pytest
from cli import kurbel as run
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from markdown_it import MarkdownIt
from tools import require

import kurbel
import kurbel.documents.inject as marks
from kurbel.formats.registry import kinds

content, filled, places = marks.content, marks.filled, marks.places

KINDS = [kind for _, kind in kinds()]
MARKDOWN, HTML, LATEX, TYPST = KINDS
OF_KIND = {
    "Markdown": ("<!-- kurbel: table -->", "<!-- /kurbel -->"),
    "HTML": ("<!-- kurbel: table -->", "<!-- /kurbel -->"),
    "LaTeX": ("% kurbel: table", "% /kurbel"),
    "Typst": ("// kurbel: table", "// /kurbel"),
}
each_kind = pytest.mark.parametrize("kind", KINDS, ids=lambda kind: kind.name)
TABLE = "| a |\n\n| b |\n"


def marked(kind: marks.Kind, *, indent: str = "", newline: str = "\n", old: str = "") -> bytes:
    opening, closing = OF_KIND[kind.name]
    return f"{indent}{opening}{newline}{old}{indent}{closing}".encode()


def refreshed(document: bytes, kind: marks.Kind, text: str = TABLE) -> bytes:
    found = places(document, kind, "notes")
    return filled(document, found, [content(text, place, kind) for place in found])


def words_of(text: str, kind: marks.Kind = MARKDOWN) -> list[tuple[int, str]]:
    return [(place.line, place.words) for place in places(text.encode(), kind, "notes")]


# Bytes that could be taken for something: code, items, line ends, half markers, other encodings.
PIECES = st.sampled_from(
    [b"\n", b"\r\n", b"\r", b" ", b"\t", b"- ", b"1. ", b"> ", b"```", b"~~~~", b"`", b"<!--", b"-->", b"%",
     b"\\", b"//", b"/*", b"*/", b"\\begin{verbatim}", b"\\end{verbatim}", b"\\verb|", b"\x00", b"\xff",
     b"\xef\xbb\xbf", b"word", "Maß".encode(), b"\x0c", b"\x85"]
)  # fmt: skip
AROUND = st.lists(st.one_of(PIECES, st.binary(max_size=3)), max_size=12).map(b"".join)


@each_kind
@given(before=AROUND, after=AROUND, old=AROUND, newline=st.sampled_from(["\n", "\r\n", "\r"]))
@settings(max_examples=80, deadline=None)
def test_bytes_around_a_place_never_change(
    kind: marks.Kind, before: bytes, after: bytes, old: bytes, newline: str
) -> None:
    opening, closing = (marker.encode() for marker in OF_KIND[kind.name])
    end = newline.encode()
    # A line feed behind a carriage return makes one line end of the two.
    assume(not (newline == "\r" and old.startswith(b"\n")))
    document = before + end + opening + end + old + end + closing + end + after
    try:
        found = places(document, kind, "notes")
    except kurbel.KurbelError:
        # The opening marker is in code that ends before the closing one.
        assert not places(before + end + opening + end + closing, kind, "notes")
        return
    new = refreshed(document, kind)
    if found:
        table = content(TABLE, found[0], kind)
        assert new == before + end + opening + end + table + closing + end + after
        assert refreshed(new, kind) == new
    else:
        # Some of what comes before makes code of the markers.
        assert new == document


@each_kind
@given(document=st.lists(st.one_of(PIECES, st.binary(max_size=4)), max_size=20).map(b"".join))
@settings(max_examples=100, deadline=None)
def test_a_document_without_markers_stays_as_it_is(kind: marks.Kind, document: bytes) -> None:
    assert refreshed(document, kind) == document


@each_kind
@pytest.mark.parametrize("newline", ["\n", "\r\n", "\r"])
@pytest.mark.parametrize("indent", ["", "  ", "\t"])
def test_a_place_takes_the_indentation_and_the_line_ends_of_its_marker(
    kind: marks.Kind, newline: str, indent: str
) -> None:
    # A tab or more makes code of Markdown but in an item of a list.
    before = f"1.  item{newline}{newline}" if kind.name == "Markdown" and indent == "\t" else ""
    document = before.encode() + marked(kind, indent=indent, newline=newline, old="old\n")
    blank = newline if kind.apart else ""
    table = f"{blank}{indent}| a |{newline}{newline}{indent}| b |{newline}{blank}"
    expected = before.encode() + marked(kind, indent=indent, newline=newline, old=table)
    assert refreshed(document, kind) == expected


@each_kind
def test_the_mark_of_byte_order_and_a_missing_last_line_end_are_kept(kind: marks.Kind) -> None:
    new = refreshed(b"\xef\xbb\xbf" + marked(kind), kind)
    assert new.startswith(b"\xef\xbb\xbf" + OF_KIND[kind.name][0].encode())
    assert new.endswith(OF_KIND[kind.name][1].encode())
    assert b"| a |" in new


@each_kind
def test_every_place_of_a_document_is_found_in_its_order(kind: marks.Kind) -> None:
    one = marked(kind) + b"\n"
    assert [place.line for place in places(one + b"text\n" + one + one, kind, "notes")] == [1, 4, 6]


def test_the_words_are_those_between_the_colon_and_the_end_of_the_comment() -> None:
    assert words_of("<!--kurbel:table  --ratio '1:5'-->\n<!--/kurbel-->\n") == [(1, "table  --ratio '1:5'")]
    assert words_of("<!--\tkurbel:\ttable\t-->\t\n <!--  /kurbel  --> \n") == [(1, "table")]
    assert words_of("%kurbel:table\n%/kurbel\n", LATEX) == [(1, "table")]
    assert words_of("//kurbel:table\n//\t/kurbel\n", TYPST) == [(1, "table")]


# Where a marker is only shown.


FENCES = [
    "```\n{}```\n",
    "~~~ text\n{}~~~~~\n",
    "````md\n```\n{}```\n````\n",
    "   ```\n{}   ```\n",
    "- item\n\n  ```\n  {}  ```\n",
    "1. - item\n     ~~~\n     {}     ~~~\n",
    "> ```\n> {}> ```\n",
    "```\n> quoted\n{}```\n",
    "text\n\n    {}\ntext\n",
    "- item\n\n      {}\n",
    "Write `{}`\n",
    "Write ``` {} ``` or ` `` ` so\n",
]


@pytest.mark.parametrize("shape", FENCES)
def test_markers_in_code_of_markdown_are_shown_only(shape: str) -> None:
    marker = "<!-- kurbel: table -->"
    text = shape.format(marker if "Write" in shape else f"{marker}\n")
    whole = f"{text}\n\n{marker}\n<!-- /kurbel -->\n"
    assert words_of(whole) == [(whole.count("\n") - 1, "table")]


PROSE = [
    "```\ncode\n```\n",
    "````\n```\n````\n",
    "- item\n\n  ```\n  code\n\nbehind the item\n\n",
    "> ```\n> code\n\n",
    "``` not a fence ` of code\n",
    "`` ` ``\n",
    "Text with ``` in it\n",
    "- \n- * * *\n\ntext\n",
    "    code\n\ntext\n",
]


@pytest.mark.parametrize("before", PROSE)
def test_markers_behind_code_of_markdown_are_markers(before: str) -> None:
    text = f"{before}<!-- kurbel: table -->\n"
    assert words_of(f"{text}<!-- /kurbel -->\n") == [(text.count("\n"), "table")]


LINES = st.sampled_from(
    ["", "", "text", "- item", "  text", "    text", "1. one", "   text", "```", "  ```", "    ```", "~~~",
     "> quote", "> ```", "      deep", "* a", "\ttab", "# head", "    - c", "`````"]
)  # fmt: skip


@given(lines=st.lists(LINES, max_size=8), indent=st.integers(0, 8))
@settings(max_examples=250, deadline=None)
def test_a_marker_is_code_where_a_library_of_commonmark_says_so(lines: list[str], indent: int) -> None:
    marker = " " * indent + "<!-- kurbel: table -->"
    text = "".join(f"{line}\n" for line in lines)
    tokens = MarkdownIt().parse(f"{text}{marker}\n")
    shown = any(token.type in ("fence", "code_block") and "kurbel" in token.content for token in tokens)
    seen = any(token.type == "html_block" and "kurbel" in token.content for token in tokens)
    # In the midst of a paragraph no table can stand, whichever way its marker is taken.
    assume(shown or seen)
    assert bool(words_of(f"{text}{marker}\n{marker.replace('kurbel: table', '/kurbel')}\n")) == seen


@pytest.mark.parametrize("name", ["verbatim", "verbatim*", "Verbatim", "lstlisting", "minted", "comment"])
def test_markers_in_verbatim_latex_are_shown_only(name: str) -> None:
    text = f"\\begin{{{name}}}[opt]\n% kurbel: table\n\\end{{{name}}}\n% kurbel: table\n% /kurbel\n"
    assert words_of(text, LATEX) == [(4, "table")]


@pytest.mark.parametrize(
    "line",
    ["% \\begin{verbatim}", "\\verb|\\begin{verbatim}|", "\\begin{verbatim}x\\end{verbatim}",
     "50\\% kurbel: no", "\\verb!% kurbel: table! is one", "%% kurbel: table",
     "% note % kurbel: table", "% kurbel is a program",
     "\\lstinline|% /kurbel|"],
)  # fmt: skip
def test_what_looks_like_a_marker_or_code_of_latex_is_neither(line: str) -> None:
    assert words_of(f"{line}\n% kurbel: table\n% /kurbel\n", LATEX) == [(2, "table")]


@pytest.mark.parametrize(
    "lines",
    ["```\n// kurbel: table\n```", "````typ\n```\n// kurbel: table\n```\n````", "/*\n// kurbel: table\n*/",
     "/* /* */\n// kurbel: table\n*/", "`// kurbel: table`", "https:// kurbel: no", "/// kurbel: table",
     "// ``` /*", "`` `a` ``", "see https://typst.app /* a */ b"],
)  # fmt: skip
def test_what_looks_like_a_marker_or_code_of_typst_is_neither(lines: str) -> None:
    text = f"{lines}\n// kurbel: table\n// /kurbel\n"
    assert words_of(text, TYPST) == [(text.count("\n") - 1, "table")]


def test_what_stands_in_a_place_is_no_code() -> None:
    text = "<!-- kurbel: table -->\n```\n<!-- /kurbel -->\n<!-- kurbel: delta -->\n<!-- /kurbel -->\n"
    assert words_of(text) == [(1, "table"), (4, "delta")]


# The difference.


@given(
    olds=st.lists(st.lists(st.sampled_from("abcdef"), max_size=12), min_size=1, max_size=4),
    around=st.lists(st.sampled_from(["c\n", "d\n", "Maß\n"]), max_size=8).map("".join),
    ended=st.booleans(),
)
@settings(max_examples=20, deadline=None)
def test_the_difference_is_what_patch_takes(
    tmp_path_factory: pytest.TempPathFactory, olds: list[list[str]], around: str, ended: bool
) -> None:
    folder = tmp_path_factory.mktemp("patch")
    path = folder / "notes.html"
    opening, closing = OF_KIND["HTML"]
    opening = opening.replace("table", "table --angle 60 --columns x")
    parts = (f"{opening}\n" + "".join(f"{one}\n" for one in old) + closing for old in olds)
    labels = iter(range(9))
    text = re.sub("columns x", lambda _: f"columns x --label a{next(labels)}", f"\n{around}".join(parts))
    path.write_text(f"a\nb\n{text}" + ("\n" if ended else ""), encoding="utf-8")
    (folder / "patched").write_bytes(path.read_bytes())
    checked = run("inject", "--check", str(path))
    assert checked.code == 1
    words = [require("patch"), "--fuzz=0", str(folder / "patched")]
    done = subprocess.run(words, input=checked.out.encode(), capture_output=True)
    assert (done.returncode, b"offset" in done.stdout) == (0, False), done.stdout
    assert run("inject", str(path)).code == 0
    assert path.read_bytes() == (folder / "patched").read_bytes()
