"""The options that several commands share; each is stated here and nowhere else."""

from collections.abc import Iterable
from os import PathLike
from typing import Annotated, Any, TypeAlias, TypedDict

from kurbel.commands.drives.given import AnyDrive as AnyDrive
from kurbel.commands.drives.given import Crank as Crank
from kurbel.commands.drives.given import Linked as Linked
from kurbel.commands.drives.given import OnMachine as OnMachine
from kurbel.commands.drives.given import Over as Over
from kurbel.commands.drives.given import Rod as Rod
from kurbel.commands.drives.given import Stroke as Stroke
from kurbel.commands.options import FILE, Choice, Columns, Count, LayoutName, Option
from kurbel.drive import load
from kurbel.exact.numerals import MOST_DIGITS, ROUNDINGS
from kurbel.page.layouts import LANGUAGES
from kurbel.reading.given import Exact

# One value or several, each text or a number.
Given: TypeAlias = Exact | Iterable[Exact]
Names: TypeAlias = str | Iterable[str]
Path: TypeAlias = str | PathLike[str]


RATIO = Option(
    "Crank ratio: 1:5, 1:4,5, 0.2; lists '1:4;1:5' and ranges 1:3..6:0.5; 1:∞ is the infinite rod.",
    "R:L", short="-r", many=True,
)  # fmt: skip
ANGLE = Option(
    "Crank angles in degrees: 22.5, 2°30', lists '0;45;90', ranges 0..180:10.", "ANGLES", unit="degrees",
    many=True,
)  # fmt: skip
STEP = Option(
    "Step of the angles; default 10. Without any of these options a layout has its own angles.", "ANGLE",
    unit="degrees",
)  # fmt: skip
SPEED = Option(
    "Speed, for columns in m/s and m/s²: 120/min, 12.5rad/s.", "SPEED", unit="turns a second"
)  # fmt: skip
FORCE = Option(f"Piston force, for columns in N and N m: {load.examples()}.", "FORCE", unit="N")
METHOD = Option(
    "exact (default), series (first order, as Blau prints) or infinite (rod of infinite length).",
    kind=Choice("method", "kurbel.motion.evaluation:METHODS"),
)
ORDER = Option(
    "With --method series the highest power of λ in x/R, 1 (default, the books') to 9; even powers add"
    " nothing, and c and p are its slopes.",
    "N", many=True,
)  # fmt: skip
FIRST_ORDER = METHOD._replace(
    help="Of moving masses: exact (default), series (accelerated to first order, the rod at its true angle)"
    " or infinite (rod of infinite length)."
)
EPS = Option(
    "Expansion ratio, cut-off after 1/ε of the stroke: 4; lists '2;3;4', ranges 2..6.", "ε", many=True
)
BACK = Option(
    "Back pressure as a share of the steam pressure: 0.1, 10%, or beside --pressure as a pressure, both"
    " above vacuum: 1.1bar; default: the best, to which the steam expands.",
    "B",
)
LANG = Option(
    "Language of headings and captions: de or en.", kind=Choice("language", LANGUAGES),
    environment="KURBEL_LANG", default="de", last=True,
)  # fmt: skip
LAYOUTS = Option(
    "Folder with layouts of your own: DIR/<name>/layout.toml.", "DIR", FILE,
    environment="KURBEL_LAYOUTS", first=True,
)  # fmt: skip
LISTED = "; `kurbel quantities` lists them. What tells rows apart is always among them."


def columns_option(layout: str, example: str, more: str = LISTED) -> Option[Any]:
    """Return --columns of a command, whose columns are by default those of a layout."""
    return Option(f"Columns and their order: {example}{more}", "NAMES", Columns(layout), many=True)


def columns_over_angle(layout: str, example: str) -> Option[Any]:
    """Return the same of a command over the crank angle."""
    return columns_option(layout, example, f"{LISTED} Pages keep φ at the left.")


def layout_option(*subjects: str) -> Option[Any]:
    return Option("Page layout; `kurbel layouts` lists them.", kind=LayoutName(subjects))


Ratios = Annotated[Given | None, RATIO]
From = Annotated[Exact | None, Option("First angle; default 0.", "ANGLE", unit="degrees")]
To = Annotated[Exact | None, Option("Last angle; default 360, the whole turn.", "ANGLE", unit="degrees")]
Method = Annotated[str | None, METHOD]
Order = Annotated[Given | None, ORDER]
Speed = Annotated[Exact | None, SPEED]
PlainSpeed = Annotated[Exact | None, SPEED._replace(help="Speed: 120/min, 12.5rad/s.")]
NeededSpeed = Annotated[Exact, SPEED._replace(help="Speed: 120/min, 12.5rad/s.")]
Force = Annotated[Exact | None, FORCE]
Acceleration = Annotated[
    Exact | None,
    Option(
        "Angular acceleration of the crank at these angles, at its --speed: 50rad/s², -20rad/s².", "ALPHA",
        unit="rad/s²",
    ),
]  # fmt: skip

Eps = Annotated[Given | None, EPS]
Cranks = Annotated[
    Given | None,
    Option(
        "Angles by which the cranks follow the first, with cylinders alike: '0;90' or '0;120;240'.", "ANGLES",
        unit="degrees",
    ),
]  # fmt: skip

Reciprocating = Annotated[
    Exact | None,
    Option(
        "Mass of piston and crosshead: 200kg. Masses need --stroke and --speed, and beside steam --bore and"
        " --pressure.",
        "MASS", unit="kg",
    ),
]  # fmt: skip
Rotating = Annotated[
    Exact | None,
    Option(
        "Mass of the crank itself at its pin, for the main bearing: 60kg; -40kg if counterweights outweigh"
        " it.",
        "MASS", unit="kg",
    ),
]  # fmt: skip
RockerInertia = Annotated[
    Exact | None,
    Option("Moment of inertia of the rocker about its pivot: '20kg m²'.", "INERTIA", unit="kg m²"),
]

ROD_POINT = Option(
    "Points of the rod by their share from the crosshead pin to the crank pin: 0.5, beyond the ends -0.2;"
    " beside its axis 0.5,0.1 in rod lengths; with --rod 150mm; lists '0;0.5;1', ranges 0..1:0.25.",
    "POINTS", many=True,
)  # fmt: skip
RodPoint = Annotated[Given | None, ROD_POINT]

Layouts = Annotated[Path | None, LAYOUTS]
Lang = Annotated[str, LANG]
Label = Annotated[
    str,
    Option(
        "Name for cross references: \\label{tab:NAME}; default: the layout's.", "NAME", default="", last=True
    ),
]
Decimal = Annotated[
    str | None,
    Option(
        "comma or point; default: by the language.", kind=Choice("decimal mark", ("comma", "point")),
        environment="KURBEL_DECIMAL", last=True,
    ),
]  # fmt: skip


Caption = Annotated[
    str | None,
    Option("Caption of your own, formulas between dollar signs: 'Weg $x/R$'.", "TEXT", last=True),
]
Notes = Annotated[
    Names,
    Option(
        "A note of your own below those of the page; [^a] before it is its mark, also in captions.", "TEXT",
        many=True, default=(), last=True,
    ),
]  # fmt: skip
SourceLine = Annotated[
    str | None,
    Option("Line of your own on the source, in place of the page's; '' leaves it out.", "TEXT", last=True),
]


TEMPLATES = Option(
    "Folder with templates of your own: DIR/base/latex.jinja sets all pages in LaTeX, DIR/NAME/latex.jinja"
    " those of a layout.",
    "DIR", FILE, environment="KURBEL_TEMPLATES", last=True,
)  # fmt: skip


class Plain(TypedDict, total=False):
    """How a page is printed."""

    digits: Annotated[
        int | None,
        Option(
            f"Decimals of every column, 0 to {MOST_DIGITS}.",
            "N",
            Count("digits", 0, MOST_DIGITS, "cannot be printed"),
            last=True,
        ),
    ]
    rounding: Annotated[
        str,
        Option("What becomes of a tie.", kind=Choice("rounding", ROUNDINGS), default="half-away", last=True),
    ]
    lang: Lang
    label: Label
    caption: Caption
    note: Notes
    source: SourceLine
    templates: Annotated[Path | None, TEMPLATES]


UNITS = Option(
    "Units of pages and data: metric, imperial or a list, 'cm;kN'. Default: metric; pages of what is given in"
    " imperial units alone have these.",
    "UNITS",
    last=True,
)


class Sheet(Plain, total=False):
    """The same of one whose columns have units."""

    units: Annotated[str | None, UNITS]


class Run(TypedDict, total=False):
    """The crank angles of a page."""

    angle: Annotated[Given | None, ANGLE]
    from_: From
    to: Annotated[
        Exact | None,
        Option(
            "Last angle; default 360, the whole turn, and 180 where outstroke and return stand side by side."
            " Beyond 180 a page is of whole turns, with one column a quantity.",
            "ANGLE", unit="degrees",
        ),
    ]  # fmt: skip
    step: Annotated[Exact | None, STEP]
    zero: Annotated[
        Exact | None,
        Option(
            "Where the angles of the page count from, if not from φ = 0: an angle, or outer for the outer"
            " dead centre, φ = 180°.",
            "ANGLE", unit="degrees",
        ),
    ]  # fmt: skip
