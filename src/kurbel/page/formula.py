"""The grammar of formulas in labels, close to Typst's: text -> a small tree.

    (sin(φ±ψ))/(cos ψ)    a fraction; the parentheses around its two parts are dropped
    x_m  x_(max)  φ^2     index and power
    2.5 "m/s"             upright text in double quotes; a number has a point whatever the page prints
    R [1 - cos α]         parentheses and brackets are printed
    sqrt(1 + λ^2)         a root; engines set a bar in place of its parentheses
    overline(a d)         the length between two points, with a bar above; plain text has ad

Spaces are kept: text needs them ("cos φ ± ψ"), other engines set their own.
"""

from __future__ import annotations

import re
from typing import NamedTuple

FENCES = {"(": ")", "[": "]"}
FUNCTIONS = frozenset(("sin", "cos", "tan", "cot", "arcsin", "arccos", "arctan", "max", "min", "ln", "log"))
ROOT, OVERLINE = "sqrt", "overline"

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
_GREEK = (
    "α alpha β beta γ gamma δ delta ε varepsilon ζ zeta η eta ϑ vartheta θ theta ι iota κ kappa λ lambda "
    "μ mu ν nu ξ xi π pi ρ varrho σ sigma τ tau υ upsilon φ varphi χ chi ψ psi ω omega "
    "∂ partial Γ Gamma Δ Delta Θ Theta Λ Lambda Ξ Xi Π Pi Σ Sigma Φ Phi Ψ Psi Ω Omega"
)
GREEK = {letter: f"\\{name}" for letter, name in re.findall(r"(\S+) (\S+)", _GREEK)}
CAPITALS = frozenset(letter for letter in GREEK if letter.isupper())


class Word(NamedTuple):
    """An upright function name."""

    text: str


class Variable(NamedTuple):
    text: str


class Numeral(NamedTuple):
    """A number, with a decimal point whatever the page prints."""

    text: str


class Sign(NamedTuple):
    """A sign between two terms, or before one."""

    text: str


class Symbol(NamedTuple):
    """A sign that stands for a value or belongs to one: ∞, %, °."""

    text: str


class Upright(NamedTuple):
    """Text in double quotes: a unit or a word."""

    text: str


class Space(NamedTuple):
    """White space in the source."""


class Group(NamedTuple):
    """Parentheses or brackets that are printed."""

    content: Nodes
    fences: str = "()"


class Root(NamedTuple):
    """A square root."""

    content: Nodes


class Overline(NamedTuple):
    """Letters of points with a bar above: the length between them."""

    content: Nodes


class Fraction(NamedTuple):
    top: Nodes
    bottom: Nodes


class Script(NamedTuple):
    """An atom with an index, a power or both."""

    base: Node
    sub: Nodes
    sup: Nodes


Node = (
    Word | Variable | Numeral | Sign | Symbol | Upright | Space | Group | Root | Overline | Fraction | Script
)
Nodes = tuple[Node, ...]


class Formula(NamedTuple):
    content: Nodes


_TOKEN = re.compile(r'[0-9]+(?:\.[0-9]+)?|[A-Za-z]+|"[^"]*"|[\s]+|.', re.DOTALL)
_DEEPEST = 20


def tokens(source: str) -> list[str]:
    """Return what a formula is made of, white space as one space."""
    return [" " if token.isspace() else token for token in _TOKEN.findall(source.strip())]


def parse_formula(source: str) -> Formula:
    """Return the tree of a formula; raise MalformedError if it is not understood."""
    parser = _Parser(source)
    content = parser.sequence()
    if parser.peek():
        raise MalformedError(f"a closing {parser.peek()} has no partner")
    return Formula(content)


class MalformedError(Exception):
    """What is wrong with a formula; whoever knows the label names it."""


class _Parser:
    """Recursive descent over the tokens of one formula."""

    def __init__(self, source: str) -> None:
        self.tokens = tokens(source)
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
            raise MalformedError("a formula or a pair of parentheses is empty")
        return tuple(nodes)

    def fraction(self, before: list[Node]) -> Fraction:
        """Take the numerator from the nodes read before the stroke, and read the denominator."""
        while before and isinstance(before[-1], Space):
            before.pop()
        if not before or isinstance(before[-1], Sign | Word):
            raise MalformedError("before / stands a number, a letter or parentheses")
        if isinstance(before[-1], Fraction):
            raise MalformedError("a second / needs parentheses, (a/b)/c or a/(b c)")
        top: Nodes = (before.pop(),)
        if isinstance(top[0], Group) and before and is_function(before[-1]):
            top = (before.pop(), *top)
        self.skip_space()
        bottom = self.factor()
        if is_function(bottom[-1]):
            raise MalformedError("a function after / needs parentheses, 1/(cos ψ)")
        return Fraction(_bare(top), _bare(bottom))

    def factor(self) -> Nodes:
        """Read an atom with its index and power; a function takes the parentheses that touch it."""
        atom = self.scripted(self.atom())
        if is_function(atom) and self.peek() == "(":
            return atom, self.scripted(self.atom())
        return (atom,)

    def scripted(self, base: Node) -> Node:
        found: dict[str, Nodes] = {"_": (), "^": ()}
        while (kind := self.peek()) in found:
            self.take()
            if found[kind]:
                raise MalformedError(f"a second {kind} needs parentheses")
            found[kind] = _bare((self.atom(),))
        return Script(base, found["_"], found["^"]) if found["_"] or found["^"] else base

    def atom(self) -> Node:
        token = self.take()
        if token in FENCES:
            return self.group(token)
        if token == ROOT and self.peek() == "(":
            return Root(self.group(self.take()).content)
        if token == OVERLINE and self.peek() == "(":
            return Overline(self.group(self.take()).content)
        if token[:1] in "0123456789" and token:
            return Numeral(token)
        if token in FUNCTIONS:
            return Word(token)
        if token in GREEK or (len(token) == 1 and token.isascii() and token.isalpha()):
            return Variable(token)
        if token in SYMBOLS:
            return Symbol(token)
        if token.startswith('"') and token[1:-1].strip():
            return Upright(token[1:-1])
        raise MalformedError(_unexpected(token))

    def group(self, opening: str) -> Group:
        self.depth += 1
        if self.depth > _DEEPEST:
            raise MalformedError(f"parentheses are nested more than {_DEEPEST} deep")
        content = self.sequence()
        if self.take() != FENCES[opening]:
            raise MalformedError(f"an opening {opening} has no partner")
        self.depth -= 1
        return Group(content, opening + FENCES[opening])


def _unexpected(token: str) -> str:
    if token in ("", ")", "]"):
        return "a number, a letter or parentheses are missing"
    if token == ROOT:
        return "a root needs parentheses, sqrt(2)"
    if token == OVERLINE:
        return "a bar above needs parentheses, overline(a d)"
    if token.isalpha() and token.isascii():
        return f"{token} is no function; letters of a product stand apart, words in double quotes"
    if token.startswith('"'):
        return "double quotes are empty"
    return f"{token!r} has no meaning in a formula"


def is_function(node: Node) -> bool:
    return isinstance(node.base if isinstance(node, Script) else node, Word)


def _bare(nodes: Nodes) -> Nodes:
    """Drop the outer parentheses, which the bar of a fraction or the place of an index replaces."""
    match nodes:
        case (Group(content, "()"),):
            return content
    return nodes
