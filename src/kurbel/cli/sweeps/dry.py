"""What `kurbel sweep --dry-run` says."""

from __future__ import annotations

from typing import TYPE_CHECKING

import click

if TYPE_CHECKING:
    from kurbel.sweeps.rows import Sweep

TIMES = ((86400, "days"), (3600, "hours"), (60, "minutes"), (1, "seconds"))
SIZES = ((10**12, "TB"), (10**9, "GB"), (10**6, "MB"), (10**3, "kB"))
# What is shorter and smaller says nothing.
LEAST = {"seconds": "less than a second", "kB": "less than a kilobyte"}


def show_estimate(sweep: Sweep, target: str | None, format: str | None) -> None:
    """Print rows, columns, parts, size and time of a sweep. Raises KurbelError."""
    from kurbel.sweeps.estimate import estimated
    from kurbel.sweeps.files.forms import form_of
    from kurbel.sweeps.work.hands import cores

    form = form_of(target or "-", format or (None if target else "parquet"))
    form.check(sweep, target or "sweep")
    found = estimated(sweep, form)
    hands = min(cores(), found.parts)
    product = " x ".join(
        f"{len(group[0].values)} of " + " and ".join(f"--{one.option.replace('_', '-')}" for one in group)
        for group in sweep.plan.groups
    )
    each = f", {sweep.each} records each" if sweep.each > 1 else ""
    rows = {
        "rows": f"{found.rows} ({product or 'one combination'}{each})",
        "columns": ", ".join(one.key for one in sweep.columns) + ", reason",
        "parts": f"{found.parts} of {min(sweep.rows_at_once, found.rows)} rows",
        "size": f"about {_in(found.size, SIZES, 'kB')} as {form.name}",
        "time": f"about {_in(found.seconds(hands), TIMES, 'seconds')} on {hands} core{'s' * (hands > 1)},"
        " measured on a sample",
    }
    if found.refused:
        rows["refused"] = f"{found.refused[0]}: {found.refused[1]}"
    for name, said in rows.items():
        click.echo(f"{name:8} {said}")


def _in(value: float, units: tuple[tuple[int, str], ...], last: str) -> str:
    for size, unit in units:
        if value >= size:
            return f"{value / size:.2g} {unit}" if value < 100 * size else f"{value / size:.0f} {unit}"
    return LEAST[last]
