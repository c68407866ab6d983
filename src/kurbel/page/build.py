"""What was asked for becomes a table: by its subject it is known who makes it."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from importlib import import_module
from typing import Protocol

from kurbel.page.layouts import Layout
from kurbel.page.table import Table


class Asked(Protocol):
    """What is asked for, whatever it is about: the layout, the language, how many records there are."""

    @property
    def layout(self) -> Layout: ...
    @property
    def lang(self) -> str: ...
    def __len__(self) -> int: ...


def build(request: Asked, pages: bool = True) -> Table:
    """Return the table that was asked for; without `pages` only its records, which need no memory."""
    module, _, name = BUILDERS[request.layout.subject].partition(":")
    builder: Callable[[Asked, bool], Table] = getattr(import_module(module), name)
    return builder(request, pages)


# By the subject of the layout; a request knows only layouts of its own subjects.
BUILDERS: Mapping[str, str] = {
    "motion": "kurbel.motion.grid:build_motion",
    "inertia": "kurbel.motion.grid:build_inertia",
    "inertia errors": "kurbel.motion.inertia_page:build_errors",
    "tangent": "kurbel.motion.tangent_page:build_tangent",
    "roots": "kurbel.solve.page:build_solve",
    **dict.fromkeys(
        ("irregularity", "strokes", "turning", "crank forces", "machine", "flywheel"),
        "kurbel.engine.page:build_engine",
    ),
    "dead centres": "kurbel.linkage.beam_page:build_beam",
    "harmonics": "kurbel.balance.harmonics_page:build_harmonics",
    "collation": "kurbel.books.collate_page:build_collation",
    "balance": "kurbel.balance.page:build_balance",
    **dict.fromkeys(("arc crank", "parallel crank"), "kurbel.linkage.page:build_linkage"),
}
