"""The notation of labels: what is printed for it in each format, and what it refuses."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st
from page_formats import page_format

from kurbel.errors import LayoutError
from kurbel.formats.registry import FORMATS, PageFormat
from kurbel.page.formula import Formula
from kurbel.page.labels import Mark, Prose, formula_plain, mark_text, parse, plain


def formula(source: str) -> Formula:
    (part,) = parse(f"${source}$")
    assert isinstance(part, Formula)
    return part


@pytest.mark.parametrize(
    ("source", "text"),
    [
        ("x/R", "x/R"),
        ("cos φ ± 1/4.5 cos 2φ", "cos φ ± 1/4,5 cos 2φ"),
        ("(sin(φ±ψ))/(cos ψ)", "sin(φ±ψ)/cos ψ"),
        ("(a + b)/(c d)", "(a + b)/(c d)"),
        ("sin (a b)/c", "sin (a b)/c"),
        ("(cos φ)/2", "(cos φ)/2"),
        ("1/(cos ψ)", "1/cos ψ"),
        ("(cos φ)/(cos ψ) x", "(cos φ)/(cos ψ) x"),
        ("(a/b)/c", "(a/b)/c"),
        ("x_m - x_(max)", "xₘ − xₘₐₓ"),
        ("x_R + φ^2", "x_R + φ²"),
        ("λ^(n+1)", "λⁿ⁺¹"),
        ("2.5^(1.5)", "2,5^(1,5)"),
        ("∓Δx = ∞ %", "∓Δx = ∞ %"),
        ("R [1 - cos α]", "R [1 − cos α]"),
        ('v = 2.5 "m/s"', "v = 2,5 m/s"),
        ("0°0'20\"", "0°0′20″"),
        ("F sqrt((R/L)^2 + 1)", "F √((R/L)² + 1)"),
        ("(sqrt(2.5))/2 cos φ", "√(2,5)/2 cos φ"),
        ("sqrt(x)^2", "√(x)²"),
        ("overline(f' d')^2 - a d", "f′d′² − a d"),
        ("(-5 ± 3 sqrt(33))/4", "(−5 ± 3 √33)/4"),
        ("sqrt(33)^2", "√(33)²"),
    ],
)
def test_formula_in_one_line_of_text(source: str, text: str) -> None:
    assert formula_plain(formula(source), ",") == text


@pytest.mark.parametrize(
    ("source", "latex"),
    [
        ("x/R", "x/R"),
        ("x/(2 R)", "x/(2R)"),
        ("-x/R", r"-\frac{x}{R}"),
        ("a x/R", r"a\frac{x}{R}"),
        ("R:L = 1:4.5", "R{:}L=1{:}4{,}5"),
        ("cos φ ± 1/4.5 cos 2φ", r"\cos\varphi\pm\frac{1}{4{,}5}\cos2\varphi"),
        ("(sin(φ±ψ))/(cos ψ)", r"\frac{\sin(\varphi\pm\psi)}{\cos\psi}"),
        ("sin φ a", r"\sin\varphi a"),
        ("x_m + x_(max)^2", r"x_{m}+x_{\max}^{2}"),
        ("ε λ ω α", r"\varepsilon\lambda\omega\alpha"),
        ("x^2° %", r"x^{2}{}^{\circ}\%"),
        ('2 "mm" 3', r"2\,\text{mm}\,3"),
        ("1 2", r"1\,2"),
        ("[1 + R/L sin φ]", r"\left[1+\frac{R}{L}\sin\varphi\right]"),
        ("a · b × c ≤ ∞", r"a\cdot b\times c\le\infty"),
        ("F sqrt((R/L)^2 + 1) a", r"F\sqrt{(R/L)^{2}+1}a"),
        ("a/sqrt(2.5)", r"a/\sqrt{2{,}5}"),
        ("overline(a d')", r"\overline{ad{}^{\prime}}"),
        ("[sqrt(1 + a/b)]", r"\left[\sqrt{1+\frac{a}{b}}\right]"),
    ],
)
def test_formula_in_latex(source: str, latex: str) -> None:
    assert page_format("latex").writer.formula(formula(source), ",") == f"${latex}$"


def test_only_a_formula_with_a_bar_needs_height_of_its_own() -> None:
    assert "displaystyle" not in page_format("latex").writer.formula(formula("x/R"), display=True)
    assert "displaystyle" not in page_format("html").writer.formula(formula("x/R"), display=True)
    assert (
        page_format("latex")
        .writer.formula(formula("1/4 cos φ"), display=True)
        .startswith(r"$\displaystyle \frac")
    )
    assert (
        page_format("html")
        .writer.formula(formula("R (1/4 cos φ)"), display=True)
        .startswith('<math displaystyle="true">')
    )


@pytest.mark.parametrize(
    ("source", "mathml"),
    [
        ("2φ", "<mn>2</mn><mi>φ</mi>"),
        ("Δx", '<mi mathvariant="normal">Δ</mi><mi>x</mi>'),
        (
            "sin(φ)",
            '<mi class="name">sin</mi><mo>&#x2061;</mo>'
            '<mrow><mo stretchy="false">(</mo><mi>φ</mi><mo stretchy="false">)</mo></mrow>',
        ),
        (
            "(a/b)/(c + d) e",
            '<mfrac><mrow><mi>a</mi><mo lspace="0" rspace="0">/</mo><mi>b</mi></mrow>'
            "<mrow><mi>c</mi><mo>+</mo><mi>d</mi></mrow></mfrac><mi>e</mi>",
        ),
        ("1/4.5 a", "<mfrac><mn>1</mn><mn>4,5</mn></mfrac><mi>a</mi>"),
        ("c_m^2", "<msubsup><mi>c</mi><mi>m</mi><mn>2</mn></msubsup>"),
        ("a < b", "<mi>a</mi><mo>&lt;</mo><mi>b</mi>"),
        ('"<b>"', "<mtext>&lt;b&gt;</mtext>"),
        ("sqrt(1 + a)", "<msqrt><mn>1</mn><mo>+</mo><mi>a</mi></msqrt>"),
        (
            "overline(a d)",
            '<mover accent="true"><mrow><mi>a</mi><mi>d</mi></mrow><mo stretchy="true">&#x203E;</mo></mover>',
        ),
        ("sqrt(a)^2", "<msup><msqrt><mi>a</mi></msqrt><mn>2</mn></msup>"),
    ],
)
def test_formula_in_mathml(source: str, mathml: str) -> None:
    assert page_format("html").writer.formula(formula(source), ",") == f"<math>{mathml}</math>"


def test_label_falls_into_prose_formulas_and_marks() -> None:
    assert parse(r"5 \$ a[^b] $x$") == (Prose("5 $ a"), Mark("b"), Prose(" "), formula("x"))


def test_white_space_is_one_space_and_no_break_spaces_stay() -> None:
    assert plain("a\n\t b\u00a0c\u2028d") == "a b\u00a0c d"


def test_angle_in_prose_has_primes() -> None:
    assert plain("2°30'") == "2°30′"
    assert plain("0°0'20\" or 'so'") == "0°0′20″ or 'so'"


@pytest.mark.parametrize(
    ("label", "reason"),
    [
        ("Kolbenweg $x/R", r"a formula needs a second $; a dollar sign in prose is written \$"),
        ("$$", "a formula or a pair of parentheses is empty"),
        ("$sn φ$", "sn is no function; letters of a product stand apart, words in double quotes"),
        ("$a/$", "a number, a letter or parentheses are missing"),
        ("$/a$", "before / stands a number, a letter or parentheses"),
        ("$a/b/c$", "a second / needs parentheses, (a/b)/c or a/(b c)"),
        ("$1/cos ψ$", "a function after / needs parentheses, 1/(cos ψ)"),
        ("$sqrt 2$", "a root needs parentheses, sqrt(2)"),
        ("$overline a$", "a bar above needs parentheses, overline(a d)"),
        ("$(a$", "an opening ( has no partner"),
        ("$(a]$", "an opening ( has no partner"),
        ("$a)$", "a closing ) has no partner"),
        ("$x_m_n$", "a second _ needs parentheses"),
        ('$2 ""$', "double quotes are empty"),
        ("$a & b$", "'&' has no meaning in a formula"),
        (f"${'(' * 21}a{')' * 21}$", "parentheses are nested more than 20 deep"),
    ],
)
def test_malformed_formula_is_a_sentence_that_names_the_label(label: str, reason: str) -> None:
    with pytest.raises(LayoutError) as caught:
        parse(label)
    assert str(caught.value) == f'the label "{label}" cannot be set: {reason}'


_PIECES = st.sampled_from(["$", "\\", *"()[]/_^ -±:°'", "sin", "cos", "x", "φ", "2", "4.5", '"', "[^a]"])


@given(st.one_of(st.text(), st.lists(_PIECES).map(lambda pieces: f"${''.join(pieces)}$")))
def test_any_label_is_set_in_every_notation_or_refused(label: str) -> None:
    try:
        parts = parse(label)
    except LayoutError:
        return
    writers = [entry.writer for entry in FORMATS.values() if isinstance(entry, PageFormat)]
    for part in parts:
        if isinstance(part, Formula):
            assert all(writer.formula(part, ",", True) for writer in writers)
    assert "\n" not in plain(label)


@given(st.text(alphabet="-,'<>|` a"))
def test_latex_prose_has_no_ligatures(prose: str) -> None:
    escaped = page_format("latex").writer.escape(prose)
    assert not any(pair in escaped for pair in ("--", ",,", "''", "<<", ">>", "`"))
    # In OT1, the encoding where nothing is said, these are ¡, ¿ and a dash.
    assert not set("<>|") & set(escaped)


@pytest.mark.parametrize(
    ("prose", "escaped"),
    [
        ("1. a", "1\\. a"),
        ("- a", "\\- a"),
        ("# a", "\\# a"),
        ("-5", "-5"),
        ("2.5", "2.5"),
        ("&amp;", "\\&amp;"),
    ],
)
def test_markdown_prose_starts_no_list(prose: str, escaped: str) -> None:
    assert page_format("markdown").writer.escape(prose) == escaped


def test_marks_are_raised_where_unicode_can() -> None:
    assert mark_text("a") == "ᵃ⁾"
    assert mark_text("12") == "¹²⁾"
    assert mark_text("*") == "*)"
    assert page_format("markdown").writer.note_mark("*") == "\\*)"
    assert page_format("latex").writer.note_mark("a") == r"\textsuperscript{a)}"
    assert page_format("typst").writer.note_mark("a") == "#super[a)];"
    assert page_format("html").writer.note_mark("a", "t-1") == '<sup><a href="#t-1">a)</a></sup>'
