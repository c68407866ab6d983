"""The motion of the piston over the crank angle."""

from typing import Annotated, Unpack

from kurbel.commands import parameters as option
from kurbel.commands.cranks import angles_of, described, of_other_mechanisms, sheet_of
from kurbel.commands.subject import makes_table
from kurbel.drive.mechanisms import MOTIONS
from kurbel.page.layouts import layout_of
from kurbel.page.subject import Question
from kurbel.reading.given import as_names


class Motion(option.Run, option.Linked, option.Sheet, total=False):
    """A crank drive that moves, at crank angles."""

    method: option.Method
    speed: option.Speed
    layouts: option.Layouts


@makes_table(
    foreign=of_other_mechanisms,
    order="angle from_ to step columns offset stroke rod method speed mechanism rocker pivot",
)
def table(
    ratio: option.Ratios = None,
    *,
    columns: Annotated[option.Names, option.columns_over_angle("kinematics", "phi,x,c,p")] = (),
    layout: Annotated[str | None, option.layout_option(*MOTIONS)] = None,
    **given: Unpack[Motion],
) -> Question:
    """Print a table of piston path, velocity and acceleration.

    \b
    kurbel table --ratio 1:5
    kurbel table --ratio '1:4;1:4,5' --step 15 --to 180 -f latex -o anhang.tex
    kurbel table --layout roetscher-112 --ratio 1:5 --ratio 1:4,5 --ratio 1:4
    kurbel table --stroke 600mm --rod 1500mm --speed 120/min
    kurbel table --mechanism arc --ratio 1:5 --rocker 6
    \f
    >>> import kurbel
    >>> page = kurbel.table("1:5", angle=[0, 45, 90], columns=["phi", "x", "c"])
    >>> print(kurbel.typeset(page, "csv"), end="")
    phi,x,c
    0,0.0000,0.0000
    45,0.3431,0.8081
    90,1.1010,1.0000
    >>> page = kurbel.table("1:5", mechanism="arc", rocker=6, angle="0;90", columns="phi,path,rocker")
    >>> print(kurbel.typeset(page, "csv"), end="")
    phi,path,rocker
    0,0.0001,9.587
    90,1.1049,-0.963
    """
    chosen, said = described({**given, "layout": layout}, ratio=ratio)
    page = layout_of(layout or chosen.layout, (chosen.subject,), given["layouts"])
    return chosen.question(
        chosen.drives(said, page.ratios),
        given["method"],
        layout=page,
        angles=angles_of(page, given),
        columns=as_names(columns, chosen.examples["table"]),
        **sheet_of(given),
    )
