"""LibreOffice without a window, in a profile of its own: what it reads in a file."""

from __future__ import annotations

import re
import subprocess
from collections.abc import Iterable
from pathlib import Path

from programs import PATIENCE
from tools import require

GERMAN = """<?xml version="1.0" encoding="UTF-8"?>
<oor:items xmlns:oor="http://openoffice.org/2001/registry">
<item oor:path="/org.openoffice.Setup/L10N"><prop oor:name="ooSetupSystemLocale" oor:op="fuse">
<value>de-DE</value></prop></item>
</oor:items>
"""
# Semicolons, UTF-8, German; text in quotation marks and numbers without, as they are shown; every sheet.
AS_SHOWN = "csv:Text - txt - csv (StarCalc):59,34,76,1,,1031,true,true,true,false,false,-1"
# Numbers, times and days are found as where a file is opened by a double click.
GERMAN_CSV = "CSV:59,34,76,1,,1031,false,true"
_FIELD = re.compile(r'("(?:[^"]|"")*"|[^;\n]*)([;\n])')


def converted(files: Iterable[Path], to: str, folder: Path, reading: str = "") -> None:
    """Have LibreOffice convert the files into a folder, all in one process."""
    profile = folder / "profile"
    (profile / "user").mkdir(parents=True, exist_ok=True)
    (profile / "user" / "registrymodifications.xcu").write_text(GERMAN, encoding="utf-8")
    words = [require("soffice"), f"-env:UserInstallation={profile.as_uri()}", "--headless"]
    words += [f"--infilter={reading}"] if reading else []
    words += ["--convert-to", to, "--outdir", str(folder), *map(str, files)]
    done = subprocess.run(words, capture_output=True, text=True, check=False, timeout=PATIENCE)
    assert done.returncode == 0, done.stderr
    assert "Error" not in done.stderr, done.stderr


def rows_as_shown(path: Path) -> list[list[str]]:
    """Return the cells of what was converted: a number as its printed decimals, a text with an apostrophe.

    Empty cells are empty texts without it.
    """
    rows: list[list[str]] = [[]]
    for field, end in _FIELD.findall(path.read_text(encoding="utf-8")):
        text = "'" + field[1:-1].replace('""', '"') if field.startswith('"') else field
        rows[-1].append(text)
        if end == "\n":
            rows.append([])
    return rows[:-1]
