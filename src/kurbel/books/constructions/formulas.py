"""Points and numbers of a construction as formulas: "C + 1/2*(P - C)", "meet(Q, left(rod), O, along)".

A formula has numbers, names, + - * / ^, brackets, points as (x, y), the functions of FUNCTIONS and a choice,
"1 if angle < 180 else -1". A point may be added to another as a vector, and be multiplied and divided by a
number. Each name is known before it is used. Formulas run on numbers of any kind; what is compared or stands
in near(...) is computed in floats, so that every kind takes the same side, and the same round number.
"""

from __future__ import annotations

import ast
import operator
import re
from collections.abc import Callable, Mapping
from dataclasses import replace
from fractions import Fraction
from functools import cached_property, partial
from typing import Any, NamedTuple, TypeAlias

from kurbel.books.constructions import placed as on
from kurbel.books.constructions.formula_names import FUNCTIONS_OF_DRIVE, KNOWN, NUMBER, POINT, DriveFunction
from kurbel.books.constructions.placed import PlacedDrive, Point
from kurbel.errors import NotationError
from kurbel.exact.kind import floats
from kurbel.exact.separation import power
from kurbel.kernel.circle import Numeric, root
from kurbel.reading.arithmetic import OPERATIONS, POWERS, parsed, wrong_power
from kurbel.reading.given import choose

# How deep formulas may build upon each other, all their brackets and names together.
DEEPEST = 200
# A prime is none of Python's letters; this one, which looks like it, is.
_PRIME = "ʹ"
# A name: a letter with an index and primes, or a word.
NAME = r"_?[^\W\d_]\w*'*"


class Function(NamedTuple):
    """A function: what it takes and gives, and how it is computed."""

    takes: tuple[str, ...]
    gives: str
    apply: Callable[..., Numeric | on.Point]


FUNCTIONS: Mapping[str, Function] = {
    "x": Function((POINT,), NUMBER, operator.itemgetter(0)),
    "y": Function((POINT,), NUMBER, operator.itemgetter(1)),
    "left": Function((POINT,), POINT, on.turned),
    "dot": Function((POINT, POINT), NUMBER, on.dot),
    "cross": Function((POINT, POINT), NUMBER, on.cross),
    "distance": Function((POINT, POINT), NUMBER, on.distance),
    "foot": Function((POINT, POINT, POINT), POINT, on.foot),
    "meet": Function((POINT, POINT, POINT, POINT), POINT, on.meet),
    "circles": Function((POINT, NUMBER, POINT, NUMBER, NUMBER), POINT, on.circles),
    "on_circle": Function((POINT, POINT, POINT, NUMBER), POINT, on.on_circle),
    "sqrt": Function((NUMBER,), NUMBER, root),
    "abs": Function((NUMBER,), NUMBER, abs),
}
# In floats alone: what is found by them stands in near(...) or is compared.
OF_FLOATS: Mapping[str, Callable[..., object]] = {"max": max, "min": min}
NEAR = "near"
COMPARED: Mapping[type, Callable[[Numeric, Numeric], bool]] = {
    ast.Lt: operator.lt,
    ast.LtE: operator.le,
    ast.Gt: operator.gt,
    ast.GtE: operator.ge,
    ast.Eq: operator.eq,
}
TRUTH = "comparison"
Value: TypeAlias = "Callable[[Values], Any]"


class Formula(NamedTuple):
    """A formula that was read: a point, a number or a comparison, and how it is computed.

    `depth` is how deep it builds upon others; one `in_floats` is a greatest or least number, which floats
    alone tell.
    """

    gives: str
    value: Value
    depth: int = 1
    in_floats: bool = False


class Values:
    """The points and numbers of a construction at one place, each computed where it is first asked for."""

    def __init__(self, at: PlacedDrive, formulas: Mapping[str, Formula], **numbers: Any) -> None:
        self.at, self._formulas, self._numbers = at, formulas, numbers
        self._found: dict[str, object] = dict(numbers)

    def __getitem__(self, name: str) -> Any:
        if name not in self._found:
            formula = self._formulas.get(name)
            self._found[name] = formula.value(self) if formula else KNOWN[name].value(self.at)
        return self._found[name]

    @cached_property
    def near(self) -> Values:
        """The same in floats."""
        if self.at.kind.of is float:
            return self
        return Values(replace(self.at, kind=floats()), self._formulas, **self._numbers)


def read(text: str, known: Mapping[str, Formula], mechanism: str) -> Formula:
    """Return the formula of a text, in which there may be these names beside those of the drive.

    Raises NotationError for what is none, ChoiceError for a name that is not known of the mechanism.
    """
    written = text.replace("'", _PRIME)
    unread = f'"{text[:60]}" is no formula; write one such as C + 1/2*(P - C)'
    found = _Reader(text, known, mechanism).of(parsed(written, "formula", unread))
    if found.depth > DEEPEST:
        raise NotationError(
            f'"{text[:60]}" builds on formulas {found.depth} deep; at most {DEEPEST} are computed'
        )
    return found


class _Reader:
    """Reads the tree of one formula."""

    def __init__(self, text: str, known: Mapping[str, Formula], mechanism: str) -> None:
        self.text, self.known = text, known
        self.of_drive = {name: one for name, one in KNOWN.items() if mechanism in one.of or not one.of}
        own = {name: one for name, one in FUNCTIONS_OF_DRIVE.items() if mechanism in one.of}
        self.functions: dict[str, Function | DriveFunction] = {**FUNCTIONS, **own}

    def of(self, tree: ast.expr) -> Formula:
        match tree:
            case ast.Constant(value=Fraction() as number):
                return Formula(NUMBER, lambda values: values.at.kind.of(number))
            case ast.Name(id=name):
                return self.named(name.replace(_PRIME, "'"))
            case ast.UnaryOp(op=ast.USub(), operand=inner):
                return self.negative(self.of(inner))
            case ast.BinOp(left=left, op=ast.Pow(), right=ast.Constant(value=Fraction() as height)):
                if height not in POWERS:
                    raise wrong_power(self.text, height)
                return self.combined(NUMBER, partial(power, exponent=int(height)), self.number(left))
            case ast.BinOp(left=left, op=op, right=right) if type(op) in OPERATIONS:
                return self.operation(type(op), self.of(left), self.of(right))
            case ast.Tuple(elts=[across, up]):
                return self.combined(POINT, Point, self.number(across), self.number(up))
            case ast.IfExp(test=test, body=body, orelse=other):
                return self.choice(test, self.of(body), self.of(other))
            case ast.Compare(left=left, ops=[op], comparators=[right]) if type(op) in COMPARED:
                return self.combined(TRUTH, COMPARED[type(op)], self.number(left), self.number(right))
            case ast.Call(func=ast.Name(id=name), args=args, keywords=[]):
                return self.call(name, args)
        raise self.wrong(
            "has what no formula may; it has numbers, names, + - * / ^, brackets, points (x, y),"
            f" {', '.join((*self.functions, *OF_FLOATS, NEAR))} and choices, 1 if x(P) > 0 else -1"
        )

    def wrong(self, said: str) -> NotationError:
        return NotationError(f'"{self.text[:60]}" {said}')

    def named(self, name: str) -> Formula:
        value = operator.itemgetter(name)
        if own := self.known.get(name):
            return own._replace(value=value, depth=own.depth + 2)
        drive = self.of_drive[choose(name, (*self.known, *self.of_drive), "point or number")]
        return Formula(drive.gives, value, 2)

    def number(self, tree: ast.expr) -> Formula:
        found = self.of(tree)
        if found.gives != NUMBER:
            raise self.wrong(f"has a {found.gives} where a number must stand")
        return found

    def combined(self, gives: str, apply: Callable[..., object], *parts: Formula) -> Formula:
        """Return what comes of the values of other formulas."""
        values = [part.value for part in parts]
        return Formula(
            gives,
            lambda at: apply(*[value(at) for value in values]),
            1 + max(part.depth for part in parts),
            any(part.in_floats for part in parts),
        )

    def negative(self, inner: Formula) -> Formula:
        if inner.gives == POINT:
            return self.combined(POINT, lambda point: Point(-point.x, -point.y), inner)
        return self.combined(inner.gives, operator.neg, inner)

    def operation(self, op: type, one: Formula, other: Formula) -> Formula:
        apply = OPERATIONS[op]
        kinds = one.gives, other.gives
        if kinds == (NUMBER, NUMBER):
            return self.combined(NUMBER, apply, one, other)
        if kinds == (POINT, POINT) and op in (ast.Add, ast.Sub):
            return self.combined(POINT, lambda p, q: Point(apply(p.x, q.x), apply(p.y, q.y)), one, other)
        if kinds == (NUMBER, POINT) and op is ast.Mult:
            return self.combined(POINT, lambda times, p: Point(times * p.x, times * p.y), one, other)
        if kinds == (POINT, NUMBER) and op in (ast.Mult, ast.Div):
            return self.combined(POINT, lambda p, part: Point(apply(p.x, part), apply(p.y, part)), one, other)
        raise self.wrong(f"has a {one.gives} and a {other.gives} where they cannot be combined")

    def choice(self, test: ast.expr, one: Formula, other: Formula) -> Formula:
        condition = self.of(test)
        if condition.gives != TRUTH or one.gives != other.gives:
            raise self.wrong("has a choice that is none; write it as 1 if x(P) > 0 else -1")
        holds = condition.value
        both = self.combined(one.gives, max, one, other)
        return both._replace(
            value=lambda values: (one if holds(values.near) else other).value(values),
            depth=max(both.depth, condition.depth + 1),
        )

    def call(self, name: str, args: list[ast.expr]) -> Formula:
        if name == NEAR:
            return self.rounded(*self.called(name, (NUMBER, NUMBER), args))
        choose(name, (*self.functions, *OF_FLOATS, NEAR), "function")
        if name in OF_FLOATS:
            numbers = self.called(name, (NUMBER,) * max(len(args), 2), args)
            return self.combined(NUMBER, OF_FLOATS[name], *numbers)._replace(in_floats=True)
        function = self.functions[name]
        found = self.called(name, function.takes, args)
        if isinstance(function, DriveFunction):
            found.insert(0, Formula(NUMBER, operator.attrgetter("at")))
        return self.combined(function.gives, function.apply, *found)

    def rounded(self, number: Formula, steps: Formula) -> Formula:
        """Return a number in floats to the nearest of so many parts of 1, the same for every kind."""

        def value(values: Values) -> Numeric:
            parts = round(steps.value(values.near))
            return values.at.kind.of(Fraction(round(parts * number.value(values.near)), parts))

        return Formula(NUMBER, value, 1 + max(number.depth, steps.depth))

    def called(self, name: str, takes: tuple[str, ...], args: list[ast.expr]) -> list[Formula]:
        found = [self.of(arg) for arg in args]
        if tuple(one.gives for one in found) != takes:
            raise self.wrong(f"has {name} of what it does not take; write {name}({', '.join(takes)})")
        return found


def lines_of(text: str) -> list[tuple[int, str, str]]:
    """Return the formulas of a block, NAME = FORMULA, each with the number of its line from 0.

    Lines below `each NAME NUMBER, NAME NUMBER:` that are set in stand for one of each: @ in them is the name
    and `part` the number. Raises NotationError for a line that is none.
    """
    found: list[tuple[int, str, str]] = []
    stations: list[tuple[str, str]] = []
    inner: list[tuple[int, str, str]] = []

    def close() -> None:
        for name, part in stations:
            for number, left, right in inner:
                own = re.sub(r"\bpart\b", f"({part})", right).replace("@", name)
                found.append((number, left.replace("@", name), own))
        stations.clear()
        inner.clear()

    for number, line in enumerate(text.splitlines()):
        bare = line.split("#")[0].rstrip()
        if not bare:
            continue
        if not bare[0].isspace():
            close()
        if head := re.fullmatch(r"each (.*):", bare):
            for place in head[1].split(","):
                if len(words := place.split()) != 2:
                    raise NotationError(f'"{bare[:60]}" is wrong; write it as each I 1/4, II 1/2:')
                stations.append((words[0], words[1]))
            continue
        left, equals, right = (part.strip() for part in bare.partition(" = "))
        if not equals:
            raise NotationError(f'"{bare.strip()[:60]}" is no point; write it as M = O + 1/2*(P - O)')
        (inner if bare[0].isspace() else found).append((number, left, right))
    close()
    return found
