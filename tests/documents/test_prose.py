"""Free text: what is understood, what is refused, and that every format prints the characters of the text."""

from __future__ import annotations

import re
import time

import pytest
from hypothesis import example, given, settings
from markdown_it import MarkdownIt
from page_formats import page_format
from places import ROOT
from prose_sample import SAMPLE, TEXTS, Parts, parsed, shown

from kurbel.documents.markdown import parse_prose
from kurbel.documents.prose import (
    Blocks,
    Break,
    Code,
    CodeBlock,
    Emphasis,
    Grid,
    Heading,
    Indexed,
    Inlines,
    Link,
    Listing,
    Paragraph,
    Quote,
    Refer,
    Rule,
    Strong,
    Text,
)
from kurbel.errors import ChoiceError, ProseError
from kurbel.formats.printer import set_prose
from kurbel.formats.registry import FORMATS
from kurbel.page.formula import parse_formula

PAGES = [name for name, form in FORMATS.items() if form.kind == "page"]


def line(text: str) -> Inlines:
    (paragraph,) = parse_prose(text)
    assert isinstance(paragraph, Paragraph)
    return paragraph.content


def printed(text: str, form: str, level: int = 1) -> str:
    return set_prose(parse_prose(text), page_format(form), ",", Parts(form), level)


def words(text: str) -> Blocks:
    return (Paragraph((Text(text),)),)


@pytest.mark.parametrize(
    ("text", "content"),
    [
        (
            "a *b* **c** `d`",
            (Text("a "), Emphasis((Text("b"),)), Text(" "), Strong((Text("c"),)), Text(" "), Code("d")),
        ),
        ("a\\\nb", (Text("a"), Break(), Text("b"))),
        ("a\n b", (Text("a b"),)),
        (r"5 \$ and \*", (Text("5 $ and *"),)),
        ("<b>x</b> &lt;", (Text("<b>x</b> <"),)),
        ("~~x~~", (Text("~~x~~"),)),
        ("2°30' and 0°0'20\"", (Text("2°30′ and 0°0′20″"),)),
        ("`2°30'`", (Code("2°30'"),)),
        ("$x/R$", (parse_formula("x/R"),)),
        ("*$a_1$ b_2*", (Emphasis((parse_formula("a_1"), Text(" b_2"))),)),
        ("$a_1 + b_1$", (parse_formula("a_1 + b_1"),)),
        ("$[a](b)$", (parse_formula("[a](b)"),)),
        ("`$`", (Code("$"),)),
        ("[a $[x]$](#n)", (Refer("n", (Text("a "), parse_formula("[x]"))),)),
        ("[a](index:)", (Indexed("a", (Text("a"),)),)),
        (f"[*a*](<index:{'b' * 80}>)", (Indexed("b" * 80, (Emphasis((Text("a"),)),)),)),
        ("[](#delta)", (Refer("delta", ()),)),
        ("[a](#größe)", (Refer("größe", (Text("a"),)),)),
        ("[a][b]\n\n[b]: HTTPS://c.de/$", (Link("HTTPS://c.de/$", (Text("a"),)),)),
        ("<mailto:a@b.de>", (Link("mailto:a@b.de", (Text("mailto:a@b.de"),)),)),
    ],
)
def test_inlines_of_a_line(text: str, content: Inlines) -> None:
    assert line(text) == content


def test_blocks_of_a_text() -> None:
    a, b = words("a"), words("b")
    assert parse_prose("## a\n\na\n=\n") == (Heading(2, (Text("a"),)), Heading(1, (Text("a"),)))
    assert parse_prose("- a\n- b") == (Listing(None, True, (a, b)),)
    assert parse_prose("3) a\n\n4) b") == (Listing(3, False, (a, b)),)
    assert parse_prose("- a\n  - a\n\n    b") == (
        Listing(None, True, ((*a, Listing(None, False, ((*a, *b),))),)),
    )
    assert parse_prose("> a\n\n---") == (Quote(a), Rule())
    assert parse_prose("```py\na\n\n\tb \n```\n\n    c") == (
        CodeBlock(("a", "", "    b ")),
        CodeBlock(("c",)),
    )
    assert parse_prose("|a|b|\n|:-:|-|\n|`\\|`|") == (
        Grid(("center", None), ((Text("a"),), (Text("b"),)), (((Code("|"),), ()),)),
    )
    assert parse_prose("") == ()


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
        (
            "[x](javascript:a)",
            'line 1: the link to "javascript:a" cannot be set; it must begin with http:, https: or mailto:,'
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
    with pytest.raises(ProseError) as caught:
        parse_prose(text)
    assert str(caught.value) == sentence
    assert f"line {caught.value.line}: " in sentence


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
    assert parse_prose(most)
    with pytest.raises(ProseError):
        parse_prose(beyond)


def test_unknown_name_raises_what_the_caller_raises() -> None:
    with pytest.raises(ChoiceError, match="no part has the name nothing"):
        printed("[](#nothing)", "html")


@pytest.mark.parametrize(
    "piece", [">", "- ", "[", "![", "*a_ ", "**a *b ", "`a", "<", "[](<\n", "a\n", "|a\n|-\n", "$"]
)
def test_pathological_text_is_set_or_refused_quickly(piece: str) -> None:
    start = time.process_time()
    parsed((piece * 50_000)[:50_000])
    with pytest.raises(ProseError):
        parse_prose(piece * 5_000_000)
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
    assert printed("# a", form, 2) == f"{heading}\n"
    assert printed("[](#delta)", form) == f"{reference}\n"
    assert printed("[b](#delta)", form) == f"{named}\n"


@pytest.mark.parametrize("form", PAGES)
def test_numbers_in_formulas_have_the_decimal_mark(form: str) -> None:
    assert "4.5" not in printed("$x = 4.5$", form)


_PLAIN = MarkdownIt("commonmark", {"html": False}).enable("table")
_PLAIN.validateLink = lambda url: True  # type: ignore[method-assign]


# A link without words shows its address: one that shows nothing, nobody finds.
_WORDLESS = re.compile(r'(<a href="([^"]*)"[^>]*>)(?=</a>)')


def source(text: str) -> str:
    """Return the page that a library makes of a text."""
    return _WORDLESS.sub(r"\1\2", _PLAIN.render(text))


def test_a_link_without_words_shows_its_address() -> None:
    for text in ("[](http://b.de/c)", "[0]: http://b.de/c\n\n[][0]"):
        assert printed(text, "html") == '<p><a href="http://b.de/c">http://b.de/c</a></p>\n'
        assert printed(text, "markdown") == "[http://b.de/c](<http://b.de/c>)\n"
        assert printed(text, "text") == "http://b.de/c\n"


@example("[0]:HTTP:\n\n[][0]")
@given(TEXTS)
def test_html_shows_the_characters_of_the_text(text: str) -> None:
    if blocks := parsed(text.replace("$", "")):
        page = set_prose(blocks, page_format("html"), ",", Parts("html"))
        expected = shown(source(text.replace("$", "")))
        assert re.sub("[′']", "'", shown(page)).replace("″", '"') == expected


@example("[0]:HTTP:\n\n[][0]")
@given(TEXTS)
def test_plain_text_has_the_characters_of_the_text(text: str) -> None:
    if blocks := parsed(text.replace("$", "")):
        page = iter(
            set_prose(blocks, page_format("text"), ",", Parts("text")).replace("′", "'").replace("″", '"')
        )
        assert all(character in page for character in shown(source(text.replace("$", ""))))


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
    if blocks := parsed(text):
        page = set_prose(blocks, page_format("markdown"), ",", Parts("markdown"), 0)
        assert rendered(_RENDERER.render(page)) == rendered(source(text))


def test_line_that_ends_before_its_first_word_is_one_in_latex() -> None:
    assert printed("*\\\na*", "latex") == "\\leavevmode\\emph{\\newline\na}\n"


def test_formulas_in_markdown_are_plain_text_that_stays_so() -> None:
    page = printed("- $[a_1]$ *$x$*", "markdown")
    assert rendered(_RENDERER.render(page)) == "<ul><li>[a₁] <em>x</em></li></ul>"


def test_sample_keeps_its_blocks_through_markdown() -> None:
    blocks = parse_prose(SAMPLE)
    assert {type(block) for block in blocks} == {Heading, Paragraph, Listing, Quote, Rule, Grid, CodeBlock}
    again = parse_prose(set_prose(blocks, page_format("markdown"), ",", Parts("html"), 0))
    assert [type(block) for block in again] == [type(block) for block in blocks]


def test_every_example_of_the_documentation_is_understood() -> None:
    page = (ROOT / "docs" / "howto" / "prose.md").read_text(encoding="utf-8")
    examples = re.findall(r"```markdown\n(.*?)```", page, re.DOTALL)
    assert len(examples) == 3
    assert all(printed(example, form) for example in examples for form in PAGES)
    with pytest.raises(ProseError) as caught:
        parse_prose("a\n\nb\nc $x")
    assert f"```text\n{caught.value}\n```" in page
