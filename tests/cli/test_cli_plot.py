"""Drawings of pages and mechanisms: files that open, what is drawn of which page, what is refused."""

from __future__ import annotations

import os
import pty
import re
import subprocess
import sys
from pathlib import Path

import pytest
from cli import printed, refusal
from drawings import plotted
from golden import assert_golden
from programs import Programs
from tools import require_library

from kurbel.reading.environment import how_to_install


@pytest.fixture
def library() -> None:
    """Skip a test without matplotlib, or fail it where nothing may be missing."""
    require_library("matplotlib")


drawn = pytest.mark.usefixtures("library")


LOADED = "--eps=3 --bore=300mm --pressure=8bar --stroke=600mm --speed=120/min"
MASSES = f"{LOADED} --reciprocating=300kg --rod-mass=150kg --centre=0.4 --gyration=0.3"
# Of these all that is written stands in tests/golden/drawings.txt.
NAMED = [
    "table --ratio=1:4,5",
    "table --ratio=1:4;1:5 --columns=x,rod_force --decimal=point",
    "table --ratio=1:4,5 --method=series --columns=c,psi --lang=en",
    "forces --stroke=600mm --rod=1500mm --force=10kN --lang=en",
    "table --mechanism=arc --rocker=5.5 --columns=path,rocker",
    "table --mechanism=parallel --columns=coupler_path,coupler_rise --lang=en",
    "forces --polar --eps=4",
    f"forces {LOADED} --reciprocating=9kg"
    " --columns=crank_pin_force,tangential_excess,energy,torque_nm,piston_force_n",
    "turning --eps=2;4 --ratio=1:4;1:5 --lang=en",
    "turning --eps=3 --flywheel=50 --speed=120/min --lang=en",
    "flywheel --torque=5000+1500sin(3φ) --speed=120/min --delta=1:100 --lang=en",
    "delta --eps=2..6 --ratio=1:4;1:5",
    "harmonics --ratio=1:4;1:5 --lang=en",
    "inertia --centre=0.65 --gyration=0.35",
    "balance --engine=inline-3 --lang=en",
    "power --eps=2..6 --pressure=8bar",
    "solve --where=c=max --ratio=1:3..6",
    "collate roetscher-112",
    "plot --positions=62.5;120 --ratio=1:4.5 --offset=0.5 --lang=en",
    "plot --positions=30 --mechanism=arc --rocker=5.5",
    "plot --positions=30 --mechanism=parallel --lang=en",
]


@drawn
def test_drawings_name_what_they_show() -> None:
    text = ""
    for words in NAMED:
        paper = plotted(*words.split())
        written = [one for one in paper.words if not re.fullmatch("[−0-9.,]+°?", one)]
        text += f"$ kurbel {words}\n{paper.title}\n{'; '.join(written)}\n\n"
        # Numbers have the mark of the language and a true minus.
        other = "." if "lang=en" not in words and "point" not in words else ","
        assert not [one for one in paper.words if re.search(rf"-\d|\d[{other}]\d", one)]
    assert_golden("drawings.txt", text)


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
    printed("table", "--columns=x", "-f", "drawing", "-o", str(file))
    content = file.read_bytes()
    assert content.startswith(start)
    assert content.endswith(end)


@drawn
def test_the_format_option_is_stronger_than_the_suffix_and_the_suffix_than_the_environment(
    tmp_path: Path,
) -> None:
    file, words = tmp_path / "drawing.svg", ("table", "--columns=x")
    printed(*words, "-f", "png", "-o", str(file))
    assert file.read_bytes().startswith(b"\x89PNG")
    printed(*words, "-o", str(file), KURBEL_TABLE_FORMAT="png", KURBEL_FORMAT="csv")
    assert file.read_bytes().startswith(b"<?xml")
    assert printed(*words, KURBEL_TABLE_FORMAT="svg").out.startswith("<?xml")


@drawn
def test_png_goes_through_a_pipe() -> None:
    words = [sys.executable, "-m", "kurbel", "plot", "--positions", "30", "-f", "png"]
    done = subprocess.run(words, capture_output=True, check=True)
    assert done.stdout.startswith(b"\x89PNG")
    assert done.stderr == b""


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
CRANK = ("--ratio=1:4", "--stroke=600mm")
OF_FILE = ("--ratio=1:4", *MASSES.split(), "--back=0.1")


@pytest.fixture
def machine(tmp_path: Path) -> str:
    path = tmp_path / "engine.toml"
    path.write_text(ENGINE_FILE, encoding="utf-8")
    return str(path)


@drawn
@pytest.mark.parametrize(
    ("kind", "typed"),
    [
        (("table",), (*CRANK, "--speed=120/min")),
        (("plot", "--positions=30"), CRANK[:1]),
        (("forces",), (*OF_FILE, "--cranks=0;90")),
        (("forces", "--polar"), (*OF_FILE, "--cranks=0;90")),
        (("turning",), (*OF_FILE, "--cranks=0;90")),
    ],
)
def test_a_drawing_takes_from_the_machine_what_is_its_own(
    kind: tuple[str, ...], typed: tuple[str, ...], machine: str
) -> None:
    words = (*kind, "-f", "svg")
    assert printed(*words, "--machine", machine).out == printed(*words, *typed).out


@drawn
def test_a_mechanism_in_the_environment_hinders_no_drawing_without_it() -> None:
    words = ("plot", "--positions=50", "--offset=0.3", "-f", "svg")
    drawing = printed(*words).out
    assert printed(*words, KURBEL_PLOT_MECHANISM="offset").out == drawing
    assert printed(*words, "--mechanism", "offset").out == drawing


@drawn
def test_a_page_in_pdf_is_a_page_and_a_drawing_where_that_is_asked_for(tmp_path: Path) -> None:
    page, drawing = tmp_path / "page.pdf", tmp_path / "drawing.pdf"
    printed("table", "-o", str(page))
    printed("table", "--columns=x", "-f", "drawing", "--width=80", "--height=90", "-o", str(drawing))
    boxes = [
        [
            round(float(side) / 72 * 25.4)
            for side in re.findall(rb"/MediaBox ?\[ ?0 0 ([\d.]+) ([\d.]+)", one)[0]
        ]
        for one in (page.read_bytes(), drawing.read_bytes())
    ]
    assert boxes[1] == [80, 90] != boxes[0]


@drawn
@pytest.mark.parametrize(
    ("words", "sentence"),
    [
        ("table --width=85 -f csv", "--width is for drawings, and csv is a page"),
        ("table --polar", "--polar is for drawings, and text is a page"),
        ("table --layout=arc --rocker=6 --mechanism=arc --infinite -f svg", "--infinite is for the straight"),
        ("delta --eps=2..6 --polar -f svg", "--polar is for the force on the crank pin"),
        (
            "table --columns=x,c,p,psi,rod_force -f svg",
            "5 panels are too many for a drawing, which has at most 4",
        ),
        ("plot --ratio=1:5 -f svg", "kurbel table --ratio 1:5 -o motion.svg"),
        ("plot --turning -f svg", "write kurbel turning --eps 4 -o turning.svg"),
    ],
)
def test_what_cannot_be_drawn_says_what_to_type(words: str, sentence: str) -> None:
    assert sentence in refusal(*words.split())


@drawn
def test_a_stroke_that_stands_beside_the_other_is_drawn_as_one_turn() -> None:
    for words in ("table --ratio=1:4", "table --ratio=1:4 --to=180", "inertia --centre=0.6 --gyration=0.3"):
        paper = plotted(*words.split())
        assert paper.values("curve-1-1")[0][[0, -1]] == pytest.approx([0, 360], abs=1e-3)
    part = plotted("table", "--ratio=1:4", "--to=90", "--columns=c,c_return")
    assert {"Hingang", "Rückgang"} <= set(part.words)


@drawn
def test_over_expansion_ratios_the_curve_goes_through_the_numbers_of_the_page() -> None:
    paper = plotted("delta", "--eps=2..6", "--ratio=1:4;1:∞")
    rows = printed("delta", "--eps=2..6", "--ratio=1:4;1:∞", "-f", "csv").records()
    for number, ratio in enumerate(("1:4", "1:∞"), 1):
        across, values = paper.values(f"curve-1-{number}")
        own = [row for row in rows if row["ratio"] == ratio]
        assert across == pytest.approx([float(row["epsilon"]) for row in own], abs=1e-4)
        assert values == pytest.approx([float(row["delta"]) for row in own], abs=1e-4)


@drawn
def test_a_spectrum_has_a_line_as_long_as_each_harmonic() -> None:
    # B₁ of the infinite rod is 1, and it has no other.
    paper = plotted("harmonics", "--ratio=1:∞", "--orders=4")
    orders, heights = paper.values("curve-1-1")
    tips = {round(float(order)): height for order, height in zip(orders[1::2], heights[1::2], strict=True)}
    assert tips == pytest.approx({1: 1, 2: 0, 4: 0}, abs=1e-4)


@drawn
def test_the_free_force_of_four_in_line_is_of_twice_the_speed() -> None:
    # 4 m r ω² λ cos 2φ and what follows of λ³, along the cylinders.
    paper = plotted("balance", "--engine=inline-4", "--ratio=1:5")
    (name,) = paper.names("curve.*")
    across, along = paper.values(name)
    assert across == pytest.approx(0, abs=1e-6)
    assert (along.max(), along.min()) == pytest.approx((0.8, -0.8 - 8 * 0.2**3 / 4), abs=0.02)


@pytest.mark.parametrize("words", [(), ("-f", "svg", "-o", "-")])
def test_a_terminal_gets_a_sentence_instead_of_a_drawing(words: tuple[str, ...]) -> None:
    ours, terminal = pty.openpty()
    command = [sys.executable, "-m", "kurbel", "plot", *words]
    done = subprocess.run(command, stdout=terminal, stderr=subprocess.PIPE, text=True, check=False)
    os.close(terminal)
    os.close(ours)
    sentence = "a terminal shows no drawings; name a file, such as -o kurbel.svg; see kurbel plot --help"
    assert (done.returncode, done.stderr) == (2, f"kurbel: {sentence}\n")


@pytest.mark.parametrize(
    "words", ["table", "forces --polar", "turning --eps=4", "delta --eps=2..6", "plot --positions=30"]
)
def test_without_matplotlib_the_extra_is_named(
    words: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(sys.modules, "matplotlib", None)
    sentence = f"drawings need matplotlib; install it with: {how_to_install('plot')}"
    assert refusal(*words.split(), "-o", str(tmp_path / "drawing.svg"), code=1) == sentence
    assert list(tmp_path.iterdir()) == []


@drawn
def test_a_drawing_that_cannot_be_written_leaves_the_old_one(tmp_path: Path) -> None:
    sentence = refusal("plot", "--positions=30", "-o", str(tmp_path / "none" / "drawing.svg"), code=1)
    assert sentence.endswith(f"the directory {tmp_path / 'none'} does not exist")
    old = tmp_path / "drawing.svg"
    old.write_text("as it was")
    refusal("table", "--columns", "x_mm", "-o", str(old))
    assert old.read_text() == "as it was"


@pytest.mark.slow
def test_a_home_that_cannot_be_written_is_no_word_beside_a_drawing(
    programs: Programs, tmp_path: Path
) -> None:
    nowhere = dict.fromkeys(("HOME", "XDG_CONFIG_HOME", "XDG_CACHE_HOME"), str(tmp_path / "file/none"))
    (tmp_path / "file").write_text("")
    environment = {name: text for name, text in os.environ.items() if name != "MPLCONFIGDIR"} | nowhere
    run = programs.kurbel("table", "-o", str(tmp_path / "drive.svg"), env=environment)
    assert run.communicate()[1] == b""
    assert (tmp_path / "drive.svg").exists()
