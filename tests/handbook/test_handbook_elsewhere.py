"""A handbook whose parts a cluster makes: the files of a build on one machine, whatever the workers see."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import pytest
from cli import kurbel
from clusters import Cluster
from manifests import MACHINE, made
from programs import Programs

from kurbel.handbook import pool

MANIFEST = """\
title = "Tafeln"
formats = ["latex", "csv"]

[[chapter]]
title = "Wege"

[[chapter.part]]
run = "table --ratio 1:5 --step 45"
name = "wege"

[[chapter.part]]
run = "flywheel --machine engine.toml"
name = "schwung"

[[chapter.part]]
run = "delta --eps 0.5"
name = "ungleich"
"""


@pytest.mark.slow
def test_workers_make_the_parts_that_one_machine_makes(
    programs: Programs, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    said = {}
    cluster = Cluster(programs, tmp_path)
    cluster.work()
    for name, words in {"here": (), "there": ("--scheduler", cluster.address)}.items():
        # Workers run in the folder above, and find a relative name nowhere.
        (folder := tmp_path / name / "book").mkdir(parents=True)
        (folder / "handbook.toml").write_text(MANIFEST)
        (folder / "engine.toml").write_text(MACHINE)
        monkeypatch.chdir(tmp_path / name)
        result = kurbel("handbook", "build", "book", *words)
        said[name] = (result.code, result.err)
    assert made(tmp_path / "there" / "book") == made(tmp_path / "here" / "book")
    assert len(made(tmp_path / "here" / "book")) > 5
    # A part that cannot be made is told of as ever.
    assert said["there"] == said["here"]
    assert "book/handbook.toml, line 16, ungleich: expansion ratio" in said["here"][1]

    # What a worker made of a file that is another one here is made again.
    made_here: list[str] = []

    worked = vars(pool)["worked"]

    def noted(pieces: Sequence[Any], jobs: int) -> Any:
        made_here.extend(piece.name for piece in pieces)
        return worked(pieces, jobs)

    monkeypatch.setattr(pool, "worked", noted)
    monkeypatch.setattr(pool, "_inputs", lambda make, made: ("other",) * len(made.inputs))
    assert kurbel("handbook", "check", "book", "--scheduler", cluster.address).code == 1
    assert sorted(made_here) == ["schwung", "ungleich"]
