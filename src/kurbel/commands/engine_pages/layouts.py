"""Which layout the pages of an engine have where none is named."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from kurbel.commands.machines import layout_of_load
from kurbel.commands.options import is_given
from kurbel.reading.given import as_ratios


def has_wheel(given: Mapping[str, Any]) -> bool:
    return given["flywheel"] is not None or given["inertia"] is not None


def layout_of_delta(given: Mapping[str, Any], names: Sequence[str]) -> str:
    """Return the layout of the irregularity, for columns of these names if there are any."""
    if has_wheel(given) and not given["detail"]:
        return "delta-flywheel"
    method, ratio = given["method"] or (), given["ratio"]
    several = len({method} if isinstance(method, str) else {*method}) > 1
    if given["detail"] or ((is_given(given["card"]) or "alpha_cutoff" in names) and not several):
        return "delta-detail"
    many = "delta-tafel" if len(as_ratios(() if ratio is None else ratio)) > 1 else "weisbach-150"
    return "delta-verfahren" if several else layout_of_load(given) or many


def layout_of_turning(given: Mapping[str, Any]) -> str:
    """Return the layout of the turning effort."""
    return "speed" if has_wheel(given) else "turning"
