"""The formulas as the books print them, in mpmath: what kurbel's digits are compared with.

Nothing here knows kurbel's kernel. The return stroke is taken from the outstroke half a turn later,
x_return(α) = S - x(180° + α), and never from a negative ratio; ψ is an arcsine; lengths are in R and the rod
is 1/λ long. Sources: Blau (22), (25), (26); Rötscher (285) and Zusammenstellung 112; for the offset crank
the triangle of crank, rod and slide line.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from mpmath import mp

# mpmath has no types.
Real = Any


@dataclass(frozen=True)
class Drive:
    """Ratio R/L and offset e/R; R in metres and ω in 1/s = speed (2π)^turns for the quantities with units."""

    ratio: Fraction
    offset: Fraction = Fraction(0)
    radius: Fraction = Fraction(1)
    speed: Fraction = Fraction(1)
    turns: bool = False
    force: Fraction = Fraction(1)


def real(number: Fraction | int) -> Real:
    exact = Fraction(number)
    return mp.mpf(exact.numerator) / exact.denominator


def evaluate(key: str, method: str, drive: Drive, degrees: Fraction, bits: int = 640) -> Real:
    """Return the quantity that kurbel calls `key`, in its unit."""
    name, returning, unit = parted(key)
    with mp.workprec(bits):
        if method == "difference":
            exact, series = (evaluate(key, one, drive, degrees, bits) for one in ("exact", "series"))
            return exact - series
        angle = real(degrees + 180 if returning else degrees) * mp.pi / 180
        value = _VALUES[name](method, drive, angle)
        if returning and name == "time":
            outer = (
                mp.pi + mp.asin(real(drive.offset) / (1 / real(drive.ratio) - 1)) if drive.offset else mp.pi
            )
            inner = mp.asin(real(drive.offset) / (1 / real(drive.ratio) + 1)) if drive.offset else 0
            value -= (outer - inner) / (real(drive.speed) * (2 * mp.pi if drive.turns else 1))
        elif returning and name == "x":
            value = stroke(drive) - value
        elif returning and name in ("c", "p", "tangential_force", "radial_force", "torque"):
            value = -value
        return value * _unit(unit, drive)


def parted(key: str) -> tuple[str, bool, str]:
    """Return the letter, whether it is the return stroke, and the unit: "x_return_mm" is x, True, mm."""
    name = max((one for one in _VALUES if f"{key}_".startswith(f"{one}_")), key=len)
    rest = key.removeprefix(name).split("_")[1:]
    returning = rest[:1] == ["return"]
    return name, returning, "_".join(rest[returning:])


def stroke(drive: Drive) -> Real:
    """√((L + R)² - e²) - √((L - R)² - e²), in R."""
    if not drive.ratio:
        return mp.mpf(2)
    rod, e = 1 / real(drive.ratio), real(drive.offset)
    return mp.sqrt((rod + 1) ** 2 - e**2) - mp.sqrt((rod - 1) ** 2 - e**2)


def rounded(value: Real, decimals: int, bits: int = 640) -> int | None:
    """Return the value times 10**decimals rounded to the nearest integer.

    None if it is within 2**-150 of a boundary, where digits alone prove nothing.
    """
    with mp.workprec(bits):
        scaled = value * mp.mpf(10) ** decimals
        below = int(mp.floor(scaled))
        rest = scaled - below
        if abs(rest - mp.mpf(0.5)) < mp.mpf(2) ** -150:
            return None
        return below + int(rest > mp.mpf(0.5))


def printed(scaled: int, decimals: int, mark: str = ".") -> str:
    """Return the digits of scaled / 10**decimals."""
    whole, rest = divmod(abs(scaled), 10**decimals)
    sign = "-" if scaled < 0 else ""
    return f"{sign}{whole}{mark}{rest:0{decimals}d}" if decimals else f"{sign}{whole}"


def _path(method: str, drive: Drive, angle: Real) -> Real:
    lam, e = real(drive.ratio), real(drive.offset)
    if method.startswith("series"):
        return 1 - mp.cos(angle) + _rod_versine(method, drive, angle)
    if method == "infinite" or not lam:
        return 1 - mp.cos(angle)
    if not e:
        return (1 - mp.cos(angle)) + (1 - mp.sqrt(1 - (lam * mp.sin(angle)) ** 2)) / lam
    rod = 1 / lam
    crosshead = mp.cos(angle) + mp.sqrt(rod**2 - (mp.sin(angle) - e) ** 2)
    return mp.sqrt((rod + 1) ** 2 - e**2) - crosshead


def _rod_versine(method: str, drive: Drive, angle: Real) -> Real:
    """L (1 - cos ψ) in units of R, Blau's fd; by powers of λ the binomial series of his root."""
    lam, sine = real(drive.ratio), mp.sin(angle)
    if method == "infinite" or not lam:
        return mp.mpf(0)
    if method == "exact":
        return (1 - mp.sqrt(1 - (lam * sine) ** 2)) / lam
    return mp.fsum(binomial * lam ** (2 * k - 1) * sine ** (2 * k) for k, binomial in _binomials(method))


def _binomials(method: str) -> list[tuple[int, Real]]:
    """Return 1, ½; 2, ⅛; 3, 1/16 and so on: k and the coefficient of z^k in 1 - √(1 - z), as far as λ^(2k-1)
    is kept."""
    terms = (int(method.partition("-")[2] or 1) + 1) // 2
    return [(k, (-1) ** (k + 1) * mp.binomial(mp.mpf(1) / 2, k)) for k in range(1, terms + 1)]


def _velocity(method: str, drive: Drive, angle: Real) -> Real:
    if method.startswith("series"):
        lam, sine = real(drive.ratio), mp.sin(angle)
        slopes = (2 * k * one * lam ** (2 * k - 1) * sine ** (2 * k - 1) for k, one in _binomials(method))
        return sine + mp.cos(angle) * mp.fsum(slopes)
    if method == "infinite":
        return mp.sin(angle)
    psi = _rod_angle(drive, angle)
    return mp.sin(angle + psi) / mp.cos(psi)


def _acceleration(method: str, drive: Drive, angle: Real) -> Real:
    lam = real(drive.ratio)
    if method.startswith("series"):
        sine, cosine = mp.sin(angle), mp.cos(angle)
        return cosine + mp.fsum(
            2 * k * one * lam ** (2 * k - 1) * sine ** (2 * k - 2) * ((2 * k - 1) * cosine**2 - sine**2)
            for k, one in _binomials(method)
        )
    if method == "infinite":
        return mp.cos(angle)
    psi = _rod_angle(drive, angle)
    if drive.offset:
        return mp.cos(angle) - mp.sin(angle) * mp.tan(psi) + lam * mp.cos(angle) ** 2 / mp.cos(psi) ** 3
    return mp.cos(angle) + lam * (mp.cos(2 * angle) + lam**2 * mp.sin(angle) ** 4) / mp.cos(psi) ** 3


def _rod_degrees(method: str, drive: Drive, angle: Real) -> Real:
    return mp.mpf(0) if method == "infinite" else _rod_angle(drive, angle) * 180 / mp.pi


def _rod_angle(drive: Drive, angle: Real) -> Real:
    return mp.asin(real(drive.ratio) * (mp.sin(angle) - real(drive.offset)))


def _rod_velocity(method: str, drive: Drive, angle: Real) -> Real:
    """Of the pin across the slide: L ψ' cos ψ = R cos φ; by powers of λ with those of 1/cos ψ."""
    if method == "infinite":
        return mp.mpf(0)
    lam, sine = real(drive.ratio), mp.sin(angle)
    if method.startswith("series"):
        steps = (2 * k * one * (lam * sine) ** (2 * k - 2) for k, one in _binomials(method))
        return lam * mp.cos(angle) * mp.fsum(steps)
    return lam * mp.cos(angle) / mp.cos(_rod_angle(drive, angle))


def _rod_acceleration(method: str, drive: Drive, angle: Real) -> Real:
    """Of the pin across the slide: L (ψ'' cos ψ - ψ'² sin ψ) = -R sin φ."""
    across = -real(drive.ratio) * mp.sin(angle)
    if method == "infinite":
        return mp.mpf(0)
    if method.startswith("series"):
        # Of cos φ sin^(2k-2) φ, a term of the velocity.
        return mp.fsum(
            2
            * k
            * one
            * real(drive.ratio) ** (2 * k - 1)
            * (
                (2 * k - 2) * mp.sin(angle) ** abs(2 * k - 3) * mp.cos(angle) ** 2
                - mp.sin(angle) ** (2 * k - 1)
            )
            for k, one in _binomials(method)
        )
    psi = _rod_angle(drive, angle)
    return (across + _rod_velocity(method, drive, angle) ** 2 * mp.sin(psi)) / mp.cos(psi)


def _time(method: str, drive: Drive, angle: Real) -> Real:
    """Since the inner dead centre, where crank and rod are in line."""
    omega = real(drive.speed) * (2 * mp.pi if drive.turns else 1)
    inner = mp.asin(real(drive.offset) / (1 / real(drive.ratio) + 1)) if drive.offset else 0
    return (angle - inner) / omega


def _rod_force(method: str, drive: Drive, angle: Real) -> Real:
    return mp.mpf(1) if method == "infinite" else 1 / mp.cos(_rod_angle(drive, angle))


def _guide_force(method: str, drive: Drive, angle: Real) -> Real:
    return mp.mpf(0) if method == "infinite" else mp.tan(_rod_angle(drive, angle))


def _radial_force(method: str, drive: Drive, angle: Real) -> Real:
    psi = mp.mpf(0) if method == "infinite" else _rod_angle(drive, angle)
    return mp.cos(angle + psi) / mp.cos(psi)


_VALUES: Mapping[str, Callable[[str, Drive, Real], Real]] = {
    "x": _path,
    "fd": _rod_versine,
    "c": _velocity,
    "p": _acceleration,
    "psi": _rod_degrees,
    "time": _time,
    "rod_velocity": _rod_velocity,
    "rod_acceleration": _rod_acceleration,
    "rod_force": _rod_force,
    "guide_force": _guide_force,
    "tangential_force": _velocity,
    "radial_force": _radial_force,
    "torque": _velocity,
    # Blau (23) and (24): v = S π n/60 and c_m = S n/30, here in units of v.
    "v": lambda method, drive, angle: mp.mpf(1),
    "c_m": lambda method, drive, angle: stroke(drive) / mp.pi,
    "v_c_m": lambda method, drive, angle: mp.pi / stroke(drive),
}


def _unit(unit: str, drive: Drive) -> Real:
    omega = real(drive.speed) * (2 * mp.pi if drive.turns else 1)
    radius = real(drive.radius)
    return {
        "": lambda: mp.mpf(1),
        "stroke": lambda: 1 / stroke(drive),
        "percent": lambda: 100 / stroke(drive),
        "mm": lambda: 1000 * radius,
        "mps": lambda: radius * omega,
        "mps2": lambda: radius * omega**2,
        "radps": lambda: omega,
        "radps2": lambda: omega**2,
        "n": lambda: real(drive.force),
        "nm": lambda: real(drive.force) * radius,
    }[unit]()
