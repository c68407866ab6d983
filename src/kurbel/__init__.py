"""Certified tables of the crank drive, as a library.

One function a subject, in the words of the command line: values are text as there, or numbers in units of
the SI, degrees, or turns a second. They return a `Table`, which prints itself, or a `Drawing`;
`table.question(...)` and its like return what would be computed. All is imported when it is first used, so
that `import kurbel` loads neither click nor Jinja nor NumPy. All of it may be called from any thread; of
those that compute certified digits one at a time does, for the precision of ball arithmetic is the
process's.

>>> import kurbel
>>> kurbel.certified("x", "1:5", 60, digits=30)
Decimal('0.575571099101947639126894292541')
>>> kurbel.certified("x", "1:5", 60, digits=2, method="series")
Decimal('0.58')
>>> print(kurbel.table("1:5", angle="0;90", columns="phi,x").typeset("csv"), end="")
phi,x
0,0.0000
90,1.1010
"""

from __future__ import annotations

from kurbel.errors import KurbelError

# That of typing, which to load is half of what `kurbel --help` takes.
TYPE_CHECKING = False
if TYPE_CHECKING:
    from kurbel.commands.balance import balance, firing
    from kurbel.commands.books import collate, example
    from kurbel.commands.construct import construct, plot_construction
    from kurbel.commands.engine import delta, turning
    from kurbel.commands.flywheel import flywheel
    from kurbel.commands.forces import forces
    from kurbel.commands.harmonics import harmonics
    from kurbel.commands.inertia import inertia
    from kurbel.commands.motion import deadcentres, table
    from kurbel.commands.numbers import certified, compute
    from kurbel.commands.plot import plot_mechanism
    from kurbel.commands.power import power, pressures
    from kurbel.commands.rotor import locomotive, rotor
    from kurbel.commands.shown import Drawing, Table, typeset
    from kurbel.commands.solve import solve
    from kurbel.engine.irregularity import compute_delta
    from kurbel.formats.pdf.writer import typeset_pdf
    from kurbel.sweeps.dataset import sweep

__version__ = "0.3.0"
__all__ = [
    "Drawing",
    "KurbelError",
    "Table",
    "__version__",
    "balance",
    "certified",
    "collate",
    "compute",
    "compute_delta",
    "construct",
    "deadcentres",
    "delta",
    "example",
    "firing",
    "flywheel",
    "forces",
    "harmonics",
    "inertia",
    "locomotive",
    "plot_construction",
    "plot_mechanism",
    "power",
    "pressures",
    "rotor",
    "solve",
    "sweep",
    "table",
    "turning",
    "typeset",
    "typeset_pdf",
]
_MODULES = {
    "kurbel.commands.balance": ("balance", "firing"),
    "kurbel.commands.rotor": ("locomotive", "rotor"),
    "kurbel.commands.books": ("collate", "example"),
    "kurbel.commands.power": ("power", "pressures"),
    "kurbel.commands.harmonics": ("harmonics",),
    "kurbel.commands.engine": ("delta", "turning"),
    "kurbel.commands.flywheel": ("flywheel",),
    "kurbel.commands.forces": ("forces",),
    "kurbel.commands.construct": ("construct", "plot_construction"),
    "kurbel.commands.inertia": ("inertia",),
    "kurbel.commands.motion": ("deadcentres", "table"),
    "kurbel.commands.numbers": ("certified", "compute"),
    "kurbel.commands.plot": ("plot_mechanism",),
    "kurbel.commands.shown": ("Drawing", "Table", "typeset"),
    "kurbel.commands.solve": ("solve",),
    "kurbel.engine.irregularity": ("compute_delta",),
    "kurbel.formats.pdf.writer": ("typeset_pdf",),
    "kurbel.sweeps.dataset": ("sweep",),
}
# Commands of which functions had names of their own, with _table behind them.
_COMMANDS = {"collation": "collate", "construction": "construct", "dead_centres": "deadcentres"}

# Functions that there were once, and what draws the same.
_DRAWN = {
    "plot_motion": 'table("1:5").plot()',
    "plot_forces": 'forces("1:5").plot()',
    "plot_polar": 'forces("1:5").plot(polar=True)',
    "plot_pressures": 'pressures(machine="engine.toml").plot()',
    "plot_engine_forces": "forces(eps=4).plot()",
    "plot_engine_polar": "forces(eps=4).plot(polar=True)",
    "plot_turning": "turning(4).plot()",
}


def __getattr__(name: str) -> object:
    for module, names in _MODULES.items():
        if name in names:
            from importlib import import_module

            return getattr(import_module(module), name)
    if name in _DRAWN:
        raise AttributeError(f"kurbel.{name} is the drawing of a page now: kurbel.{_DRAWN[name]}")
    stem = name.removesuffix("_table")
    new = _COMMANDS.get(stem, stem)
    if new != name and new in __all__:
        raise AttributeError(f"kurbel.{name} is called kurbel.{new} now, as the command is")
    raise AttributeError(f"module 'kurbel' has no attribute {name!r}")


def __dir__() -> list[str]:
    return __all__
