"""The dead centres of a crank drive, or of a beam engine by the formulas of the books."""

from collections.abc import Mapping
from fractions import Fraction
from typing import Annotated, Any, Unpack

from kurbel.commands import parameters as option
from kurbel.commands.old_motion import described, meant, of_other_mechanisms, sheet_of
from kurbel.commands.options import FLAG, Columns, Option, is_given
from kurbel.commands.parameters import Given
from kurbel.commands.subject import makes_table
from kurbel.drive.crank import Described
from kurbel.errors import ProblemError
from kurbel.page.layouts import layout_of
from kurbel.page.subject import Question
from kurbel.reading.given import as_names, as_numbers

BEAM, DRIVE = "dead centres", "drive dead centres"
_OF_DRIVES = ("mechanism", "offset", "rocker", "pivot", "circuit", "speed")
_LENGTHS = ("stroke", "rod")


def _of_beam(values: Mapping[str, Any]) -> bool:
    """Whether dead centres are those of a beam engine, and not of a crank drive that is described."""
    if values["layout"]:
        return layout_of(values["layout"], (BEAM, DRIVE), values["layouts"]).subject == BEAM
    if is_given(values["mechanism"]):
        return False
    of_beam = is_given(values["beam"]) or values["exact"]
    return of_beam or not any(is_given(values[name]) for name in (*_OF_DRIVES, *_LENGTHS))


def _no_dead_centres(values: Mapping[str, Any]) -> Mapping[str, str]:
    if _of_beam(values):
        why = "does not belong to the beam engine; leave --beam and --exact out for a crank drive"
        return {name: f"--{name} {why}" for name in _OF_DRIVES}
    why = "is for the beam engine, and a crank drive was described; leave one of the two out"
    of_beam = {name: f"--{name} {why}" for name in ("beam", "exact")}
    chosen = meant(values, layout=None)
    if "beam" in chosen.takes:
        del of_beam["beam"]
    return of_beam | of_other_mechanisms(values, chosen, ("stroke", "speed"))


def _lone_length(values: Mapping[str, Any]) -> Mapping[str, str]:
    if not _of_beam(values) or all(is_given(values[name]) for name in _LENGTHS):
        return {}
    why = "gives the ratio of the beam engine only where both are known, --stroke and --rod; add the other"
    return {name: f"--{name} {why}" for name in _LENGTHS}


def _one_arm(beam: Given | None) -> Fraction | None:
    """Return the arm of a beam engine that is described as a crank drive."""
    if not is_given(beam) or beam is None:
        return None
    first, *others = as_numbers(beam, "beam arm")
    if others:
        raise ProblemError(
            f"--mechanism beam is one engine, and {1 + len(others)} arms were given; leave --mechanism out"
            " for the angles of § 149"
        )
    return first


class Turned(option.Linked, option.Sheet, total=False):
    """A crank drive that turns evenly."""

    speed: Annotated[
        Given | None, option.SPEED._replace(help="Speed, for columns in m/s: 120/min, 12.5rad/s.")
    ]
    layouts: option.Layouts


@makes_table(
    foreign=_no_dead_centres,
    needless=_lone_length,
    order="ratio exact mechanism offset rocker pivot circuit stroke crank true_stroke"
    " time_ratio rod speed columns",
)
def dead_centres_table(
    beam: Annotated[
        Given | None,
        Option("Arm of the beam in crank radii: 3; lists '3;4', ranges 3..6:0.5.", "A:R", many=True),
    ] = None,
    *,
    ratio: Annotated[
        Given | None,
        option.RATIO._replace(help="Crank ratio: 1:5; lists and ranges 1:3..6."),
    ] = None,
    exact: Annotated[
        bool,
        Option("From the true geometry of the linkage; default: the formulas of § 149.", kind=FLAG),
    ] = False,
    columns: Annotated[
        option.Names,
        option.columns_option("weisbach-149", "mu,nu,path_1", ".")._replace(
            kind=Columns("weisbach-149", "dead-centres")
        ),
    ] = (),
    layout: Annotated[str | None, option.layout_option(BEAM, DRIVE)] = None,
    **given: Unpack[Turned],
) -> Question:
    """Print the dead centres of a beam engine: angles μ and ν of the rod, their distance, the small paths.

    Of another crank drive that is described: its dead centres, stroke and times, and with --stroke and
    --speed the crank-pin velocity and the mean piston speed.

    \b
    kurbel deadcentres --beam 3 --ratio 1:5
    kurbel deadcentres --beam 3 --ratio 1:5 --exact
    kurbel deadcentres --mechanism arc --ratio 1:5 --rocker 6
    kurbel deadcentres --ratio 1:4 --offset 0.5 --stroke 600mm --speed 120/min
    \f
    >>> import kurbel
    >>> page = kurbel.dead_centres_table(3, ratio="1:5", columns="mu,path_1")
    >>> print(kurbel.typeset(page, "csv"), end="")
    mu,path_1
    0.7958,0.00010
    >>> page = kurbel.dead_centres_table(ratio="1:4", offset=0.5, columns="phi_i,phi_o,time_ratio")
    >>> print(kurbel.typeset(page, "csv"), end="")
    phi_i,phi_o,time_ratio
    5.739,189.594,1.0438
    """
    values = {**given, "ratio": ratio, "beam": beam, "exact": exact, "layout": layout}
    if _of_beam(values):
        from kurbel.linkage.beam.page import BeamRequest

        page = layout_of(layout or "weisbach-149", (BEAM,), given["layouts"])
        known = is_given(given["stroke"]) and is_given(given["rod"])
        lengths = (given["stroke"], given["rod"]) if known else ()
        return BeamRequest(
            layout=page,
            arms=as_numbers(page.arms if beam is None else beam, "beam arm"),
            ratios=tuple(crank.ratio for crank in Described(ratio, *lengths).cranks(page.ratios)),
            exact=exact,
            columns=as_names(columns, "mu,nu"),
            **sheet_of(given),
        )
    from kurbel.linkage.dead_centres import DeadCentresRequest, drives_of

    page = layout_of(layout or "dead-centres", (DRIVE,), given["layouts"])
    chosen, said = described({**given, "beam": _one_arm(beam), "layout": None}, ratio=ratio)
    drives = drives_of(chosen, said, page.ratios)
    return DeadCentresRequest(
        layout=page,
        mechanism=chosen.name,
        drives=drives,
        columns=as_names(columns, "phi_i,phi_o"),
        **sheet_of(given),
    )
