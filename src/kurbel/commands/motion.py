"""The motion of the piston over the crank angle."""

from typing import Annotated

from kurbel.commands import parameters as option
from kurbel.commands.cranks import angles_of, mechanism_of, of_other_mechanisms
from kurbel.commands.subject import makes_table
from kurbel.drive.crank import Described
from kurbel.drive.mechanisms import MOTIONS
from kurbel.page.layouts import layout_of
from kurbel.page.subject import Question
from kurbel.reading.given import as_names


@makes_table(foreign=of_other_mechanisms)
def table(
    ratio: option.Ratios = None,
    *,
    angle: option.Angles = None,
    from_: option.From = None,
    to: option.To = None,
    step: option.Step = None,
    columns: Annotated[option.Names, option.columns_over_angle("kinematics", "phi,x,c,p")] = (),
    offset: option.Offset = None,
    stroke: option.Stroke = None,
    rod: option.Rod = None,
    method: option.Method = None,
    speed: option.Speed = None,
    mechanism: option.Mechanism = None,
    rocker: option.Rocker = None,
    pivot: option.Pivot = None,
    layouts: option.Layouts = None,
    layout: Annotated[str | None, option.layout_option(*MOTIONS)] = None,
    digits: option.Digits = None,
    rounding: option.Rounding = "half-away",
    lang: option.Lang = "de",
    label: option.Label = "",
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
    chosen = mechanism_of(mechanism, offset, layout, layouts)
    said = Described(ratio, stroke, rod, speed, method, offset, rocker, pivot)
    chosen.check(said)
    page = layout_of(layout or chosen.layout, (chosen.subject,), layouts)
    return chosen.question(
        chosen.drives(said, page.ratios),
        method,
        layout=page,
        angles=angles_of(page, angle, from_, to, step),
        columns=as_names(columns, chosen.examples["table"]),
        digits=digits,
        rounding=rounding,
        lang=lang,
        label=label,
    )
