"""A file is written whole or not at all, whatever goes wrong, and what was there before is kept."""

from __future__ import annotations

import errno
import io
import os
import resource
import signal
import subprocess
import sys
import threading
from contextlib import suppress
from pathlib import Path
from tempfile import TemporaryDirectory

import pytest
from apart import NOBODY, as_nobody
from cli import kurbel, printed, refusal
from programs import PATIENCE, Programs, wait_until

from kurbel import KurbelError
from kurbel.formats.render import remove_left_over, whole_file

LONG = ("table", "-f", "csv", "--step", "0.0001")
ENDLESS = ("table", "-f", "json", "--step", "0.000001")


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    (tmp_path / "old.csv").write_text("as it was")
    return tmp_path


def names(folder: Path) -> list[str]:
    return sorted(path.name for path in folder.iterdir())


def write(target: Path, content: bytes = b"new") -> None:
    with whole_file(str(target)) as stream:
        stream.write(content)


@pytest.mark.parametrize(
    "failure", [OSError(errno.ENOSPC, "No space left on device"), KeyboardInterrupt(), SystemExit(143)]
)
@pytest.mark.parametrize("name", ["old.csv", "new.csv"])
def test_a_failure_while_writing_leaves_what_was_there(
    failure: BaseException, name: str, folder: Path
) -> None:
    expected = KurbelError if isinstance(failure, OSError) else type(failure)
    with pytest.raises(expected), whole_file(str(folder / name)) as stream:
        stream.write(b"half")
        raise failure
    assert names(folder) == ["old.csv"]
    assert (folder / "old.csv").read_text() == "as it was"


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="/dev/full is a device of Linux")
def test_a_full_device_is_one_sentence() -> None:
    sentence = "cannot write /dev/full: No space left on device"
    for format_name in ("csv", "text"):
        assert refusal("table", "-f", format_name, "-o", "/dev/full", code=1) == sentence


def test_a_read_only_directory_or_file_is_left_alone() -> None:
    with TemporaryDirectory() as name:
        old, new = Path(name, "old.csv"), Path(name, "new.csv")
        old.write_text("as it was")
        old.chmod(0o400)
        if os.geteuid() == 0:
            for path in (name, old):
                os.chown(path, NOBODY, NOBODY)
        refusal("table", "-o", f"{name}/missing/table.csv", code=1)

        def refused() -> None:
            said = refusal("table", "-o", str(old), code=1)
            assert said == f"cannot write {old}: the file is read-only"
            os.chmod(name, 0o500)
            assert refusal("table", "-o", str(new), code=1) == f"cannot write {new}: Permission denied"

        as_nobody(refused)
        os.chmod(name, 0o700)
        assert names(Path(name)) == ["old.csv"]
        assert old.read_text() == "as it was"


def test_a_new_file_has_the_mode_of_any_new_file(folder: Path) -> None:
    write(folder / "new.csv")
    (folder / "plain").write_text("")
    assert (folder / "new.csv").stat().st_mode == (folder / "plain").stat().st_mode


def test_a_link_keeps_pointing_to_its_file_and_makes_one_that_is_not_there(folder: Path) -> None:
    elsewhere = folder / "elsewhere"
    elsewhere.mkdir()
    (elsewhere / "real.csv").write_text("as it was")
    (folder / "link.csv").symlink_to(elsewhere / "real.csv")
    (folder / "empty.csv").symlink_to(elsewhere / "later.csv")
    for link, target in (("link.csv", "real.csv"), ("empty.csv", "later.csv")):
        write(folder / link)
        assert (folder / link).readlink() == elsewhere / target
        assert (elsewhere / target).read_text() == "new"
    assert names(elsewhere) == ["later.csv", "real.csv"]


def test_a_place_where_no_file_can_be_is_named(folder: Path) -> None:
    missing, old = folder / "missing", folder / "old.csv"
    for target, sentence in (
        (missing / "table.csv", f"cannot write {missing}/table.csv: the directory {missing} does not exist"),
        (old / "table.csv", f"cannot write {old}/table.csv: {old} is not a directory"),
        (folder, f"cannot write {folder}: it is a directory; name a file in it"),
        (folder / "two\nlines" / "x.csv", None),
    ):
        said = refusal("table", "-f", "csv", "-o", str(target), code=1)
        assert sentence is None or said == sentence
    assert "two\\nlines" in said
    assert names(folder) == ["old.csv"]


def test_the_longest_name_of_a_file_can_be_written(folder: Path) -> None:
    for name in ("n" * 251 + ".csv", "ü" * 125 + ".csv"):
        write(folder / name)
        assert (folder / name).read_text() == "new"
    assert refusal("table", "-o", str(folder / ("n" * 252 + ".csv")), code=1).endswith(": File name too long")


def is_writing(run: subprocess.Popen[bytes], folder: Path) -> bool:
    """Whether the program has written something into a file of the folder, with a name or without."""
    opened = [path.stat().st_size for path in folder.glob(".old.csv.*")]
    for link in Path(f"/proc/{run.pid}/fd").glob("*"):
        with suppress(OSError):
            opened += [link.stat().st_size] if str(link.readlink()).startswith(f"{folder}/") else []
    return any(opened)


@pytest.fixture(params=["anonymous", "named"])
def kind(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> str:
    """Temporary files as on a system that knows files without names, and as on one that does not."""
    if request.param == "named":
        monkeypatch.delattr(os, "O_TMPFILE", raising=False)
    elif not hasattr(os, "O_TMPFILE"):
        pytest.skip("this system has no files without names")
    return str(request.param)


def test_a_file_of_either_kind_is_written_whole_or_not_at_all(kind: str, folder: Path) -> None:
    (folder / "old.csv").chmod(0o604)
    with pytest.raises(KeyboardInterrupt), whole_file(str(folder / "old.csv")) as stream:
        stream.write(b"half")
        raise KeyboardInterrupt
    assert (names(folder), (folder / "old.csv").read_text()) == (["old.csv"], "as it was")
    with whole_file(str(folder / "old.csv")) as stream:
        stream.write(b"new")
        stream.flush()
        assert (folder / "old.csv").read_text() == "as it was"
        assert len(names(folder)) == (1 if kind == "anonymous" else 2)
    assert (names(folder), (folder / "old.csv").read_text()) == (["old.csv"], "new")
    assert (folder / "old.csv").stat().st_mode & 0o777 == 0o604


def test_a_killed_run_leaves_nothing_or_what_the_next_one_removes(programs: Programs, folder: Path) -> None:
    run = programs.kurbel(*ENDLESS, "-o", str(folder / "old.csv"))
    wait_until(lambda: is_writing(run, folder))
    run.kill()
    run.wait()
    assert (folder / "old.csv").read_text() == "as it was"
    write(folder / "another.csv")
    assert names(folder) == ["another.csv", "old.csv"]


def test_what_is_left_over_is_removed_but_never_what_is_being_written(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.delattr(os, "O_TMPFILE", raising=False)
    (folder / ".gone.csv.0123456789ab.part").write_text("half")
    (folder / ".link.csv.0123456789ab.part").symlink_to(folder / "old.csv")
    (folder / ".notes.part").write_text("the author's own")
    os.mkfifo(folder / ".pipe.csv.0123456789ab.part")
    with whole_file(str(folder / "slow.csv")) as stream:
        stream.write(b"slow")
        remove_left_over(str(folder))
    assert (folder / "slow.csv").read_text() == "slow"
    assert names(folder) == [
        ".link.csv.0123456789ab.part", ".notes.part", ".pipe.csv.0123456789ab.part", "old.csv", "slow.csv"
    ]  # fmt: skip


def test_a_pipe_is_written_directly(folder: Path) -> None:
    pipe = folder / "pipe"
    os.mkfifo(pipe)
    received: list[bytes] = []
    reader = threading.Thread(target=lambda: received.append(pipe.read_bytes()), daemon=True)
    reader.start()
    write(pipe)
    reader.join(PATIENCE)
    assert received == [b"new"]
    assert pipe.is_fifo()


def test_a_page_longer_than_a_page_is_pointed_out(tmp_path: Path) -> None:
    words = ("table", "--step", "2", "-o", str(tmp_path / "long.tex"))
    assert (
        kurbel(*words).err
        == "kurbel: the table is longer than a page; it is set in parts, with --longtable where it stands\n"
    )
    assert printed(*words, "--longtable").out == ""


def test_the_format_is_that_of_the_suffix_unless_it_is_typed(folder: Path) -> None:
    words = ("table", "--angle", "50")
    for name, format_name in (("a.tex", "latex"), ("b.HTM", "html")):
        printed(*words, "-o", str(folder / name), KURBEL_FORMAT="json")
        assert (folder / name).read_text() == printed(*words, "-f", format_name).out
    printed(*words, "-f", "latex", "-o", str(folder / "e.html"))
    assert (folder / "e.html").read_text() == (folder / "a.tex").read_text()


def test_a_file_has_the_bytes_of_standard_output(folder: Path) -> None:
    words = ("table", "-f", "csv", "--step", "0.01")
    assert printed(*words, "-o", str(folder / "old.csv")).out == ""
    assert (folder / "old.csv").read_bytes() == printed(*words, "-o", "-").out.encode()


def test_a_closed_pipe_ends_quietly(programs: Programs) -> None:
    run = programs.kurbel(*LONG, stdout=subprocess.PIPE)
    assert run.stdout is not None
    assert run.stderr is not None
    assert run.stdout.readline() == b"ratio,phi,x,x_return,c,c_return,p,p_return\n"
    run.stdout.close()
    assert run.stderr.read() == b""
    # As of a program that the signal ends.
    assert run.wait() == 128 + signal.SIGPIPE


def test_a_full_disk_behind_standard_output_is_one_sentence(programs: Programs) -> None:
    if not Path("/dev/full").exists():
        pytest.skip("/dev/full is a device of Linux")
    with open("/dev/full", "wb") as full:
        run = programs.kurbel("table", stdout=full)
        _, errors = run.communicate()
    assert (run.returncode, errors) == (1, b"kurbel: cannot write: No space left on device\n")


def test_a_closed_standard_output_is_one_sentence_and_a_closed_error_takes_nothing(
    programs: Programs,
) -> None:
    run = programs.kurbel("table", prepare=lambda: os.close(1))
    _, errors = run.communicate()
    assert (run.returncode, errors) == (1, b"kurbel: cannot write: Bad file descriptor\n")
    run = programs.kurbel("table", "--ratio", "abc", stdout=subprocess.PIPE, prepare=lambda: os.close(2))
    output, _ = run.communicate()
    assert (run.returncode, output) == (2, b"")


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="/dev/full is a device of Linux")
@pytest.mark.parametrize(
    ("words", "code"),
    [
        (("table", "--ratio", "abc"), 2),
        ((), 2),
        (("deadcentres", "--mechanism", "beam", "--machine", "none.toml"), 1),
        # What is said of a page that is written is no part of it.
        (("table", "--step", "2", "-o", "long.tex"), 0),
    ],
)
def test_a_full_standard_error_leaves_the_exit_code(
    words: tuple[str, ...], code: int, programs: Programs, tmp_path: Path
) -> None:
    with open("/dev/full", "wb") as full:
        run = programs.kurbel(*words, stdout=subprocess.PIPE, stderr=full, cwd=tmp_path)
        output, _ = run.communicate()
    assert (run.returncode, output) == (code, b"")


def test_a_disk_that_fills_up_leaves_the_old_file(programs: Programs, folder: Path) -> None:
    # The limit on the size of files fails for root too, and in the middle of the table.
    run = programs.kurbel(
        *LONG, "-o", str(folder / "old.csv"),
        prepare=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (10**5, 10**5)),
    )  # fmt: skip
    _, errors = run.communicate()
    assert (run.returncode, errors.count(b"\n")) == (1, 1)
    assert errors == f"kurbel: cannot write {folder / 'old.csv'}: File too large\n".encode()
    assert names(folder) == ["old.csv"]
    assert (folder / "old.csv").read_text() == "as it was"


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_a_signal_in_a_long_table_leaves_the_old_file(
    number: signal.Signals, programs: Programs, folder: Path
) -> None:
    run = programs.kurbel(*ENDLESS, "-o", str(folder / "old.csv"))
    wait_until(lambda: is_writing(run, folder))
    run.send_signal(number)
    _, errors = run.communicate()
    assert run.returncode == 128 + number
    assert errors.strip() == b""
    assert names(folder) == ["old.csv"]
    assert (folder / "old.csv").read_text() == "as it was"


def test_a_long_table_shows_a_bar_on_a_terminal_and_only_there(programs: Programs, folder: Path) -> None:
    master, slave = pytest.importorskip("pty").openpty()
    words = ("table", "-f", "csv", "--step", "0.001", "--columns", "phi,x")
    run = programs.kurbel(*words, "-o", str(folder / "new.csv"), stderr=slave)
    os.close(slave)
    shown = io.BytesIO()
    while True:
        try:
            part = os.read(master, 4096)
        except OSError:
            # Linux ends a terminal that nobody holds with an error.
            break
        if not part:
            break
        shown.write(part)
    os.close(master)
    assert run.wait() == 0
    assert b"360001 rows" in shown.getvalue()
    assert b"100%" in shown.getvalue()
    quiet = subprocess.run([sys.executable, "-m", "kurbel", *words], capture_output=True, check=True)
    assert quiet.stderr == b""
    assert (folder / "new.csv").read_bytes() == quiet.stdout
    assert quiet.stdout.count(b"\n") == 360_002


def test_dev_stdout_is_the_stream_and_not_a_file_to_replace(tmp_path: Path) -> None:
    target = tmp_path / "all.txt"
    command = f"echo head; {sys.executable} -m kurbel table --angle 60 -f csv -o /dev/stdout; echo tail"
    with target.open("wb") as stream:
        subprocess.run(["sh", "-c", command], stdout=stream, check=True)
    lines = target.read_text(encoding="utf-8").splitlines()
    assert (lines[0], lines[-1], len(lines)) == ("head", "tail", 4)
