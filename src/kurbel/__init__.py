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
    from kurbel.balance_library import make_balance_table, make_harmonics_table
    from kurbel.collate_library import make_collation_table
    from kurbel.engine_library import make_dead_centres_table, make_engine_table
    from kurbel.example_library import make_example_table
    from kurbel.irregularity import delta
    from kurbel.library import certified, compute, make_table, typeset
    from kurbel.linkage_library import make_arc_table, make_parallel_table
    from kurbel.pdf import typeset_pdf
    from kurbel.rod_library import make_inertia_table, make_tangent_table
    from kurbel.solve_library import make_solve_table

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
    "delta": "kurbel.irregularity",
    "make_balance_table": "kurbel.balance_library",
    "make_collation_table": "kurbel.collate_library",
    "make_dead_centres_table": "kurbel.engine_library",
    "make_engine_table": "kurbel.engine_library",
    "make_example_table": "kurbel.example_library",
    "make_harmonics_table": "kurbel.balance_library",
    "make_arc_table": "kurbel.linkage_library",
    "make_parallel_table": "kurbel.linkage_library",
    "make_inertia_table": "kurbel.rod_library",
    "make_tangent_table": "kurbel.rod_library",
    "make_solve_table": "kurbel.solve_library",
    "typeset_pdf": "kurbel.pdf",
}


def __getattr__(name: str) -> object:
    if name not in __all__:
        raise AttributeError(f"module 'kurbel' has no attribute {name!r}")
    from importlib import import_module

    return getattr(import_module(_MODULES.get(name, "kurbel.library")), name)


def __dir__() -> list[str]:
    return __all__
