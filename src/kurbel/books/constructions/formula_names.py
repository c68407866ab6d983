"""What formulas of constructions may name beside their points: of the drive, and true values by the kernel.

Lengths are in units of R, velocities in those of the crank pin's v, accelerations in v²/R, forces in those of
the piston force, or of M v²/R.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from operator import attrgetter
from typing import TYPE_CHECKING, NamedTuple, TypeAlias

from kurbel.books.constructions.placed import PlacedDrive, Point
from kurbel.drive.moved import Moved
from kurbel.exact.certify import ball
from kurbel.exact.kind import floats
from kurbel.kernel import beam, forces, kinematics, linkage, slotted
from kurbel.kernel.circle import Circle, Numeric, root
from kurbel.kernel.forces import mean_force
from kurbel.kernel.parts import COMMON, STRETCHING, TURNING
from kurbel.kernel.steam import logarithm
from kurbel.linkage.beam_engine import LOWER, UPPER, BeamEngine, chord_square
from kurbel.motion.evaluation import OUT, RETURN

if TYPE_CHECKING:
    from flint import arb

POINT, NUMBER = "point", "number"
CRANKS = ("straight", "offset")
ARC, BEAM, SLOTTED = ("arc",), ("beam",), ("slotted",)
TURN = 360


OfPlace: TypeAlias = Callable[[PlacedDrive], Numeric]


class Known(NamedTuple):
    """What a name stands for: a point or a number, of which mechanisms, and how it is computed."""

    gives: str
    value: Callable[[PlacedDrive], Numeric | Point]
    of: tuple[str, ...] = ()


class DriveFunction(NamedTuple):
    """A function of the drive: what it takes and gives, and how it is computed."""

    takes: tuple[str, ...]
    gives: str
    apply: Callable[..., Numeric | Point]
    of: tuple[str, ...]


def _of_crank(kernel: Callable[..., Numeric], way: int = 1) -> OfPlace:
    """Return a kernel formula of the crank, on the return stroke (-1) from its own dead centre."""
    return lambda at: kernel(at.circle, way * at.ratio, way * at.offset if at.drive.offset else None)


def _of_rocker(kernel: Callable[..., Numeric], stroke: int = OUT) -> OfPlace:
    def found(at: PlacedDrive) -> Numeric:
        stands = at.linked if stroke == OUT else at.drive.at(stroke, at.circle, at.kind, "exact")
        return kernel(stands.place, stands.arc)

    return found


def _either(crank: OfPlace, rocker: OfPlace) -> OfPlace:
    return lambda at: rocker(at) if at.guided else crank(at)


_rod_velocity = _either(_of_crank(kinematics.rod_velocity), _of_rocker(linkage.rod_velocity))
_rod_acceleration = _either(_of_crank(kinematics.rod_acceleration), _of_rocker(linkage.rod_acceleration))
_velocity = _either(_of_crank(kinematics.piston_velocity), _of_rocker(linkage.velocity))


def _common(at: PlacedDrive) -> Numeric:
    """Return p₂: along the slide with its sign, on the arc of a rocker its amount."""
    common = at.parted.common
    return common.size() if at.guided else common.along


def _stroke(at: PlacedDrive) -> int:
    """Return 0 on the outstroke and 1 on the return."""
    moved = at.drive.moved(floats(), "exact")
    begin, end = (180 * (stroke + float(moved.dead_centre(stroke))) for stroke in (0, 1))
    return 0 if begin <= (float(at.angle) - begin) % TURN + begin < end else 1


def _from_dead_centre(at: PlacedDrive) -> Circle[Numeric]:
    return at.kind.circle(at.angle - 180 * _stroke(at))


def _moved(at: PlacedDrive) -> Moved:
    found: Moved = at.drive.moved(at.kind, "exact")
    return found


def _share(at: PlacedDrive) -> Numeric:
    """Return the share of the stroke that the piston has gone."""
    moved = _moved(at)
    return moved.path(_stroke(at), _from_dead_centre(at)) / moved.length


def _steam_force(at: PlacedDrive) -> Numeric:
    """Return P on the piston, over Q."""
    steam = at.beside.steam
    if steam is None:
        return at.number(1)
    acting = steam.numbers(at.kind.of, at.kind.exponent)
    return acting.pressure(_share(at)) - acting.back


def _tangential(at: PlacedDrive) -> Numeric:
    """Return T of the stroke, over Q."""
    moved = _moved(at)
    return _steam_force(at) * moved.velocity(_stroke(at), _from_dead_centre(at))


def _mean(at: PlacedDrive) -> Numeric:
    """Return the constant tangential pressure that does as much work, by the kernel."""
    length = _moved(at).length
    if at.beside.steam is None:
        return length / at.kind.pi
    return mean_force(at.beside.steam.strokes(at.kind, True), at.kind.pi, length)


def _work_over_turn(at: PlacedDrive) -> Numeric:
    """Return the same by Weisbach's P, with the work of the stroke over that of the half circle."""
    length, steam = _moved(at).length, at.beside.steam
    if steam is None:
        return length / at.kind.pi
    ratio = at.number(steam.expansion)
    back = 1 / ratio if steam.back is None else at.number(steam.back)
    return length / at.kind.pi * ((1 + logarithm(ratio)) / ratio - back)


def _beam(value: Callable[[BeamEngine, arb], arb]) -> OfPlace:
    """Return what the beam engine has in truth, from q²/r²."""

    def found(at: PlacedDrive) -> Numeric:
        engine = BeamEngine(at.drive.arm, at.drive.crank.ratio)
        return at.kind.enclosed(lambda: value(engine, chord_square(engine)))

    return found


def _lean(side: int) -> OfPlace:
    """Return by how much the rod leans at a dead centre, in radians."""
    return _beam(lambda engine, square: ball(beam.lean_sine(square, *engine.numbers(side))).asin())


def _points(of: tuple[str, ...], **values: Callable[[PlacedDrive], Point]) -> dict[str, Known]:
    return {name: Known(POINT, value, of) for name, value in values.items()}


def _numbers(of: tuple[str, ...], **values: OfPlace) -> dict[str, Known]:
    return {name: Known(NUMBER, value, of) for name, value in values.items()}


KNOWN: Mapping[str, Known] = {
    **_points(
        (),
        shaft=lambda at: Point(at.number(0), at.number(0)),
        pin=attrgetter("pin"),
        along=lambda at: Point(at.number(1), at.number(0)),
        up=lambda at: Point(at.number(0), at.number(1)),
    ),
    **_points((*CRANKS, *ARC), end=attrgetter("end")),
    **_points(ARC, pivot=attrgetter("pivot")),
    **_points(SLOTTED, bearing=attrgetter("bearing"), tip=attrgetter("tip")),
    **_numbers(
        (),
        rod=attrgetter("rod"),
        ratio=attrgetter("ratio"),
        angle=lambda at: at.number(at.angle),
        sine=lambda at: at.circle.sine,
        cosine=lambda at: at.circle.cosine,
        versine=lambda at: at.circle.versine,
        # Of a point of the rod, its centre of mass and its radius of gyration, in rod lengths from its end.
        share=lambda at: at.number(at.beside.point),
        centre=lambda at: at.number(1 - at.mass.centre),
        gyration=lambda at: root(at.number(at.mass.gyration_square)),
    ),
    **_numbers((), pi=lambda at: at.kind.pi),
    **_numbers(
        CRANKS,
        offset=attrgetter("offset"),
        # 0 on the outstroke, 1 on the return.
        stroke=lambda at: at.number(_stroke(at)),
        force=_steam_force,
        pressure=_tangential,
    ),
    **_numbers(CRANKS, mean_pressure=_mean, mean_work=_work_over_turn),
    **_numbers(
        CRANKS,
        path=_of_crank(kinematics.piston_path),
        path_return=_of_crank(kinematics.piston_path, -1),
        guide_force=_of_crank(forces.guide_force),
        rod_force=_of_crank(forces.rod_force),
        tangential_force=_of_crank(forces.tangential_force),
        radial_force=_of_crank(forces.radial_force),
    ),
    **_numbers(
        (*CRANKS, *ARC),
        velocity=_velocity,
        acceleration=_either(
            _of_crank(kinematics.piston_acceleration),
            _of_rocker(linkage.acceleration),
        ),
        # Of the rod's end about the crank pin.
        swing=lambda at: abs(at.rod * _rod_velocity(at)),
        # u²/L.
        normal=lambda at: at.rod * _rod_velocity(at) ** 2,
        tangential=lambda at: abs(at.rod * _rod_acceleration(at)),
        # The rod's acceleration in parts, and the masses in its ends that have their forces.
        common=_common,
        replaced=lambda at: at.parted.replaced_size(),
        turning=lambda at: at.parted.turning,
        stretching=lambda at: at.parted.stretching,
        mass_in_pin=lambda at: at.parted.mass_in_pin(COMMON),
        mass_in_end=lambda at: at.parted.mass_in_crosshead(COMMON),
        turning_mass_in_pin=lambda at: at.parted.mass_in_pin(TURNING),
        turning_mass_in_end=lambda at: at.parted.mass_in_crosshead(TURNING),
        stretching_mass=lambda at: at.parted.mass_in_pin(STRETCHING),
    ),
    **_numbers(
        ARC,
        rocker=lambda at: at.number(at.drive.rocker),
        curvature=lambda at: at.number(at.drive.curvature),
        chord=_of_rocker(linkage.chord),
        chord_return=_of_rocker(linkage.chord, RETURN),
        # c²/B.
        centripetal=lambda at: abs(at.linked.arc.curvature) * _velocity(at) ** 2,
    ),
    **_numbers((*BEAM, *SLOTTED), arm=lambda at: at.number(at.drive.arm)),
    **_numbers(
        SLOTTED,
        lever_velocity=lambda at: at.linked.place.turning,
        block_velocity=lambda at: at.linked.place.slide,
        coriolis=lambda at: slotted.coriolis(at.linked.place),
    ),
    **_numbers(
        BEAM,
        sagitta=_beam(lambda engine, square: ball(beam.sagitta(square, ball(engine.arm)))),
        upper_lean=_lean(UPPER),
        lower_lean=_lean(LOWER),
    ),
}
FUNCTIONS_OF_DRIVE: Mapping[str, DriveFunction] = {
    "crosshead": DriveFunction((POINT,), POINT, PlacedDrive.crosshead, CRANKS),
    "end_on_rocker": DriveFunction((POINT, NUMBER), POINT, PlacedDrive.end_on_rocker, ARC),
    # The acceleration of a point of the rod, by its share from the end on.
    "accelerated": DriveFunction(
        (NUMBER,), NUMBER, lambda at, share: at.parted.at_point(share).size(), (*CRANKS, *ARC)
    ),
}
