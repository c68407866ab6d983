"""`kurbel plot`: drawings in files that open, from what is typed, the environment and the machine."""

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

from kurbel.reading.extras import how_to_install


@pytest.fixture
def library() -> None:
    """Skip a test without matplotlib, or fail it where nothing may be missing."""
    require_library("matplotlib")


drawn = pytest.mark.usefixtures("library")


LOADED = "--eps=3 --bore=300mm --pressure=8bar --stroke=600mm --speed=120/min"
MASSES = f"{LOADED} --reciprocating=300kg --rod-mass=150kg --centre=0.4 --gyration=0.3"
# Of these all that is written stands in tests/golden/drawings.txt.
NAMED = [
    "--ratio=1:4,5 --step=30",
    "--ratio=1:4;1:5 --columns=x,rod_force --decimal=point --step=30",
    "--ratio=1:4,5 --method=series --columns=c,c_return,psi --lang=en --step=30",
    "--stroke=600mm --rod=1500mm --speed=120/min --force=10kN --lang=en --step=30",
    "--mechanism=arc --rocker=5.5 --columns=path,rocker --step=30",
    "--mechanism=parallel --columns=coupler_path,coupler_rise --lang=en --step=30",
    "--polar --eps=4 --step=30",
    f"--forces {LOADED} --reciprocating=9kg --step=30"
    " --columns=crank_pin_force,tangential_excess,energy,torque_nm,piston_force_n",
    "--turning --eps=2;4 --ratio=1:4;1:5 --lang=en --step=30",
    "--turning --eps=3 --flywheel=50 --speed=120/min --lang=en --step=30",
    "--positions=62.5;120 --ratio=1:4.5 --offset=0.5 --lang=en",
    "--positions=30 --mechanism=arc --rocker=5.5",
    "--positions=30 --mechanism=parallel --lang=en",
]


@drawn
def test_drawings_name_what_they_show() -> None:
    text = ""
    for words in NAMED:
        paper = plotted(*words.split())
        written = [one for one in paper.words if not re.fullmatch("[−0-9.,]+°?", one)]
        text += f"$ kurbel plot {words}\n{paper.title}\n{'; '.join(written)}\n\n"
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
    printed("plot", "--step", "10", "-o", str(file))
    content = file.read_bytes()
    assert content.startswith(start)
    assert content.endswith(end)


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
        (("--step=30",), (*CRANK, "--speed=120/min")),
        (("--positions=30",), CRANK),
        (("--forces", "--step=30"), OF_FILE),
        (("--polar", "--step=30"), OF_FILE),
        (("--turning", "--step=30"), (*OF_FILE, "--cranks=0;90")),
        (("--polar", "--step=30", "--force=10kN"), CRANK),
        (("--step=30", "--force=10kN"), (*CRANK, "--speed=120/min")),
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
def test_a_mechanism_in_the_environment_hinders_no_drawing_without_it() -> None:
    for words, name in (
        (("--polar",), "straight"),
        (("--positions=50", "--offset=0.3"), "offset"),
        (("--polar",), "arc"),
    ):
        drawing = printed("plot", *words, "-f", "svg").out
        environment = {"KURBEL_PLOT_MECHANISM": name} | ({"KURBEL_PLOT_ROCKER": "6"} if name == "arc" else {})
        assert printed("plot", *words, "-f", "svg", **environment).out == drawing
        if name != "arc":
            assert printed("plot", *words, "--mechanism", name, "-f", "svg").out == drawing


@drawn
def test_what_is_typed_outdoes_the_machine(machine: str) -> None:
    words = ("plot", "--polar", "--step", "10", "-f", "svg")
    other = printed(*words, "--machine", machine, "--eps=5", "--ratio=1:6").out
    assert (
        other == printed(*words, *MASSES.replace("eps=3", "eps=5").split(), "--back=0.1", "--ratio=1:6").out
    )
    assert other != printed(*words, "--machine", machine).out


@drawn
def test_the_crank_of_the_machine_is_that_of_its_engine(tmp_path: Path) -> None:
    file = tmp_path / "engine.toml"
    for crank, typed in (
        ('stroke = "600mm"\nrod = "1350mm"', "--ratio=1:4,5"),
        ("offset = 0.2", "--offset=0.2"),
    ):
        file.write_text(f"[crank]\n{crank}\n[steam]\neps = 3\n", encoding="utf-8")
        for kind in ("--polar", "--turning"):
            words = ("plot", kind, "--step", "30", "-f", "svg")
            drawing = printed(*words, "--machine", str(file)).out
            assert drawing == printed(*words, "--eps=3", typed).out != printed(*words, "--eps=3").out


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
    "words",
    [
        "",
        "--polar",
        "--positions=30",
        "--turning --eps=4",
        "--polar --eps=4",
        "--mechanism=parallel --positions=30",
    ],
)
def test_without_matplotlib_the_extra_is_named(
    words: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(sys.modules, "matplotlib", None)
    sentence = f"drawings need matplotlib; install it with: {how_to_install('plot')}"
    assert refusal("plot", *words.split(), "-o", str(tmp_path / "drawing.svg"), code=1) == sentence
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
