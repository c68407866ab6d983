"""The notation for labels: prose with formulas between dollar signs and note marks such as [^a].

    Kolbenweg $x/R$          a formula in prose; $1:4.5$ takes the decimal mark of the page
    $(sin(φ±ψ))/(cos ψ)$     a fraction; the parentheses around its two parts are dropped
    $x_m$ $x_(max)$ $φ^2$    index and power
    $v = 2.5 "m/s"$          upright text in double quotes
    5 \\$                     a dollar sign in prose

Spaces inside a formula are kept where text needs them ("cos φ ± ψ") and left to the engine elsewhere.
A new output notation is one more `formula_...` function at the end of this file.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from functools import lru_cache
from itertools import groupby

from kurbel.errors import LayoutError

FENCES = {"(": ")", "[": "]"}
FUNCTIONS = frozenset(("sin", "cos", "tan", "cot", "arcsin", "arccos", "arctan", "max", "min", "ln", "log"))

# Sign in the source -> sign in print, LaTeX.
SIGNS = {
    "+": ("+", "+"),
    "-": ("−", "-"),
    "−": ("−", "-"),
    "±": ("±", r"\pm"),
    "∓": ("∓", r"\mp"),
    "·": ("·", r"\cdot"),
    "×": ("×", r"\times"),
    # A ratio is one term: 1:5 with the spaces of a relation would fall apart beside R:L =.
    ":": (":", "{:}"),
    "=": ("=", "="),
    "<": ("<", "<"),
    ">": (">", ">"),
    "≤": ("≤", r"\le"),
    "≥": ("≥", r"\ge"),
    "≈": ("≈", r"\approx"),
}
# The empty group lets a degree sign follow a power: x^{2}^{\circ} is an error in LaTeX.
SYMBOLS = {
    "∞": ("∞", r"\infty"),
    "%": ("%", r"\%"),
    "°": ("°", r"{}^{\circ}"),
    "'": ("′", r"{}^{\prime}"),
    "′": ("′", r"{}^{\prime}"),
    '"': ("″", r"{}^{\prime\prime}"),
    "″": ("″", r"{}^{\prime\prime}"),
    "…": ("…", r"\dots"),
}
_GREEK_SMALL = "α alpha β beta γ gamma δ delta ε varepsilon ζ zeta η eta ϑ vartheta θ theta ι iota κ kappa λ lambda"
_GREEK_REST = "μ mu ν nu ξ xi π pi ρ varrho σ sigma τ tau υ upsilon φ varphi χ chi ψ psi ω omega"
_GREEK_CAPITALS = "Γ Gamma Δ Delta Θ Theta Λ Lambda Ξ Xi Π Pi Σ Sigma Φ Phi Ψ Psi Ω Omega"


def _greek(*tables: str) -> dict[str, str]:
    words = " ".join(tables).split()
    return {letter: f"\\{name}" for letter, name in zip(words[::2], words[1::2], strict=True)}


GREEK = _greek(_GREEK_SMALL, _GREEK_REST, _GREEK_CAPITALS)
CAPITALS = frozenset(_greek(_GREEK_CAPITALS))


@dataclass(frozen=True, slots=True)
class Word:
    """An upright function name."""

    text: str


@dataclass(frozen=True, slots=True)
class Variable:
    text: str


@dataclass(frozen=True, slots=True)
class Numeral:
    """A number, with a decimal point whatever the page prints."""

    text: str


@dataclass(frozen=True, slots=True)
class Sign:
    """A sign between two terms, or before one."""

    text: str


@dataclass(frozen=True, slots=True)
class Symbol:
    """A sign that stands for a value or belongs to one: ∞, %, °."""

    text: str


@dataclass(frozen=True, slots=True)
class Upright:
    """Text in double quotes: a unit or a word."""

    text: str


@dataclass(frozen=True, slots=True)
class Space:
    """White space in the source."""


@dataclass(frozen=True, slots=True)
class Group:
    """Parentheses or brackets that are printed."""

    content: Nodes
    fences: str = "()"


@dataclass(frozen=True, slots=True)
class Fraction:
    top: Nodes
    bottom: Nodes


@dataclass(frozen=True, slots=True)
class Script:
    """An atom with an index, a power or both."""

    base: Node
    index: Nodes
    power: Nodes


Node = Word | Variable | Numeral | Sign | Symbol | Upright | Space | Group | Fraction | Script
Nodes = tuple[Node, ...]


@dataclass(frozen=True, slots=True)
class Prose:
    text: str


@dataclass(frozen=True, slots=True)
class Formula:
    content: Nodes


@dataclass(frozen=True, slots=True)
class Mark:
    """A mark that points to a note."""

    text: str


Part = Prose | Formula | Mark

_PART = re.compile(r"\\(?P<dollar>\$)|\$(?P<formula>[^$]*)(?P<end>\$?)|\[\^(?P<mark>[^\]]+)\]")
# Everything that breaks or jumps within a line; the no-break and thin spaces of typography stay.
_WHITE = re.compile(r"[\t-\r\x1c-\x20\x85\u2028\u2029]+")
# Minutes and seconds of an angle typed with quotation marks.
_MINUTES = re.compile(r"(°[0-9.,]+)'(?:([0-9.,]+)\")?")
_TOKEN = re.compile(r'[0-9]+(?:\.[0-9]+)?|[A-Za-z]+|"[^"]*"|[\s]+|.', re.DOTALL)
_DEEPEST = 20


@lru_cache(maxsize=1024)
def parse(label: str) -> tuple[Part, ...]:
    """Return the parts of a label. Neighbouring pieces of prose are one part; white space is one space.

    Raises LayoutError, naming the label, if a formula is not closed or not understood.
    """
    try:
        return tuple(_joined(_parts(_WHITE.sub(" ", label))))
    except _Malformed as error:
        raise LayoutError(f'the label "{label}" cannot be set: {error}') from None


def _parts(label: str) -> Iterator[Part]:
    done = 0
    for match in _PART.finditer(label):
        yield Prose(label[done : match.start()])
        done = match.end()
        if match["dollar"]:
            yield Prose("$")
        elif match["mark"]:
            yield Mark(match["mark"])
        elif not match["end"]:
            raise _Malformed(r"a formula needs a second $; a dollar sign in prose is written \$")
        else:
            yield Formula(_Parser(match["formula"]).formula())
    yield Prose(label[done:])


def _joined(parts: Iterable[Part]) -> Iterator[Part]:
    for is_prose, run in groupby(parts, key=lambda part: isinstance(part, Prose)):
        if not is_prose:
            yield from run
        elif prose := "".join(part.text for part in run if isinstance(part, Prose)):
            yield Prose(_MINUTES.sub(_primes, prose))


def _primes(angle: re.Match[str]) -> str:
    minutes, seconds = angle.groups()
    return f"{minutes}′{seconds}″" if seconds else f"{minutes}′"


class _Malformed(Exception):
    """What is wrong with a formula; `parse` adds the label."""


class _Parser:
    """Recursive descent over the tokens of one formula."""

    def __init__(self, source: str) -> None:
        self.tokens = [" " if token.isspace() else token for token in _TOKEN.findall(source.strip())]
        self.at = 0
        self.depth = 0

    def peek(self) -> str:
        return self.tokens[self.at] if self.at < len(self.tokens) else ""

    def take(self) -> str:
        token = self.peek()
        self.at += 1
        return token

    def skip_space(self) -> None:
        if self.peek() == " ":
            self.at += 1

    def formula(self) -> Nodes:
        content = self.sequence()
        if self.peek():
            raise _Malformed(f"a closing {self.peek()} has no partner")
        return content

    def sequence(self) -> Nodes:
        """Read up to a closing parenthesis or the end."""
        nodes: list[Node] = []
        self.skip_space()
        while self.peek() not in ("", ")", "]"):
            token = self.peek()
            if token == "/":
                self.take()
                nodes.append(self.fraction(nodes))
            elif token == " ":
                self.take()
                nodes.append(Space())
            elif token in SIGNS:
                nodes.append(Sign(self.take()))
            else:
                nodes.extend(self.factor())
        while nodes and isinstance(nodes[-1], Space):
            nodes.pop()
        if not nodes:
            raise _Malformed("a formula or a pair of parentheses is empty")
        return tuple(nodes)

    def fraction(self, before: list[Node]) -> Fraction:
        """Take the numerator from the nodes read before the stroke, and read the denominator."""
        while before and isinstance(before[-1], Space):
            before.pop()
        if not before or isinstance(before[-1], Sign | Word):
            raise _Malformed("before / stands a number, a letter or parentheses")
        if isinstance(before[-1], Fraction):
            raise _Malformed("a second / needs parentheses, (a/b)/c or a/(b c)")
        top: Nodes = (before.pop(),)
        if isinstance(top[0], Group) and before and _is_function(before[-1]):
            top = (before.pop(), *top)
        self.skip_space()
        bottom = self.factor()
        if _is_function(bottom[-1]):
            raise _Malformed("a function after / needs parentheses, 1/(cos ψ)")
        return Fraction(_bare(top), _bare(bottom))

    def factor(self) -> Nodes:
        """Read an atom with its index and power; a function takes the parentheses that touch it."""
        atom = self.scripted(self.atom())
        if _is_function(atom) and self.peek() == "(":
            return atom, self.scripted(self.atom())
        return (atom,)

    def scripted(self, base: Node) -> Node:
        found: dict[str, Nodes] = {"_": (), "^": ()}
        while (kind := self.peek()) in found:
            self.take()
            if found[kind]:
                raise _Malformed(f"a second {kind} needs parentheses")
            found[kind] = _bare((self.atom(),))
        return Script(base, found["_"], found["^"]) if found["_"] or found["^"] else base

    def atom(self) -> Node:
        token = self.take()
        if token in FENCES:
            return self.group(token)
        if token[:1] in "0123456789" and token:
            return Numeral(token)
        if token in FUNCTIONS:
            return Word(token)
        if token in GREEK or (len(token) == 1 and token.isascii() and token.isalpha()):
            return Variable(token)
        if token in SYMBOLS:
            return Symbol(token)
        if token.startswith('"'):
            return Upright(token[1:-1])
        raise _Malformed(_unexpected(token))

    def group(self, opening: str) -> Group:
        self.depth += 1
        if self.depth > _DEEPEST:
            raise _Malformed(f"parentheses are nested more than {_DEEPEST} deep")
        content = self.sequence()
        if self.take() != FENCES[opening]:
            raise _Malformed(f"an opening {opening} has no partner")
        self.depth -= 1
        return Group(content, opening + FENCES[opening])


def _unexpected(token: str) -> str:
    if token in ("", ")", "]"):
        return "a number, a letter or parentheses are missing"
    if token.isalpha() and token.isascii():
        return f"{token} is no function; letters of a product stand apart, words in double quotes"
    return f"{token!r} has no meaning in a formula"


def _is_function(node: Node) -> bool:
    return isinstance(node.base if isinstance(node, Script) else node, Word)


def _bare(nodes: Nodes) -> Nodes:
    """Drop the outer parentheses, which the bar of a fraction or the place of an index replaces."""
    match nodes:
        case (Group(content, "()"),):
            return content
    return nodes


# Prose ------------------------------------------------------------------------------------------------


def escape_text(prose: str) -> str:
    return prose


_MARKDOWN = re.compile(r"[\\`*_\[\]<>|~$]|&(?=[#A-Za-z])")
# At the start of a line these make a list or a heading.
_MARKDOWN_START = re.compile(r"^( *)([-+=]|#+|[0-9]+(?=[.)]))(?=[ .)]|$)")


def escape_markdown(prose: str) -> str:
    escaped = _MARKDOWN.sub(r"\\\g<0>", prose)
    return _MARKDOWN_START.sub(_escape_start, escaped)


def _escape_start(match: re.Match[str]) -> str:
    space, start = match.groups()
    return f"{space}{start}\\" if start.isdigit() else f"{space}\\{start}"


_HTML = str.maketrans({"&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;"})


def escape_html(prose: str) -> str:
    return prose.translate(_HTML)


_LATEX = str.maketrans(
    {letter: f"${command}$" for letter, command in GREEK.items()}
    | {symbol: f"${latex}$" for symbol, (_, latex) in (SIGNS | SYMBOLS).items() if not symbol.isascii()}
    | {character: f"\\{character}" for character in "#$%&_{}"}
    | {
        "\\": r"\textbackslash{}",
        "~": r"\textasciitilde{}",
        "^": r"\textasciicircum{}",
        "`": r"\textasciigrave{}",
        # babel makes " active in German; \textquotedbl is missing in the old default encoding.
        '"': r"\char34{}",
        # After \\ a bracket or a star would be read as its argument.
        "[": "{[}",
        "]": "{]}",
        "*": "{*}",
        "°": r"\textdegree{}",
    }
)
# Two of these in a row are one sign in TeX fonts: --, ,, '' << >>.
_LIGATURE = re.compile(r"([-,'<>])(?=\1)")


def escape_latex(prose: str) -> str:
    return _LIGATURE.sub(r"\1{}", prose.translate(_LATEX))


# Formulas ---------------------------------------------------------------------------------------------


def formula_text(formula: Formula, mark: str = ".", display: bool = False) -> str:
    """Return a formula in one line of Unicode: sin(φ±ψ)/cos ψ, xₘ, φ². It has no other size."""
    return _text(formula.content, mark)


def _text(nodes: Nodes, mark: str) -> str:
    return "".join(_text_node(nodes, place, mark) for place in range(len(nodes)))


def _text_node(nodes: Nodes, place: int, mark: str) -> str:
    match nodes[place]:
        case Sign(text):
            return SIGNS[text][0]
        case Symbol(text):
            return SYMBOLS[text][0]
        case Numeral(text):
            return text.replace(".", mark)
        case Space():
            return " "
        case Group(content, fences):
            return f"{fences[0]}{_text(content, mark)}{fences[1]}"
        case Fraction(top, bottom):
            return _text_fraction(nodes, place, top, bottom, mark)
        case Script(base, index, power):
            scripts = _small(index, "_", _INDICES, mark) + _small(power, "^", _POWERS, mark)
            return _text((base,), mark) + scripts
        case Word(text) | Variable(text) | Upright(text):
            return text


def _text_fraction(nodes: Nodes, place: int, top: Nodes, bottom: Nodes, mark: str) -> str:
    """Write a fraction with a stroke, and with parentheses where the stroke alone would be misread."""
    alone_before = place == 0 or isinstance(_beside(nodes, place, -1), Sign)
    alone_after = place == len(nodes) - 1 or isinstance(_beside(nodes, place, 1), Sign)
    above, below = _text(top, mark), _text(bottom, mark)
    if _is_sum(top) or (len(top) > 1 and not alone_before):
        above = f"({above})"
    if _is_sum(bottom) or (len(bottom) > 1 and not (alone_after and _is_function(bottom[0]))):
        below = f"({below})"
    return f"{above}/{below}"


_RELATIONS = frozenset("=<>≤≥≈:")


def _has_stroke(nodes: Nodes, place: int) -> bool:
    """Tell whether an engine should set a fraction with a stroke: x/R, not a small x over a small R.

    So it does for a fraction of letters and numbers that is a whole side of its formula. One that stands
    among factors or in a sum would be misread, and one of functions is easier to read with a bar.
    """
    fraction = nodes[place]
    assert isinstance(fraction, Fraction)
    neighbours = [_beside(nodes, place, step) for step in (-1, 1) if 0 <= place + step < len(nodes)]
    if not all(isinstance(node, Sign) and node.text in _RELATIONS for node in neighbours):
        return False
    parts = fraction.top + fraction.bottom
    return not _is_sum(parts) and not any(_is_function(node) for node in parts)


def _has_bar(nodes: Nodes) -> bool:
    """Tell whether a sequence has a fraction with a bar, which needs height."""
    return any(
        _has_bar(node.content)
        if isinstance(node, Group)
        else isinstance(node, Fraction) and not _has_stroke(nodes, place)
        for place, node in enumerate(nodes)
    )


def _beside(nodes: Nodes, place: int, step: int) -> Node:
    """Return the next node that is not a space; spaces never end a sequence."""
    place += step
    return nodes[place + step] if isinstance(nodes[place], Space) else nodes[place]


def _is_sum(nodes: Nodes) -> bool:
    return any(isinstance(node, Sign | Fraction) for node in nodes)


_INDICES = dict(zip("0123456789aehijklmnoprstuvxβγρφχ", "₀₁₂₃₄₅₆₇₈₉ₐₑₕᵢⱼₖₗₘₙₒₚᵣₛₜᵤᵥₓᵦᵧᵨᵩᵪ", strict=True))
_POWERS = dict(
    zip(
        "0123456789−+)abcdefghijklmnoprstuvwxyz",
        "⁰¹²³⁴⁵⁶⁷⁸⁹⁻⁺⁾ᵃᵇᶜᵈᵉᶠᵍʰⁱʲᵏˡᵐⁿᵒᵖʳˢᵗᵘᵛʷˣʸᶻ",
        strict=True,
    )
)


def _small(nodes: Nodes, sign: str, small: dict[str, str], mark: str) -> str:
    if not nodes:
        return ""
    text = _text(nodes, mark)
    if all(character in small for character in text):
        return "".join(small[character] for character in text)
    return f"{sign}{text}" if len(text) == 1 else f"{sign}({text})"


def formula_markdown(formula: Formula, mark: str = ".", display: bool = False) -> str:
    """Return a formula as text; dollar signs are left alone, since many readers of Markdown print them."""
    return escape_markdown(formula_text(formula, mark))


_COMMAND = re.compile(r"\\[A-Za-z]+$")


def formula_latex(formula: Formula, mark: str = ".", display: bool = False) -> str:
    r"""Return a formula for LaTeX, dollar signs included: $x/R$, $\frac{1}{4{,}5}\cos\varphi$. Needs amsmath.

    `display` gives fractions their full size, and the line the height for it.
    """
    content = _latex(formula.content, mark)
    if display and _has_bar(formula.content):
        return f"$\\displaystyle {content}\\rule[-1.05em]{{0pt}}{{2.7em}}$"
    return f"${content}$"


def _latex(nodes: Nodes, mark: str) -> str:
    result = ""
    for place in range(len(nodes)):
        piece = _latex_node(nodes, place, mark)
        if piece[:1].isalpha() and _COMMAND.search(result):
            result += " "
        result += piece
    return result


def _latex_node(nodes: Nodes, place: int, mark: str) -> str:
    node = nodes[place]
    match node:
        case Word(text):
            return f"\\{text}"
        case Variable(text):
            return GREEK.get(text, text)
        case Numeral(text):
            return text.replace(".", "{,}" if mark == "," else mark)
        case Sign(text):
            return SIGNS[text][1]
        case Symbol(text):
            return SYMBOLS[text][1]
        case Upright(text):
            return f"\\text{{{escape_latex(text)}}}"
        case Space():
            return r"\," * _is_seen(nodes, place)
        case Group(content, fences):
            left, right = (r"\left", r"\right") if _has_bar(content) else ("", "")
            return f"{left}{fences[0]}{_latex(content, mark)}{right}{fences[1]}"
        case Fraction(top, bottom) if _has_stroke(nodes, place):
            below = _latex(bottom if len(bottom) == 1 else (Group(bottom),), mark)
            return f"{_latex(top, mark)}/{below}"
        case Fraction(top, bottom):
            return f"\\frac{{{_latex(top, mark)}}}{{{_latex(bottom, mark)}}}"
        case Script(base, index, power):
            inner = _latex((base,), mark)
            below = f"_{{{_latex(index, mark)}}}" if index else ""
            above = f"^{{{_latex(power, mark)}}}" if power else ""
            return (f"{{{inner}}}" if isinstance(base, Symbol) else inner) + below + above


def _is_seen(nodes: Nodes, place: int) -> bool:
    """Tell whether a space must be set because the engine, which spaces by itself, would set none.

    A unit needs it, and two numbers, which would run into one.
    """
    before, after = nodes[place - 1], nodes[place + 1]
    both_numbers = isinstance(before, Numeral) and isinstance(after, Numeral)
    return both_numbers or isinstance(before, Upright) or isinstance(after, Upright)


def formula_html(formula: Formula, mark: str = ".", display: bool = False) -> str:
    """Return a formula in MathML; `display` gives fractions their full size."""
    style = ' displaystyle="true"' if display and _has_bar(formula.content) else ""
    return f"<math{style}>{_mathml(formula.content, mark)}</math>"


def _mathml(nodes: Nodes, mark: str) -> str:
    return "".join(_mathml_node(nodes, place, mark) for place in range(len(nodes)))


def _mathml_node(nodes: Nodes, place: int, mark: str) -> str:
    node = nodes[place]
    match node:
        case Word(text):
            return f"{_apart(nodes, place)}<mi>{text}</mi>{_apply(nodes, place)}"
        case Variable(text):
            return f'<mi mathvariant="normal">{text}</mi>' if text in CAPITALS else f"<mi>{text}</mi>"
        case Numeral(text):
            return f"<mn>{text.replace('.', mark)}</mn>"
        case Sign(text):
            tight = ' lspace="0" rspace="0"' if text == ":" else ""
            return f"<mo{tight}>{escape_html(SIGNS[text][0])}</mo>"
        case Symbol(text):
            return f'<mi mathvariant="normal">{SYMBOLS[text][0]}</mi>'
        case Upright(text):
            return f"<mtext>{escape_html(text)}</mtext>"
        case Space():
            return _THIN * _is_seen(nodes, place)
        case Group(content, fences):
            # Fences that may stretch are set with side bearings, even around a single line.
            fixed = "" if _has_bar(content) else ' stretchy="false"'
            opening, closing = (f"<mo{fixed}>{fence}</mo>" for fence in fences)
            return f"<mrow>{opening}{_mathml(content, mark)}{closing}</mrow>"
        case Fraction(top, bottom) if _has_stroke(nodes, place):
            below = _mathml(bottom if len(bottom) == 1 else (Group(bottom),), mark)
            return f'{_mathml(top, mark)}<mo lspace="0" rspace="0">/</mo>{below}'
        case Fraction(top, bottom):
            return f"<mfrac>{_row(top, mark)}{_row(bottom, mark)}</mfrac>"
        case Script(base, index, power):
            tag = "m" + "sub" * bool(index) + "sup" * bool(power)
            inner = "".join(_row(nodes, mark) for nodes in ((base,), index, power) if nodes)
            function = _is_function(base)
            before, after = (_apart(nodes, place), _apply(nodes, place)) if function else ("", "")
            return f"{before}<{tag}>{inner}</{tag}>{after}"


def _row(nodes: Nodes, mark: str) -> str:
    content = _mathml(nodes, mark)
    return content if len(nodes) == 1 else f"<mrow>{content}</mrow>"


_THIN = '<mspace width="0.167em"/>'


def _apart(nodes: Nodes, place: int) -> str:
    """Return the thin space between a factor and a function, which browsers do not set by themselves."""
    return "" if place == 0 or isinstance(_beside(nodes, place, -1), Sign) else _THIN


def _apply(nodes: Nodes, place: int) -> str:
    """Return the invisible sign that binds a function to what follows it, and the space after it."""
    if place == len(nodes) - 1 or isinstance(_beside(nodes, place, 1), Sign):
        return ""
    argument = _beside(nodes, place, 1)
    return "<mo>&#x2061;</mo>" + _THIN * (not isinstance(argument, Group | Word) and not _is_function(argument))


# Note marks -------------------------------------------------------------------------------------------


def mark_text(mark: str, target: str = "") -> str:
    """Return a mark raised, ᵃ⁾, or as it is, *), where Unicode has no raised character. Text has no links."""
    closed = f"{mark})"
    return "".join(_POWERS[character] for character in closed) if set(closed) <= _POWERS.keys() else closed


def mark_markdown(mark: str, target: str = "") -> str:
    """Return a mark without a link: an anchor in Markdown is HTML, which many readers drop."""
    return escape_markdown(mark_text(mark))


def mark_latex(mark: str, target: str = "") -> str:
    return f"\\textsuperscript{{{escape_latex(mark)})}}"


def mark_html(mark: str, target: str = "") -> str:
    text = f"{escape_html(mark)})"
    return f'<sup><a href="#{escape_html(target)}">{text}</a></sup>' if target else f"<sup>{text}</sup>"


def plain(label: str, mark: str = ".") -> str:
    """Return a label as Unicode text."""
    return set_label(label, escape_text, lambda formula: formula_text(formula, mark), mark_text)


def set_label(
    label: str,
    escape: Callable[[str], str],
    formula: Callable[[Formula], str],
    note: Callable[[str], str],
) -> str:
    """Return a label in a notation given by the three functions that set its prose, formulas and marks."""
    pieces = []
    for part in parse(label):
        match part:
            case Prose(text):
                pieces.append(escape(text))
            case Formula():
                pieces.append(formula(part))
            case Mark(text):
                pieces.append(note(text))
    return "".join(pieces)
