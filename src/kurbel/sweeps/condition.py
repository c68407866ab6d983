"""Conditions on the axes of a sweep, such as eps*back < 1: at which points they hold, exactly."""

from __future__ import annotations

import ast
import operator
import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from math import inf, isfinite, isinf, log2, prod
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from kurbel.commands.options import alone_of
from kurbel.errors import NotationError, ProblemError
from kurbel.exact.separation import MOST_BITS, TooLargeError, outgrows, power
from kurbel.reading import notation
from kurbel.reading.arithmetic import OPERATIONS, parsed
from kurbel.reading.given import allowed_name
from kurbel.sweeps.columns import key_of
from kurbel.sweeps.coordinates import exact_at, values_at
from kurbel.sweeps.plan import Axis, Places, Plan

Mask = NDArray[np.bool_]
Arrays = Mapping[str, NDArray[np.generic]]
# A float is known better than this; nearer numbers are compared exactly.
NEAR = 1e-9
# Below this floats lose digits: no error is taken to be less.
LEAST = 1e-290
GRAMMAR = "write it as 'eps*back < 1', with + - * / **, < <= > >= == !=, and, or, not, and names of axes"

# A ratio as it is written elsewhere, 1:4.
_RATIO = re.compile(r"\b(\d+(?:\.\d+)?):(\d+(?:\.\d+)?)")
_NUMBERS: Mapping[type, Callable[..., Any]] = {**OPERATIONS, ast.Pow: operator.pow}
_COMPARED: Mapping[type, Callable[..., Any]] = {
    ast.Lt: operator.lt,
    ast.LtE: operator.le,
    ast.Gt: operator.gt,
    ast.GtE: operator.ge,
    ast.Eq: operator.eq,
    ast.NotEq: operator.ne,
}
# What may stand in a condition.
_ALLOWED = (
    *(ast.BoolOp, ast.And, ast.Or, ast.UnaryOp, ast.Not, ast.USub, ast.UAdd),
    *(ast.BinOp, *_NUMBERS, ast.Compare, *_COMPARED, ast.Name, ast.Load, ast.Constant),
)


@dataclass(frozen=True)
class Condition:
    """A condition as it was written."""

    text: str

    def __post_init__(self) -> None:
        if not all(isinstance(one, _ALLOWED) for one in ast.walk(self.tree)):
            raise NotationError(self.unread)
        if not isinstance(self.tree, ast.Compare | ast.BoolOp | ast.UnaryOp):
            raise NotationError(f'condition "{self.text[:60]}" compares nothing; {GRAMMAR}')

    @cached_property
    def tree(self) -> ast.expr:
        """The parsed text."""
        ratios = _RATIO.sub(r"(\1/\2)", self.text)
        return parsed(ratios, "condition", self.unread, number=notation.number)

    @property
    def unread(self) -> str:
        """The sentence for a text that is no condition."""
        return f'condition "{self.text[:60]}" cannot be read; {GRAMMAR}'

    @property
    def names(self) -> list[str]:
        """The names of axes in it, in their order."""
        found = [one for one in ast.walk(self.tree) if isinstance(one, ast.Name)]
        return list(dict.fromkeys(one.id for one in sorted(found, key=lambda one: one.col_offset)))

    def holds(self, floats: Arrays, exact: Callable[[int], Mapping[str, object]], count: int) -> Mask:
        """Return where it holds, by the values of the names at so many places: floats or texts in arrays,
        and exact ones at a place, for where floats do not tell. A division by zero holds nowhere, nor does
        a root of what is below zero."""
        doubtful = np.zeros(count, bool)
        with np.errstate(all="ignore"):
            found = np.broadcast_to(_floats(self.tree, floats, doubtful).value, count).copy()
        for place in np.flatnonzero(doubtful).tolist():
            try:
                found[place] = _exact(self.tree, exact(place))
            except ZeroDivisionError:
                found[place] = False
            except TooLargeError as error:
                raise NotationError(f'condition "{self.text[:60]}": {error}') from None
            except OverflowError:
                raise NotationError(
                    f'condition "{self.text[:60]}" has powers beyond 10^308, which are not computed; write it'
                    " with smaller ones"
                ) from None
        return found.astype(bool)


class _Float(NamedTuple):
    """Floats or texts, and how large what they were made of is: their error counts in that."""

    value: Any
    size: Any


def _floats(node: ast.expr, values: Arrays, doubtful: Mask) -> _Float:
    """Return the value in floats, and mark the places at which a comparison is too near."""
    match node:
        case ast.BoolOp(op=op, values=parts):
            join = np.logical_and if isinstance(op, ast.And) else np.logical_or
            found = [_floats(one, values, doubtful).value for one in parts]
            return _Float(join.reduce(np.broadcast_arrays(*found)), None)
        case ast.UnaryOp(op=op, operand=one):
            value, size = _floats(one, values, doubtful)
            return _Float(np.logical_not(value) if isinstance(op, ast.Not) else _signed(op, value), size)
        case ast.BinOp(left=left, op=op, right=right):
            return _joined(_floats(left, values, doubtful), op, _floats(right, values, doubtful))
        case ast.Compare(left=left, ops=ops, comparators=others):
            told = [_floats(one, values, doubtful) for one in (left, *others)]
            steps = zip(told, ops, told[1:], strict=False)
            compared = [_compared(first, op, second, doubtful) for first, op, second in steps]
            return _Float(np.logical_and.reduce(np.broadcast_arrays(*compared)), None)
        case ast.Name(id=name):
            known = values[name]
            return _Float(known, None if known.dtype.kind == "O" else np.abs(known))
        case ast.Constant(value=str() as text):
            return _Float(text, None)
        case ast.Constant(value=Fraction() as value):
            known = np.float64(_as_float(value))
            return _Float(known, abs(known) + LEAST)
    raise AssertionError(ast.dump(node))


def _joined(first: _Float, op: ast.operator, second: _Float) -> _Float:
    if first.size is None or second.size is None:
        raise NotationError(f"words have neither sums nor products; {GRAMMAR}")
    value = _NUMBERS[type(op)](first.value, second.value)
    if isinstance(op, ast.Add | ast.Sub):
        return _Float(value, first.size + second.size)
    if isinstance(op, ast.Mult):
        return _Float(value, first.size * second.size)
    share = first.size / np.abs(first.value)
    if isinstance(op, ast.Div):
        return _Float(value, np.abs(value) * share * second.size / np.abs(second.value))
    return _Float(value, np.abs(value) * (1 + share * np.abs(second.value)))


def _compared(first: _Float, op: ast.cmpop, second: _Float, doubtful: Mask) -> Any:
    if (first.size is None) != (second.size is None):
        raise NotationError(f"a word is compared with a number; {GRAMMAR}")
    if first.size is not None:
        apart = np.abs(first.value - second.value)
        # What is no number is settled by exact numbers, too.
        doubtful |= ~(apart > NEAR * (first.size + second.size))
    return _COMPARED[type(op)](first.value, second.value)


def _settled(first: object, op: ast.cmpop, second: object) -> bool:
    """Return how exact numbers compare; of two that no float holds it is not known."""
    beyond = [isinstance(one, float) and not isfinite(one) for one in (first, second)]
    if all(beyond) or any(one != one for one in (first, second)):
        raise OverflowError
    return bool(_COMPARED[type(op)](first, second))


def _as_float(value: Fraction) -> float:
    """Return the nearest float, an infinite one beyond all."""
    try:
        return float(value)
    except OverflowError:
        return inf if value > 0 else -inf


def _power(first: Fraction | float, second: Fraction | float) -> Any:
    """Return a power, exact if it is a whole one; of one beyond all exact numbers an infinite float."""
    if _is_endless(second):
        if first > 1 and second > 0:
            return inf
        raise OverflowError
    whole = second == int(second)
    if whole and isinstance(first, Fraction) and isinstance(second, Fraction):
        try:
            return power(first, int(second))
        except TooLargeError:
            if not outgrows(first, int(second)):
                raise
            return -inf if first < 0 and second % 2 else inf
    if first < 0 and not whole:
        raise ZeroDivisionError
    if first > 1 and second * log2(first) > MOST_BITS:
        return inf
    found = float(first) ** float(second)
    # What is near to zero is not zero.
    if first and not found:
        raise OverflowError
    return found


def _is_endless(value: object) -> bool:
    return isinstance(value, float) and isinf(value)


def _reckoned(op: ast.operator, first: object, second: object) -> object:
    # What is beyond all numbers can be compared, and no more.
    if _is_endless(first) or _is_endless(second):
        raise OverflowError
    return _NUMBERS[type(op)](first, second)


def _signed(op: ast.unaryop, value: Any) -> Any:
    return -value if isinstance(op, ast.USub) else value


def _exact(node: ast.expr, values: Mapping[str, object]) -> Any:
    """Return the value in exact numbers."""
    match node:
        case ast.BoolOp(op=ast.And(), values=parts):
            return all(_exact(one, values) for one in parts)
        case ast.BoolOp(values=parts):
            return any(_exact(one, values) for one in parts)
        case ast.UnaryOp(op=op, operand=one):
            value = _exact(one, values)
            return not value if isinstance(op, ast.Not) else _signed(op, value)
        case ast.BinOp(left=left, op=op, right=right):
            first, second = _exact(left, values), _exact(right, values)
            return _power(first, second) if isinstance(op, ast.Pow) else _reckoned(op, first, second)
        case ast.Compare(left=left, ops=ops, comparators=others):
            found = [_exact(one, values) for one in (left, *others)]
            steps = zip(found, ops, found[1:], strict=False)
            return all(_settled(first, op, second) for first, op, second in steps)
        case ast.Name(id=name):
            return values[name]
        case ast.Constant(value=value):
            return value
    raise AssertionError(ast.dump(node))


# Combinations of the options in the condition and of those before them: some seconds, some hundred megabytes.
MOST_TRIED = 5 * 10**7
BLOCK = 1 << 20
# The group of options that do not vary.
FIXED = -1


@dataclass(frozen=True)
class KeptPlaces:
    """The places on the axes up to the last one of the condition, and how many points each of them has."""

    places: Places
    each: int

    def __len__(self) -> int:
        return len(self.places) * self.each

    def points(self, numbers: Places) -> Places:
        """Return the points on the whole grid by their numbers among those that are left."""
        places, within = np.divmod(numbers, self.each)
        return self.places[places] * self.each + within


def kept_of(plan: Plan) -> KeptPlaces:
    """Return the points at which the condition of the plan holds. Raises KurbelError."""
    condition = Condition(plan.only)
    axes = named_axes(plan, condition)
    last = max(group for group, _ in axes.values())
    sizes = plan.sizes[: last + 1]
    count = prod(sizes)
    if count > MOST_TRIED:
        raise ProblemError(
            f"the condition {plan.only} is tried at {count} combinations of the options that it names and of"
            " those before them, and at most 5*10^7 are tried; write these options first"
        )
    found = []
    for start in range(0, count, BLOCK):
        block = np.arange(start, min(start + BLOCK, count))
        found.append(block[_holds(plan, condition, axes, sizes, block)])
    kept = np.concatenate(found)
    if not len(kept):
        raise ProblemError(f"the condition {plan.only} holds at no combination; nothing is left to compute")
    return KeptPlaces(kept, prod(plan.sizes[last + 1 :]))


def named_axes(plan: Plan, condition: Condition) -> Mapping[str, tuple[int, Axis]]:
    """Return the axes that a condition names, by their options or columns, each with its group."""
    axes = {axis.option: (place, axis) for place, group in enumerate(plan.groups) for axis in group}
    # What is the same everywhere may be named, too.
    axes |= {name: (FIXED, Axis(name, (alone_of(given),))) for name, given in plan.given.items()}
    axes |= {key_of(option): found for option, found in axes.items()}
    if not condition.names:
        raise ProblemError(
            f"the condition {plan.only} names no option; choose from {', '.join(sorted(plan.axes))}"
        )
    return {name: axes[allowed_name(name, axes, "option of the sweep")] for name in condition.names}


def _holds(
    plan: Plan,
    condition: Condition,
    axes: Mapping[str, tuple[int, Axis]],
    sizes: tuple[int, ...],
    block: Places,
) -> NDArray[np.bool_]:
    places = {
        name: np.zeros_like(block) if place == FIXED else block // prod(sizes[place + 1 :]) % sizes[place]
        for name, (place, _) in axes.items()
    }
    values = {name: values_at(plan, axis, places[name]) for name, (_, axis) in axes.items()}
    floats = {name: np.array(one, object) if isinstance(one, list) else one for name, one in values.items()}

    def exact(row: int) -> Mapping[str, object]:
        return {name: exact_at(plan, axis, int(places[name][row])) for name, (_, axis) in axes.items()}

    return condition.holds(floats, exact, len(block))
