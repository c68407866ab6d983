"""Numbers that are not known yet: a formula run on them writes itself down, one operation a line."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from typing import Any, NoReturn

from kurbel.errors import KurbelError


class UntraceableError(KurbelError):
    """The formula asks for more than arithmetic: what a number is decides what happens next."""


class Tape:
    """The lines of a formula, each operation once, and the floats that it was given.

    These are its `constants`, by their place: formulas that differ by nothing else are the same lines.
    """

    def __init__(self) -> None:
        self.lines: list[str] = []
        self.constants: list[float] = []
        self._written: dict[str, str] = {}
        self._places: dict[str, int] = {}
        self._is_law = False

    @contextmanager
    def law(self) -> Iterator[None]:
        """Within it floats are numbers that never change, and stand in the lines themselves."""
        before, self._is_law = self._is_law, True
        yield
        self._is_law = before

    def input(self, name: str) -> Traced:
        """Return a number that the reader of the lines knows by this name."""
        return Traced(self, name)

    def number(self, expression: str) -> Traced:
        """Return the number that an expression gives."""
        if expression not in self._written:
            name = f"v{len(self.lines)}"
            self.lines.append(f"{name} = {expression}")
            self._written[expression] = name
        return Traced(self, self._written[expression])

    def name(self, number: object) -> str:
        """Return what stands in a line for a number of any kind: whole numbers themselves."""
        if isinstance(number, Traced):
            return number.name
        if isinstance(number, int):
            return repr(float(number))
        if not isinstance(number, float):
            raise UntraceableError(f"a {type(number).__name__} is no number of a traced formula")
        if self._is_law:
            return repr(float(number))
        # A comparison tells neither 0.0 from -0.0 nor NaN from NaN.
        place = self._places.setdefault(float(number).hex(), len(self.constants))
        if place == len(self.constants):
            self.constants.append(float(number))
        return f"k{place}"


class Traced:
    """A number by its name on the tape. It has arithmetic and nothing else: no size, no sign, no truth."""

    __slots__ = ("name", "tape")

    def __init__(self, tape: Tape, name: str) -> None:
        self.tape = tape
        self.name = name

    def _of(self, left: Traced | float, sign: str, right: Traced | float) -> Traced:
        name = self.tape.name
        return self.tape.number(f"{name(left)} {sign} {name(right)}")

    def __add__(self, other: Traced | float) -> Traced:
        return self._of(self, "+", other)

    def __radd__(self, other: Traced | float) -> Traced:
        return self._of(other, "+", self)

    def __sub__(self, other: Traced | float) -> Traced:
        return self._of(self, "-", other)

    def __rsub__(self, other: Traced | float) -> Traced:
        return self._of(other, "-", self)

    def __mul__(self, other: Traced | float) -> Traced:
        return self._of(self, "*", other)

    def __rmul__(self, other: Traced | float) -> Traced:
        return self._of(other, "*", self)

    def __truediv__(self, other: Traced | float) -> Traced:
        return self._of(self, "/", other)

    def __rtruediv__(self, other: Traced | float) -> Traced:
        return self._of(other, "/", self)

    def __neg__(self) -> Traced:
        return self.tape.number(f"-{self.name}")

    def __pow__(self, power: Traced | float) -> Traced:
        # What NumPy makes of these powers, to the bit.
        if power == 2:
            return self * self
        if power == 0.5:
            return self.tape.number(f"sqrt({self.name})")
        raise UntraceableError(f"the power {power} is not traced")

    def unrounded(self, parts: Callable[[Traced], tuple[Any, Any]]) -> tuple[object, ...]:
        """Return what `circle` does of an angle in degrees, without asking in which quarter it lies."""
        return unrounded(self, parts)

    def __gt__(self, other: Traced | float) -> Condition:
        return Condition(self.tape, f"{self.name} > {self.tape.name(other)}")

    def __array_ufunc__(
        self, ufunc: Callable[..., object], method: str, *numbers: Any, **options: object
    ) -> Any:
        done = _UFUNCS.get(ufunc.__name__)
        if method != "__call__" or options or done is None:
            raise UntraceableError(f"{ufunc.__name__} is not traced")
        return done(*(number.item() if hasattr(number, "item") else number for number in numbers))

    def _refuse(self, *_: object, **__: object) -> NoReturn:
        raise UntraceableError("a traced number is not known yet")

    __array__ = __array_function__ = __bool__ = __float__ = __int__ = __index__ = __abs__ = _refuse
    __eq__ = __ne__ = __lt__ = __le__ = __ge__ = _refuse
    __len__ = __iter__ = __getitem__ = __hash__ = __round__ = __floordiv__ = __mod__ = _refuse


class Condition:
    """What holds of numbers that are not known yet: `np.where` knows it, nothing else."""

    def __init__(self, tape: Tape, text: str) -> None:
        self.tape = tape
        self.text = text

    def __array_function__(
        self, function: Callable[..., object], _: object, numbers: Sequence[Any], options: object
    ) -> Traced:
        if function.__name__ != "where" or options or numbers[0] is not self:
            raise UntraceableError(f"{function.__name__} is not traced")
        one, other = (self.tape.name(number) for number in numbers[1:])
        return self.tape.number(f"({one} if {self.text} else {other})")

    def __bool__(self) -> bool:
        raise UntraceableError("a traced number is not known yet")


def _chosen(one: Traced | float, sign: str, other: Traced | float) -> Traced:
    """Return one of two numbers, NaN if either is, as NumPy does."""
    traced = one if isinstance(one, Traced) else other
    assert isinstance(traced, Traced)
    tape = traced.tape
    first, second = tape.name(one), tape.name(other)
    return tape.number(f"({first} if {first} {sign} {second} or {first} != {first} else {second})")


# What a float of NumPy's own does with a traced number.
_UFUNCS: dict[str, Callable[..., object]] = {
    "add": lambda one, other: one + other,
    "subtract": lambda one, other: one - other,
    "multiply": lambda one, other: one * other,
    "divide": lambda one, other: one / other,
    "negative": lambda one: -one,
    "square": lambda one: one * one,
    "sqrt": lambda one: one**0.5,
    "absolute": lambda one: one.tape.number(f"abs({one.name})"),
    "maximum": lambda one, other: _chosen(one, ">=", other),
    "minimum": lambda one, other: _chosen(one, "<=", other),
}


# Added to a number below 2**51 it leaves the nearest whole number, half to even, in the last bits.
WHOLE = float(3 << 51)


class Sign:
    """1 or -1, of which a product is the other number with its sign turned or not."""

    def __init__(self, turned: Traced) -> None:
        self.turned = turned

    def __mul__(self, other: Traced) -> Traced:
        bits = f"float64({other.name}).view(int64) ^ {self.turned.name}"
        return other.tape.number(f"int64({bits}).view(float64)")


def unrounded(degrees: Traced, parts: Callable[[Traced], tuple[Any, Any]]) -> tuple[object, ...]:
    """Return the turns of sine, cosine and versine, the part that the sine takes and that of the others.

    `parts` gives sine and versine within ±45°, unrounded. The bits are those of `kernel.circle`.
    """
    tape = degrees.tape
    with tape.law():
        raised = degrees / 90 + WHOLE
        sine, versine = parts(degrees - 90 * (raised - WHOLE))
        # Rows of QUARTERS in kernel/circle.py, by the last two bits of the number of quarters.
        bits = tape.number(f"float64({raised.name}).view(int64)")
        odd = tape.number(f"{bits.name} & 1 != 0")
        back, not_back, falls = (_sign(bits, change) for change in ("", " ^ 2", " + 1"))
        one = back * tape.number("1.0 + 0.0")
        of_sine, of_cosine = _either(odd, one, 0.0), _either(odd, 0.0, one)
    return (
        [(of_sine, falls), (of_cosine, not_back), (1 - of_cosine, back)],
        sine._make(_either(odd, *either) for either in zip(versine, sine, strict=True)),
        sine._make(_either(odd, *either) for either in zip(sine, versine, strict=True)),
    )


def _sign(bits: Traced, change: str) -> Sign:
    """Return -1 where the second last bit is set, once the bits are changed."""
    return Sign(bits.tape.number(f"(({bits.name}{change}) & 2) << 62"))


def _either(condition: Traced, one: Traced | float, other: Traced | float) -> Traced:
    tape = condition.tape
    return tape.number(f"({tape.name(one)} if {condition.name} else {tape.name(other)})")
