"""A locomotive and a layout become a table of what its wheels and its frame bear, by balanced shares."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from fractions import Fraction

from kurbel.balancing.locomotives.locomotive import Locomotive, Run
from kurbel.balancing.locomotives.quantities import NEEDS, At, quantities
from kurbel.balancing.rotors.page import number_of
from kurbel.errors import ProblemError
from kurbel.exact.numerals import Label, Number, figure
from kurbel.motion.captions import turns_label
from kurbel.page.axes import ColumnAxis, ListAxis, Place, angle_text
from kurbel.page.quantity import Column, Quantity, Words, words
from kurbel.page.subject import Question, Subject
from kurbel.page.table import Field
from kurbel.reading.amounts import amount
from kurbel.reading.notation import about

WORDS: Mapping[str, Words] = {
    "share": words("Ausgeglichener Teil|Balanced share"),
    "cranks": words("Kurbeln: |Cranks: "),
    "places": words("; Zylindermitten: |; cylinders' centre lines: "),
    "wheels": words("; Räder bei |; wheels at "),
    "reciprocating": words("Massen: hin- und hergehend |Masses: reciprocating "),
    "revolving": words("; umlaufend, an der Kurbel |; revolving, at the crank "),
    "order": words(
        "Kräfte erster Ordnung; die umlaufenden Massen sind ganz ausgeglichen|Forces of the first order; the"
        " revolving masses are balanced wholly"
    ),
    "axles": words(
        "Den Teil der hin- und hergehenden Massen gleichen {axles} gekuppelte Achsen zu gleichen Teilen aus;"
        " Ausgleich und Räder sind die der Achse mit den Kurbeln"
        "|{axles} coupled axles balance equal parts of the share of the reciprocating masses; balance and"
        " wheels are those of the axle with the cranks"
    ),
    "angles": words(
        "Winkel zählen im Drehsinn wie die der Kurbeln, φ von der Stellung, in der diese stehen wie angegeben"
        "|Angles count in the sense of rotation as those of the cranks, φ from where these stand as given"
    ),
    "wheel": words("Durchmesser der Räder |Diameter of the wheels "),
    "load": words("ruhende Last eines Rades |static load of a wheel "),
    "limit": words("erlaubter Hammerschlag |allowed hammer blow "),
    "radius": words("Halbmesser der Ausgleichmassen |radius of the balancing masses "),
}


@dataclass(frozen=True, kw_only=True, eq=False, repr=False)
class LocomotiveRequest(Question):
    """What is asked for: a locomotive that runs, with several shares of its masses balanced."""

    engine: Locomotive
    run: Run
    shares: tuple[Fraction, ...]

    no_column = "there is no column beside the axes; add one, such as blow_left_n"

    def check(self) -> None:
        for share in self.shares:
            if not 0 <= share <= 1:
                raise ProblemError(
                    f"share of the balanced masses is {about(share)}; it must lie within 0..1, for it is a"
                    " share of the reciprocating mass"
                )

    def entry(self, key: str) -> Quantity:
        one = super().entry(key)
        # The page's last column has the units.
        named = {lang: f"{name} {one.symbol}".rstrip() for lang, name in one.name.items()}
        return one._replace(spanners=(), heading=named)

    def missing(self, quantity: Quantity) -> str:
        run = self.run
        unknown = {
            "--speed": run.omega is None,
            "--wheel": run.wheel is None,
            "--balance-radius": run.radius is None,
            "--wheel-load": run.load is None,
            "--hammer-blow": run.limit is None and run.load is None,
        }
        lacking = [option for option in NEEDS.get(quantity.needs, ()) if unknown[option]]
        return f"column {quantity.key} needs {' and '.join(lacking)}" if lacking else ""


def _number(question: LocomotiveRequest, column: Column, place: Place, times: int) -> Number | None:
    return number_of(question, column, At(question.engine, question.run, question.shares[place["share"]]))


def _share_axis(question: LocomotiveRequest) -> ListAxis:
    """The shares of the masses that go to and fro that are balanced."""
    return ListAxis(
        question.shares,
        Field("share", WORDS["share"][question.lang], "$c$"),
        figure,
        lambda share: f"$c = {figure(share)}$",
    )


def _notes(question: LocomotiveRequest) -> Iterator[Label]:
    lang, engine = question.lang, question.engine
    cranks = "; ".join(f"${angle_text(one.angle)}$" for one in engine.cranks)
    places = _listed([one.place for one in engine.cranks], "mm")
    yield (
        WORDS["cranks"][lang] + cranks + WORDS["places"][lang] + places + WORDS["wheels"][lang]
        + _listed(engine.planes, "mm") + f"; $R = {amount(engine.radius, 'mm')}$"
    )  # fmt: skip
    revolving = [one.revolving for one in engine.cranks]
    masses = WORDS["reciprocating"][lang] + _listed(_once([one.reciprocating for one in engine.cranks]), "kg")
    yield masses + (WORDS["revolving"][lang] + _listed(_once(revolving), "kg") if any(revolving) else "")
    if run := "; ".join(_said_of_run(question.run, lang)):
        yield run
    if engine.axles > 1:
        yield WORDS["axles"][lang].format(axles=engine.axles)
    yield WORDS["order"][lang]
    yield WORDS["angles"][lang]


def _said_of_run(run: Run, lang: str) -> Iterator[Label]:
    if run.speed is not None:
        yield turns_label(run.speed)
    if run.velocity is not None:
        yield f"$v = {amount(run.velocity, 'km/h')}$"
    for key, value, unit in (
        ("wheel", run.wheel, "mm"),
        ("load", run.load, "N"),
        ("limit", run.limit, "N"),
        ("radius", run.radius, "mm"),
    ):
        if value is not None:
            yield f"{WORDS[key][lang]}${amount(value, unit)}$"


def _once(masses: list[Fraction]) -> list[Fraction]:
    """Return one mass where all are alike."""
    return masses[:1] if len(set(masses)) == 1 else masses


def _listed(values: list[Fraction] | tuple[Fraction, ...], unit: str) -> Label:
    return "; ".join(f"${amount(value, unit)}$" for value in values)


SUBJECT = Subject(
    key="locomotive",
    layout="locomotive",
    command="locomotive",
    axes={"share": _share_axis, "column": ColumnAxis},
    axis_keys=("share",),
    own_first=False,
    quantities=quantities,
    number=_number,
    caption=lambda question: question.layout.caption[question.lang],
    notes=_notes,
    options=NEEDS,
)
