"""The crank angles at which path, velocity, acceleration and the like fulfil a condition."""

from collections.abc import Iterable, Mapping
from typing import Annotated, Any, Unpack

from kurbel.commands import parameters as option
from kurbel.commands.motion import described, meant, of_other_mechanisms, sheet_of, some
from kurbel.commands.options import Option
from kurbel.commands.subject import makes_table
from kurbel.errors import NotationError
from kurbel.page.layouts import layout_of
from kurbel.page.subject import Question
from kurbel.reading.given import as_names


def _of_drives(values: Mapping[str, Any]) -> Mapping[str, str]:
    # No layout tells the mechanism.
    return of_other_mechanisms(values, meant(values, layout=None))


class Drives(option.AnyDrive, option.Sheet, total=False):
    """Crank drives of which conditions are asked."""

    ratio: option.Ratios
    method: option.Method
    speed: option.Speed
    layouts: option.Layouts


@makes_table(
    foreign=_of_drives,
    order="ratio columns offset stroke rod method speed mechanism rocker pivot beam",
)
def solve_table(
    where: Annotated[
        str | Iterable[str],
        Option(
            'Condition: p=0, s=25% (share of the stroke), x=1.1, "x = 200 mm", "c = 3 m/s", c=max, p=min,'
            ' "p = 1/6 of dead centre", psi=5; repeated for several.',
            "CONDITION",
            many=True,
        ),
    ] = (),
    *,
    columns: Annotated[
        option.Names,
        option.columns_option(
            "solve", "stroke,phi,phi_turn,x,c,p", ". Pages keep the stroke and φ at the left."
        ),
    ] = (),
    layout: Annotated[str, option.layout_option("roots")] = "solve",
    **given: Unpack[Drives],
) -> Question:
    """Print all crank angles of the turn at which a condition holds, on both strokes.

    Path, velocity and acceleration count on either stroke from the dead centre where it begins, in its
    direction; max and min are those of each stroke.

    \b
    kurbel solve --ratio 1:5 --method series --where p=0
    kurbel solve --ratio '1:4;1:5' --where s=25% --where c=max
    kurbel solve --stroke 600mm --rod 1500mm --speed 120/min --where "c = 3 m/s"
    kurbel solve --ratio 1:5 --mechanism arc --rocker 6 --where acceleration=0
    \f
    >>> import kurbel
    >>> page = kurbel.solve_table("p = 0", ratio="1:5", method="series", columns="stroke,phi,x")
    >>> print(kurbel.typeset(page, "csv"), end="")
    stroke,phi,x
    outstroke,79.2724,0.9104
    return,100.7276,1.0896
    """
    from kurbel.reading.where import read_condition
    from kurbel.solve.page import SolveRequest

    page = layout_of(layout, ("roots",), given["layouts"])
    chosen, said = described(given)
    drives = chosen.solved(some(chosen.drives(said, page.ratios)), given["method"])
    texts = [where] if isinstance(where, str) or not isinstance(where, Iterable) else list(where)
    if not all(isinstance(text, str) for text in texts):
        raise NotationError('a condition is text, such as "p = 0"')
    return SolveRequest(
        layout=page,
        drives=drives,
        conditions=tuple(dict.fromkeys(read_condition(text, drives[0].names) for text in texts)),
        columns=as_names(columns, "stroke,phi,x"),
        **sheet_of(given),
    )
