"""Handbooks: how one is written and built, and one with every kind of item for the tests of documents."""

from __future__ import annotations

import json
import subprocess
from collections.abc import Mapping
from pathlib import Path

from cli import Result, kurbel
from tools import require

MACHINE = """\
[crank]
ratio = "1:5"
speed = "120/min"
[steam]
eps = 4
[flywheel]
power = "50kW"
delta = "1:100"
"""
TABLES = {
    "weg": "table --ratio 1:5",
    "zusammenstellung": "table --layout roetscher-112 --ratio 1:5 --ratio 1:4,5 --ratio 1:4",
    "path": "table --ratio 1:4 --step 15",
    "feinweg": "table --ratio 1:5 --step 1",
    "delta": "delta --eps 2..6",
    "dead-centres": "deadcentres",
    "harmonische": "harmonics",
    "blau": "example blau 33",
    "kraefte": "inertia --centre 0.65 --gyration 0.35 --layout ensslin-forces --step 30",
    "leistung": "power --eps 3 --pressure 8bar --stroke 1m --bore 40cm --speed 100/min",
    "schwung": "flywheel --eps 3 --ratio 1:5 --delta 1:100 --power 50kW --speed 120/min",
    "motor": "balance --layout balance",
    "scheiben": "rotor --masses '12;9kg' --radii 50mm --angles '0;70' --planes '0;300mm'",
}
FIGURES = {"kurven": "table --ratio 1:5 -f drawing", "stellung": "plot --positions 30 --ratio 1:5"}
ENGLISH = ("path", "dead-centres", "stellung")
CHAPTERS = ("bewegung", "gleichgang", "beispiele")
_FIRST = """
Die Tafeln dieses Abschnitts geben Weg, Geschwindigkeit und Beschleunigung des Kolbens in Einheiten von $R$,
$v$ und $v^2/R$. Die Stange ist *fünfmal* so lang wie die Kurbel, $λ = R/L = 1/5$; für andere Verhältnisse
gilt [](#zusammenstellung). Den Verlauf zeigt [](#kurven), und was daraus folgt, steht in
[dem Abschnitt über den Gleichgang](#gleichgang).

# Zum Gebrauch

- Winkel zählen vom inneren Totpunkt, auf dem Rückgang vom äußeren.
- Zwischenwerte: geradlinig, mit einem Fehler unter $0.001$.

| Größe | Einheit |
|-------|---------|
| Weg $x$ | $R$ |
| Geschwindigkeit $c$ | $v$ |
"""
_SECOND = """
Der Ungleichförmigkeitsgrad $δ$ hängt von der [Füllung](index:) ab; siehe [](#delta) und [](#path).
Wörter hat das [](#index).
"""


def keys_of(**keys: str) -> str:
    """Return lines of a manifest, with texts that are quoted as in JSON."""
    return "".join(f"{key} = {json.dumps(words, ensure_ascii=False)}\n" for key, words in keys.items())


def run(name: str, command: str, **keys: str) -> str:
    """Return the part of a manifest that is a page."""
    return f"[[chapter.part]]\n{keys_of(run=command, name=name, **keys)}"


def text(words: str, **keys: str) -> str:
    """Return the part of a manifest that is a text."""
    return f"[[chapter.part]]\n{keys_of(**keys, text=words)}"


def chapter(title: str, *parts: str, **keys: str) -> str:
    return f"[[chapter]]\n{keys_of(title=title, **keys)}{''.join(parts)}"


def _parts(*names: str) -> list[str]:
    languages = {name: "en" if name in ENGLISH else "de" for name in names}
    return [run(name, (TABLES | FIGURES)[name], lang=lang) for name, lang in languages.items()]


SAMPLE = f"""
title = "Tafeln des Kurbeltriebs"
subtitle = "für Handbücher und Vorlesungen"
author = "A. Setzer"
formats = ["html", "markdown", "latex", "typst", "pdf", "csv", "json"]
matter = ["symbols", "index"]
[pdf]
standards = ["ua-1", "a-2b"]
{
    chapter(
        "Bewegung des Kolbens, $x/R$",
        text(_FIRST),
        *_parts("weg", "zusammenstellung", "kurven", "path", "feinweg"),
        name="bewegung",
    )
}
{chapter("Gleichgang", text(_SECOND), *_parts("delta", "dead-centres", "stellung"))}
{chapter("Beispiele und Reihen", *_parts(*[*TABLES][6:]), name="beispiele")}
"""


def write(folder: Path, manifest: str, files: Mapping[str, str] = {}) -> Path:
    """Write a manifest and what lies beside it, and return their folder."""
    for name, content in {"handbook.toml": manifest, **files}.items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(content, encoding="utf-8")
    return folder


def handbook(command: str, *words: object, **environment: str) -> Result:
    jobs = () if command == "list" else ("--jobs", "1")
    return kurbel("handbook", command, *map(str, words), *jobs, **environment)


def built(folder: Path, manifest: str, files: Mapping[str, str] = {}, **environment: str) -> Path:
    """Build a handbook, which must succeed, and return the folder of its pages."""
    done = handbook("build", write(folder, manifest, files), **environment)
    assert (done.code, done.out) == (0, ""), done.err
    return folder / "pages"


def made(folder: Path) -> dict[str, bytes]:
    """Return all that was built, without what is of use on this machine only."""
    output = folder / "pages"
    return {
        path.relative_to(output).as_posix(): path.read_bytes()
        for path in sorted(output.rglob("*"))
        if path.is_file() and ".kurbel" not in path.parts
    }


def told(program: str, pdf: Path, *options: str) -> str:
    """Return what a program of poppler prints of a PDF."""
    to = [] if program in ("pdfinfo", "pdftohtml") else ["-"]
    command = [require(program), *options, str(pdf), *to]
    return subprocess.run(command, capture_output=True, check=True, encoding="utf-8").stdout


def pages_of(pdf: Path) -> list[str]:
    """Return the text of each page, its white space as single spaces."""
    pages = told("pdftotext", pdf, "-layout").rstrip("\f").split("\f")
    return [" ".join(page.split()) for page in pages]
