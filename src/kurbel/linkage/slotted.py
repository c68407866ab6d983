"""The slotted lever as a mechanism: crank and slotted lever, Whitworth's return; see kernel/slotted.py."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cache, partial
from typing import Any

from kurbel.drive.at import At, known
from kurbel.drive.crank import LONGEST_ROD, RODLESS, Crank, DescribedDrive, radii
from kurbel.errors import ProblemError
from kurbel.exact.kind import Kind
from kurbel.exact.numerals import Label, exact_text
from kurbel.kernel import slotted as kernel
from kurbel.kernel.circle import Circle, Numeric, root
from kurbel.kernel.linkage import half_sine
from kurbel.kernel.slotted import Lever, Links
from kurbel.linkage.linkage import (
    Linkage,
    LinkageDrive,
    LinkageMechanism,
    LinkagePosition,
    LinkageRequest,
    Outline,
    Point,
    in_strokes,
    linkage_subject,
    plain_notes,
)
from kurbel.motion.drives import AT_REST
from kurbel.motion.entries import OF_ROD, headed, in_units, measured
from kurbel.motion.evaluation import OUT
from kurbel.motion.motion_quantities import FORCES, Force, force_entries, torque_entries
from kurbel.motion.notes import digits_text
from kurbel.page.quantity import Formula, Of, Quantity, filled, words
from kurbel.reading.given import as_number
from kurbel.reading.notation import about, check_bounds

TITLE = words("Kurbelschleife|Slotted lever")


@dataclass(frozen=True, slots=True)
class SlottedLever(Linkage):
    """A slotted lever: its pivot D beside the shaft, its arm B, a rod L that moves a ram on a line e from the
    shaft, away from the pivot, and whether the ram is ahead of the lever on the outstroke (1) or behind (-1).

    All are in units of R; without a rod the ram has the way of the arm's end along the slide, and no line.
    Valid for D other than R, and where the rod closes and the ram turns only at its two dead centres.
    """

    pivot: Fraction
    arm: Fraction
    rod: Fraction | None = None
    offset: Fraction | None = None
    circuit: Fraction | int = 1
    crank: Crank = RODLESS

    def __post_init__(self) -> None:
        for name, length in (("pivot", self.pivot), ("rocker", self.arm), ("rod", self.rod or Fraction(1))):
            check_bounds(
                f"the {name} of the slotted lever", length, f"be above 0 and at most {LONGEST_ROD} R", " R"
            )
        if self.pivot == 1:
            raise ProblemError(
                "the pivot of the slotted lever is as far from the shaft as the crank is long, and the block"
                " meets it; with --pivot above 1 the lever swings, below 1 it is carried round"
            )
        if self.circuit not in (1, -1):
            raise ProblemError(
                f"circuit is {self.circuit}; it must be 1 or -1, the ram ahead of the lever or behind it"
            )
        if self.rod is None:
            if self.offset is not None:
                raise ProblemError(
                    "--offset is where the ram of a rod slides; add --rod, or leave --offset out"
                )
        elif self.offset is None and self.swings:
            raise ProblemError(
                "the ram needs the line on which it slides; add --offset, its distance from the shaft on the"
                " other side than the pivot, for example --offset 1"
            )
        else:
            self._check_rod(self.rod)

    @property
    def swings(self) -> bool:
        """Whether the lever swings (crank and slotted lever), or is carried round (Whitworth)."""
        return self.pivot > 1

    @property
    def height(self) -> Fraction:
        """h, by which the ram's line lies above the pivot; through it where nothing else is said."""
        return Fraction(0) if self.offset is None else self.pivot + self.offset

    def _check_rod(self, rod: Fraction) -> None:
        height, arm = self.height, self.arm
        if not self.swings:
            if abs(height) + arm >= rod:
                raise ProblemError(
                    f"the rod is {about(rod)} R; it must be longer than {about(abs(height) + arm)} R, or the"
                    " lever is not carried round"
                )
            return
        # cos² of the lever where it turns; there the rod comes nearest to be in line with it.
        least = 1 - 1 / (self.pivot * self.pivot)
        in_line = rod + arm if height > 0 else rod - arm
        if abs(height - arm) >= rod or (in_line > 0) == (height * height >= in_line * in_line * least):
            raise ProblemError(
                f"a rod of {about(rod)} R on an arm of {about(arm)} R, with the ram's line {about(height)} R"
                " above the pivot, does not move the ram once to and fro; make the rod longer or the line"
                " nearer to the arm's end"
            )

    def links(self, stroke: int, kind: Kind) -> Links[Numeric]:
        """Return the lengths with the sign of the stroke."""
        ratio = Fraction(0) if self.rod is None else stroke * self.circuit / self.rod
        of = kind.of
        return Links(of(stroke * self.pivot), of(self.arm), of(self.height), of(ratio), stroke)

    def place(self, stroke: int, circle: Circle[Numeric], kind: Kind) -> Any:
        return kernel.lever(circle, self.links(stroke, kind))

    def at(self, stroke: int, circle: Circle[Numeric], numbers: Kind, method: str, of: object = None) -> At:
        """Return the place of the lever, with its lengths for the kernel."""
        links = self.links(stroke, numbers)
        return At(circle, self, numbers, stroke, place=kernel.lever(circle, links), arc=links)

    def dead_angle(self, stroke: int, kind: Kind) -> Numeric:
        """Return φ_i, or for RETURN φ_o - 180°, in degrees within ±90°."""
        return kind.arc(kernel.dead_crank_sine(self.links(stroke, kind), self.swings))

    def way(self, kind: Kind) -> Numeric:
        """Return the stroke of the ram in units of R."""
        if self.swings:
            return kind.of(2 * self.arm / self.pivot)
        links = self.links(int(self.circuit), kind)
        tilt = links.height * links.ratio
        ends = (root((1 + sign * links.arm * links.ratio) ** 2 - tilt * tilt) for sign in (1, -1))
        return 4 * links.arm / sum(ends)

    def swing(self, kind: Kind) -> Numeric:
        """Return the lever's swing in degrees, a whole turn if it is carried round."""
        return 2 * kind.arc(kind.of(1 / self.pivot)) if self.swings else kind.of(Fraction(360))

    def least_transmission(self, kind: Kind) -> Numeric:
        """Return the least angle between the rod and the square to the slide, in degrees."""
        at_dead_centre = root(kind.of(1 - 1 / self.pivot**2)) if self.swings else kind.of(Fraction(-1))
        links = self.links(OUT, kind)
        ends = (links.height - links.arm, links.height - links.arm * at_dead_centre)
        return 90 - kind.arc(max(abs(links.ratio * one) for one in ends))

    def outline(self) -> Outline:
        pivot, arm, height = map(float, (self.pivot, self.arm, self.height))
        rod = float(self.rod or 0)
        stand = partial(_stand, -pivot, arm, height - pivot, -self.circuit * rod)
        far = arm / pivot if self.swings else arm
        left, right = -max(1.0, far), max(1.0, far)
        sides = (left - rod, right) if self.circuit == 1 else (left, right + rod)
        low = -pivot - (0 if self.swings else max(arm, 1 - pivot))
        lines = (0.0, height - pivot) if rod else (0.0,)
        high = max(1.0, arm - pivot, *lines)
        return Outline(TITLE, ((0, 0),), *sides, stand, min(low, -1.0), high, ((0.0, -pivot),), lines)


def _stand(pivot: float, arm: float, line: float, rod: float, pin: Point) -> LinkagePosition:
    shaft, foot = (0.0, 0.0), (0.0, pivot)
    along, up = pin[0], pin[1] - pivot
    reach = (along * along + up * up) ** 0.5
    end = (arm * along / reach, pivot + arm * up / reach)
    # The lever reaches the block, too.
    tip = end if arm > reach else pin
    links = {"crank": (shaft, pin), "lever": (foot, tip)}
    chains: tuple[tuple[Point, ...], ...] = ((shaft, pin), (foot, tip))
    pins: tuple[Point, ...] = (pin,)
    letters = [("lever", "$B$", 0.8)]
    if rod:
        rise = line - end[1]
        way = (rod * rod - rise * rise) ** 0.5
        ram = (end[0] + (way if rod > 0 else -way), line)
        links["rod"] = (end, ram)
        chains, pins, letters = (*chains, (end, ram)), (pin, end, ram), [*letters, ("rod", "$L$", 0.5)]
    return LinkagePosition(links, pins, chains, tuple(letters))


# Lengths are in units of R; what letters stand for is printed once.
_Q, _SIGMA = "$q = 1 + D^2 + 2 D sin φ$", "$sin σ = (h - B cos θ)/L$"
_THETA = "$tan θ = -(cos φ)/(D + sin φ)$"
_PLACE = (_Q, _THETA, _SIGMA)
_TURNING, _GAIN = "$ω_B/ω = (1 + D sin φ)/q$", "$ε_B/ω^2 = (D (D^2 - 1) cos φ)/q^2$"
_SLIDING, _VELOCITY = "$w/v = (D cos φ)/sqrt(q)$", "$c/v = ω_B/ω B cos(θ + σ)/(cos σ)$"
# What becomes of formulas without a rod of the ram, σ = 0.
_RODLESS = (
    *((", " + _SIGMA, ""), (" + L (cos σ - cos σ_i)", ""), ("= 1/(cos σ)", "= 1"), ("= tan σ", "= 0")),
    ("(sin(θ + σ)/(cos σ) + (B sin^2 θ)/(L cos^3 σ))", "sin θ"),
    *(("cos(θ + σ)/(cos σ)", "cos θ"), ("cos(θ + σ)/(sqrt(q) cos σ)", "(cos θ)/sqrt(q)")),
)


def _lever_angle(at: At) -> Numeric:
    place: Lever[Numeric] = at.place
    if at.drive.swings:
        return at.stroke * at.numbers.arc(place.sine)
    if at.degrees is None:
        # From -90° on as well, where the lever lies along the slide.
        return 90 + 2 * at.numbers.arc(half_sine(-place.cosine, at.stroke * place.sine))
    between = at.numbers.arc(-at.arc.pivot * at.circle.cosine / place.reach)
    turned = at.degrees - 90 * at.stroke
    return (at.numbers.of(turned) if isinstance(turned, Fraction) else turned) - between


def _of(kernel_function: Callable[..., Numeric], printed: Label, symbols: tuple[Label, ...] = ()) -> Formula:
    return Formula(lambda at: kernel_function(at.place, at.arc), printed, symbols)


def _path(at: At) -> Numeric:
    return kernel.path(at.place, at.arc, at.drive.swings)


@cache
def slotted_registry() -> Mapping[str, Quantity]:
    """Return every quantity of the slotted lever by its key."""
    return {one.key: one for one in (*_motion(), *_forces())}


def _motion() -> Iterator[Quantity]:
    yield headed("lever", "Hebelwinkel|Lever angle", "θ", "°", Formula(_lever_angle, _THETA))
    formula = Formula(_path, "$x/R = B (sin θ - sin θ_i) + L (cos σ - cos σ_i)$", (_THETA, _SIGMA))
    path = headed("path", "Weg|Path", "x", "R", formula, names=("path", "x"), rises=True)
    yield from (path, in_strokes(path), measured(path))
    rows: tuple[tuple[str, str, str, str, Formula], ...] = (
        ("lever_velocity", "Winkelgeschwindigkeit des Hebels|Angular velocity of the lever", "ω_B", "ω",
         Formula(lambda at: at.place.turning, _TURNING, (_Q,))),
        ("lever_acceleration", "Winkelbeschleunigung des Hebels|Angular acceleration of the lever", "ε_B",
         "ω²", Formula(lambda at: at.place.gain, _GAIN, (_Q,))),
        ("block_velocity", "Gleitgeschwindigkeit des Steins|Rubbing velocity of the block", "w", "v",
         Formula(lambda at: at.place.slide, _SLIDING, (_Q,))),
        ("coriolis", "Coriolisbeschleunigung|Acceleration of Coriolis", "p_C", "v²/R",
         Formula(lambda at: kernel.coriolis(at.place), "$(p_C R)/v^2 = 2 ω_B/ω w/v$",
                 (_SLIDING, _TURNING, _Q))),
        ("rod_velocity", "Winkelgeschwindigkeit der Stange|Angular velocity of the rod", "ω_L", "ω",
         _of(kernel.rod_velocity, "$ω_L/ω = (B sin θ)/(L cos σ) ω_B/ω$", (_TURNING, *_PLACE))),
        ("rod_acceleration", "Winkelbeschleunigung der Stange|Angular acceleration of the rod", "ε_L", "ω²",
         _of(kernel.rod_acceleration, "$ε_L/ω^2 = B/(L cos σ) (ε_B/ω^2 sin θ + ω_B^2/ω^2 cos θ)"
             " + ω_L^2/ω^2 tan σ$", (_TURNING, _GAIN, *_PLACE))),
        ("velocity", "Geschwindigkeit|Velocity", "c", "v",
         _of(kernel.velocity, _VELOCITY, (_TURNING, *_PLACE))),
        ("acceleration", "Beschleunigung|Acceleration", "p", "v²/R",
         _of(kernel.acceleration, "$(p R)/v^2 = ε_B/ω^2 B cos(θ + σ)/(cos σ)"
             " - ω_B^2/ω^2 B (sin(θ + σ)/(cos σ) + (B sin^2 θ)/(L cos^3 σ))$", (_TURNING, _GAIN, *_PLACE))),
    )  # fmt: skip
    for key, *said in rows:
        names = (key, str(said[1])) if said[1] in ("c", "p") else (key,)
        yield from in_units(key, *said, names=names, direction=OF_ROD if key.startswith("rod") else None)


_FORCES: Mapping[str, tuple[Force, Formula]] = {
    "rod_force": (
        Force("Stangenkraft|Rod force", "S", "$S$ längs der Stange, in der Richtung des Hubes"
              "|$S$ along the rod, in the direction of the stroke"),
        Formula(lambda at: 1 / at.place.slant_cosine, "$S/F = 1/(cos σ)$", (_SIGMA,)),
    ),
    "guide_force": (
        Force("Führungsdruck|Guide force", "N", "$N$ auf den Stößel, vom Drehpunkt weg"
              "|$N$ on the ram, away from the pivot"),
        Formula(lambda at: at.place.slant / at.place.slant_cosine + 0, "$N/F = tan σ$", (_SIGMA,)),
    ),
    "block_force": (
        Force("Kraft am Stein|Block force", "Q", "$Q$ des Hebels auf den Stein, bei aufrechtem Hebel in der"
              " Richtung des Hubes|$Q$ of the lever on the block, with the lever upright in the direction of"
              " the stroke"),
        Formula(lambda at: kernel.block_force(at.place), "$Q/F = B cos(θ + σ)/(sqrt(q) cos σ)$", _PLACE),
    ),
    "tangential_force": (
        FORCES["tangential_force"], _of(kernel.velocity, "$T/F = c/v$", (_VELOCITY, _TURNING)),
    ),
    "radial_force": (
        FORCES["radial_force"],
        Formula(lambda at: kernel.radial_force(at.place, at.circle, at.arc), "$Z/F = Q/F (D cos φ)/sqrt(q)$"),
    ),
}  # fmt: skip


def _forces() -> Iterator[Quantity]:
    for key, (force, formula) in _FORCES.items():
        yield from force_entries(key, force, {"exact": formula}, {"exact": formula}, of=Of.FORCE)
    torque = {"exact": _of(kernel.velocity, "$M_d/(F R) = T/F$")}
    yield from torque_entries(torque, torque, of=Of.FORCE)


class SlottedDrive(LinkageDrive):
    """The slotted lever as conditions see it; where quantities rise and fall is proved by balls."""

    def is_free(self, quantity: Quantity) -> bool:
        return False

    @property
    def at_rest(self) -> tuple[str, ...]:  # type: ignore[override]
        # Where the lever swings it rests there, too.
        return (*AT_REST, "lever_velocity", "coriolis", "rod_velocity") if self.drive.swings else AT_REST


_PLAIN = plain_notes(
    words("$F$ auf den Stößel, in der Richtung des Hubes|$F$ on the ram, in the direction of the stroke"),
    words(
        "$φ$ von der Schubrichtung, bei 90° ist der Kurbelzapfen dem Drehpunkt des Hebels am fernsten; $θ$ im"
        " Drehsinn der Kurbel von der Mittellinie; Längen der Formeln in Kurbelhalbmessern"
        "|$φ$ from the slide direction, at 90° the crank pin is farthest from the lever's pivot; $θ$ from the"
        " line of centres as the crank turns; lengths of formulas in crank radii"
    ),
)
LINE = words(
    "{lengths}: Totlagen $φ_i = {inner}°$ und $φ_o = {outer}°$, Hub ${stroke} R$, Zeitverhältnis Hingang zu"
    " Rückgang ${times}:1$"
    "|{lengths}: dead centres at $φ_i = {inner}°$ and $φ_o = {outer}°$, stroke ${stroke} R$, times of"
    " outstroke and return ${times}:1$"
)


def _notes(question: LinkageRequest) -> Iterator[Label]:
    rodless = all(drive.rod is None for drive in question.drives)
    for line in _PLAIN(question):
        yield filled(line, _RODLESS if rodless else ())
    if any(column.quantity.direction is OF_ROD for column in question.page_columns):
        yield OF_ROD[question.lang]
    for drive in question.drives:
        yield LINE[question.lang].format(
            lengths=", ".join(MECHANISM.lengths(drive)),
            inner=digits_text(drive.inner, 3),
            outer=digits_text(drive.outer, 3),
            stroke=digits_text(drive.way, 4),
            times=digits_text(drive.time_ratio, 4),
        )


SUBJECT = linkage_subject(
    "slotted lever",
    layout="slotted",
    command="table --mechanism slotted",
    quantities=slotted_registry,
    notes=_notes,
)


class Slotted(LinkageMechanism):
    name = "slotted"
    title = "the slotted lever"
    layout = "slotted"
    forces_layout = "forces-slotted"
    heavy = False
    quick = True
    takes = ("stroke", "rod", "speed", "offset", "rocker", "pivot", "circuit")
    motion = (("path", "path"), ("velocity", "velocity"), ("acceleration", "acceleration"))

    def lacking(self, said: DescribedDrive) -> str:
        if said.pivot is not None:
            return ""
        return "the slotted lever needs the place of its pivot; add --pivot, for example --pivot 2"

    def lengths(self, drive: SlottedLever) -> list[Label]:
        """Return the lengths of a drive with their letters."""
        rod = "∞" if drive.rod is None else f"{exact_text(drive.rod)} R"
        lengths = [f"$D = {exact_text(drive.pivot)} R$", f"$B = {exact_text(drive.arm)} R$", f"$L = {rod}$"]
        return lengths if drive.rod is None else [*lengths, f"$h = {exact_text(drive.height)} R$"]

    def drives(self, said: DescribedDrive, ratios: Sequence[str]) -> tuple[SlottedLever, ...]:
        crank = said.rodless

        def length(name: str) -> Fraction | None:
            given = getattr(said, name)
            return None if given is None else radii(given, name, crank.radius)

        pivot = known(length("pivot"))
        # Long enough for the block, where it is farthest from the pivot.
        arm = length("rocker") or pivot + 1
        circuit, rod = 1 if said.circuit is None else as_number(said.circuit, "circuit"), length("rod")
        if rod is not None:
            if rod <= 1:
                raise ProblemError(
                    f"the rod is {about(rod)} R; slotted levers with a rod of at most R are not computed"
                )
            crank = replace(crank, ratio=1 / rod)
        return (SlottedLever(pivot, arm, rod, length("offset"), circuit, crank),)

    def solved(self, drives: Sequence[SlottedLever], method: str | None) -> tuple[SlottedDrive, ...]:
        return tuple(SlottedDrive(one, self.layout) for one in drives)


MECHANISM = Slotted()
