"""What gives way to what was typed: defaults from a machine's file and from the environment."""

from __future__ import annotations

from kurbel.commands.loads import NAMES, OWN
from kurbel.commands.part import Origin, Values
from kurbel.commands.subject import SPELLED
from kurbel.errors import ProblemError
from kurbel.reading.given import as_length, as_ratios
from kurbel.reading.notation import ratio_text

_LENGTHS = ("ratio", "stroke", "rod")


def settle_loads(values: Values) -> None:
    """Drop the loads that one which was typed outdoes, with all that describes them alone."""
    typed = [key for key in OWN if values.typed(key)]
    if not typed or not values.says(*NAMES):
        return
    others = [key for key in OWN if key not in typed and values.says(key)]
    for name in {option for key in others for option in (key, *OWN[key][1])}:
        if not values.typed(name):
            values.drop(name)


def settle_sizes(values: Values) -> None:
    """Give the stroke its value by the option that was given in its place. Raises KurbelError."""
    if not values.says(*SPELLED):
        return
    names = [name for name in ("stroke", *SPELLED[:-1]) if values.says(name)]
    if any(map(values.typed, names)):
        values.drop(*(name for name in names if not values.typed(name)))
    spelled = next((name for name in SPELLED if values.says(name)), "")
    if not spelled:
        return
    from kurbel.drive.size.given import in_strokes

    found = in_strokes(values.values)
    if values.says("time_ratio"):
        values.spell("rod", spelled, found["rod"])
    values.spell("stroke", spelled, found["stroke"])
    values.read.update(SPELLED)
    for name in SPELLED:
        values.values[name] = None


def settle_lengths(values: Values) -> None:
    """Keep two of crank ratio, stroke and length of the rod at the most, for two give the third.

    Raises ProblemError where what is left says two different things.
    """
    if not values.values.keys() >= {*_LENGTHS}:
        return
    if values.typed("ratio") and values.origins.get("rod") is Origin.ENVIRONMENT:
        values.drop("rod")
    if not all(map(values.says, _LENGTHS)):
        return
    if not values.typed("ratio"):
        if not (values.typed("stroke") or values.typed("rod")):
            _check_agreement(values)
        values.drop("ratio")
    elif values.typed("stroke") != values.typed("rod"):
        values.drop("rod" if values.typed("stroke") else "stroke")
    elif not values.typed("rod"):
        raise ProblemError(
            "stroke and rod are known and give the ratio; beside --ratio give the stroke or the rod as well"
        )


def _check_agreement(values: Values) -> None:
    ratio, stroke, rod = (values.values[name] for name in _LENGTHS)
    share = as_length(stroke, "stroke") / 2 / as_length(rod, "rod")
    if set(as_ratios(ratio)) != {share}:
        raise ProblemError(
            f"stroke {stroke} and rod {rod} give R:L = {ratio_text(share)},"
            f" and the ratio is {';'.join(ratio)}; leave one of the three out"
        )
