"""What pages can be about: where each subject stands, and a command that prints a page of it."""

from __future__ import annotations

from collections.abc import Mapping

from kurbel.drive import mechanisms
from kurbel.drive.mechanisms import Pages

_INERTIA = "inertia --centre 0.65 --gyration 0.35"
_MACHINE = "forces --eps 4 --bore 300mm --pressure 8bar --stroke 600mm --speed 120/min --reciprocating 300kg"
_EFFORT = "forces --bore 300mm --pressure-difference 2bar --stroke 600mm --friction 500N"
_HEAVY = "forces --stroke 600mm --speed 120/min --reciprocating 300kg"
_ARC = "--mechanism arc --rocker 6"
_PRESSED = _MACHINE.replace("forces", "pressures")
_LISTED = "delta --eps 4 --cranks 0;90"
_EXCITED = "harmonics --quantity torque --eps 4 --bore 300mm --pressure 8bar --stroke 600mm --speed 120/min"
_AXLE = "--spacing 0.7m --gauge 1.5m --stroke 600mm --reciprocating 300kg"
_ROTOR = "--masses 3;4kg --radii 1m --angles 0;90 --planes 0;1m"
_EVEN = "--power 50kW --speed 120/min --delta 1:100"
# What pages can be about, by its name.
SUBJECTS: Mapping[str, Pages] = {
    "motion": Pages("kurbel.motion.page:MOTION", "table"),
    "effort": Pages("kurbel.motion.page:EFFORT", _EFFORT),
    "mass forces": Pages("kurbel.motion.page:MASSES", _HEAVY),
    "series errors": Pages("kurbel.motion.series.errors_page:SUBJECT", "table --layout series-errors"),
    "successive": Pages("kurbel.motion.series.chord_page:SUBJECT", "table --layout roetscher-gf"),
    "tangent": Pages("kurbel.motion.tangent_page:SUBJECT", "forces --at tangent"),
    "irregularity": Pages("kurbel.engine.page:IRREGULARITY", "delta"),
    "strokes": Pages("kurbel.engine.page:STROKES", "delta --eps 2"),
    "cylinders": Pages("kurbel.engine.cylinders.page:SUBJECT", _LISTED),
    "compressor": Pages("kurbel.engine.page:COMPRESSOR", "delta --pressure-ratio 2..6"),
    "pump": Pages("kurbel.engine.page:PUMP", "delta --pump"),
    "gas cycle": Pages("kurbel.engine.page:GAS_CYCLE", "delta --compression 5..8 --heat 10"),
    "power": Pages("kurbel.engine.power.page:SUBJECT", "power --eps 3 --pressure 8bar"),
    "turning": Pages("kurbel.engine.page:TURNING", "turning --eps 4"),
    "torques": Pages("kurbel.engine.diagram.page:OF_TORQUES", "turning --torque 5000+1500sin(3φ)"),
    "areas": Pages("kurbel.engine.diagram.page:OF_AREAS", "turning --areas +52J;-124J;+72J"),
    "speed": Pages("kurbel.engine.speed.page:SPEED", "turning --eps 4 --flywheel 50 --speed 120/min"),
    "evenness": Pages("kurbel.engine.speed.page:EVENNESS", "delta --flywheel 50"),
    "crank forces": Pages("kurbel.engine.page:CRANK_FORCES", "forces --eps 4"),
    "machine": Pages("kurbel.engine.page:MACHINE", _MACHINE),
    "rod load": Pages("kurbel.engine.rodload.page:SUBJECT", "forces --eps 4"),
    "flywheel": Pages("kurbel.engine.page:FLYWHEEL", f"flywheel --eps 4 {_EVEN}"),
    "flywheel sizing": Pages(
        "kurbel.engine.diagram.wheel.page:SUBJECT", "flywheel --swing 5kJ --speed 300/min --delta 1:50"
    ),
    "pressures": Pages("kurbel.engine.pressures.page:PRESSURES", _PRESSED),
    "pressures over the angle": Pages("kurbel.engine.pressures.page:PRESSURES_OVER_ANGLE", _PRESSED),
    "dead centres": Pages("kurbel.linkage.beam.page:SUBJECT", "deadcentres"),
    "drive dead centres": Pages("kurbel.linkage.dead_centres:SUBJECT", f"deadcentres {_ARC}"),
    "harmonics": Pages("kurbel.balancing.harmonics_page:SUBJECT", "harmonics"),
    "torque": Pages("kurbel.engine.harmonics.page:TORQUE", "harmonics --quantity torque --eps 4"),
    "excitation": Pages("kurbel.engine.harmonics.page:EXCITING", _EXCITED),
    "balance": Pages("kurbel.balancing.page:SUBJECT", "balance"),
    "balance at angles": Pages("kurbel.balancing.angles.page:AT_ANGLES", "balance --angle 30"),
    "balance extremes": Pages("kurbel.balancing.angles.extremes:EXTREMES", "balance"),
    "rotor": Pages("kurbel.balancing.rotors.page:SUBJECT", f"rotor {_ROTOR}"),
    "locomotive": Pages("kurbel.balancing.locomotives.page:SUBJECT", f"locomotive {_AXLE}"),
    "firing orders": Pages("kurbel.balancing.firing_page:ORDERS", "firing"),
    "firing": Pages("kurbel.balancing.firing_page:FIRING", "firing --order 1-3-4-2"),
    **mechanisms.SUBJECTS,
    "coupled axles": Pages("kurbel.linkage.coupled:SUBJECT", "forces --mechanism parallel --axles 3"),
    "rod points": Pages("kurbel.motion.points.page:SUBJECT", "table --point 0.5"),
    "inertia": Pages("kurbel.motion.inertia_page:INERTIA", _INERTIA),
    "inertia errors": Pages("kurbel.motion.inertia_page:SUBJECT", _INERTIA),
    "rod masses": Pages("kurbel.motion.rod_masses:SUBJECT", _INERTIA),
    "pin masses": Pages("kurbel.motion.rod_masses:PINS", _INERTIA),
    "rocker inertia": Pages("kurbel.linkage.arc.inertia:SUBJECT", f"{_INERTIA} {_ARC}"),
    "roots": Pages("kurbel.conditions.page:SUBJECT", "solve --where p=0"),
    "over path": Pages("kurbel.conditions.over.page:MOTION", "table --over path"),
    "forces over path": Pages("kurbel.conditions.over.page:FORCES", "forces --over path"),
    "unknown": Pages(
        "kurbel.conditions.unknown_page:SUBJECT", "solve --unknown ratio --angle 80 --where c=max"
    ),
    "loaded roots": Pages("kurbel.conditions.load_page:SUBJECT", "solve --eps 4 --where torque=max"),
    "construction": Pages("kurbel.books.constructions.page:SUBJECT", "construct blau-9 --table"),
    "collation": Pages("kurbel.books.collate_page:SUBJECT", "collate roetscher-112"),
    "formulas": Pages("kurbel.books.formulas.page:SUBJECT", "collate blau-equations"),
}
