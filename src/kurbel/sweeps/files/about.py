"""What a file says of a sweep and of its columns: who computed what, of what, and in which units."""

from __future__ import annotations

from typing import Any

import kurbel
from kurbel.page.labels import plain
from kurbel.sweeps.rows import Column, Sweep


def about(sweep: Sweep) -> dict[str, Any]:
    """Return what is said of the whole file."""
    return {"kurbel": kurbel.__version__, "inputs": {"command": sweep.plan.command}}


def about_column(column: Column) -> dict[str, str]:
    """Return what is said of a column, as plain text; what there is nothing to say of is left out."""
    said = {
        "name": column.name,
        "symbol": plain(column.symbol),
        "unit": plain(column.unit),
        "formula": column.formula,
        "source": column.source,
        "role": column.role,
    }
    return {name: text for name, text in said.items() if text}
