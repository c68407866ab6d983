"""Points of the rod as they are asked for, 0.5, 50%, 1/3, 500mm, beside the axis 0.5,0.1; and in drawings."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction

from kurbel.drive.crank import Crank
from kurbel.errors import NotationError, ProblemError
from kurbel.exact.kind import Kind
from kurbel.exact.numerals import Label, Number, exact_text, finite_decimals, nearest
from kurbel.kernel.circle import Numeric
from kurbel.kernel.coupler import Point as KernelPoint
from kurbel.page.steps import Joint, Line, Point, Scene
from kurbel.reading import notation, units
from kurbel.reading.given import as_fraction, as_share_or_length
from kurbel.reading.notation import about, plain, quoted

# Farther from the rod than that nobody asks, in rod lengths.
FARTHEST = 1000
# The ends by their letters in the books.
LETTERS: Mapping[str, Fraction] = {"A": Fraction(1), "B": Fraction(0)}
_WHAT = "point"
# What a German writes for 0.5 and 12.5 mm, and what is a place beside the axis with whole numbers.
_WHOLE = re.compile(r"\s*[-+−]?\d+\s*")
_PLAIN = re.compile(r"\s*\d+\s*")
_MEASURED = re.compile(r"\s*\d+\s*[^\d\s.].*")
EXAMPLE = "0.5, or 0.5,0.1 for one beside the axis of the rod"


@dataclass(frozen=True, slots=True)
class RodPoint:
    """A point at the share s of the rod from the crosshead pin B to the crank pin A, and t rod lengths beside
    it, on the side of the crank pin during the outstroke."""

    share: Fraction
    beside: Fraction = Fraction(0)

    def __post_init__(self) -> None:
        if max(abs(self.share), abs(self.beside)) > FARTHEST:
            raise ProblemError(
                f"the point is {about(max(self.share, self.beside, key=abs))} rod lengths away; at most"
                f" {FARTHEST} are computed, and 0 to 1 is the rod itself"
            )

    def on(self, kind: Kind) -> KernelPoint[Numeric]:
        """Return it on a kind of number."""
        return KernelPoint(kind.of(self.share), kind.of(self.beside) if self.beside else None)

    @property
    def is_pin(self) -> bool:
        """Whether it is the crank pin."""
        return self.share == 1 and not self.beside

    @property
    def label(self) -> Label:
        """What tells it from others: $s = 0.5$, beside the axis $s = 0.5$, $t = 0.1$."""
        own = f"$s = {exact_text(self.share)}$"
        return f"{own}, $t = {exact_text(self.beside)}$" if self.beside else own

    @property
    def text(self) -> str:
        """It as it is typed: 0.5, or 0.5,0.1."""
        parts = (self.share, self.beside) if self.beside else (self.share,)
        return ",".join(plain(one) if finite_decimals(one) is not None else str(one) for one in parts)

    def value(self, decimals: int | None) -> Number | Label:
        """Return what stands for it in records: a number, to so many decimals; None makes it a text."""
        return self.text if decimals is None else nearest(self.share, decimals)


def decimals_of(points: Sequence[RodPoint]) -> int | None:
    """Return how many decimals write all points as numbers, None if one of them is none."""
    counts = [None if one.beside else finite_decimals(one.share) for one in points]
    known = [count for count in counts if count is not None]
    return max(known) if len(known) == len(counts) else None


def points_of(given: object, cranks: Sequence[Crank]) -> tuple[RodPoint, ...]:
    """Return the points of lists and ranges, each once; lengths count in that of the rod of these cranks."""
    found = tuple(dict.fromkeys(_each(given, _length_of(cranks))))
    notation.check_length(len(found), notation.LONGEST_LIST, "points")
    if not found:
        raise NotationError(f"no point of the rod was given; write it as {EXAMPLE}")
    return found


def _each(given: object, one: Callable[[object], Fraction]) -> Iterator[RodPoint]:
    values = [given] if isinstance(given, str) or not isinstance(given, Iterable) else list(given)
    for value in values:
        if not isinstance(value, str):
            yield RodPoint(as_fraction(value))
            continue
        for part in value.split(";"):
            yield from _read(part, value, one)


def _read(part: str, whole: str, one: Callable[[object], Fraction]) -> Iterator[RodPoint]:
    if not part.strip():
        raise NotationError(f"{_WHAT} {quoted(whole)} has an empty place; write a list as '0;0.5;1'")
    if ".." in part:
        yield from map(RodPoint, notation.each_number([part], _WHAT, one))
        return
    share, comma, beside = part.partition(",")
    if comma:
        _check_comma(part, share, beside)
    try:
        yield RodPoint(one(share), one(beside) if comma else Fraction(0))
    except NotationError as error:
        if "add --" in str(error) or "ratio" in str(error):
            raise
        raise NotationError(
            f"{_WHAT} {quoted(part)} is no place on the rod; write its share from the crosshead pin to the"
            f" crank pin as {EXAMPLE}"
        ) from None


def _check_comma(part: str, share: str, beside: str) -> None:
    """Raise NotationError for commas that may be those of decimals."""
    figures = part.split(",")
    if len(figures) == 4 and all(map(_PLAIN.fullmatch, figures[1:])):
        first, second, third, fourth = (one.strip() for one in figures)
        raise NotationError(
            f"{_WHAT} {quoted(part)} has commas of decimals and one that parts them; write it as"
            f" {first}.{second},{third}.{fourth}"
        )
    if len(figures) > 2:
        raise NotationError(f"{_WHAT} {quoted(part)} has {len(figures)} parts; write a list as '0;0.5;1'")
    if _WHOLE.fullmatch(share) and _PLAIN.fullmatch(beside):
        first, second = share.strip(), beside.strip()
        raise NotationError(
            f"{_WHAT} {quoted(part)} could be the share {first}.{second}, or a point {second} rod lengths"
            f" beside the axis; write {first}.{second}, or {first}.0,{second}.0"
        )
    if _WHOLE.fullmatch(share) and _MEASURED.fullmatch(beside):
        raise NotationError(
            f"{_WHAT} {quoted(part)} could be one number or two; write {share.strip()}.{beside.strip()}, or a"
            " point beside the axis with the unit at both, such as 500mm,20mm"
        )


def _length_of(cranks: Sequence[Crank]) -> Callable[[object], Fraction]:
    """Return the reader of a share of the rod, or of a length."""
    lengths = {crank.rod_length for crank in cranks}

    def read(given: object) -> Fraction:
        if not isinstance(given, str):
            return as_fraction(given)
        text = given.strip().removesuffix("L").strip()
        if text in LETTERS:
            return LETTERS[text]
        if not units.is_measure(text):
            return as_share_or_length(text, _WHAT, None, "")
        measured = units.displacement(text, _WHAT)
        if len(lengths) > 1:
            raise NotationError(
                f"{_WHAT} {quoted(text)} is a length, and the rods of several ratios have several; give it as"
                " a share of the rod, such as 0.5"
            )
        (whole,) = lengths
        if whole is None:
            raise NotationError(
                f"{_WHAT} {quoted(text)} is a length, but that of the rod is not known; add --rod, for"
                " example --rod 1500mm, or give a share of the rod, such as 0.5"
            )
        return measured / whole

    return read


# What paths leave free beyond them, in R.
ROOM = 0.25


def carried(pin: Point, end: Point, share: float, beside: float) -> Point:
    """Return a point of a rod from its driven end to the crank pin, and beside it by so many of its lengths,
    above a rod that leads to the left."""
    along, up = pin[0] - end[0], pin[1] - end[1]
    return end[0] + share * along + beside * up, end[1] + share * up - beside * along


def paths_of(points: Sequence[RodPoint], scene: Scene) -> Iterator[Joint]:
    """Yield where points on the rod of what moves are, at equal steps of a turn."""
    rod = next(link for link in scene.links if link.kind == "rod")
    for one in points:
        share, beside = float(one.share), float(one.beside)
        yield tuple(carried(pin, end, share, beside) for pin, end in zip(rod.start, rod.end, strict=True))


def with_points(scene: Scene, points: Sequence[RodPoint], whole: Scene | None = None) -> Scene:
    """Return what moves with points of its rod as pins, and their paths, which are those of a whole turn."""
    paths = tuple(paths_of(points, whole or scene))
    xs, ys = zip(*(place for path in paths for place in path), strict=True)
    return scene._replace(
        low=(min(scene.low[0], min(xs) - ROOM), min(scene.low[1], min(ys) - ROOM)),
        high=(max(scene.high[0], max(xs) + ROOM), max(scene.high[1], max(ys) + ROOM)),
        fixed=(*scene.fixed, *(Line("centre", (*path, path[0])) for path in paths)),
        pins=(*scene.pins, *paths_of(points, scene)),
    )
