"""Every page in imperial units has the values of the metric one."""

import json
import re
import shlex
from fractions import Fraction
from typing import Any

import pytest
from cli import kurbel as kurbel_in

# How many of the SI's each is, by NIST SP 811.
SIZES: dict[str, Fraction] = {
    "in": Fraction("0.0254"), "ft": Fraction("0.3048"), "in²": Fraction("0.00064516"),
    "ft/s": Fraction("0.3048"), "ft/s²": Fraction("0.3048"), "lb": Fraction("0.45359237"),
    "lbf": Fraction("4.4482216152605"), "lbf ft": Fraction("1.3558179483314004"),
    "ft lbf": Fraction("1.3558179483314004"), "hp": Fraction("745.69987158227022"),
    "psi": Fraction("4.4482216152605") / Fraction("0.00064516"), "lb ft²": Fraction("0.0421401100938048"),
    "ft³/min": Fraction("0.028316846592") / 60,
    "mm": Fraction(1, 1000), "cm²": Fraction(1, 10**4), "kN": Fraction(1000), "kPa": Fraction(1000),
    "bar": Fraction(10**5), "MPa": Fraction(10**6), "kW": Fraction(1000), "kJ": Fraction(1000),
    "m³/min": Fraction(1, 60),
}  # fmt: skip


def page(words: tuple[str, ...], *units: str) -> Any:
    result = kurbel_in(*words, *units, "-f", "json")
    assert result.code == 0, result.err
    return json.loads(result.out, parse_float=str)


MACHINE = "--stroke 600mm --speed 120/min --reciprocating 200kg"
STEAM = "--eps 4 --bore 300mm --pressure 8bar"
PAGES = (
    f"table {MACHINE.replace('--reciprocating 200kg', '')} --angle 30;60 --columns phi,x,x_mm,c_mps,p_mps2",
    f"forces {MACHINE} --force 10kN --angle 30;60",
    f"forces {MACHINE} --bore 300mm --head-pressure 5bar --friction 500N --angle 30;60",
    f"forces {MACHINE} {STEAM} --angle 30;60",
    "forces --mechanism arc --rocker 6 --stroke 600mm --force 10kN --angle 30;60",
    "inertia --centre 0.6 --gyration 0.3 --rod-mass 150kg --stroke 600mm --speed 120/min --angle 30",
    "inertia --layout rod-masses --centre 0.6 --gyration 0.3 --rod-mass 10kg --rod 1m",
    f"turning {MACHINE} {STEAM} --angle 30;60 --columns phi,torque_nm,mean_pressure_kpa,indicated_power",
    "turning --torque '5000 + 1500 sin(3φ)' --inertia 500kgm2 --speed 300/min",
    "turning --areas 52;-124;92;-140;85;-72;107 --area-scale '500 N m; 6°'",
    "flywheel --power 50kW --speed 120/min --delta 1:100 --eps 4 --radius 1.5m",
    "flywheel --swing 5kJ --speed 300/min --delta 1:50 --radius 0.6m",
    f"power {STEAM} --stroke 450mm --speed 200/min --specific-volume '0.24 m3/kg'",
    "power --pressure-ratio 4 --suction-pressure 1bar --bore 300mm --stroke 450mm --speed 200/min",
    f"pressures {MACHINE} {STEAM}",
    "rotor --masses '200;300kg' --radii '0.2;0.15m' --angles 0;45 --planes 0;400mm --speed 300/min",
    f"solve {MACHINE.replace('--reciprocating 200kg', '')} --where c=max --columns phi,x_mm,c_mps",
    "solve --unknown force --ratio 1:4 --stroke 300mm --angle 60 --where 'torque = 500 N m'",
    f"solve {STEAM} --stroke 600mm --where torque=max --columns phi,torque_nm",
)


@pytest.mark.parametrize("words", PAGES)
def test_a_page_in_imperial_units_has_the_values_of_the_metric_one(words: str) -> None:
    name = tuple(shlex.split(words))
    metric = page(name)
    other = page(name, "--units", "imperial")
    changed = 0
    assert len(metric["rows"]) == len(other["rows"])
    for row, own in zip(metric["rows"], other["rows"], strict=True):
        for one, column in zip(metric["columns"], other["columns"], strict=True):
            value, converted = row[one["key"]], own[column["key"]]
            units = one["unit"], column["unit"]
            if units[0] == units[1] or value is None:
                assert value == converted, (one["key"], units)
                continue
            changed += 1
            apart = _si(value, units[0]) - _si(converted, units[1])
            assert abs(apart) <= _half(value, units[0]) + _half(converted, units[1]), (
                one["key"],
                value,
                converted,
            )
    assert changed


def _si(value: Any, unit: str) -> Fraction:
    size: Fraction = SIZES.get(unit, Fraction(1))
    return Fraction(str(value)) * size


def _half(value: Any, unit: str) -> Fraction:
    """Return half a unit of the last place, in the SI's."""
    places = len(str(value).partition(".")[2])
    found: Fraction = SIZES.get(unit, Fraction(1)) / (2 * 10**places)
    return found


# What a page has in units of the drive without lengths and speed, and the columns of these.
SHARES = {
    "table --angle 30": "x,x_return,c,c_return,p,p_return",
    "table --mechanism arc --rocker 6 --angle 30": "path,velocity_return,acceleration",
    "table --mechanism beam --beam 3 --angle 30": "path,velocity_return,acceleration",
    "table --layout series-errors": "error_x,error_c,error_p",
    "solve --where c=max": "x,c",
    "turning --layout turning-path --angle 30": "pin_path",
    "deadcentres --offset 0.2": "stroke",
}


@pytest.mark.parametrize("words", SHARES)
def test_a_machine_is_printed_in_millimetres_and_metres_alone(words: str) -> None:
    def rows(*options: str) -> str:
        """Return what a page has between its outer rules, heads included."""
        result = kurbel_in(*words.split(), *options, "-f", "text")
        assert result.code == 0, result.err
        return result.out.split("━\n")[1]

    # The turning effort knows a speed of moving masses alone.
    machine = f"{MACHINE} {STEAM}".split()[: None if words.startswith("turning") else 4]
    share = re.compile(r"x/R|c/v|p R/v²|s/r| R$", re.MULTILINE)
    assert share.search(rows())
    assert not share.search(rows(*machine))
    assert share.search(rows(*machine, "--columns", SHARES[words]))
    keys = {one["key"] for one in page((*words.split(), *machine))["columns"]}
    assert keys > {*SHARES[words].split(",")}
