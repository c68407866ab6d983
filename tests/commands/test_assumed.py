"""What changes a number and was not given stands on the page, with the option that gives it."""

import re
from pathlib import Path

import pytest
from cli import kurbel, printed

HARMONICS = "harmonics --quantity torque"
STEAM = ("--exponent 1.2", "--clearance 5%", "--back 0.1", "--single-acting")
MASSES = "forces --reciprocating 20kg --stroke 90mm --speed 3000/min --angle 30"
SWING = "flywheel --power 300kW --speed 90/min --energy-fluctuation 0.1 --delta 0.5%"
RIM = "flywheel --swing 56kJ --speed 120/min --delta 1:60 --rim-diameter 3m --density 7200kg/m3"
SHAKING = "balance --reciprocating 2kg --stroke 90mm --speed 3000/min"


def page(command: str, *more: str) -> str:
    words = [*command.split(), *(word for one in more for word in one.split())]
    return " ".join(printed(*words).out.split())


@pytest.mark.parametrize(
    ("command", "options"),
    [
        *(
            (f"{command} --eps 3", STEAM)
            for command in ("delta", "turning", "forces", "solve --where torque=max", HARMONICS)
        ),
        ("flywheel --eps 3 --power 9kW --speed 90/min --delta 1:50", STEAM),
        ("pressures --eps 3 --bore 300mm --pressure 8bar", STEAM),
        ("power --eps 3", (*STEAM, "--diagram-factor 0.8")),
        ("delta --pressure-ratio 3", ("--exponent 1.3", "--clearance 4%", "--single-acting")),
        ("delta --pressure-ratio 3 --single-acting", ("--other-side 1.1bar --suction-pressure 1bar",)),
        ("delta --compression 6 --heat 10", ("--two-stroke", "--exponent 1.3", "--exhaust-pressure 1.1")),
        ("delta --pump differential", ("--small-area 0.4",)),
        (MASSES, ("--slope 0",)),
        (f"{MASSES} --slope 30", ("--gravity 9.81",)),
        ("delta --eps 3 --flywheel 50", ("--resistance square",)),
        (SWING, ("--turns 2",)),
        (RIM, ("--rim-share 90%",)),
        (SHAKING, ("--revolving 1kg",)),
    ],
)
def test_an_assumption_stands_on_the_page_until_it_is_given(command: str, options: tuple[str, ...]) -> None:
    german, english = (page(command, f"--lang {lang}") for lang in ("de", "en"))
    for option in options:
        # One that stands for another choice follows a word.
        hint = re.compile(rf"\((?:else |sonst )?{option.split()[0]}\)")
        assert hint.search(german) and hint.search(english), option
        assert not hint.search(page(command, option)), option
    assert not hint.search(page(command, option, "--lang en")), option


def test_a_document_names_no_options(tmp_path: Path) -> None:
    notes = tmp_path / "notes.md"
    notes.write_text("<!-- kurbel: delta --eps 3 --lang en -->\n<!-- /kurbel -->\n", encoding="utf-8")
    assert kurbel("inject", str(notes)).code == 0
    table = notes.read_text(encoding="utf-8").split("-->", 1)[1]
    assert "no clearance; back pressure" in table and "double-acting\n" in table
    assert "--" not in table.split("<!--")[0].replace("---", "").replace("--:", "")
