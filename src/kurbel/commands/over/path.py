"""The table of a drive over the piston's path: its shares of the stroke, its columns, its masses."""

from collections.abc import Mapping, Sequence
from fractions import Fraction
from typing import Any

from kurbel.commands.old_motion import sheet_of, some
from kurbel.commands.options import is_given
from kurbel.drive.crank import Described
from kurbel.errors import NotationError, ProblemError
from kurbel.motion.mechanism import Mechanism
from kurbel.page.layouts import Layout
from kurbel.page.subject import Question
from kurbel.reading import notation
from kurbel.reading.given import as_names, as_share, as_shares

WHAT = "share of the stroke"
STEP = Fraction(1, 10)


def over_path(
    chosen: Mechanism, said: Described, page: Layout, given: Mapping[str, Any], drives: Sequence[Any] = ()
) -> Question:
    """Return what is asked for of drives that were described, or of these, at shares of the stroke."""
    from kurbel.solve.over.page import PathRequest

    drives = some(drives or chosen.drives(said, page.ratios))
    return PathRequest(
        layout=page,
        mechanism=chosen.name,
        drives=chosen.solved(drives, given["method"]),
        shares=shares_of(given),
        columns=as_names(given["columns"], "share,phi,c"),
        # It counts from the dead centre, whatever pages over angles do.
        **sheet_of({**given, "zero": None}),
    )


def shares_of(given: Mapping[str, Any]) -> Sequence[Fraction]:
    """Return the shares that are listed, or those of a run, by default every tenth of the stroke."""
    shares, step = given["shares"], given["step"]
    run = [given[name] for name in ("from_", "to", "step")]
    if shares is not None:
        if any(is_given(one) for one in run):
            raise ProblemError(
                "--shares lists the shares and --from, --to, --step run through them; use one or the other"
            )
        return as_shares(shares, WHAT)
    first = Fraction(0) if given["from_"] is None else as_share(given["from_"], WHAT)
    last = Fraction(1) if given["to"] is None else as_share(given["to"], WHAT)
    width = STEP if step is None else as_share(step, WHAT)
    if step is None and last > first:
        width = min(STEP, last - first)
    return notation.progression(first, last, width, "share")


def not_shares(values: Mapping[str, Any]) -> dict[str, str]:
    """Return what runs over angles, as defaults from elsewhere may, each with its sentence."""
    names = [name for name in ("from", "to", "step") if is_given(values[name])]
    return {name: said for name in names if (said := _no_share(values[name], name))}


def _no_share(value: Any, name: str) -> str:
    try:
        found = as_share(value, WHAT)
    except NotationError as error:
        return str(error)
    if 0 <= found <= 1:
        return ""
    text = str(value).strip()[:40]
    meant = f"; write --{name} {text}%" if text.isdigit() and found <= 100 else ""
    return f"--{name} {text} is no share of the stroke, which runs from 0 to 1, that is 0% to 100%{meant}"
