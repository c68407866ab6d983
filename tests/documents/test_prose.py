"""Free text: what is understood, what is refused, and that every format prints the characters of the text."""

from __future__ import annotations

import re
import time

import pytest
from hypothesis import example, given, settings
from markdown_it import MarkdownIt
from places import ROOT
from prose_sample import SAMPLE, TEXTS, parsed, set_in, shown

import kurbel
from kurbel.formats.registry import FORMATS

PAGES = [name for name, form in FORMATS.items() if form.kind == "page"]


@pytest.mark.parametrize(
    ("text", "page"),
    [
        ("a *b* **c** `d`", "a <em>b</em> <strong>c</strong> <code>d</code>"),
        ("a\\\nb", "a<br>\nb"),
        ("a\n b", "a b"),
        (r"5 \$ and \*", "5 $ and *"),
        ("<b>x</b> &lt;", "&lt;b&gt;x&lt;/b&gt; &lt;"),
        ("~~x~~", "~~x~~"),
        ("2°30' and 0°0'20\"", "2°30′ and 0°0′20″"),
        ("`2°30'`", "<code>2°30'</code>"),
        ("`$`", "<code>$</code>"),
        ("[a](index:)", "a"),
        (f"[*a*](<index:{'b' * 80}>)", "<em>a</em>"),
        ("[](#delta)", '<a href="#tab-delta">Tabelle 3</a>'),
        ("[a](#start)", '<a href="#ch-start">a</a>'),
        ("[a][b]\n\n[b]: HTTPS://c.de/$", '<a href="HTTPS://c.de/$">a</a>'),
        ("<mailto:a@b.de>", '<a href="mailto:a@b.de">mailto:a@b.de</a>'),
    ],
)
def test_inlines_of_a_line(text: str, page: str) -> None:
    assert set_in("html", text) == f"<p>{page}</p>\n"


@pytest.mark.parametrize(
    ("text", "page"),
    [
        ("$x/R$", "x/R"),
        ("*$a_1$ b_2*", "a₁ b_2"),
        ("$a_1 + b_1$", "a₁ + b₁"),
        ("$[a](b)$", "[a](b)"),
        ("[a $[x]$](#delta)", "a [x] (Tabelle 3)"),
        ("## a\n\na\n=\n", "a\n─\n\na\n━"),
        ("- a\n- b", " • a\n • b"),
        ("3) a\n\n4) b", " 3. a\n\n 4. b"),
        ("> a\n\n---", "  │ a\n\n" + "─" * 78),
        ("```py\na\n\n\tb \n```\n\n    c", "    a\n\n        b \n\n    c"),
        ("|a|b|\n|:-:|-|\n|`\\|`|", " a   b\n---  ---\n |"),
        ("", ""),
    ],
)
def test_blocks_of_a_text(text: str, page: str) -> None:
    assert set_in("text", text) == (page and f"{page}\n")


INDEXED = "words for the index are [words](index:) or, with another term, [words](<index:the term>)"


@pytest.mark.parametrize(
    ("text", "sentence"),
    [
        ("a\n\nb\n![x](y.png)", "line 4: a text can hold no images; a figure has its own place"),
        ("> a\n> b $x", r"line 2: a formula needs a second $; a dollar sign in prose is written \$"),
        (
            "a\n*b $x_$*",
            'line 2: the formula "x_" cannot be set: a number, a letter or parentheses are missing',
        ),
        ("$a * b$", "line 1: the formula \"a * b\" cannot be set: '*' has no meaning in a formula"),
        (
            "|a|\n|-|\n|b|\n|[x](file:///etc)|",
            'line 4: the link to "file:///etc" cannot be set; it must begin with http:, https: or mailto:,'
            " or be # and the name of a table, figure or chapter",
        ),
        ("[](<index:b>)", f"line 1: {INDEXED}"),
        ("a\n[*a*](index:)", f"line 2: {INDEXED}"),
        (
            f"[a](<index:{'b' * 81}>)",
            "line 1: a term of the index may have 80 characters, all of them printed",
        ),
        ("[a](index:b%00c)", "line 1: a term of the index may have 80 characters, all of them printed"),
        ("a\n\n#", r"line 3: a heading has no words; a # in prose is written \#"),
        ("a\nb\x07", "line 2: the character U+0007 is a control and not printed"),
        ("a\n\n> > > > > b", "line 3: lists and quotations are nested more than 4 deep"),
        ("x" * 200_001, "line 1: the text has 200001 characters; 200000 are allowed"),
    ],
)
def test_what_cannot_be_set_is_a_sentence_with_its_line(text: str, sentence: str) -> None:
    with pytest.raises(kurbel.KurbelError) as caught:
        set_in("html", text)
    assert str(caught.value) == sentence


@pytest.mark.parametrize(
    ("most", "beyond"),
    [
        ("x" * 200_000, "x" * 200_001),
        ("> " * 4 + "b", "> " * 5 + "b"),
        ("- " * 4 + "b", "- " * 5 + "b"),
        ("*a " * 10 + "b" + "*" * 10, "*a " * 11 + "b" + "*" * 11),
    ],
    ids=["length", "quotations", "lists", "emphasis"],
)
def test_as_much_as_any_page_has_is_set_and_no_more(most: str, beyond: str) -> None:
    assert set_in("html", most)
    with pytest.raises(kurbel.KurbelError):
        set_in("html", beyond)


def test_unknown_name_raises_what_the_caller_raises() -> None:
    with pytest.raises(kurbel.KurbelError, match="no part has the name nothing"):
        set_in("html", "[](#nothing)")


@pytest.mark.parametrize("piece", ["> ", "- ", "![", "*a_ ", "[](<\n", "|a\n|-\n"])
def test_pathological_text_is_set_or_refused_quickly(piece: str) -> None:
    start = time.process_time()
    parsed((piece * 20_000)[:20_000])
    with pytest.raises(kurbel.KurbelError):
        set_in("html", piece * 5_000_000)
    assert time.process_time() - start < 10


@pytest.mark.parametrize(
    ("form", "heading", "reference", "named"),
    [
        ("text", "a\n─", "Tabelle 3", "b (Tabelle 3)"),
        ("markdown", "### a", "[Tabelle 3](<02-x.md#tab-delta>)", "[b](<02-x.md#tab-delta>)"),
        (
            "html",
            "<h3>a</h3>",
            '<p><a href="#tab-delta">Tabelle 3</a></p>',
            '<p><a href="#tab-delta">b</a></p>',
        ),
        (
            "latex",
            r"\subsection{a}",
            r"\hyperref[tab:delta]{\tablename~\ref*{tab:delta}}",
            r"\hyperref[tab:delta]{b}",
        ),
        ("rst", "a\n~", ":ref:`Tabelle 3 <tab-delta>`", ":ref:`b <tab-delta>`"),
        ("typst", "#heading(level: 3)[a];", "#ref(<tab-delta>);", "#link(<tab-delta>)[b];"),
    ],
)
def test_headings_stand_below_the_chapter_and_references_lead_to_their_part(
    form: str, heading: str, reference: str, named: str
) -> None:
    assert set_in(form, "# a", 2) == f"{heading}\n"
    assert set_in(form, "[](#delta)") == f"{reference}\n"
    assert set_in(form, "[b](#delta)") == f"{named}\n"


@pytest.mark.parametrize("form", PAGES)
def test_numbers_in_formulas_have_the_decimal_mark(form: str) -> None:
    assert "4.5" not in set_in(form, "$x = 4.5$")


_PLAIN = MarkdownIt("commonmark", {"html": False}).enable("table")
_PLAIN.validateLink = lambda url: True  # type: ignore[method-assign]


# A link without words shows its address: one that shows nothing, nobody finds.
_WORDLESS = re.compile(r'(<a href="([^"]*)"[^>]*>)(?=</a>)')


def source(text: str) -> str:
    """Return the page that a library makes of a text."""
    return _WORDLESS.sub(r"\1\2", _PLAIN.render(text))


def test_a_link_without_words_shows_its_address() -> None:
    for text in ("[](http://b.de/c)", "[0]: http://b.de/c\n\n[][0]"):
        assert set_in("html", text) == '<p><a href="http://b.de/c">http://b.de/c</a></p>\n'
        assert set_in("markdown", text) == "[http://b.de/c](<http://b.de/c>)\n"
        assert set_in("text", text) == "http://b.de/c\n"


@example("[0]:HTTP:\n\n[][0]")
@given(TEXTS)
def test_pages_show_the_characters_of_the_text(text: str) -> None:
    text = text.replace("$", "")
    if parsed(text):
        expected = shown(source(text))
        assert re.sub("[′']", "'", shown(set_in("html", text))).replace("″", '"') == expected
        page = iter(set_in("text", text).replace("′", "'").replace("″", '"'))
        assert all(character in page for character in expected)


_RENDERER = MarkdownIt("commonmark").enable("table")
_SPACE = re.compile(
    r"\s*(</?(?:p|li|ul|ol|h\d|blockquote|pre|hr|table|thead|tbody|tr|t[hd])\b[^>]*>|<br />|</code></pre>)\s*"
)


def rendered(page: str) -> str:
    """Return a page that readers of Markdown show, white space apart."""
    page = re.sub(r' class="language[^"]*"|<!-- -->| title="[^"]*"', "", page)
    page = page.replace("<br>", "<br />").replace("′", "'").replace("″", "&quot;")
    page = re.sub(r"(<(?:p|li|h\d)>)(?:\s*<br />)+|(?:<br />\s*)+(?=</)", r"\1", page)
    return _SPACE.sub(r"\1", " ".join(page.split())).replace("<p></p>", "")


@example("[0]:HTTP:\n\n[][0]")
@example("a \\| b\\\n\\:-")
@example("a\\\n\\===")
@example("a\\\n\\---")
@example("a\\\n\\1. b")
@example("\\# a\n\n# a \\#\n\n\\1) b")
@example("- - +\n\n* * *\n\n- a\n\n+ b")
@example("- > # a\n  [x]: y\n  > b")
@example("a*b*c *&#32;d* ***e*** **f *g* h**, *i*_j_")
@example("``` a`b ```\n\n|`a\\|b`|\\||\n|-|-|")
@settings(max_examples=300)
@given(TEXTS)
def test_markdown_is_shown_as_its_source(text: str) -> None:
    text = text.replace("$", "").replace("\t", " ")
    if parsed(text):
        assert rendered(_RENDERER.render(set_in("markdown", text, 0))) == rendered(source(text))


def test_line_that_ends_before_its_first_word_is_one_in_latex() -> None:
    assert set_in("latex", "*\\\na*") == "\\leavevmode\\emph{\\newline\na}\n"


def test_formulas_in_markdown_are_plain_text_that_stays_so() -> None:
    page = set_in("markdown", "- $[a_1]$ *$x$*")
    assert rendered(_RENDERER.render(page)) == "<ul><li>[a₁] <em>x</em></li></ul>"


def test_sample_keeps_its_blocks_through_markdown() -> None:
    blocks = r"<(h\d|p|ul|ol|li|blockquote|hr|table|pre)\b"
    found = re.findall(blocks, set_in("html", SAMPLE))
    assert {*found} >= {"h2", "p", "ul", "ol", "blockquote", "hr", "table", "pre"}
    again = re.sub(r"<02-x.md#[a-z]+-(\w+)>", r"#\1", set_in("markdown", SAMPLE, 0))
    assert re.findall(blocks, set_in("html", again)) == found


def test_every_example_of_the_documentation_is_understood() -> None:
    page = (ROOT / "docs" / "howto" / "prose.md").read_text(encoding="utf-8")
    examples = re.findall(r"```markdown\n(.*?)```", page, re.DOTALL)
    assert len(examples) == 3
    assert all(set_in(form, example) for example in examples for form in PAGES)
    with pytest.raises(kurbel.KurbelError) as caught:
        set_in("html", "a\n\nb\nc $x")
    assert f"```text\n{caught.value}\n```" in page
