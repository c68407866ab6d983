"""`kurbel verify`: the numbers of a page computed once more; a digit changed by hand is found."""

from __future__ import annotations

import io
import json
import re
import shlex
import sys
from collections.abc import Iterator
from fractions import Fraction
from pathlib import Path
from random import Random
from typing import Any
from unittest import mock

import numpy as np
import pytest
from cli import kurbel, printed

import kurbel as library
from kurbel import verify

MASSES = "--stroke 600mm --speed 120/min --pressure 8bar --bore 300mm --reciprocating 100kg"
# A page of each command, drive, load and of each way to say a size.
PAGES = {
    "table --ratio 1:4.5 --step 45 --rounding half-even": 5 * 6,
    "table --stroke 24in --rod 5ft --speed 120rpm --angle 12.5;77 --units imperial": 2 * 12,
    "table --stroke crank:3dm --rod 14dm --offset 6cm --speed 2/s --step 90 --columns phi,x_mm,c_mps,psi": 15,
    "table --mechanism arc --rocker 6R --pivot '5;6' --step 90": 3 * 10,
    "table --method series --order 3 --step 60 --zero 90": 7 * 3,
    "table --layout verfahren --step 90": 5 * 9,
    "table --label my-table --angle 30": 6,
    "table --point 1/3 --angle 40": 10,
    "table --mechanism parallel --angle 40": 6,
    "deadcentres --mechanism arc --rocker 3 --stroke 1m --speed 2/s --columns outstroke_time,return_time": 2,
    "deadcentres --mechanism arc --rocker 3 --pivot '4;1.5'": 8,
    "forces --force 5kN --stroke crank:300mm --step 90": 3 * 10,
    f"forces --stroke 600mm --speed 2/s {MASSES.partition('bar ')[2]} --head-pressure 2bar --friction 500N"
     " --piston-rod 50mm --slope vertical --angle 0;40;180 --columns phi,crosshead_load_n,bearing_force_n": 6,
    f"forces --eps 4 {MASSES} --rod-mass 50kg --clearance 8% --release 92% --cushion 80% --lead 1%"
    " --piston-rod 9cm --tail-rod 4cm --centre 0.6 --gyration 30% --step 90": 5 * 9,
    "forces --compression 6 --heat 10 --layout rod-load --columns thrust,thrust_angle,reversal_unbroken": 9,
    "turning --eps 3 --back 0.1 --exponent 1.2 --clearance 5% --cranks 0;90 --step 120": 4 * 4,
    f"turning --eps 4 {MASSES} --rod-mass 50kg --centre 0.6 --gyration 0.3 --slope 20 --method series"
    " --angle 100": 4,
    "turning --compression 6 --peak-pressure 30 --angle 200": 4,
    "turning --pump single --suction-pressure -0.3bar --delivery-pressure 6bar --angle 30": 4,
    "delta --eps 3 --detail": 2 * 5 + 6,
    f"forces --eps 4 --cranks 0;90 {MASSES} --angle 40;250 --columns phi,torque_nm,rod_force_n": 4,
    "delta --eps 3 --method exact --method series --columns delta_exact,delta_series,difference_series": 3,
    "delta --eps 3 --inertia 3584kgm2 --power 50kW --speed 120/min": 7,
    "turning --eps 4 --flywheel 50 --angle 0;40": 2 * 3,
    "forces --force 1kN --pin-friction 0.06 --crank-pin 120mm --shaft 90mm --stroke 1m --step 60": 7 * 8,
    "forces --mechanism parallel --axles 14;15;14 --driven 2 --angle 40": 8,
    "forces --angle s=0..100%:25% --columns share,phi,phi_return,rod_force_return": 5 * 3,
    "forces --at tangent --force 10kN": 5,
    "table --offset 0.3 --digits 12 --angle s=0;s=1/3;s=1": 3 * 6,
    "table --angle s=0..1:0.5 --mechanism arc --rocker 6": 3 * 6,
    "deadcentres --beam 3 --exact": 6,
    "deadcentres --columns mu,distance_1,path_2": 3,
    "deadcentres --beam 3;1e11 --ratio 1:∞ --exact": 12,
    "solve --where p=0 --where s=12.5% --where c=max --where x=1 --where x=max --offset 0.3 --digits 9": 60,
    "solve --where x=0 --where psi=max --where 'p = 1/6 of dead centre' --ratio 1:4": 42,
    "solve --stroke 600mm --rod 1500mm --speed 120/min --where 'c = 3 m/s'": 28,
    "solve --eps 4 --where tangential=0.5": 4 * 4,
    "solve --where guide_force=max --where s=25% --digits 0 --columns phi_turn,x,guide_force": 20,
    "solve --stroke 400mm --reciprocating 100kg --force 40kN --speed 250/min --where torque=max"
    " --where 'crosshead_load = 30 kN' --columns phi_turn,torque_nm": 12,
    "solve --unknown stroke --ratio 1:4 --force 10kN --reciprocating 30kg --speed 300/min --angle 60;c=max"
    " --where 'torque = 300 N m' --units imperial": 6,
    "forces --compression 6 --peak-pressure 30 --angle 's=10%' --columns phi,rod_force": 8,
    "table --method series --order 3 --angle s=10%;s=1/3": 2 * 6,
    "pressures --reciprocating 300kg --stroke 600mm --bore 300mm --speed 2/s --eps 4 --pressure 8bar": 22 * 4,
    "pressures --eps 4 --bore 300mm --pressure 8bar --angle 0;210 --units imperial": 4,
    "delta --compression 14 --cycle dual --peak-pressure 60 --heat 9 --columns efficiency,mean_pressure": 2,
    "inertia --centre 0.65 --gyration 0.35 --angle 40;250": 2 * 6,
    "inertia --rod 500mm --rod-mass 4kg --pendulum '1.35s;1.32s' --pendulum-from 'crosshead;crank'"
    " --rod-acceleration 23000rad/s2 --layout rod-masses": 25,
    "inertia --method series --rod-mass 9kg --stroke 60cm --rod 1.5m --speed 2/s --centre 0.6 --angle 40"
    " --rod-inertia '6 kg m2' --rod-inertia-about crank --columns phi,inertia_pin_n,common_acceleration": 2,
    "inertia --mechanism arc --rocker 6 --centre 0.65 --gyration 0.35 --angle 40": 6,
    "harmonics --ratio '1:4.5;5:6' --orders 12 --digits 20 --quantity c": 14,
    f"harmonics --eps 4 {MASSES} --offset 0.3 --cranks 0;90 --quantity torque --orders 1": 10,
    "rotor --masses 12;9kg --radii 5cm --angles 0;70 --planes 0;3cm --balance-planes 1;5cm --bearings 0;6cm"
    " --speed 900/min --columns line,mass_kg,angle,unbalance_kgm,unbalance_n,moment_nm --about 1cm": 30,
    "locomotive --spacing 0.7m --gauge 1.5m --stroke 24in --reciprocating 300kg --revolving 90kg --axles 2"
    " --velocity 96km/h --wheel 1.8m --wheel-load 60kN --balance-radius 60cm --share 0.4;1": 2 * 18,
    "balance --engine v6-90 --ratio 1:4 --orders 6 --share 0.4"
    " --columns order,factor,along,forward,least": 32,
    "balance --cranks 0;130 --banks -30;20 --positions 0;40cm --reciprocating 3;2kg --revolving 1kg"
    " --stroke 20cm --speed 9/s --angle 50 --ratio 1:4 --columns order,across_n,magnitude_n,direction": 18,
    "power --eps 3 --pressure 8bar --back 1.1bar --clearance 8% --exponent 1.2 --power 75kW --stroke-bore 1.5"
    " --speed 250/min --efficiency 0.9 --diagram-factor 0.8 --specific-volume 0.24m3/kg": 14,
    "power --mean-pressure 5bar;4bar --working-strokes 2 --bore 300mm --piston-rod 5cm --stroke 450mm"
    " --piston-speed 3m/s": 6,
    "power --pressure-ratio 8 --stages 2 --suction-pressure 1bar --exponent 1.3 --clearance 4% --bore 300mm"
    " --stroke 300mm --speed 300/min --suction-temperature 20°C --intermediate-pressure 3bar --columns"
    " second_bore,against_perfect,cooler_heat,compression_heat,isothermal_efficiency,delivered_volume": 6,
    "power --eps 8 --pressure 8bar --compound 300mm --bore 50cm --columns high_bore,low_mean_pressure": 2,
    "flywheel --swing 56kJ --speed 110..120/min --rim-diameter 3m --density 7200kg/m3 --rim-section 2:1"
    " --columns inertia,delta,rim_mass,breadth,thickness,greatest_speed,stored": 7,
    f"flywheel --eps 4 {MASSES} --delta 1:80 --columns power,swing_share,swing,inertia": 4,
    "flywheel --torque '5000 + 1500 sin(3φ) - 700 cos(φ)' --speed 300/min --delta 1:50": 12,
    "turning --torque '0:0; 60:90; 200:-10; 360:0' --load-torque '125/6 + 3 sin(2φ)' --step 50": 8 * 4,
    "turning --areas +52;-124;+72 --area-scale '500 N m; 6°'": 6,
}  # fmt: skip


def page_of(line: str, folder: Path) -> Path:
    path = folder / "page.json"
    printed(*shlex.split(line), "-o", str(path))
    return path


def verified(path: Path, *words: str) -> tuple[int, list[dict[str, str]]]:
    """Return the exit code, and what is said of each column."""
    found = kurbel("verify", *words, "-f", "csv", str(path))
    return found.code, found.records()


@pytest.mark.parametrize("line", PAGES, ids=str)
def test_every_number_is_confirmed(line: str, tmp_path: Path) -> None:
    code, columns = verified(page_of(line, tmp_path))
    assert [one for one in columns if one["confirmed"] != one["cells"]] == []
    assert sum(int(one["cells"]) for one in columns) == PAGES[line]
    assert code == 0


@pytest.mark.parametrize(
    ("line", "digit", "other", "said"),
    [
        ("table --ratio 1:5 --angle 60", '"x": 0.5756', '"x": 0.5755',
         "x at ratio 1:5, phi 60 is printed 0.5755; right is 0.5756"),
        ("forces --eps 4 --angle 60", '"guide_force": 0.1088', '"guide_force": 0.1089', "right is 0.1088"),
        ("delta --eps 4", '"delta": 1.423', '"delta": 1.4231', "is printed 1.4231; right is 1.42"),
        ("solve --where p=0", '"phi": 79.1001', '"phi": 79.1002', "is printed 79.1002; right is 79.1001"),
        ("table --angle s=0..1:0.5", '"phi": 84.2608', '"phi": 83.2608', "right is 84.2608"),
        ("rotor --masses 12;9kg --radii 5cm --angles 0;70", '"angle": 29.29', '"angle": 29.28', "is 29.29"),
        ("locomotive --spacing 1m --gauge 1.5m --stroke 60cm --reciprocating 300kg --speed 5/s --share 1/2",
         '"pull_n": 62810', '"pull_n": 62800', "right is 62810"),
        ("balance --engine inline-4 --ratio 1:5", '"along": 0.8082', '"along": 0.8083', "right is 0.8082"),
        ("power --eps 3 --pressure 8bar --back 1bar --bore 30cm --stroke 45cm --speed 200/min",
         '"indicated_power": 97.468', '"indicated_power": 97.467', "right is 97.468"),
        ("flywheel --torque '5000 + 1500 sin(3φ)' --speed 300/min --inertia 200kgm2", '"steadiness": 197.39',
         '"steadiness": 197.38', "right is 197.39"),
        ("turning --torque '5000 + 1500 sin(3φ)' --angle 30", '"excess_energy": 500.0',
         '"excess_energy": 500.1', "right is 500.0"),
        ("harmonics --quantity torque --eps 4 --orders 1", "0.03085", "0.03086", "right is 0.03085"),
        ("inertia --method series --centre 0.6 --gyration 0.3 --angle 40 --columns stretching_acceleration",
         "0.1174", "0.1175", "right is 0.1174"),
        ("power --pressure-ratio 4 --exponent 1.3 --stages 2 --columns against_one_stage", "0.92019",
         "0.92018", "right is 0.92019"),
        ("inertia --rod 50cm --rod-mass 4kg --pendulum '1.35s;1.32s' --pendulum-from 'crosshead;crank'"
         " --rod-acceleration 23000rad/s2 --layout rod-masses --columns model,correction_nm", "-1276.5",
         "-1276.4", "right is -1276.5"),
        ("inertia --centre 0.6 --gyration 0.3 --layout inertia-errors", "63.6476", "63.6477", "is 63.6476"),
        ("delta --compression 6 --heat 10 --columns efficiency", "0.511", "0.512", "right is 0.511"),
        ("solve --unknown ratio --angle 80 --where c=max", "0.18199", "0.18198", "right is 0.18199"),
        ("turning --eps 4 --angle 90", '"eps": "4"', '"eps": "4.01"', "tangential at"),
    ],
)  # fmt: skip
def test_a_change_by_hand_is_found(line: str, digit: str, other: str, said: str, tmp_path: Path) -> None:
    path = page_of(line, tmp_path)
    text = path.read_text(encoding="utf-8")
    assert digit in text
    changed = text.replace(digit, other)
    if "eps" in digit:
        # What is printed of the axis says what the row is of.
        changed = changed.replace('"epsilon": 4', '"epsilon": 4.01')
    path.write_text(changed, encoding="utf-8")
    found = kurbel("verify", str(path))
    assert found.code == 1
    assert said in found.out


CARD = Path(__file__).parents[2] / "scripts/corpus/files/cards/condenser.csv"


@pytest.mark.parametrize(
    ("line", "confirmed", "digit", "other"),
    [
        ("delta", 23, '"v_max_error": 0.0052', '"v_max_error": 0.0051'),
        # Of 20,831 N the points bear two figures, which are rounded to thousands.
        ("forces --bore 200mm --angle 0", 5, '_n": 21000', '_n": 22000'),
        ("turning --bore 300mm --friction 2kN --angle 80", 8, '"energy": 0.3', '"energy": 0.4'),
        ("pressures --shares 0;0.4 --units imperial", 8, '"gas_pressure_psi": ', '"gas_pressure_psi": 1'),
    ],
)  # fmt: skip
def test_what_an_indicator_card_bears_is_confirmed(
    line: str, confirmed: int, digit: str, other: str, tmp_path: Path
) -> None:
    path = page_of(f"{line} --card {CARD}", tmp_path)
    code, columns = verified(path)
    counted = [one for one in columns if not one["column"].endswith("_error")]
    assert sum(int(one["confirmed"]) for one in counted) == sum(int(one["cells"]) for one in counted)
    assert (code, sum(int(one["confirmed"]) for one in columns)) == (0, confirmed)
    path.write_text(path.read_text("utf-8").replace(digit, other), "utf-8")
    assert "right is" in kurbel("verify", str(path)).out


def test_a_page_comes_through_a_pipe(monkeypatch: pytest.MonkeyPatch) -> None:
    page = printed("table", "--angle=60", "-f", "json").out
    monkeypatch.setattr(sys, "stdin", io.StringIO(page))
    assert "6 of 6 numbers are confirmed, 0 are wrong" in printed("verify", "-").out
    monkeypatch.setattr(sys, "stdin", io.StringIO("x"))
    assert "standard input is no JSON" in kurbel("verify", "-").err


def test_what_is_not_computed_a_second_time_is_said_with_its_reason(tmp_path: Path) -> None:
    path = page_of("rotor --masses ?;3kg --radii 10cm --angles ?;0 --columns line,mass_kg", tmp_path)
    code, (column,) = verified(path)
    assert (code, column["confirmed"], column["wrong"]) == (0, "0", "0")
    assert column["reason"] == "masses that are asked for are not computed a second time"
    path = page_of(
        "turning --eps 4 --bore 300mm --pressure 8bar --stroke 600mm --speed 120/min --inertia 500kgm2"
        " --step 90 --columns phi,speed",
        tmp_path,
    )
    assert "a flywheel without a power is not known" in kurbel("verify", str(path)).out
    assert verified(path, "--strict")[0] == 1


HANDBOOK = """title = "Tafeln"
lang = "{lang}"
matter = ["colophon"]
verify = true
formats = ["markdown"]

[[chapter]]
title = "Wege"

[[chapter.part]]
run = "table --ratio 1:5 --angle 60"

[[chapter.part]]
run = "rotor --masses '?;3kg' --radii 10cm --angles '?;0' --columns line,mass_kg,unbalance_kgm"
name = "rotor"
"""


@pytest.mark.parametrize(
    ("lang", "said"),
    [
        ("de", "6 von 11 Zahlen der Tabellen sind von einer zweiten Rechnung mit anderen Formeln bestätigt."
         " Nicht ein zweites Mal berechnet: 5 in [Tabelle 2](<01-wege.md#tab-rotor>)."),
        ("en", "6 of 11 numbers of the tables are confirmed by a second computation with other formulas."
         " Not computed a second time: 5 in [Table 2](<01-wege.md#tab-rotor>)."),
    ],
)  # fmt: skip
def test_a_colophon_says_how_many_numbers_are_confirmed(lang: str, said: str, tmp_path: Path) -> None:
    (tmp_path / "handbook.toml").write_text(HANDBOOK.format(lang=lang), encoding="utf-8")
    assert kurbel("handbook", "build", str(tmp_path)).code == 0
    (colophon,) = tmp_path.glob("pages/markdown/*colophon.md")
    assert said in colophon.read_text(encoding="utf-8")
    assert kurbel("handbook", "check", str(tmp_path)).code == 0
    with mock.patch("kurbel.verify.drives.Drive.unit", lambda *_: verify.Number(exact={1: Fraction(2)})):
        found = kurbel("handbook", "check", str(tmp_path))
    assert found.code == 1
    assert "a second computation finds a number wrong: x at ratio 1:5, phi 60" in found.out + found.err


def test_no_option_is_left_unsaid_that_the_page_counts() -> None:
    given: dict[str, Any] = {"ratio": [Fraction(1, 4), 0.2], "stroke": 0.6, "force": "5kN"}
    page = library.forces(**given, angle=np.array([60.0, 90.0]), lang="en", label="a")
    request = json.loads(page.typeset("json"))["request"]
    asked = {"ratio": ["1/4", 0.2], "angle": [60.0, 90.0], "stroke": 0.6, "force": "5kN", "layout": "forces"}
    assert request == {"command": "forces", "options": asked}


def test_a_machines_file_and_the_environment_are_told_as_well(tmp_path: Path) -> None:
    machine = tmp_path / "engine.toml"
    machine.write_text('[crank]\nstroke = "600mm"\nratio = "1:5"\n', encoding="utf-8")
    words = ("table", "--machine", str(machine), "--angle=60", "-f", "json")
    request = json.loads(printed(*words, KURBEL_TABLE_SPEED="2/s").out)["request"]
    assert request["options"] == {"ratio": "1:5", "stroke": "600mm", "speed": "2/s", "angle": "60"}


def test_a_long_page_says_it_too(tmp_path: Path) -> None:
    path = page_of("table --step 0.1 --columns phi,x,p", tmp_path)
    text = path.read_text(encoding="utf-8")
    rows = json.loads(text)["rows"]
    assert len(rows) == 3601
    few = json.dumps([rows[place] for place in (0, 7, 600, 1234, 3600)])
    path.write_text(re.sub(r'(?s)"rows": \[.*\]', lambda _: f'"rows": {few}', text), encoding="utf-8")
    assert "10 of 10 numbers are confirmed" in printed("verify", str(path)).out


@pytest.mark.parametrize(
    ("content", "said"),
    [
        ("{", "is no JSON"),
        ("[1]", "is no page of kurbel's; write one with -f json"),
        ('{"rows": [], "columns": []}', "does not say what was asked for; write the page anew"),
        ('{"rows": [], "columns": {}, "request": {}}', "is damaged: its columns"),
        ('{"rows": [{}], "columns": [{"key": "x", "unit": "", "method": "exact"}],'
         ' "request": {"command": "table", "options": {}}}', "what was asked for lack something"),
        ("{\udcff", "is no JSON: it is not UTF-8"),
        ("", "cannot be read"),
    ],
)  # fmt: skip
def test_other_files_are_refused_by_a_sentence(content: str, said: str, tmp_path: Path) -> None:
    path = tmp_path / "page.json"
    if content:
        path.write_text(content, encoding="utf-8", errors="surrogateescape")
    found = kurbel("verify", str(path))
    assert found.code in (1, 2)
    assert found.out == ""
    assert said in found.err
    assert str(path) in found.err


def test_without_mpmath_one_sentence_says_what_installs_it(tmp_path: Path) -> None:
    path = page_of("table --angle 60", tmp_path)
    computing = ("kurbel.verify", "kurbel.commands.verified", "kurbel.commands.second")
    gone = {name: one for name, one in sys.modules.items() if not name.startswith(computing)}
    with (
        mock.patch.dict(sys.modules, gone, clear=True),
        mock.patch("importlib.util.find_spec", lambda _: None),
    ):
        found = kurbel("verify", str(path))
    assert found.code in (1, 2)
    assert "a second computation needs mpmath" in found.err
    assert "verify" in found.err.partition("install it with")[2]


STRANGE: list[Any] = [
    *(None, True, 0, -1, 1e9, "", "x", "1:0", "nan", "-5", "1/0", "9" * 60, [], ["a", "b"], {}, "∞", "60°")
]
# With how often each is damaged: every speed over the turn of an engine is proved.
DAMAGED = {
    "table --ratio 1:5 --angle 60 --stroke 600mm --speed 2/s": 20,
    "table --mechanism arc --rocker 6 --pivot '5;6' --angle 60": 20,
    f"forces --eps 4 {MASSES} --angle 50": 20,
    "turning --compression 6 --peak-pressure 30 --angle 200": 20,
    "delta --eps 4 --detail": 10,
    "rotor --masses 12;9kg --radii 5cm --angles 0;70 --planes 0;3cm --balance-planes 1;5cm": 12,
    "locomotive --spacing 1m --gauge 1.5m --stroke 60cm --reciprocating 300kg --speed 5/s --share 1/2": 12,
    "balance --engine v2-90 --share 0.5 --ratio 1:4": 12,
    "power --eps 3 --pressure 8bar --back 1bar --bore 30cm --stroke 45cm --speed 200/min": 12,
    "flywheel --swing 56kJ --speed 110..120/min --rim-diameter 3m --density 7200kg/m3": 12,
    "turning --torque '5000 + 1500 sin(3φ)' --angle 30": 12,
}


def places_of(value: Any, above: tuple[Any, ...] = ()) -> Iterator[tuple[Any, ...]]:
    """Yield where values of a page stand, what stands in others too."""
    inner = value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ()
    for key, one in inner:
        yield (*above, key)
        yield from places_of(one, (*above, key))


@pytest.mark.parametrize("line", DAMAGED, ids=str)
def test_whatever_stands_in_a_page_is_computed_or_a_sentence(line: str, tmp_path: Path) -> None:
    path = page_of(line, tmp_path)
    whole, chance = path.read_text(encoding="utf-8"), Random(line)
    for _ in range(DAMAGED[line]):
        page = json.loads(whole)
        *above, last = chance.choice(
            [one for one in places_of(page) if one[0] in ("request", "columns", "rows")]
        )
        place = page
        for key in above:
            place = place[key]
        place[last] = chance.choice(STRANGE)
        path.write_text(json.dumps(page), encoding="utf-8")
        found = kurbel("verify", str(path))
        assert found.code in (0, 1, 2)
        assert len(found.err.splitlines()) <= 1, found.err


@pytest.mark.parametrize(
    ("own", "other"), [('"x": 0.5756', '"x": "0,58?"'), ('"ratio": "1:5", "phi"', '"ratio": "1:4", "phi"')]
)
def test_no_text_and_no_other_ratio_is_passed_over(own: str, other: str, tmp_path: Path) -> None:
    path = page_of("table --ratio 1:5 --angle 60", tmp_path)
    path.write_text(path.read_text(encoding="utf-8").replace(own, other), encoding="utf-8")
    code, columns = verified(path, "--strict")
    assert code == 1
    assert (columns[0]["column"], columns[0]["confirmed"], columns[0]["uncomputed"]) == ("x", "0", "1")
