"""`kurbel plot`: the values of the tables in files that open, or one sentence that says why not."""

from __future__ import annotations

import math
import os
import pty
import re
import subprocess
import sys
import xml.etree.ElementTree as ET
from collections.abc import Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from cli import printed, refusal
from numpy.typing import NDArray
from places import CARDS
from programs import Programs
from tools import require_library

import kurbel
from kurbel.drive.crank import Crank
from kurbel.drive.load import PistonForce
from kurbel.drive.rod import Moving, Rod
from kurbel.drive.wheel import Wheel
from kurbel.engine.engine import Engine, Load, Steam
from kurbel.engine.request import EngineRequest
from kurbel.engine.turn import Turn
from kurbel.linkage.arc.crank import ArcCrank
from kurbel.linkage.parallel import ParallelCrank
from kurbel.linkage.question import LinkageRequest
from kurbel.motion.mechanism import STRAIGHT
from kurbel.motion.page import Request
from kurbel.motion.quantities import registry
from kurbel.page.layouts import layout
from kurbel.plot.chart.model import Curve, Panel
from kurbel.plot.curves import motion_keys, motion_panels, pin_force, pin_force_keys
from kurbel.plot.engine import PIN_FORCE, TURNING, engine_pin_force, force_panels, turning_panels
from kurbel.plot.panels import MOST_POINTS, axis_name
from kurbel.plot.speed import speed_panel
from kurbel.plot.style import FORMATS
from kurbel.reading.extras import how_to_install
from kurbel.reading.units import Speed

CARD = CARDS / "ideal-2.csv"
ANGLES = tuple(Fraction(degree) for degree in range(0, 361, 3))
FLOATS = [float(angle) for angle in ANGLES]
FIFTH, QUARTER = Fraction(1, 5), Fraction(1, 4)
# 600 mm stroke, 120/min, 10 kN.
MACHINE = Crank(FIFTH, Fraction(0), Fraction(3, 10), Speed(Fraction(2)), PistonForce(Fraction(10_000)))
HELP = "see kurbel plot --help"


@pytest.fixture
def library() -> None:
    """Skip a test without matplotlib, or fail it where nothing may be missing."""
    require_library("matplotlib")


drawn = pytest.mark.usefixtures("library")


def asked(columns: Sequence[str], *cranks: Crank, method: str | None = None, lang: str = "de") -> Request:
    return Request(
        layout=layout("kinematics"), cranks=cranks, angles=ANGLES, method=method, lang=lang,
        columns=tuple(columns),
    )  # fmt: skip


def turning(
    *expansions: int, ratios: Sequence[Fraction] = (FIFTH,), cranks: Sequence[int] = (0,)
) -> list[Panel]:
    request = EngineRequest(
        layout=layout("turning"),
        steams=[Steam(Fraction(one)) for one in expansions],
        drives=[Crank(ratio) for ratio in ratios],
        cranks=[Fraction(one) for one in cranks],
        angles=ANGLES,
        columns=TURNING,
    )
    return turning_panels(request)


def labels(panel: Panel) -> list[str]:
    return [curve.label for curve in panel.curves]


# Values -----------------------------------------------------------------------------------------------


@pytest.mark.parametrize("method", ["exact", "series", "infinite"])
def test_the_points_are_the_values_of_compute(method: str) -> None:
    keys = ("x", "c_return", "p", "psi", "x_percent")
    values = kurbel.compute(FLOATS, "1:5", keys, method=method)
    panels = motion_panels(asked(keys, Crank(FIFTH), method=method))
    assert len(panels) == len(keys)
    for key, panel in zip(keys, panels, strict=True):
        (curve,) = panel.curves
        assert list(curve.angles) == FLOATS
        assert list(curve.values) == values[key].tolist()


def test_the_curves_of_an_offset_crank_are_its_own() -> None:
    (panel,) = motion_panels(asked(["c"], Crank(FIFTH, Fraction(1, 2))))
    assert list(panel.curves[0].values) == kurbel.compute(FLOATS, "1:5", "c", offset="0.5")["c"].tolist()


def test_each_ratio_has_a_curve_in_the_panel_of_each_quantity() -> None:
    cranks = (Crank(QUARTER), Crank(FIFTH), Crank(Fraction(0)))
    panels = motion_panels(asked(["x", "rod_force", "guide_force"], *cranks))
    assert [panel.label for panel in panels] == [
        "Kolbenweg $x/R$",
        "Stangenkraft $S/F$",
        "Führungsdruck $N/F$",
    ]
    for panel, key in zip(panels, ("x", "rod_force", "guide_force"), strict=True):
        assert labels(panel) == ["$R:L = 1:4$", "$R:L = 1:5$", "$R:L = 1:∞$"]
        for curve, ratio in zip(panel.curves, ("1:4", "1:5", "1:∞"), strict=True):
            assert list(curve.values) == kurbel.compute(FLOATS, ratio, key)[key].tolist()


def test_forces_of_one_crank_share_a_panel_and_are_in_newtons_where_the_piston_force_is_known() -> None:
    assert motion_keys(STRAIGHT, Crank(FIFTH)) == ("x", "c", "p")
    keys = motion_keys(STRAIGHT, MACHINE)
    forces, torque = motion_panels(asked(keys, MACHINE, lang="en"))
    assert (forces.unit, torque.unit) == ("N", "N m")
    assert forces.label == "Rod force, guide force, tangential force and radial force"
    assert torque.label == "Torque $M_d$"
    assert labels(forces) == ["$S$", "$N$", "$T$", "$Z$"]
    shares = kurbel.compute(FLOATS, "1:5", ["rod_force", "guide_force", "tangential_force", "radial_force"])
    for curve, values in zip(forces.curves, shares.values(), strict=True):
        np.testing.assert_allclose(curve.values, 10_000 * values, rtol=1e-14, atol=1e-9)
    np.testing.assert_allclose(
        torque.curves[0].values, 3000 * shares["tangential_force"], rtol=1e-14, atol=1e-9
    )


def test_a_machine_is_drawn_in_its_units() -> None:
    machine = Crank(FIFTH, radius=Fraction(3, 10), speed=Speed(Fraction(2)))
    assert motion_keys(STRAIGHT, machine) == ("x_mm", "c_mps", "p_mps2")
    assert motion_keys(STRAIGHT, Crank(FIFTH, radius=Fraction(1))) == ("x_mm", "c", "p")
    units = [
        (panel.label, panel.unit) for panel in motion_panels(asked(motion_keys(STRAIGHT, machine), machine))
    ]
    assert units == [
        ("Kolbenweg $x$", "mm"), ("Kolbengeschwindigkeit $c$", "m/s"), ("Kolbenbeschleunigung $p$", "m/s²"),
    ]  # fmt: skip


def test_the_two_strokes_of_a_quantity_share_a_panel() -> None:
    (panel,) = motion_panels(asked(["c", "c_return"], Crank(FIFTH), lang="en"))
    assert labels(panel) == ["Outstroke", "Return"]
    (panel,) = motion_panels(asked(["c", "c_return"], Crank(FIFTH), Crank(QUARTER), lang="en"))
    assert len(set(labels(panel))) == 4
    assert labels(panel)[0] == "$R:L = 1:5$, Outstroke"


@pytest.mark.parametrize("lang", ["de", "en"])
def test_every_quantity_has_an_axis_that_names_it_with_its_unit_once(lang: str) -> None:
    names = {key: axis_name(quantity, lang) for key, quantity in registry().items()}
    assert names["psi"][2] == "°"
    for key, (name, heading, unit) in names.items():
        assert name == registry()[key].name[lang]
        assert (" in " in heading) <= (not unit), key
        # The ratio of two velocities has none.
        in_degrees = registry()[key].is_arc and key != "v_c_m"
        assert bool(unit) == (bool(registry()[key].needs) or in_degrees), key


def test_the_pin_force_is_the_rod_force_turned_by_the_crank() -> None:
    ratio = 0.25
    request, crank = asked(pin_force_keys(STRAIGHT, Crank(QUARTER)), Crank(QUARTER)), Crank(QUARTER)
    vector, (across, up), unit, strokes = pin_force(request, STRAIGHT.solved([crank], None)[0])
    assert strokes is not None
    assert (strokes.ends, strokes.names) == ([0, 180, 360], ["Hingang", "Rückgang"])
    assert (across, up, unit) == ("Tangentialkraft $T/F$", "Radialkraft $Z/F$", "")
    phi = np.radians(FLOATS)
    psi = np.arcsin(ratio * np.sin(phi))
    # In the frame of the engine the rod presses the pin with (-1, tan ψ); the crank sees it turned by φ.
    along, beside = -np.ones_like(phi), np.tan(psi)
    np.testing.assert_allclose(vector.across, -along * np.sin(phi) + beside * np.cos(phi), rtol=0, atol=1e-14)
    np.testing.assert_allclose(vector.up, -along * np.cos(phi) - beside * np.sin(phi), rtol=0, atol=1e-14)


def test_the_turning_effort_is_that_of_the_turn() -> None:
    effort, energy = turning(4)
    turn = Turn(Engine(Crank(FIFTH), Steam(Fraction(4))), "exact")
    assert (effort.label, energy.label) == (
        "Tangentialkraft $T/Q$, mittlere Umfangskraft $P/Q$", "Überschussarbeit $W/(Q R)$",
    )  # fmt: skip
    # The work ln ε/ε of both strokes over the circle: 2 ln 4/(4 π) = 0,22064.
    assert labels(effort) == ["$T/Q$", "$P/Q = 0.2206$"]
    for curve, value in ((effort.curves[0], turn.tangential_force), (energy.curves[0], turn.energy_at)):
        at = dict(zip(curve.angles, curve.values, strict=True))
        for angle in ANGLES:
            assert at[float(angle)] == pytest.approx(float(value(angle / 180)), abs=1e-14)


def test_the_mean_is_that_of_the_book() -> None:
    # Weisbach-Herrmann, § 150, prints 0,22063 for ε = 2.
    mean = turning(2)[0].curves[1]
    assert list(mean.angles) == [0, 360]
    assert list(mean.values) == pytest.approx([0.22064] * 2, abs=5e-6)


@pytest.mark.parametrize("cranks", [(0,), (0, 90)])
def test_the_energy_is_the_area_between_the_tangential_force_and_its_mean(cranks: Sequence[int]) -> None:
    (force, mean), (energy,) = (panel.curves for panel in turning(3, cranks=cranks))
    assert force.angles == energy.angles
    excess = np.asarray(force.values) - mean.values[0]
    areas = (excess[1:] + excess[:-1]) / 2 * np.diff(np.radians(force.angles))
    np.testing.assert_allclose(np.cumsum(areas), energy.values[1:], rtol=0, atol=2e-3)


def test_the_curves_have_the_tips_at_cut_off() -> None:
    curve = turning(4)[0].curves[0]
    # Cut-off after a quarter of the stroke, R/2: of the triangle of crank, rod and slide all sides are known.
    corner = float(np.degrees(np.arccos((5.5**2 + 1 - 5**2) / (2 * 5.5))))
    assert min(abs(angle - corner) for angle in curve.angles) < 1e-9
    tip = max(zip(curve.values, curve.angles, strict=True))
    assert tip[1] == pytest.approx(corner, abs=1e-9)
    assert all(low < high for low, high in pairwise(curve.angles))


# Forces of an engine ------------------------------------------------------------------------------------

EPS, BACK = 3, 0.1
STEAM = Steam(Fraction(EPS), Fraction(1, 10))
# 300 mm bore and 8 bar, 600 mm stroke, 120/min.
LOAD = Load(Fraction(3, 10), Fraction(800_000))
SIZED = Crank(QUARTER, radius=Fraction(3, 10))
NEWTONS = math.pi / 4 * 0.3**2 * 800_000
OMEGA = 4 * math.pi


def engine_request(
    *columns: str, steams: Sequence[Steam] = (STEAM,), drive: Crank = SIZED, **rest: Any
) -> EngineRequest:
    return EngineRequest(
        layout=layout("engine-forces"), steams=steams, drives=[drive], angles=ANGLES,
        columns=columns, **rest,
    )  # fmt: skip


def curve_at(curve: Curve) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    return np.radians(curve.angles), np.asarray(curve.values)


def net_steam(phi: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the piston force in Q away from the dead centre of the stroke, by Mariotte's law; λ = 1/4."""
    sides = np.where(phi < np.pi, 1, -1)
    path = 1 - sides * np.cos(phi) + sides * (4 - np.sqrt(16 - np.sin(phi) ** 2))
    return np.where(path / 2 < 1 / EPS, 1, 1 / (EPS * np.maximum(path / 2, 1e-9))) - BACK


def within(phi: NDArray[np.float64]) -> NDArray[np.bool_]:
    """Return the places that are no dead centres, where forces have two values."""
    return np.asarray(np.abs(np.sin(phi)) > 1e-9)


def test_the_forces_of_an_engine_are_those_of_mariotte_and_the_triangle_of_forces() -> None:
    keys = ("piston_force", "guide_force", "tangential_force", "radial_force")
    (panel,) = force_panels(engine_request(*keys, lang="en"))
    assert panel.label == "Piston force, guide force, tangential force and radial force"
    assert (labels(panel), panel.unit) == (["$F/Q$", "$N/Q$", "$T/Q$", "$Z/Q$"], "")
    for curve, key in zip(panel.curves, keys, strict=True):
        phi, values = curve_at(curve)
        psi = np.arcsin(np.sin(phi) / 4)
        # In the frame of the outstroke; on the return the steam presses the other way.
        force = net_steam(phi) * np.where(phi < np.pi, 1, -1)
        meant = {
            "piston_force": force,
            "guide_force": force * np.tan(psi),
            "tangential_force": force * np.sin(phi + psi) / np.cos(psi),
            "radial_force": force * np.cos(phi + psi) / np.cos(psi),
        }[key]
        there = within(phi)
        assert there.sum() > 115
        np.testing.assert_allclose(values[there], meant[there], rtol=1e-9, atol=1e-12)


def test_where_the_steam_changes_sides_the_force_has_both_its_values() -> None:
    (panel,) = force_panels(engine_request("piston_force", "radial_force", "tangential_force"))
    piston, radial, tangential = panel.curves
    end = 1 / EPS - BACK
    for curve, sign in ((piston, 1), (radial, -1)):
        points = list(zip(curve.angles, curve.values, strict=True))
        assert points[0] == pytest.approx((0, 1 - BACK), abs=1e-9)
        both = [value for angle, value in points if angle == 180]
        assert both == pytest.approx([sign * end, -sign * (1 - BACK)], abs=1e-9)
        assert points[-1] == pytest.approx((360, -end), abs=1e-9)
        assert len(points) == len(set(points)) == len(ANGLES) + 3
    # Across the crank there is no force at the dead centre, and no jump.
    assert all(low < high for low, high in pairwise(tangential.angles))
    assert dict(zip(tangential.angles, tangential.values, strict=True))[180] == pytest.approx(0, abs=1e-12)


def test_the_curves_bend_at_cut_off_and_at_dead_centres_whatever_the_step() -> None:
    request = replace(
        engine_request("piston_force"), angles=tuple(Fraction(7 * number) for number in range(55))
    )
    (curve,) = force_panels(request)[0].curves
    for side in (1, -1):
        # Cut-off after a third of the stroke, 2/3 R, counted from either dead centre.
        head = 4 + side * (1 - 2 / EPS)
        corner = math.degrees(math.acos(side * (head**2 + 1 - 16) / (2 * head)))
        corner += 180 * (side < 0)
        assert min(abs(angle - corner) for angle in curve.angles) < 1e-9
    assert {180.0, 360.0} <= set(curve.angles)


def test_a_cut_off_at_an_angle_of_the_curve_is_no_jump() -> None:
    # After a quarter of the stroke the crank of an infinite rod is at 60°, and at 240°.
    request = replace(engine_request(*PIN_FORCE, steams=[Steam(Fraction(4))]), drives=[Crank(Fraction(0))])
    vector = engine_pin_force(request)[0]
    assert [angle for angle, after in pairwise(vector.angles) if angle == after] == [180]
    assert len(vector.angles) == len(ANGLES) + 1


def test_single_acting_the_return_stroke_is_idle() -> None:
    (panel,) = force_panels(engine_request("piston_force", "radial_force", double=False))
    for curve in panel.curves:
        values = [value for angle, value in zip(curve.angles, curve.values, strict=True) if angle >= 180]
        assert abs(values[0]) == pytest.approx(1 / EPS - BACK, abs=1e-9)
        assert values[1:] == pytest.approx([0] * (len(values) - 1), abs=1e-15)


def test_each_engine_has_a_curve_in_the_panel_of_each_force() -> None:
    other = Steam(Fraction(2), Fraction(1, 10))
    panels = force_panels(engine_request("piston_force", "tangential_force", steams=(STEAM, other)))
    assert [panel.label for panel in panels] == ["Kolbenkraft $F/Q$", "Tangentialkraft $T/Q$"]
    for panel in panels:
        assert labels(panel) == ["$ε = 3$", "$ε = 2$"]
    for curve, end in zip(panels[0].curves, (1 / 3, 1 / 2), strict=True):
        assert curve.values[-1] == pytest.approx(-(end - BACK), abs=1e-9)


def test_quantities_of_an_engine_have_their_unit_once() -> None:
    keys = ("crank_pin_force", "tangential_excess", "energy", "torque_nm", "piston_force_n")
    panels = force_panels(engine_request(*keys, load=LOAD))
    headings = [(panel.label, labels(panel), panel.unit) for panel in panels]
    assert headings == [
        ("Kraft am Kurbelzapfen und Überschuss über die mittlere", ["$K/Q$", "$(T - P)/Q$"], ""),
        ("Überschussarbeit $W/(Q R)$", [""], ""),
        ("Drehmoment $M_d$", [""], "N m"),
        ("Kolbenkraft $F$", [""], "N"),
    ]


def moving(**masses: Any) -> EngineRequest:
    heavy = replace(SIZED, speed=Speed(Fraction(2)), moving=Moving(**masses))
    keys = tuple(f"{key}_n" for key in ("tangential_force", "radial_force", "guide_force"))
    return engine_request(*keys, load=LOAD, drive=heavy)


def newton(phi: NDArray[np.float64], piston: float, rod: float, centre: float, gyration: float) -> Any:
    """Return T, Z and N in newtons from the motion of the masses, differentiated by differences; L = 1.2 m.

    x from the shaft to the crosshead, y to the crank pin's side on the outstroke.
    """
    radius, length, step = 0.3, 1.2, 1e-3

    def places(at: NDArray[np.float64]) -> tuple[Any, Any, Any]:
        pin = radius * np.exp(1j * at)
        head = pin.real + np.sqrt(length**2 - pin.imag**2)
        return pin, head, np.arcsin(pin.imag / length)

    def second(part: int, weight: float = 0) -> Any:
        """Return the second derivative in time of the head, the rod's angle or a point between the pins."""
        at = [places(phi + way) for way in (-step, 0, step)]
        low, mid, high = (one[part] if part else (1 - weight) * one[1] + weight * one[0] for one in at)
        return OMEGA**2 * (low - 2 * mid + high) / step**2

    pin, head, _ = places(phi)
    steam = -NEWTONS * net_steam(phi) * np.where(phi < np.pi, 1, -1)
    thrust = steam - piston * second(1).real
    moved = rod * second(0, 1 - centre)
    # The rod under the crosshead's thrust, the guide's N and the force of the pin: moments about the pin.
    arm, mass_arm = head - pin, centre * (head - pin)
    # ψ turns against the mathematical sense.
    turning = -rod * gyration**2 * second(2)
    guide = (turning + mass_arm.real * moved.imag - mass_arm.imag * moved.real + arm.imag * thrust) / arm.real
    on_pin = thrust + 1j * guide - moved
    in_crank = on_pin * np.exp(-1j * phi)
    return in_crank.imag, -in_crank.real, guide


@pytest.mark.parametrize("rod", [0, 150])
def test_the_forces_with_the_masses_are_those_of_newton(rod: int) -> None:
    masses: dict[str, Any] = {"reciprocating": Fraction(200)}
    if rod:
        masses["rod"] = Rod(Fraction(2, 5), Fraction(9, 100), Fraction(rod))
    (panel,) = force_panels(moving(**masses))
    assert (labels(panel), panel.unit) == (["$T$", "$Z$", "$N$"], "N")
    phi = np.radians(panel.curves[0].angles)
    for curve, number in zip(panel.curves, range(3), strict=True):
        phi, values = curve_at(curve)
        there = within(phi)
        meant = newton(phi, 200, rod, 0.4, 0.3 * 1.2)[number]
        np.testing.assert_allclose(values[there], meant[there], rtol=0, atol=2)


def test_the_polar_diagram_leaps_at_the_dead_centres_along_the_crank() -> None:
    vector, names, unit, strokes = engine_pin_force(engine_request(*PIN_FORCE))
    assert strokes is not None
    assert (strokes.ends, strokes.names) == ([0, 180, 360], ["Hingang", "Rückgang"])
    assert (names, unit) == (("Tangentialkraft $T/Q$", "Radialkraft $Z/Q$"), "")
    points = list(zip(vector.angles, vector.across, vector.up, strict=True))
    end = 1 / EPS - BACK
    before, after = (point[1:] for point in points if point[0] == 180)
    assert before == pytest.approx((0, -end), abs=1e-9)
    assert after == pytest.approx((0, 1 - BACK), abs=1e-9)
    assert points[0][1:] == pytest.approx((0, 1 - BACK))
    assert points[-1][1:] == pytest.approx((0, -end), abs=1e-9)
    phi = np.radians(vector.angles)
    force = net_steam(phi) / np.sqrt(1 - np.sin(phi) ** 2 / 16)
    there = within(phi)
    np.testing.assert_allclose(np.hypot(vector.across, vector.up)[there], force[there], rtol=1e-9, atol=1e-12)


def test_the_speed_of_a_flywheel_is_drawn_from_its_work_and_its_mean_lies_between_the_extremes() -> None:
    request = EngineRequest(
        layout=layout("turning"), steams=[STEAM], drives=[SIZED], angles=ANGLES, columns=TURNING,
    )  # fmt: skip
    (energy,), (_, mean) = turning_panels(request)[1].curves, turning_panels(request)[0].curves
    work = dict(zip(*curve_at(energy), strict=True))
    for turns, letters in ((None, "$v/v_1$"), (Speed(Fraction(2)), "$n$")):
        wheeled = replace(request, layout=layout("speed"), wheel=Wheel(Fraction(3), speed=turns))
        panel = speed_panel(replace(wheeled, columns=("speed",)))
        assert letters.strip("$") in panel.label
        speed, level = panel.curves
        unity = np.asarray(speed.values)[0]
        for angle, value in zip(*curve_at(speed), strict=True):
            np.testing.assert_allclose(
                value / unity, np.sqrt(1 + 2 * work[angle] / mean.values[0] / 3), rtol=1e-12
            )
        # The extremes lie between the angles that are drawn.
        np.testing.assert_allclose(level.values, (max(speed.values) + min(speed.values)) / 2, rtol=2e-3)
        np.testing.assert_allclose(level.values if turns else unity, 120 if turns else 1, rtol=1e-12)


def test_the_turning_effort_with_the_masses_has_theirs_besides_the_steams() -> None:
    heavy_crank = replace(SIZED, speed=Speed(Fraction(2)), moving=Moving(Fraction(200)))
    request = EngineRequest(
        layout=layout("turning"), steams=[STEAM], drives=[heavy_crank], angles=ANGLES, columns=TURNING,
        load=LOAD,
    )  # fmt: skip
    phi, heavy = curve_at(turning_panels(request)[0].curves[0])
    light = np.asarray(turning_panels(replace(request, drives=[SIZED]))[0].curves[0].values)
    psi = np.arcsin(np.sin(phi) / 4)
    velocity = np.sin(phi + psi) / np.cos(psi)
    slope = np.gradient(velocity, phi)
    inertia = -200 * 0.3 * OMEGA**2 * slope * velocity / NEWTONS
    np.testing.assert_allclose((heavy - light)[1:-1], inertia[1:-1], rtol=0, atol=1e-3)
    assert np.abs(inertia).max() > 0.05


# Arc crank and parallel crank ---------------------------------------------------------------------------


def linkage(name: str, *columns: str, ratios: Sequence[Fraction] = (FIFTH,), lang: str = "de") -> list[Panel]:
    arcs = tuple(ArcCrank(Crank(ratio), Fraction(3)) for ratio in ratios)
    drives = arcs if name == "arc" else (ParallelCrank(),)
    request = LinkageRequest(layout=layout(name), angles=ANGLES, drives=drives, columns=columns, lang=lang)
    return motion_panels(request)


def rocker_angle(phi: NDArray[np.float64], rod: float, rocker: float) -> NDArray[np.float64]:
    """Return the angle of the rocker from downwards, by two circles about pin and pivot that meet."""
    pivot, pin = rod + 1j * rocker, np.exp(1j * phi)
    apart = np.abs(pin - pivot)
    at_pivot = np.arccos((apart**2 + rocker**2 - rod**2) / (2 * apart * rocker))
    return np.asarray(np.angle((pin - pivot) * np.exp(1j * at_pivot) / -1j))


def test_the_motion_of_an_arc_crank_is_that_of_two_circles_that_meet() -> None:
    path, velocity, acceleration, angle = linkage("arc", "path", "velocity", "acceleration", "rocker")
    assert [panel.label for panel in (path, velocity, acceleration)] == [
        "Weg auf dem Bogen $x/R$", "Geschwindigkeit $c/v$", "Beschleunigung $(p R)/v^2$",
    ]  # fmt: skip
    assert (angle.label, angle.unit, path.unit) == ("Schwingenwinkel $θ$", "°", "")
    phi, values = curve_at(angle.curves[0])
    turned = rocker_angle(phi, 5, 3)
    np.testing.assert_allclose(values, np.degrees(turned), rtol=0, atol=1e-9)
    # At the inner dead centre the rod's end is 6 R from the shaft, 3 R from the pivot.
    ground = math.hypot(5, 3)
    at_pivot = math.acos((ground**2 + 9 - 36) / (2 * 3 * ground))
    dead = at_pivot - math.atan2(5, 3)
    way = 3 * (dead - turned)
    np.testing.assert_allclose(path.curves[0].values, way, rtol=0, atol=1e-9)
    slope = np.gradient(way, phi, edge_order=2)
    np.testing.assert_allclose(velocity.curves[0].values, slope, rtol=0, atol=3e-3)
    bend = np.gradient(slope, phi, edge_order=2)
    np.testing.assert_allclose(acceleration.curves[0].values[3:-3], bend[3:-3], rtol=0, atol=6e-3)


def test_the_coupling_rod_moves_along_and_across() -> None:
    path, velocity, acceleration = linkage("parallel", lang="en")
    assert (path.label, labels(path)) == ("Path", ["$x/R$", "$y/R$"])
    assert labels(velocity) == ["$c_x/v$", "$c_y/v$"]
    assert (acceleration.label, labels(acceleration)[1]) == ("Acceleration", "$(p_y R)/v^2$")
    phi = np.radians(FLOATS)
    meant = (1 - np.cos(phi), np.sin(phi), np.sin(phi), np.cos(phi), np.cos(phi), -np.sin(phi))
    found = [curve.values for panel in (path, velocity, acceleration) for curve in panel.curves]
    np.testing.assert_allclose(found, meant, rtol=0, atol=1e-15)


def test_arc_cranks_of_several_ratios_share_the_panel_of_a_quantity() -> None:
    panels = linkage("arc", "path", "rod", ratios=(FIFTH, QUARTER), lang="en")
    assert [panel.label for panel in panels] == ["Path along the arc $x/R$", "Rod angle $ψ$"]
    assert [labels(panel) for panel in panels] == [["$R:L = 1:5$", "$R:L = 1:4$"]] * 2
    (panel,) = linkage("arc", "velocity", "velocity_return", lang="en")
    assert labels(panel) == ["Outstroke", "Return"]
    # The angles of the return stroke count from the outer dead centre, and so do its velocities.
    there, back = (np.asarray(curve.values) for curve in panel.curves)
    np.testing.assert_allclose(back[:61], -there[60:], rtol=0, atol=1e-12)


def test_several_engines_are_told_apart_and_have_no_means() -> None:
    effort, energy = turning(2, 4, ratios=(QUARTER, FIFTH))
    assert labels(effort) == labels(energy)
    assert labels(effort) == [
        f"$ε = {expansion}$, $r:l = {ratio}$" for expansion in (2, 4) for ratio in ("1:4", "1:5")
    ]
    assert labels(turning(2, 4)[0]) == ["$ε = 2$", "$ε = 4$"]
    assert labels(turning(2, ratios=(QUARTER, FIFTH))[0]) == ["$r:l = 1:4$", "$r:l = 1:5$"]


# Files ------------------------------------------------------------------------------------------------

LOADED = ("--eps", "3", "--bore", "300mm", "--pressure", "8bar", "--stroke", "600mm", "--speed", "120/min")
MASSES = (*LOADED, "--reciprocating", "300kg", "--rod-mass", "150kg", "--centre", "0.4", "--gyration", "0.3")
DRAWINGS: Mapping[str, tuple[str, ...]] = {
    "motion": (),
    "ratios": ("--ratio", "1:4;1:5", "--columns", "p,rod_force", "--step", "5"),
    "machine": (
        "--stroke",
        "600mm",
        "--rod",
        "1500mm",
        "--speed",
        "120/min",
        "--force",
        "10kN",
        "--step",
        "5",
    ),
    "offset": ("--ratio", "1:4", "--offset", "0.3", "--from", "-30", "--to", "330", "--step", "5"),
    "positions": ("--positions", "30;75", "--ratio", "1:4", "--offset", "0.3"),
    "arc": ("--mechanism", "arc", "--rocker", "6", "--step", "5"),
    "arc positions": ("--mechanism", "arc", "--rocker", "4", "--pivot", "4;-3,5", "--positions", "45;120"),
    "parallel": ("--mechanism", "parallel", "--step", "5"),
    "parallel positions": ("--mechanism", "parallel", "--positions", "45;120"),
    "polar": ("--polar", "--ratio", "1:4", "--step", "5"),
    "turning": ("--turning", "--eps", "4", "--ratio", "1:5", "--back", "0.1", "--step", "5"),
    "forces": ("--forces", "--ratio", "1:4", "--step", "5"),
    "engine": ("--forces", "--eps", "4", "--back", "0.1", "--step", "5"),
    "pin": ("--polar", "--eps", "3", "--bore", "300mm", "--pressure", "8bar", "--step", "5"),
    "masses": ("--forces", *MASSES, "--columns", "crank_pin_force_n,torque_nm", "--step", "5"),
    "turning masses": ("--turning", "--eps", "4", *MASSES, "--step", "5"),
    "engines": ("--turning", "--eps", "2;4", "--single-acting", "--cranks", "0;180", "--step", "5"),
}
SVG = "{http://www.w3.org/2000/svg}"


def svg(*words: str) -> ET.Element:
    return ET.fromstring(printed("plot", *words, "-f", "svg").out)


def title(root: ET.Element) -> str:
    return next(root.iter("{http://purl.org/dc/elements/1.1/}title")).text or ""


def path_of(root: ET.Element, name: str) -> NDArray[np.float64]:
    group = next(one for one in root.iter(f"{SVG}g") if one.get("id") == name)
    path = next(group.iter(f"{SVG}path")).get("d") or ""
    numbers = [float(number) for number in re.findall(r"-?[\d.]+", path)]
    return np.asarray(numbers).reshape(-1, 2)


def commands(root: ET.Element, name: str) -> str:
    """Return the letters of a path."""
    group = next(one for one in root.iter(f"{SVG}g") if one.get("id") == name)
    return re.sub(r"[^A-Z]", "", next(group.iter(f"{SVG}path")).get("d") or "")


@drawn
@pytest.mark.slow
@pytest.mark.parametrize("name", DRAWINGS)
def test_every_drawing_is_written_in_both_languages_and_the_same_bytes_twice(
    name: str, tmp_path: Path
) -> None:
    german = ("plot", *DRAWINGS[name], "--lang", "de")
    assert printed(*german, "-o", str(tmp_path / "one.svg")).out == ""
    written = (tmp_path / "one.svg").read_bytes()
    assert printed(*german, "-f", "svg", "-o", "-").out.encode() == written
    english = printed("plot", *DRAWINGS[name], "--lang", "en", "-f", "svg").out.encode()
    assert title(ET.fromstring(written)) != title(ET.fromstring(english)) != ""


@drawn
@pytest.mark.parametrize(
    ("name", "start", "end"),
    [
        ("png", b"\x89PNG\r\n\x1a\n", b"IEND\xaeB`\x82"),
        ("pdf", b"%PDF-1.", b"%%EOF\n"),
        ("svg", b"<?xml ", b"</svg>\n"),
        ("pgf", b"% ", b"\\end{pgfpicture}%\n\\makeatother%\n\\endgroup%\n"),
    ],
)
def test_each_format_opens(name: str, start: bytes, end: bytes, tmp_path: Path) -> None:
    file = tmp_path / f"drawing.{name.upper()}"
    printed("plot", "--step", "10", "-o", str(file))
    content = file.read_bytes()
    assert content.startswith(start)
    assert content.endswith(end)


def test_every_format_is_tested() -> None:
    assert set(FORMATS) == {"png", "pdf", "svg", "pgf"}


@drawn
def test_the_format_option_is_stronger_than_the_suffix_and_the_suffix_than_the_environment(
    tmp_path: Path,
) -> None:
    file = tmp_path / "drawing.svg"
    printed("plot", "--step", "10", "-f", "pdf", "-o", str(file))
    assert file.read_bytes().startswith(b"%PDF")
    printed("plot", "--step", "10", "-o", str(file), KURBEL_PLOT_FORMAT="png", KURBEL_FORMAT="csv")
    assert file.read_bytes().startswith(b"<?xml")
    assert printed("plot", "--step", "10", KURBEL_PLOT_FORMAT="svg").out.startswith("<?xml")


@drawn
def test_png_goes_through_a_pipe() -> None:
    words = [sys.executable, "-m", "kurbel", "plot", "--positions", "30", "-f", "png"]
    done = subprocess.run(words, capture_output=True, check=True)
    assert done.stdout.startswith(b"\x89PNG")
    assert done.stderr == b""


@drawn
def test_the_lines_on_paper_are_the_curves_of_compute() -> None:
    root = svg("--ratio", "1:4,5", "--step", "1")
    angles = np.arange(361.0)
    for panel, values in enumerate(kurbel.compute(angles, "1:4,5").values(), 1):
        across, down = path_of(root, f"curve-{panel}-1").T
        for drawn_at, meant in ((across, angles), (down, values)):
            slope, start = np.polyfit(meant, drawn_at, 1)
            np.testing.assert_allclose(drawn_at, start + slope * meant, rtol=0, atol=2e-6 * np.ptp(drawn_at))
        # y runs down in SVG.
        assert np.argmin(down) == np.argmax(values)


@drawn
def test_the_polar_curve_on_paper_is_the_pin_force_in_one_scale() -> None:
    root = svg("--polar", "--ratio", "1:3", "--step", "1")
    out, back = (path_of(root, f"curve-{number}") for number in (1, 2))
    # Both strokes have the dead centre between them.
    assert len(out) == len(back) == 181
    path = np.concatenate([out, back[1:]])
    force = kurbel.compute(np.arange(361.0), "1:3", ["tangential_force", "radial_force"])
    across, up = (np.polyfit(force[key], drawn_at, 1)[0] for key, drawn_at in zip(force, path.T, strict=True))
    assert across == pytest.approx(-up, rel=1e-6)
    assert across > 0


@drawn
def test_the_forces_on_paper_are_those_of_the_panel_and_broken_at_the_dead_centre() -> None:
    root = svg("--forces", "--eps", "3", "--back", "0.1", "--ratio", "1:4", "--step", "3")
    (panel,) = force_panels(engine_request("piston_force", "guide_force", "tangential_force", "radial_force"))
    values = np.concatenate([curve.values for curve in panel.curves])
    drawn_at = np.concatenate([path_of(root, f"curve-1-{number}")[:, 1] for number in range(1, 5)])
    slope, start = np.polyfit(values, drawn_at, 1)
    np.testing.assert_allclose(drawn_at, start + slope * values, rtol=0, atol=1e-4)
    for number, moves in ((1, 2), (2, 1), (3, 1), (4, 2)):
        assert commands(root, f"curve-1-{number}").count("M") == moves
    for number, jump in ((1, (1 / 3 - 0.1, -0.9)), (4, (0.1 - 1 / 3, 0.9))):
        assert path_of(root, f"jumps-1-{number}")[:, 1] == pytest.approx(
            start + slope * np.array(jump), abs=1e-4
        )


@drawn
def test_the_mechanism_on_paper_stands_at_its_angle() -> None:
    (x0, y0), (x1, y1) = path_of(svg("--positions", "30", "--ratio", "1:4"), "crank")
    (_, _), (x2, y2) = rod = path_of(svg("--positions", "30", "--ratio", "1:4"), "rod")
    radius = np.hypot(x1 - x0, y1 - y0)
    assert np.degrees(np.arctan2(y0 - y1, x1 - x0)) == pytest.approx(30, abs=1e-4)
    assert np.hypot(*(rod[1] - rod[0])) == pytest.approx(4 * radius, rel=1e-6)
    assert y2 == pytest.approx(y0, abs=1e-5)
    assert x2 > x1


@drawn
def test_the_arc_crank_on_paper_is_true_to_scale() -> None:
    root = svg("--positions", "70", "--mechanism", "arc", "--ratio", "1:4", "--rocker", "3")
    crank, rod, rocker = (np.diff(path_of(root, name), axis=0)[0] for name in ("crank", "rod", "rocker"))
    lengths = [float(np.hypot(*one)) for one in (crank, rod, rocker)]
    assert lengths == pytest.approx([lengths[0], 4 * lengths[0], 3 * lengths[0]], rel=1e-5)
    assert np.degrees(np.arctan2(-crank[1], crank[0])) == pytest.approx(70, abs=1e-3)


@drawn
def test_an_indicator_card_of_the_ideal_engine_draws_nearly_its_curve() -> None:
    require_library("pint")
    ideal = path_of(svg("--turning", "--eps", "2", "--step", "5"), "curve-2-1")
    card = path_of(svg("--turning", "--card", str(CARD), "--step", "5"), "curve-2-1")
    # The ideal engine's curve has two points of cut-off as well.
    assert len(ideal) == len(card) + 2
    near = ideal[[int(np.argmin(abs(ideal[:, 0] - place))) for place in card[:, 0]]]
    np.testing.assert_allclose(near, card, rtol=0, atol=0.5)


@drawn
def test_a_drawing_says_what_it_shows() -> None:
    assert title(svg("--step", "10")) == (
        "Kolbenweg, Kolbengeschwindigkeit und Kolbenbeschleunigung für R:L = 1:5; genaue Formeln"
    )
    assert (
        title(svg("--positions", "30", "--ratio", "1:4.5", "--lang", "en")) == "Crank drive for R:L = 1:4.5"
    )
    assert title(svg("--positions", "30", "--ratio", "1:4.5", "--decimal", "point")) == (
        "Kurbeltrieb für R:L = 1:4.5"
    )
    arc = ("--mechanism", "arc", "--rocker", "5.5", "--positions", "30")
    assert title(svg(*arc)) == "Bogenschubkurbel für R:L = 1:5, B = 5,5 R"
    assert title(svg("--mechanism", "parallel", "--positions", "30", "--lang", "en")) == "Parallel crank"
    assert title(svg("--polar", "--eps", "4", "--step", "10")) == (
        "Polardiagramm der Kraft am Kurbelzapfen im Achsenkreuz der Kurbel: Tangentialkraft T, Radialkraft Z"
        " der Dampfmaschine für ε = 4, R:L = 1:5; genaue Formeln"
    )


@drawn
def test_the_environment_gives_defaults_that_other_kinds_ignore() -> None:
    environment = {"KURBEL_PLOT_COLUMNS": "x", "KURBEL_PLOT_BORE": "300mm", "KURBEL_PLOT_SPEED": "nonsense"}
    words = ("plot", "--polar", "--step", "10", "-f", "svg")
    assert printed(*words, **environment).out == printed(*words).out
    only = ("plot", "--step", "10", "-f", "svg")
    assert printed(*only, KURBEL_PLOT_COLUMNS="x").out == printed(*only, "--columns", "x").out
    assert printed(*only, KURBEL_PLOT_EPS="nonsense").out == printed(*only).out
    assert printed(*words, KURBEL_PLOT_EPS="3").out == printed(*words, "--eps", "3").out


ENGINE_FILE = """
[crank]
ratio = "1:4"
stroke = "600mm"
speed = "120/min"
angles = "0;90"
[steam]
eps = 3
back = "10%"
bore = "300mm"
pressure = "8bar"
[masses]
reciprocating = "300kg"
rod = "150kg"
centre = "0.4"
gyration = "0.3"
[flywheel]
power = "50kW"
"""
CRANK = ("--ratio", "1:4", "--stroke", "600mm")
OF_FILE = (*CRANK, *MASSES, "--back", "0.1")


@pytest.fixture
def machine(tmp_path: Path) -> str:
    path = tmp_path / "engine.toml"
    path.write_text(ENGINE_FILE, encoding="utf-8")
    return str(path)


@drawn
@pytest.mark.parametrize(
    ("kind", "typed"),
    [
        (("--step", "10"), (*CRANK, "--speed", "120/min")),
        (("--positions", "30"), CRANK),
        (("--forces", "--step", "10"), OF_FILE),
        (("--polar", "--step", "10"), OF_FILE),
        (("--polar", "--step", "10", "--lang", "en"), OF_FILE),
        (("--turning", "--step", "10"), (*OF_FILE, "--cranks", "0;90")),
        (("--polar", "--step", "10", "--force", "10kN"), CRANK),
        (("--forces", "--step", "10", "--force", "10kN"), CRANK),
        (("--step", "10", "--force", "10kN"), (*CRANK, "--speed", "120/min")),
    ],
)
def test_a_drawing_takes_from_the_machine_what_is_its_own(
    kind: tuple[str, ...], typed: tuple[str, ...], machine: str
) -> None:
    words = ("plot", *kind, "-f", "svg")
    drawing = printed(*words, "--machine", machine).out
    assert drawing == printed(*words, *typed).out
    steam = ("--eps", "4") if "--turning" in kind else ()
    assert drawing != printed(*words, *steam).out


@drawn
@pytest.mark.parametrize(
    ("kind", "other"), [(("--polar",), ()), (("--positions", "50"), ("--offset", "0.3"))]
)
def test_the_straight_and_the_offset_crank_can_be_named(
    kind: tuple[str, ...], other: tuple[str, ...]
) -> None:
    words = ("plot", *kind, *other, "-f", "svg")
    name = "offset" if other else "straight"
    assert printed(*words, "--mechanism", name).out == printed(*words).out
    assert printed(*words, KURBEL_PLOT_MECHANISM=name).out == printed(*words).out


@drawn
def test_a_mechanism_without_forces_in_the_environment_hinders_no_drawing_of_forces() -> None:
    words = ("plot", "--polar", "--step", "10", "-f", "svg")
    assert printed(*words, KURBEL_PLOT_MECHANISM="arc", KURBEL_PLOT_ROCKER="6").out == printed(*words).out


@drawn
def test_an_engine_is_drawn_with_the_offset_of_the_machine(tmp_path: Path) -> None:
    file = tmp_path / "engine.toml"
    file.write_text("[crank]\noffset = 0.2\n[steam]\neps = 3\n", encoding="utf-8")
    for kind in ("--forces", "--polar", "--turning"):
        words = ("plot", kind, "--step", "30", "-f", "svg")
        typed = printed(*words, "--eps", "3", "--offset", "0.2").out
        assert printed(*words, "--machine", str(file)).out == typed
        assert typed != printed(*words, "--eps", "3").out


@drawn
def test_what_is_typed_outdoes_the_machine(machine: str) -> None:
    words = ("plot", "--polar", "--step", "10", "-f", "svg", "--machine", machine)
    other = printed(*words, "--eps", "5", "--ratio", "1:6").out
    typed = (*MASSES[2:], "--back", "0.1", "--eps", "5", "--ratio", "1:6")
    assert other == printed(*words[:-2], *typed).out
    assert other != printed(*words).out
    sentence = refusal(*words, "--columns", "x")
    assert sentence == "--columns says nothing about the polar diagram of an engine; leave it out"


@drawn
def test_stroke_and_rod_give_an_engine_its_ratio(tmp_path: Path) -> None:
    file = tmp_path / "engine.toml"
    file.write_text('[crank]\nstroke = "600mm"\nrod = "1350mm"\n[steam]\neps = 3\n', encoding="utf-8")
    for kind in ("--polar", "--forces", "--turning"):
        words = ("plot", kind, "--step", "10", "-f", "svg")
        drawing = printed(*words, "--machine", str(file)).out
        assert drawing == printed(*words, "--eps", "3", "--ratio", "1:4,5").out


# Refusals ---------------------------------------------------------------------------------------------

REFUSALS = [
    (("--eps", "4"), "--eps describes a steam engine; --forces, --polar, --pressures and --turning draw one"),
    (
        ("--positions", "30", "--bore", "300mm"),
        "--bore describes a steam engine; --forces, --polar, --pressures and --turning draw one",
    ),
    (("--polar", "--bore", "300mm"), "--bore is for the steam of an engine; add --eps or --card"),
    (("--forces", "--rod-mass", "9kg"), "--rod-mass is for the steam of an engine; add --eps or --card"),
    (
        ("--polar", "--eps", "4", "--cranks", "0;90"),
        "--cranks says nothing about the polar diagram of an engine; leave it out",
    ),
    (
        ("--forces", "--eps", "4", "--force", "10kN"),
        "--force says nothing about the forces of an engine; leave it out",
    ),
    (
        ("--forces", "--eps", "4", "--offset", "4"),
        "offset e = 4 R is too large for R:L = 1:5; the crank turns only if |e| < L - R = 4 R, for at"
        " φ = 270° the rod stands square to the slide",
    ),
    (
        ("--forces", "--eps", "4", "--columns", "mean_force"),
        'there is no column "mean_force"; choose from epsilon, ratio, phi, ',
    ),
    (
        ("--forces", "--eps", "4", "--columns", "rod_force_n"),
        "column rod_force_n needs --bore and, but for a card, --pressure; leave it out, or give that",
    ),
    (
        ("--polar", "--eps", "3", "--bore", "300mm"),
        "newtons need the bore and the steam pressure; add --pressure",
    ),
    (
        ("--polar", "--eps", "3", "--reciprocating", "90kg"),
        "--reciprocating needs --stroke, --speed, --bore, --pressure to become a force",
    ),
    (
        ("--polar", "--eps", "3;4"),
        "--polar draws one crank drive, and 2 expansion ratios were given; choose one",
    ),
    (
        ("--polar", "--eps", "3", "--ratio", "1:4;1:5"),
        "--polar draws one crank drive, and 2 ratios were given; choose one",
    ),
    (
        ("--forces", "--eps", "3", "--method", "infinite"),
        "--method infinite is for the motion alone; of engines write --ratio 1:∞",
    ),
    (
        ("--mechanism", "arc"),
        "the arc crank needs the length of its rocker; add --rocker, for example --rocker 6",
    ),
    (
        ("--mechanism", "offset"),
        "the offset crank needs the offset e; add --offset, for example --offset 0.5",
    ),
    (
        ("--mechanism", "parallel", "--stroke", "600mm"),
        "--stroke does not belong to the parallel crank, whose page is in units of R and v; it is for"
        " --mechanism straight, offset, arc or beam",
    ),
    (
        ("--mechanism", "parallel", "--positions", "30", "--ratio", "1:4"),
        "--ratio does not belong to the parallel crank; it is for --mechanism straight, offset, arc or beam",
    ),
    (
        ("--mechanism", "arc", "--rocker", "6", "--force", "9kN"),
        "--force says nothing about the arc crank; leave it out",
    ),
    (
        ("--mechanism", "arc", "--rocker", "6", "--positions", "30", "--ratio", "1:4;1:5"),
        "--positions draws one crank drive, and 2 ratios were given; choose one",
    ),
    (
        ("--mechanism", "arc", "--rocker", "6", "--polar"),
        "the polar diagram of the arc crank is not drawn; leave --mechanism out",
    ),
    (
        ("--mechanism", "arc", "--polar", "--eps", "4"),
        "the arc crank needs the length of its rocker; add --rocker, for example --rocker 6",
    ),
    (("--rocker", "6"), "--rocker does not belong to the straight crank; it is for --mechanism arc"),
    (
        ("--mechanism", "arc", "--rocker", "6", "--columns", "y"),
        'there is no column "y"; choose from ratio, phi, path, ',
    ),
    (
        ("--mechanism", "arc", "--rocker", "13", "--positions", "30"),
        "the length of the rod is 5 R, that of the rocker 13 R; drawn to scale they may be at most 12 R, or"
        " the crank is too small to be seen",
    ),
    (("--forces", "--polar"), "--forces and --polar are two drawings; leave one out"),
    (
        ("--forces", "--eps", "2..30"),
        "a panel of 29 curves was asked for; at most 12 can be told apart",
    ),
    (("--forces", "--eps", "3", "--to", "0"), "the only crank angle is 0°; a curve needs two"),
    (("--polar", "--turning"), "--polar and --turning are two drawings; leave one out"),
    (("--positions", "30", "--polar"), "--positions and --polar are two drawings; leave one out"),
    (("--positions", "30", "--columns", "x"), "--columns says nothing about the mechanism; leave it out"),
    (("--positions", "30", "--step", "5"), "--step says nothing about the mechanism; leave it out"),
    (("--polar", "--speed", "2/s"), "--speed says nothing about the polar diagram; leave it out"),
    (
        ("--turning", "--eps", "4", "--power", "5kW"),
        "--power is for --inertia, whose flywheel is weighed against it; leave it out",
    ),
    (
        ("--turning", "--eps", "4", "--inertia", "3kgm2", "--speed", "2/s"),
        "--inertia needs the mean torque that it takes up; add --power, or --stroke, --bore and the pressure",
    ),
    (
        ("--turning", "--rocker", "6"),
        "--rocker does not belong to the straight crank; it is for --mechanism arc",
    ),
    (("--polar", "--ratio", "1:4;1:5"), "--polar draws one crank drive, and 2 ratios were given; choose one"),
    (("--polar", "--method", "series"), 'method "series" has no formula for tangential_force; use exact'),
    (
        ("--turning", "--method", "infinite"),
        "--method infinite is for the motion alone; of engines write --ratio 1:∞",
    ),
    (("--columns", "x_mm"), "column x_mm is in mm and needs --stroke"),
    (("--columns", "phi"), "--columns names no quantity; add one, for example --columns phi,x,c,p"),
    (("--from", "30", "--to", "30"), "the only crank angle is 30°; a curve needs two"),
    (("--polar", "--from", "30", "--to", "30"), "the only crank angle is 30°; a curve needs two"),
    (
        ("--step", "0.01"),
        f"curves of 36001 points were asked for; at most {MOST_POINTS} can be drawn, so make the step larger",
    ),
    (("--ratio", "1:3..30"), "a panel of 28 curves was asked for; at most 12 can be told apart"),
    (("--turning", "--eps", "2..30"), "a panel of 29 curves was asked for; at most 12 can be told apart"),
    (
        ("--positions", "0..360"),
        "a drawing of 361 crank angles was asked for; at most 36 can be told apart",
    ),
    (("--positions", "1e30"), "an angle is beyond 1000000°; give it within one turn, 0..360"),
    (
        ("--ratio", "1:1"),
        "crank ratio R:L is 1; it must be below 1, or the rod is too short to pass the dead centre",
    ),
]


@pytest.mark.parametrize(("words", "sentence"), REFUSALS, ids=[" ".join(words) for words, _ in REFUSALS])
def test_what_cannot_be_drawn_is_refused_in_a_sentence(
    words: tuple[str, ...], sentence: str, tmp_path: Path
) -> None:
    refused = refusal("plot", *words, "-o", str(tmp_path / "drawing.svg"))
    # A list of names goes on after its beginning.
    assert refused[: len(sentence)] == sentence if sentence.endswith(", ") else refused == sentence
    assert list(tmp_path.iterdir()) == []


def test_a_drawing_without_a_file_asks_for_one() -> None:
    assert refusal("plot") == f"no file was named; add -o kurbel.svg, or -f svg for standard output; {HELP}"
    assert refusal("plot", "-o", "") == f"--output names no file; - is standard output; {HELP}"


@pytest.mark.parametrize("words", [(), ("-f", "svg", "-o", "-")])
def test_a_terminal_gets_a_sentence_instead_of_a_drawing(words: tuple[str, ...]) -> None:
    ours, terminal = pty.openpty()
    command = [sys.executable, "-m", "kurbel", "plot", *words]
    done = subprocess.run(command, stdout=terminal, stderr=subprocess.PIPE, text=True, check=False)
    os.close(terminal)
    os.close(ours)
    sentence = f"a terminal shows no drawings; name a file, such as -o kurbel.svg; {HELP}"
    assert (done.returncode, done.stderr) == (2, f"kurbel: {sentence}\n")


@pytest.mark.parametrize("name", ["drawing", "drawing.txt", "drawing.svg.gz"])
def test_a_file_of_another_suffix_is_refused(name: str, tmp_path: Path) -> None:
    sentence = refusal("plot", "-o", str(tmp_path / name))
    assert sentence.endswith(f'{name}" names no drawing; its suffix must be one of .svg, .png, .pdf, .pgf')
    assert list(tmp_path.iterdir()) == []


def test_an_unknown_format_is_answered_with_the_nearest() -> None:
    names = "svg, png, pdf, pgf, html, gif"
    sentence = f'there is no drawing format "pgn" (did you mean png?); choose from {names}'
    assert refusal("plot", "-f", "pgn") == sentence


@pytest.mark.parametrize(
    "words",
    [
        (),
        ("--polar",),
        ("--positions", "30"),
        ("--turning", "--eps", "4"),
        ("--forces", "--eps", "4"),
        ("--polar", "--eps", "4"),
        ("--mechanism", "parallel"),
        ("--mechanism", "parallel", "--positions", "30"),
        ("--mechanism", "arc", "--rocker", "6", "--positions", "30"),
    ],
)
def test_without_matplotlib_the_extra_is_named(
    words: tuple[str, ...], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(sys.modules, "matplotlib", None)
    sentence = f"drawings need matplotlib; install it with: {how_to_install('plot')}"
    assert refusal("plot", *words, "-o", str(tmp_path / "drawing.svg"), code=1) == sentence
    assert list(tmp_path.iterdir()) == []


@drawn
def test_a_drawing_that_cannot_be_written_leaves_the_old_one(tmp_path: Path) -> None:
    sentence = refusal("plot", "--step", "10", "-o", str(tmp_path / "none" / "drawing.svg"), code=1)
    assert sentence.endswith(f"the directory {tmp_path / 'none'} does not exist")
    old = tmp_path / "drawing.svg"
    old.write_text("as it was")
    refusal("plot", "--columns", "x_mm", "-o", str(old))
    assert old.read_text() == "as it was"


@pytest.mark.slow
def test_a_home_that_cannot_be_written_is_no_word_beside_a_drawing(
    programs: Programs, tmp_path: Path
) -> None:
    nowhere = dict.fromkeys(("HOME", "XDG_CONFIG_HOME", "XDG_CACHE_HOME"), str(tmp_path / "file/none"))
    (tmp_path / "file").write_text("")
    environment = {name: text for name, text in os.environ.items() if name != "MPLCONFIGDIR"} | nowhere
    run = programs.kurbel("plot", "-o", str(tmp_path / "drive.svg"), env=environment)
    assert run.communicate()[1] == b""
    assert (tmp_path / "drive.svg").exists()
