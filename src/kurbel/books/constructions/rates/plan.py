"""What the constructions of velocity and acceleration share: the turned-round plan, and the true lengths."""

from __future__ import annotations

from typing import Any

from kurbel.books.constructions.geometry import Point, cross, distance, dot, meet, to
from kurbel.books.constructions.model import (
    AID,
    CENTRE,
    LINK,
    Angle,
    Arrow,
    Circle,
    Element,
    Length,
    Line,
    Measure,
    Placed,
    Points,
    RightAngle,
    Step,
    along,
)
from kurbel.kernel import kinematics
from kurbel.page.quantity import Words, words

ALONG, UP = Point(1, 0), Point(0, 1)
# The drive to scale, by the letters of shaft, crank pin and crosshead pin.
DRIVE = (
    "Kurbelkreis um ${shaft}$, Kurbel ${shaft} {pin} = R$, Schubstange ${pin} {head} = L$; die"
    " Geschwindigkeit $v = ω R$ des Kurbelzapfens ist so lang wie $R$"
    "|Crank circle about ${shaft}$, crank ${shaft} {pin} = R$, rod ${pin} {head} = L$; the velocity"
    " $v = ω R$ of the crank pin is as long as $R$"
)
PLAN = (
    "Senkrechte zur Schubrichtung durch ${shaft}$: sie trifft die Schubstange oder ihre Verlängerung in"
    " ${plan}$; ${shaft} {plan} = c/ω$, und ${pin} {plan}$ ist die Geschwindigkeit von ${head}$ um ${pin}$,"
    " beide um 90° gedreht"
    "|Perpendicular to the slide through ${shaft}$: it meets the rod, or the rod produced, at ${plan}$;"
    " ${shaft} {plan} = c/ω$, and ${pin} {plan}$ is the velocity of ${head}$ about ${pin}$, both turned by"
    " 90°"
)

PARTS = (
    "${end} {shaft} = p/ω^2$; ebenso sind ${pin} {share}$ und ${share} {end}$ die Beschleunigung von ${head}$"
    " um ${pin}$, nach der Stange und senkrecht zu ihr, ${shaft} {pin}$ die von ${pin}$"
    "|${end} {shaft} = p/ω^2$; so are ${pin} {share}$ and ${share} {end}$ the acceleration of ${head}$ about"
    " ${pin}$, along the rod and square to it, and ${shaft} {pin}$ that of ${pin}$"
)

BACK = Step(
    words(
        "Das Dreieck $O P C$ ist der gedrehte Plan: um 90° zurückgedreht ist $O P$ die"
        " Geschwindigkeit $v$ von $P$ und $O C$ die Geschwindigkeit $c$ von $Q$"
        "|The triangle $O P C$ is the turned plan: turned back by 90°, $O P$ is the velocity $v$ of"
        " $P$ and $O C$ the velocity $c$ of $Q$"
    ),
    (Arrow("Q", "W", "$c$"),),
)
SIGNS = words(
    "$c$ ist im Hingang positiv, $p$ nach der Welle hin; die anderen Strecken sind Beträge ihrer Formeln"
    "|$c$ is positive on the outstroke, $p$ towards the shaft; the other lengths are the amounts of their"
    " formulas"
)
SCHMOLKE = words(
    "Schmolke, Dinglers Polytechnisches Journal 330 (1915), 476, Abb. 3"
    "|Schmolke, Dinglers Polytechnisches Journal 330 (1915), 476, Fig. 3"
)
STRAIGHT = "{author}'s construction holds for the straight crank alone; klein holds for the offset one, too"


def said(text: str, **letters: str) -> Words:
    """Return a sentence in both languages with the letters of a book."""
    return words(text.format(**letters))


def drive_step(pin: str, head: str, *more: Element, offset: bool = True) -> Step:
    """Return the step that draws the drive; where there may be an offset, the shaft has a line of its own."""
    slide = "across" if offset else head
    lines = (Line("across", "O", CENTRE, 6), Line(head, "above", CENTRE, 6)) if offset else ()
    return Step(
        said(DRIVE, shaft="O", pin=pin, head=head),
        (
            Circle("O", pin, CENTRE),
            *(lines or (Line(head, "O", CENTRE, 6),)),
            Line("O", pin, LINK),
            Line(pin, head, LINK),
            Angle("O", slide, pin, "$φ$", 1),
            *more,
        ),
        ("O", pin, head),
    )


def plan_step(pin: str, head: str, plan: str, *measures: Measure, offset: bool = True) -> Step:
    """Return the step that draws the turned plan."""
    slide = "across" if offset else head
    return Step(
        said(PLAN, shaft="O", pin=pin, head=head, plan=plan),
        (Line(pin, plan, AID, 3), Line("O", plan, AID, 3), RightAngle("O", plan, slide), *measures),
        (plan,),
    )


def turned_plan(at: Placed) -> Point:
    """Return where the perpendicular to the slide through the shaft meets the line of the rod."""
    return meet(at.pin, to(at.crosshead, at.pin), at.shaft, UP)


def shared(at: Placed, plan: Point) -> Any:
    """Return u²/L² of the turned plan: which share of the rod its normal acceleration is."""
    return square(at.pin, plan) / (at.rod * at.rod)


def square(start: Point, end: Point) -> Any:
    """Return the square of the length between two points."""
    way = to(start, end)
    return dot(way, way)


def upward(start: str, end: str) -> Any:
    """Return what measures from one point up to another across the slide."""
    return lambda points: points[end].y - points[start].y


def velocity(at: Placed) -> Any:
    """Return c in units of v."""
    if at.drive.offset:
        return kinematics.offset_velocity(at.circle, at.ratio, at.offset)
    return kinematics.piston_velocity(at.circle, at.ratio)


def acceleration(at: Placed) -> Any:
    """Return p in units of v²/R."""
    if at.drive.offset:
        return kinematics.offset_acceleration(at.circle, at.ratio, at.offset)
    return kinematics.piston_acceleration(at.circle, at.ratio)


def swing(at: Placed) -> Any:
    """Return |u| = L |ψ'|, the velocity of the crosshead about the crank pin, in units of v."""
    return abs(at.rod * kinematics.offset_rod_velocity(at.circle, at.ratio, at.offset))


def towards_pin(at: Placed) -> Any:
    """Return u²/L, its acceleration along the rod, in units of v²/R."""
    turn = kinematics.offset_rod_velocity(at.circle, at.ratio, at.offset)
    return at.rod * turn * turn


def across_rod(at: Placed) -> Any:
    """Return L |ψ''|, its acceleration square to the rod, in units of v²/R."""
    return abs(at.rod * kinematics.offset_rod_acceleration(at.circle, at.ratio, at.offset))


def on_rod(start: str, end: str, pin: str, head: str) -> Any:
    """Return what measures a length that lies on the line of the rod, and has no root that fails at 0."""

    def measure(points: Points) -> Any:
        rod = to(points[pin], points[head])
        return abs(dot(to(points[start], points[end]), rod)) / distance(points[pin], points[head])

    return measure


def square_to_rod(start: str, end: str, pin: str, head: str) -> Any:
    """Return what measures a length square to the rod."""

    def measure(points: Points) -> Any:
        rod = to(points[pin], points[head])
        return abs(cross(rod, to(points[start], points[end]))) / distance(points[pin], points[head])

    return measure


def velocity_length(shaft: str, plan: str) -> Length:
    return Length(
        shaft + plan, (shaft, plan), "$c/ω$", "$R(sin φ + cos φ tan ψ)$", upward(shaft, plan), velocity
    )


def swing_length(pin: str, plan: str, head: str) -> Length:
    ends = (pin, plan)
    return Length(pin + plan, ends, "$u/ω$", "$R (cos φ)/(cos ψ)$", on_rod(*ends, pin, head), swing)


def normal_length(start: str, end: str, pin: str, head: str) -> Length:
    ends, formula = (start, end), "$u^2/(ω^2 L) = R λ (cos^2 φ)/(cos^2 ψ)$"
    return Length(start + end, ends, "", formula, on_rod(*ends, pin, head), towards_pin)


def tangential_length(start: str, end: str, pin: str, head: str) -> Length:
    ends, formula = (start, end), "$R(sin φ - (λ cos^2 φ tan ψ)/(cos ψ))/(cos ψ)$"
    return Length(start + end, ends, "", formula, square_to_rod(*ends, pin, head), across_rod)


def acceleration_length(start: str, end: str) -> Length:
    """Return the length that is p/ω², positive towards the shaft."""
    formula = "$R(cos φ - sin φ tan ψ + λ (cos^2 φ)/(cos^3 ψ))$"
    return Length(start + end, (start, end), "$p/ω^2$", formula, along(start, end), acceleration)
