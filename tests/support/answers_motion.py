"""Problems on motion: the triangle of crank and rod, differentiated numerically in 30 digits."""

from __future__ import annotations

from collections.abc import Callable

from mpmath import (
    acos,
    arg,
    asin,
    cos,
    degrees,
    diff,
    expj,
    findroot,
    lu_solve,
    matrix,
    mpc,
    mpf,
    pi,
    radians,
    sign,
    sin,
    sqrt,
)
from problem_answers import Rows, solution


def path(phi: mpf, crank: mpf, rod: mpf) -> mpf:
    """How far the piston is from the inner dead centre: the triangle's third side, taken from its longest."""
    return crank + rod - crank * cos(phi) - sqrt(rod**2 - (crank * sin(phi)) ** 2)


def place(angle: mpf, crank: mpf, rod: mpf, speed: mpf) -> dict[str, mpf]:
    """Path, velocity and acceleration there, in mm, m/s, m/s²."""

    def at(phi: mpf) -> mpf:
        return path(phi, crank, rod)

    phi = radians(angle)
    return {"x_mm": at(phi) * 1000, "c_mps": diff(at, phi) * speed, "p_mps2": diff(at, phi, 2) * speed**2}


def angle_of(condition: Callable[[mpf], mpf], low: float, high: float) -> mpf:
    """The angle in degrees between two at which a condition changes its sign."""
    bounds = (radians(mpf(low)), radians(mpf(high)))
    return degrees(findroot(condition, bounds, solver="anderson", tol=mpf(10) ** -24))


def turning(crank: mpf, rod: mpf, speed: mpf, angle: mpf) -> dict[str, mpf]:
    """Velocity and acceleration of the rod there."""
    lean, phi = lambda phi: asin(crank * sin(phi) / rod), radians(angle)
    once, twice = diff(lean, phi) * speed, diff(lean, phi, 2) * speed**2
    return {"rod_velocity_radps": once, "rod_acceleration_radps2": twice}


@solution
def piston_at_an_angle(stroke: mpf, rod: mpf, speed: mpf, angle: mpf) -> Rows:
    return [place(angle, stroke / 2, rod, speed)]


@solution
def greatest_velocity_first_order(crank: mpf, rod: mpf, speed: mpf) -> Rows:
    ratio = crank / rod
    phi = acos((sqrt(1 + 8 * ratio**2) - 1) / (4 * ratio))
    velocity = crank * speed * (sin(phi) + ratio / 2 * sin(2 * phi))
    return [{"phi": degrees(phi), "c_mps": velocity}, {"phi": 180 - degrees(phi), "c_mps": velocity}]


@solution
def greatest_velocity(crank: mpf, rod: mpf, speed: mpf) -> Rows:
    def at(phi: mpf) -> mpf:
        return path(phi, crank, rod)

    fastest = angle_of(lambda phi: diff(at, phi, 2), 60, 90)
    top = place(fastest, crank, rod, speed)["c_mps"]
    # On the return the third derivative vanishes between the dead centre and the quarter turn.
    slow = angle_of(lambda phi: diff(at, phi, 3), 181, 230)
    least = place(slow, crank, rod, speed)
    return [
        {"phi": fastest, "c_mps": top, "p_mps2": 0},
        {"phi": 180 - fastest, "c_mps": top, "p_mps2": 0},
        {"phi": 0, "p_mps2": place(mpf(0), crank, rod, speed)["p_mps2"]},
        {"phi": slow - 180, "c_mps": -least["c_mps"], "p_mps2": -least["p_mps2"]},
    ]


@solution
def rod_turns(crank: mpf, rod: mpf, speed: mpf, pin: mpf, big: mpf, angle: mpf) -> Rows:
    piston = place(angle, crank, rod, speed)["c_mps"]

    def size(share: mpf) -> mpf:
        """The velocity of a point of the rod, whose ends move as the piston and square to the crank."""
        ends = mpc(-piston), crank * speed * 1j * expj(radians(angle))
        return abs(ends[0] * (1 - share) + ends[1] * share)

    turned, slowest = turning(crank, rod, speed, angle), findroot(lambda one: diff(size, one), mpf("0.1"))
    rates = {"crosshead_pin": (0, pin), "crank_pin": (speed, big)}
    rubbed = {
        f"{name}_rubbing_mps": (turned["rod_velocity_radps"] + own) * wide / 2
        for name, (own, wide) in rates.items()
    }
    found = {"slowest_point": slowest, "rod_along_mps": size(slowest) * sign(piston), **turned, **rubbed}
    return [{"psi": degrees(asin(crank * sin(radians(angle)) / rod)), **found}]


@solution
def where_the_rod_works_hardest(crank: mpf, rod: mpf, speed: mpf) -> Rows:
    lean = degrees(asin(crank / rod))
    return [
        {"phi_turn": 90, "psi": lean, "rod_velocity_radps": 0},
        {"phi_turn": 270, "psi": -lean, "rod_velocity_radps": 0},
        {"phi_turn": 0, "psi": 0, "rod_velocity_radps": speed * crank / rod},
    ]


@solution
def offset_stroke(crank: mpf, rod: mpf, offset: mpf) -> Rows:
    inner, outer = asin(offset / (rod + crank)), pi + asin(offset / (rod - crank))
    out = outer - inner
    stroke = sqrt((rod + crank) ** 2 - offset**2) - sqrt((rod - crank) ** 2 - offset**2)
    ends = {"phi_i": degrees(inner), "phi_o": degrees(outer)}
    return [{**ends, "time_ratio": out / (2 * pi - out), "stroke_mm": stroke * 1000}]


@solution
def half_stroke(stroke: mpf, rod: mpf) -> Rows:
    phi = degrees(acos(stroke / 4 / rod))
    return [{"phi": phi, "x_mm": stroke * 500}, {"phi": 180 - phi, "x_mm": stroke * 500}]


@solution
def shares_of_the_stroke(ratio: mpf, share: mpf) -> Rows:
    """The crosshead is at a distance from the shaft; law of cosines for the crank's angle."""
    rod = 1 / ratio

    def crank_at(gone: mpf) -> mpf:
        distance = 1 + rod - 2 * gone
        return degrees(acos((1 + distance**2 - rod**2) / (2 * distance)))

    return [{"phi": crank_at(share)}, {"phi": 180 - crank_at(1 - share)}]


@solution
def engine_piston(stroke: mpf, rod: mpf, speed: mpf) -> Rows:
    return [{"phi": angle, **place(mpf(angle), stroke / 2, rod, speed)} for angle in (0, 90, 180)]


@solution
def stroke_of_an_offset_crank(stroke: mpf, rod: mpf, offset: mpf) -> Rows:
    def gone(crank: mpf) -> mpf:
        return sqrt((rod + crank) ** 2 - offset**2) - sqrt((rod - crank) ** 2 - offset**2)

    ends = (stroke / 4, stroke / 2)
    crank = findroot(lambda radius: gone(radius) - stroke, ends, solver="anderson")
    return offset_stroke(crank, rod, offset)


@solution
def four_bar(crank: mpf, coupler: mpf, rocker: mpf, frame: mpf, speed: mpf, angle: mpf) -> Rows:
    pin = crank * expj(radians(angle))
    across = abs(frame - pin)
    # The far pin by the law of cosines in the triangle of coupler and rocker, above the frame.
    lean = acos((coupler**2 + across**2 - rocker**2) / (2 * coupler * across))
    far = pin + coupler * expj(arg(frame - pin) + lean)
    rod, arm = far - pin, far - frame
    # speed · pin + turning · rod = rocking · arm, each turned by a right angle.
    loop = matrix([[rod.real, -arm.real], [rod.imag, -arm.imag]])
    turning, rocking = lu_solve(loop, -speed * matrix([pin.real, pin.imag]))
    return [{"turn_velocity_radps": rocking, "rod_velocity_radps": -turning}]


@solution
def time_of_half_a_stroke(crank: mpf, rod: mpf, speed: mpf) -> Rows:
    phi = acos(crank / rod / 2)
    return [{"phi": degrees(one), "time": one / speed} for one in (phi, pi - phi)]


@solution
def crank_and_slotted_lever(crank: mpf, frame: mpf, lever: mpf) -> Rows:
    half = degrees(acos(crank / frame))
    stroke = 2 * lever * crank / frame
    return [{"time_ratio": (180 - half) / half, "swing": 2 * (90 - half), "stroke_mm": stroke * 1000}]


@solution
def whitworth_quick_return(crank: mpf, frame: mpf, arm: mpf, rod: mpf) -> Rows:
    half = degrees(acos(frame / crank))
    return [{"time_ratio": (180 - half) / half, "stroke_mm": 2 * arm * 1000}]


@solution
def shaper_ram(crank: mpf, frame: mpf, lever: mpf, rod: mpf, line: mpf, speed: mpf, angle: mpf) -> Rows:
    """With the ram to the left of the lever, which the pin turns from the right."""

    def block(t: mpf) -> mpf:
        return crank * expj(radians(angle) + speed * t) + 1j * frame

    def ram(t: mpf) -> mpf:
        end = lever * expj(arg(block(t)))
        return sqrt(rod**2 - (line + frame - end.imag) ** 2) - end.real

    turned, slide = (diff(one, 0) for one in (lambda t: arg(block(t)), lambda t: abs(block(t))))
    of_ram = {"velocity_mps": diff(ram, 0), "acceleration_mps2": diff(ram, 0, 2)}
    of_block = {"block_velocity_mps": slide, "coriolis_mps2": 2 * turned * slide}
    return [{**of_ram, **of_block, "lever_acceleration_radps2": diff(lambda t: arg(block(t)), 0, 2)}]


@solution
def scotch_yoke(stroke: mpf, speed: mpf, angle: mpf) -> Rows:
    pin = stroke / 2 * expj(radians(angle))
    moved = 1j * speed * pin
    along = {"path_mm": (stroke / 2 - pin.real) * 1000, "velocity_mps": -moved.real}
    return [{**along, "slot_velocity_mps": moved.imag, "acceleration_mps2": speed**2 * pin.real}]


@solution
def middle_of_the_rod(crank: mpf, rod: mpf, speed: mpf, angle: mpf) -> Rows:
    def pin(phi: mpf) -> mpc:
        # Along towards the shaft, across to the side of the pin.
        return mpc(-crank * cos(phi), crank * sin(phi))

    def end(phi: mpf) -> mpf:
        return path(phi, crank, rod) - crank - rod

    phi = radians(angle)
    half = [lambda phi: pin(phi).real / 2 + end(phi) / 2, lambda phi: pin(phi).imag / 2]
    velocity, acceleration = (sqrt(sum(diff(part, phi, n) ** 2 for part in half)) for n in (1, 2))
    of_point = {"velocity_mps": velocity * speed, "acceleration_mps2": acceleration * speed**2}
    return [{**of_point, **turning(crank, rod, speed, angle), "c_mps": diff(end, phi) * speed}]


def angle_after(gone: mpf, crank: mpf, rod: mpf) -> mpf:
    """The crank angle from the inner dead centre at which the piston is so far from there."""
    there = crank + rod - gone
    return degrees(acos((crank**2 + there**2 - rod**2) / (2 * crank * there)))


@solution
def after_a_share_of_the_stroke(stroke: mpf, rod: mpf, speed: mpf, share: mpf) -> Rows:
    crank = stroke / 2
    out, back = (angle_after(gone, crank, rod) for gone in (share * stroke, (1 - share) * stroke))
    first, second = (place(phi, crank, rod, speed) for phi in (out, back))
    of_out = {"phi": out, "c_mps": first["c_mps"], "p_mps2": first["p_mps2"]}
    return [{**of_out, "phi_return": 180 - back, "c_return_mps": second["c_mps"]}]


@solution
def after_a_length_of_path(stroke: mpf, rod: mpf, speed: mpf, path: mpf) -> Rows:
    crank = stroke / 2
    angles = angle_after(path, crank, rod), 360 - angle_after(stroke - path, crank, rod)
    found = ((phi, place(phi, crank, rod, speed)) for phi in angles)
    return [{"phi": phi, "c_mps": one["c_mps"], "p_mps2": one["p_mps2"]} for phi, one in found]


@solution
def speed_for_an_acceleration(stroke: mpf, rod: mpf, gain: mpf) -> Rows:
    crank = stroke / 2
    return [{"speed": sqrt(gain / (crank * (1 + crank / rod))) * 30 / pi}]


@solution
def four_bar_that_speeds_up(
    crank: mpf, coupler: mpf, rocker: mpf, frame: mpf, speed: mpf, gain: mpf, angle: mpf
) -> Rows:
    def far(phi: mpf) -> tuple[mpc, mpc]:
        pin = crank * expj(phi)
        across = abs(frame - pin)
        lean = acos((coupler**2 + across**2 - rocker**2) / (2 * coupler * across))
        return pin, pin + coupler * expj(arg(frame - pin) + lean)

    def at(time: mpf) -> mpf:
        return radians(angle) + speed * time + gain * time**2 / 2

    def rocking(time: mpf) -> mpf:
        return arg(far(at(time))[1] - frame)

    def leaning(time: mpf) -> mpf:
        pin, end = far(at(time))
        return arg(end - pin)

    return [
        {"turn_acceleration_radps2": diff(rocking, 0, 2), "rod_acceleration_radps2": -diff(leaning, 0, 2)}
    ]
