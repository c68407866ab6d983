"""PDF by an installed TeX, for those who have one: the same files give the same bytes, always."""

from __future__ import annotations

import math
import os
import re
import shutil
import signal
import subprocess
from contextlib import suppress
from pathlib import Path
from tempfile import TemporaryDirectory
from time import monotonic

from kurbel.errors import TexError
from kurbel.reading.given import choose

_SAFE = ("-interaction=nonstopmode", "-halt-on-error", "-file-line-error", "-no-shell-escape")
# latexmk counts its own runs, and reads no commands from files named latexmkrc.
ENGINES = {
    "lualatex": ("lualatex", *_SAFE),
    "pdflatex": ("pdflatex", *_SAFE),
    "latexmk": ("latexmk", "-norc", "-pdf", "-silent", *_SAFE),
}
_RUNS = 5
_SECONDS = 300.0
# The folder of the documents as TeX sees it: a path of one letter, whatever the true one has in it.
_LINK = "d"
_ERROR = re.compile(r"^(?:\S+?:[0-9]+: |! )(.+)", re.MULTILINE)
# Every engine may write anew what the next run reads.
_KEPT = (".aux", ".toc", ".out")


def compile_tex(folder: str, name: str, engine: str, epoch: int = 0, seconds: float = _SECONDS) -> bytes:
    """Return the PDF of `name`.tex in the folder, run until its references are settled.

    `engine` is lualatex, pdflatex or latexmk (with pdflatex); `epoch` is the time that the document may see,
    in seconds since 1970. Nothing is written into the folder, and TeX runs no programs and reads no other
    files but its own. Raises TexError with the first error of the log, or if it takes longer than `seconds`
    in all, and for a missing engine.
    """
    choose(engine, ENGINES, "PDF engine")
    command = ENGINES[engine]
    if shutil.which(command[0]) is None:
        raise TexError(f"--pdf-engine {engine} needs TeX: there is no {command[0]} on this machine")
    with TemporaryDirectory(prefix="kurbel-") as place:
        os.symlink(os.path.abspath(folder), os.path.join(place, _LINK))
        # latexmk wants to see its file; the engines find the others through TEXINPUTS.
        Path(place, f"{name}.tex").write_text(f"\\input{{{_LINK}/{name}}}\n", encoding="utf-8")
        before, end = None, monotonic() + seconds
        for _ in range(1 if engine == "latexmk" else _RUNS):
            _run((*command, f"{name}.tex"), place, name, epoch, seconds, end)
            after = [path.read_bytes() for suffix in _KEPT if (path := Path(place, name + suffix)).exists()]
            if after == before:
                break
            before = after
        return Path(place, f"{name}.pdf").read_bytes()


def _run(command: tuple[str, ...], place: str, name: str, epoch: int, seconds: float, end: float) -> None:
    process = subprocess.Popen(
        command,
        cwd=place,
        env=_environment(place, epoch),
        stdin=subprocess.DEVNULL,
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
        start_new_session=True,
    )
    limit_time(process.pid, seconds)
    try:
        code = process.wait(max(0.0, end - monotonic()))
    except subprocess.TimeoutExpired:
        raise TexError(f"{command[0]} did not finish {name}.tex within {seconds:g} seconds") from None
    finally:
        # latexmk has started others.
        if process.poll() is None:
            os.killpg(process.pid, signal.SIGKILL)
            process.wait()
    if code or not Path(place, f"{name}.pdf").exists():
        raise TexError(f"{command[0]} cannot set {name}.tex: {_first_error(place, name)}")


def limit_time(process: int, seconds: float) -> None:
    """Have the system end it, should this process be killed and no longer wait for it."""
    try:
        import resource
    except ImportError:
        return
    if hasattr(resource, "prlimit"):
        with suppress(OSError):
            resource.prlimit(process, resource.RLIMIT_CPU, (math.ceil(seconds),) * 2)


def _environment(place: str, epoch: int) -> dict[str, str]:
    return os.environ | {
        "SOURCE_DATE_EPOCH": str(epoch),
        "FORCE_SOURCE_DATE": "1",
        "TEXINPUTS": f".:{_LINK}:",
        "TEXMFHOME": os.path.join(place, "none"),
        "openin_any": "p",
        "openout_any": "p",
        "shell_escape": "f",
        # Lines of the log are not broken, so that an error is whole.
        "max_print_line": "1000",
        "LC_ALL": "C.UTF-8",
        "TZ": "UTC",
    }


def _first_error(place: str, name: str) -> str:
    log = Path(place, f"{name}.log")
    text = log.read_text(encoding="utf-8", errors="replace") if log.exists() else ""
    found = _ERROR.search(text)
    return found[1].strip() if found else "it wrote no log that says why"
