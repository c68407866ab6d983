"""Pieces of a handbook in processes of their own: one that ends its process takes no other along."""

from __future__ import annotations

from functools import partial
from pathlib import Path

from deadly import deadly, harmless

from kurbel.handbook.pool import KILLED, NOT_TRIED, BuiltFiles, WorkPiece, worked


def pieces(kinds: str, folder: Path) -> list[WorkPiece]:
    """Return pieces by their letters: one that dies always, one that dies once, one that is made."""
    once = partial(deadly, str(folder / "once"))
    makes: dict[str, partial[BuiltFiles]] = {"d": partial(deadly), "o": once, "m": partial(harmless)}
    return [WorkPiece(f"{number}{kind}", "", makes[kind], None) for number, kind in enumerate(kinds)]


def test_a_piece_that_ends_its_process_fails_alone(tmp_path: Path) -> None:
    (tmp_path / "once").touch()
    came = {piece.name: made for piece, made in worked(pieces("mdmomdm", tmp_path), 2)}
    assert not (tmp_path / "once").exists()
    assert came == {
        f"{number}{kind}": KILLED if kind == "d" else harmless() for number, kind in enumerate("mdmomdm")
    }


def test_where_many_end_their_processes_the_rest_is_not_tried(tmp_path: Path) -> None:
    came = {piece.name: made for piece, made in worked(pieces("dddddmmm", tmp_path), 2)}
    assert len(came) == 8
    assert [*came.values()].count(KILLED) == 3
    assert {made for made in came.values() if isinstance(made, str)} == {KILLED, NOT_TRIED}
