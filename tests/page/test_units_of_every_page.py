"""Every page in imperial units has the values of the metric one, and no metric unit."""

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
    "ft³/min": Fraction("0.028316846592") / 60, "lb ft": Fraction("0.138254954376"),
    "mph": Fraction("0.44704"), "lb/h": Fraction("0.45359237") / 3600,
    "lb/(hp h)": Fraction("0.45359237") / (Fraction("745.69987158227022") * 3600),
    "mm": Fraction(1, 1000), "cm²": Fraction(1, 10**4), "kN": Fraction(1000), "kPa": Fraction(1000),
    "bar": Fraction(10**5), "MPa": Fraction(10**6), "kW": Fraction(1000), "kJ": Fraction(1000),
    "m³/min": Fraction(1, 60), "km/h": 1 / Fraction("3.6"), "kg/h": Fraction(1, 3600),
    "kg/kWh": 1 / Fraction(3_600_000),
}  # fmt: skip


def page(words: tuple[str, ...], *units: str) -> Any:
    result = kurbel_in(*words, *units, "-f", "json")
    assert result.code == 0, result.err
    return json.loads(result.out, parse_float=str)


MACHINE = "--stroke 600mm --speed 120/min --reciprocating 200kg"
STEAM = "--eps 4 --bore 300mm --pressure 8bar"
WEIGHED = f"balance --engine inline-3 --spacing 0.9m {MACHINE}"
PAGES = (
    f"table {MACHINE.replace('--reciprocating 200kg', '')} --angle 30;60 --columns phi,x,x_mm,c_mps,p_mps2",
    f"forces {MACHINE} --force 10kN --angle 30;60",
    f"forces {MACHINE} --bore 300mm --head-pressure 5bar --friction 500N --angle 30;60",
    f"forces {MACHINE} {STEAM} --angle 30;60",
    "forces --mechanism arc --rocker 6 --stroke 600mm --force 10kN --angle 30;60",
    "inertia --centre 0.6 --gyration 0.3 --rod-mass 150kg --stroke 600mm --speed 120/min --angle 30",
    "inertia --layout inertia-errors --centre 0.6 --gyration 0.3 --rod-mass 150kg --stroke 600mm --speed 2/s",
    "inertia --layout rod-masses --centre 0.6 --gyration 0.3 --rod-mass 10kg --rod 1m",
    f"turning {MACHINE} {STEAM} --angle 30;60 --columns phi,torque_nm,mean_pressure_kpa,indicated_power",
    "turning --torque '5000 + 1500 sin(3φ)' --inertia 500kgm2 --speed 300/min",
    "turning --areas 52;-124;92;-140;85;-72;107 --area-scale '500 N m; 6°'",
    "flywheel --power 50kW --speed 120/min --delta 1:100 --eps 4 --radius 1.5m",
    "flywheel --swing 5kJ --speed 300/min --delta 1:50 --radius 0.6m",
    f"power {STEAM} --stroke 450mm --speed 200/min --specific-volume '0.24 m3/kg' --efficiency 0.8",
    "power --pressure-ratio 4 --suction-pressure 1bar --bore 300mm --stroke 450mm --speed 200/min",
    f"pressures {MACHINE} {STEAM}",
    "rotor --masses '200;300kg' --radii '0.2;0.15m' --angles 0;45 --planes 0;400mm --speed 300/min",
    WEIGHED,
    f"{WEIGHED} --angle 40",
    f"{WEIGHED} --layout balance-greatest",
    "balance --cranks 0;90 --positions '-0.7;0.8m' --reciprocating 300kg --stroke 600mm --speed 2/s"
    " --columns residual,order,along_n",
    "locomotive --spacing 2m --gauge 1.5m --stroke 660mm --reciprocating 240kg --revolving 150kg"
    " --velocity 90km/h --wheel 1.7m --wheel-load 60kN --balance-radius 550mm",
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
            units = _unit(one, row), _unit(column, row)
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


def _unit(column: Any, row: Any) -> str:
    """Return the unit of a column in a row; some have forces in some rows and moments in others."""
    unit: str = column["unit"]
    force, _, moment = unit.partition(", ")
    row_of = row.get("residual") or row.get("force")
    return moment if moment and row_of in ("moment", "couple", "torque") else force


def _si(value: Any, unit: str) -> Fraction:
    size: Fraction = SIZES.get(unit, Fraction(1))
    return Fraction(str(value)) * size


def _half(value: Any, unit: str) -> Fraction:
    """Return half a unit of the last place, in the SI's."""
    places = len(str(value).partition(".")[2])
    found: Fraction = SIZES.get(unit, Fraction(1)) / (2 * 10**places)
    return found


ENGINE = "--stroke 24in --rod 5ft --speed 120/min --reciprocating 300lb"
AXLE = "locomotive --spacing 80in --gauge 58in --stroke 28in --reciprocating 700lb --revolving 300lb"
ACTED = "--eps 4 --bore 12in --pressure 120psi"
GIVEN = (
    f"balance --engine inline-3 --spacing 3ft {ENGINE}",
    f"balance --engine inline-3 --spacing 3ft {ENGINE} --angle 30",
    f"balance --engine inline-3 --spacing 3ft {ENGINE} --layout balance-greatest",
    "balance --cranks 0;90 --positions '-30;30in'",
    f"balance --cranks 0;90 --positions '-30;30in' {ENGINE} --revolving 200lb --revolving-share 1"
    " --balance-radius 10in --about 20in",
    "rotor --masses 20;30lb --radii 8;6in --angles 0;45 --planes 0;4ft --speed 600/min",
    f"{AXLE} --balance-radius 22in --wheel 63in --velocity 88ft/s --wheel-load 30000lbf"
    " --hammer-blow 9000lbf",
    f"power {ACTED} --stroke 24in --speed 120/min --efficiency 0.85 --specific-volume '3.7 ft³/lb'",
    "inertia --centre 0.6 --gyration 0.3 --rod-mass 150lb --stroke 24in --speed 2/s --layout inertia-errors",
    "inertia --layout rod-masses --centre 20in --pendulum 1.8s --pendulum-from crosshead --rod-mass 9lb"
    " --rod 4ft",
    f"forces {ENGINE} --bore 12in --pressure-difference 100psi --friction 100lbf --slope 30 --angle 60",
    "flywheel --power 50hp --speed 120/min --delta 1:100 --eps 4 --radius 5ft",
    "turning --areas '52;-124;92;-140;85;-72;107' --area-scale '500 lbf ft; 6°'",
    "turning --areas '52ft*lbf;-124ft*lbf;72ft*lbf' --inertia 500lbft² --speed 300/min",
    "turning --torque '5000 + 1500 sin(3φ)' --inertia 500lbft² --speed 300/min",
    "solve --force 1000lbf --stroke 24in --where 'guide_force = 100 lbf'",
)
METRIC = re.compile(
    r"(?<![\w/])([kM]?N m|[kM]N|[cm]m|m/s²?|km/h|kg[^\s,;]*|kWh|[kM]?Pa|bar|[kM]W|[kM]J|m³\S+|[cm]?m²)(?!\w)"
    r"|\bin N\b|\d [NJWm](?=[,;.]|$)",
    re.MULTILINE,
)


@pytest.mark.parametrize("lang", ["de", "en"])
@pytest.mark.parametrize("words", GIVEN)
def test_what_is_given_in_imperial_units_has_no_other_on_its_page(words: str, lang: str) -> None:
    given = (*shlex.split(words), "--lang", lang)
    for more in ((), ("--units", "imperial")):
        said = kurbel_in(*given, *more).out.replace("\N{NO-BREAK SPACE}", " ")
        assert "lb" in said or " in" in said or "Zoll" in said
        assert not [one[0] for one in METRIC.finditer(said)]
    assert METRIC.search(kurbel_in(*given, "--units", "metric").out.replace("\N{NO-BREAK SPACE}", " "))


DRAWN = (
    ("--stroke 24in --rod 5ft --columns x_mm", "in mm: 609.60 at 180°", "in inches: 24.000 at 180°"),
    ("--stroke 24in --rod 5ft --speed 120/min --columns c_mps --over path", "c in m/s: ", "c in ft/s: "),
    ("--force 1000lbf --stroke 24in --columns torque_nm", "in N m: 1382.7 at", "in lbf ft: 1019.8 at"),
    (f"--polar {ACTED} --stroke 24in", "in kN", "in 10³ lbf"),
    (f"--pressures {ACTED} {ENGINE}", "in bar", "in psi"),
    (
        "--turning --torque '(50000 + 15000 sin(3φ)) lbf ft'",
        "in kN m: T, T_L = 67.791 kN m; Excess energy W in kJ: ΔW = 13.558 kJ",
        "in 10³ lbf ft: T, T_L = 50.000 · 10³ lbf ft; Excess energy W in 10³ ft lbf: ΔW = 10.000 · 10³ ft",
    ),
    ("--point 0.5 --columns path_along_mm --stroke 24in", "ξ in mm", "ξ in inches"),
)


@pytest.mark.parametrize(("words", "metric", "imperial"), DRAWN)
def test_a_drawing_has_the_units_that_are_given(words: str, metric: str, imperial: str) -> None:
    given = ("plot", *shlex.split(words), "--lang", "en", "-f", "svg", "--width", "150mm")
    for units, said in (((), imperial), (("--units", "metric"), metric)):
        drawn = kurbel_in(*given, *units)
        assert drawn.err == ""
        (told,) = re.findall("<desc>(.*?)</desc>", drawn.out)
        assert said in told
        assert bool(METRIC.search(told.replace("N:", ""))) is (said == metric)


# What a page has in units of the drive without lengths and speed, and the columns of these.
SHARES = {
    "table --angle 30": "x,x_return,c,c_return,p,p_return",
    "table --mechanism arc --rocker 6 --angle 30": "path,velocity_return,acceleration",
    "table --mechanism beam --beam 3 --angle 30": "path,velocity_return,acceleration",
    "table --layout series-errors": "error_x,error_c,error_p",
    "solve --where c=max": "x,c",
    "turning --layout turning-path --eps 4 --angle 30": "pin_path",
    "deadcentres --offset 0.2": "stroke",
}


@pytest.mark.parametrize("words", SHARES)
def test_a_machine_is_printed_in_millimetres_and_metres_alone(words: str) -> None:
    def rows(*options: str) -> str:
        """Return what a page has between its outer rules, heads included."""
        result = kurbel_in(*words.split(), *options, "-f", "text")
        assert result.code == 0, result.err
        return result.out.split("━\n")[1]

    # The turning effort knows a speed of moving masses alone, and has its steam.
    weighed = f"{MACHINE} {STEAM.removeprefix('--eps 4')}".split()
    machine = weighed if words.startswith("turning") else weighed[:4]
    share = re.compile(r"x/R|c/v|p R/v²|s/r| R$", re.MULTILINE)
    assert share.search(rows())
    assert not share.search(rows(*machine))
    assert share.search(rows(*machine, "--columns", SHARES[words]))
    keys = {one["key"] for one in page((*words.split(), *machine))["columns"]}
    assert keys > {*SHARES[words].split(",")}
