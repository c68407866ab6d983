"""Certified tables of the crank drive, as a library.

These functions give what the command line gives. They are imported when they are first used, so that
`import kurbel` loads neither click nor Jinja nor NumPy. Pages and certified digits are for one thread at a
time, for the precision of ball arithmetic is the process's; `compute` and `delta` run in any.

>>> import kurbel
>>> kurbel.certified("x", "1:5", 60, digits=30)
Decimal('0.575571099101947639126894292541')
>>> kurbel.certified("x", "1:5", 60, digits=2, method="series")
Decimal('0.58')
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from kurbel.errors import KurbelError

if TYPE_CHECKING:
    from kurbel.commands.balance import make_balance_table, make_harmonics_table
    from kurbel.commands.collate import make_collation_table
    from kurbel.commands.engine import make_dead_centres_table, make_engine_table
    from kurbel.commands.example import make_example_table
    from kurbel.commands.linkage import make_arc_table, make_parallel_table
    from kurbel.commands.motion import certified, compute, make_table, typeset
    from kurbel.commands.rod import make_inertia_table, make_tangent_table
    from kurbel.commands.solve import make_solve_table
    from kurbel.engine.irregularity import delta
    from kurbel.formats.pdf.by_typst import typeset_pdf

__version__ = "0.1.0"
__all__ = [
    "KurbelError",
    "__version__",
    "certified",
    "compute",
    "delta",
    "make_arc_table",
    "make_balance_table",
    "make_collation_table",
    "make_dead_centres_table",
    "make_engine_table",
    "make_example_table",
    "make_harmonics_table",
    "make_inertia_table",
    "make_parallel_table",
    "make_solve_table",
    "make_table",
    "make_tangent_table",
    "typeset",
    "typeset_pdf",
]
_MODULES = {
    "delta": "kurbel.engine.irregularity",
    "make_balance_table": "kurbel.commands.balance",
    "make_collation_table": "kurbel.commands.collate",
    "make_dead_centres_table": "kurbel.commands.engine",
    "make_engine_table": "kurbel.commands.engine",
    "make_example_table": "kurbel.commands.example",
    "make_harmonics_table": "kurbel.commands.balance",
    "make_arc_table": "kurbel.commands.linkage",
    "make_parallel_table": "kurbel.commands.linkage",
    "make_inertia_table": "kurbel.commands.rod",
    "make_tangent_table": "kurbel.commands.rod",
    "make_solve_table": "kurbel.commands.solve",
    "typeset_pdf": "kurbel.formats.pdf.by_typst",
}


def __getattr__(name: str) -> object:
    if name not in __all__:
        raise AttributeError(f"module 'kurbel' has no attribute {name!r}")
    from importlib import import_module

    return getattr(import_module(_MODULES.get(name, "kurbel.commands.motion")), name)


def __dir__() -> list[str]:
    return __all__
