"""Crank ratio, stroke and length of the rod: two give the third, and what is typed outdoes the rest."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import click
from click.core import ParameterSource

from kurbel.cli.options import nothing, typed
from kurbel.errors import ProblemError
from kurbel.reading import notation

LENGTHS = ("ratio", "stroke", "rod")


def settled_lengths(options: Mapping[str, Any]) -> dict[str, Any]:
    """Return the options with two of ratio, stroke and rod at the most.

    Raises ProblemError where what is left says two different things.
    """
    kept = dict(options)
    if typed("ratio") and _from_environment("rod"):
        kept["rod"] = None
    given = [name for name in LENGTHS if kept.get(name) not in (None, ())]
    if len(given) == len(LENGTHS):
        name = _outdone(kept)
        kept[name] = nothing(kept[name])
    return kept


def _outdone(options: Mapping[str, Any]) -> str:
    if not typed("ratio"):
        if not (typed("stroke") or typed("rod")):
            _check_agreement(options)
        return "ratio"
    if typed("stroke") == typed("rod"):
        if typed("rod"):
            raise ProblemError("--stroke and --rod already give the ratio; leave --ratio out")
        raise ProblemError(
            "stroke and rod are known and give the ratio; beside --ratio give the stroke or the rod as well"
        )
    return "rod" if typed("stroke") else "stroke"


def _check_agreement(options: Mapping[str, Any]) -> None:
    from kurbel.reading.units import length

    share = length(options["stroke"], "stroke") / 2 / length(options["rod"], "rod")
    if set(notation.ratios(options["ratio"])) != {share}:
        raise ProblemError(
            f"stroke {options['stroke']} and rod {options['rod']} give R:L = {notation.ratio_text(share)},"
            f" and the ratio is {';'.join(options['ratio'])}; leave one of the three out"
        )


def _from_environment(name: str) -> bool:
    return click.get_current_context().get_parameter_source(name) is ParameterSource.ENVIRONMENT
