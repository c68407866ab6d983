"""The arc crank as a mechanism: what its pages say, in both languages, and what those of engines call it."""

from __future__ import annotations

import re
from abc import abstractmethod
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from typing import Any, ClassVar

from kurbel.drive.at import known
from kurbel.drive.crank import Crank, DescribedDrive, radii
from kurbel.drive.load import CARD, COMPRESSOR, FORCE, GAS, MASSES, PUMP, STEAM
from kurbel.errors import NotationError, ProblemError
from kurbel.exact.kind import Kind
from kurbel.exact.numerals import Label, exact_text
from kurbel.kernel.circle import Numeric
from kurbel.linkage.arc import ArcCrank, ArcDrive
from kurbel.linkage.arc_quantities import LEFT, arc_registry
from kurbel.linkage.linkage import LinkageMechanism, LinkageRequest, captioned, force_lines, linkage_subject
from kurbel.linkage.rocker import RockerCrank
from kurbel.motion.captions import WORDS as FORMULA_WORDS
from kurbel.motion.captions import direction_notes
from kurbel.motion.evaluation import LOADED, OUT, RETURN
from kurbel.motion.notes import WORDS as MOTION_WORDS
from kurbel.motion.notes import digits_text, moving_notes
from kurbel.page.quantity import Column, Of, Quantity, Words, filled, words
from kurbel.reading.given import as_number
from kurbel.reading.notation import ratio_text

# In place of what they say of a crosshead; the letter of the rocker is B.
NAMES: Mapping[str, str] = {
    "Führung": "Schwinge",
    "Guide": "Rocker",
    "Führungsdruck": "Schwingenkraft",
    "Guide force": "Rocker force",
    "$N$ auf den Kreuzkopf": "$N$ längs der Schwinge auf ihr Ende",
    "$N$ on the crosshead": "$N$ along the rocker on its end",
    "$S$ am Kreuzkopf, positiv als Druck": "$S$ am Schwingenende, positiv als Druck",
    "$S$ at the crosshead, positive as thrust": "$S$ at the rocker's end, positive as thrust",
    "Kraft am Kreuzkopfzapfen": "Kraft am Schwingenzapfen",
    "Crosshead-pin force": "Rocker-pin force",
    "$B$ Betrag am Kreuzkopfzapfen": "$G$ Betrag am Schwingenzapfen",
    "$B$ magnitude at the crosshead pin": "$G$ magnitude at the rocker pin",
    "Kreuzkopfzapfen": "Schwingenzapfen",
    "Crosshead pin": "Rocker pin",
    "Stange am Kreuzkopf": "Stange an der Schwinge",
    "Rod at the crosshead": "Rod at the rocker",
    "am Kreuzkopfzapfen: längs der Führung": "am Schwingenzapfen: längs seines Bogens",
    "at the crosshead pin: along the slide": "at the rocker pin: along its arc",
    "Last am Kreuzkopfzapfen": "Last am Schwingenzapfen",
    "Load at the crosshead pin": "Load at the rocker pin",
    "$F_B = F + F_m$ längs der Führung": "$F_B = F + F_m$ längs des Bogens",
    "$F_B = F + F_m$ along the slide": "$F_B = F + F_m$ along the arc",
    "$F_m$ der hin- und hergehenden Massen, ohne die Stange": "$F_m$ der Massen am Schwingenende, ohne die"
    " Stange",
    "$F_m$ of the reciprocating masses, without the rod": "$F_m$ of the masses at the rocker's end, without"
    " the rod",
    "$B$": "$G$",
    "$B$ in N": "$G$ in N",
    "$B$ in $Q$": "$G$ in $Q$",
}


def named(quantity: Quantity, names: Mapping[str, str]) -> Quantity:
    """Return a quantity by the names of another drive."""
    return quantity._replace(
        name=_words(quantity.name, names),
        symbol=_label(quantity.symbol, names),
        heading=_words(quantity.heading, names),
        spanners=tuple(_words(one, names) for one in quantity.spanners),
        direction=None if quantity.direction is None else _words(quantity.direction, names),
    )


def headed(column: Column, names: Mapping[str, str]) -> Column:
    """Return a column under the heads of another drive."""
    return column._replace(
        spanners=tuple(_label(one, names) for one in column.spanners),
        heading=tuple(_label(one, names) for one in column.heading),
    )


def _words(words: Words, names: Mapping[str, str]) -> Words:
    return {lang: _label(one, names) for lang, one in words.items()}


def _label(label: Label, names: Mapping[str, str]) -> Label:
    return names.get(label, label)


# How the keys of the force of the rocker begin.
GUIDE = "guide_force"
# {±} belongs to the stroke, {β±} to the stroke and the side of the pivot, {β+} and {β-} to that side alone.
CLOSURE = "${lead}R cos φ + L cos ψ = D {β+} B sin θ$, ${lead}R sin φ - L sin ψ = H {β-} B cos θ$"
SIGNS = {("", 1): "+", ("", -1): "-", ("both", 1): "±", ("both", -1): "∓"}
WORDS: Mapping[str, Words] = {
    "for": words(" für {drive}| for {drive}"),
    "closure": words(
        "{closure}; Schwinge $B$, ihr Drehpunkt von der Welle $D$ längs und $H$ quer zur Schubrichtung"
        "|{closure}; rocker $B$, its pivot $D$ along and $H$ across the slide direction from the shaft"
    ),
    "angles": words(
        "$θ$ im Drehsinn der Kurbel von der Lage der Schwinge quer zur Schubrichtung, $ψ$ im "
        "entgegengesetzten von der Schubrichtung"
        "|$θ$ in the crank's sense from the rocker's position square to the slide direction, $ψ$ in the "
        "opposite one from the slide direction"
    ),
    "radians": words("; in $x$ im Bogenmaß|; in $x$ in radians"),
    "dead_centres": words(
        "{drive}: Totlagen $φ_i = {inner}°$ und $φ_o = {outer}°$, Schwingungswinkel ${swing}°$, Hub auf dem "
        "Bogen ${stroke} R$, Zeitverhältnis Hingang zu Rückgang ${times}:1$, kleinster Übertragungswinkel "
        "${least}°$"
        "|{drive}: dead centres at $φ_i = {inner}°$ and $φ_o = {outer}°$, swing ${swing}°$, stroke along "
        "the arc ${stroke} R$, times of outstroke and return ${times}:1$, least transmission angle "
        "${least}°$"
    ),
    "force": words(
        "$F$ längs des Bogens, in der Richtung des Hubes|$F$ along the arc, in the direction of the stroke"
    ),
    "piston": words(
        "Der Kolben wirkt am Schwingenende, längs seines Bogens, auf dem Wege und Hub zählen"
        "|The piston acts at the rocker's end, along its arc, on which paths and the stroke count"
    ),
    "reciprocating": words("am Schwingenende|at the rocker's end"),
    "held": words(
        "$N$ hält auch die Masse am Schwingenende auf ihrem Bogen"
        "|$N$ also keeps the mass at the rocker's end on its arc"
    ),
    "rocker": words("Schwinge um ihren Drehpunkt|rocker about its pivot"),
    "rotating": MOTION_WORDS["rotating"],
    "connecting_rod": words(
        "|".join(
            MOTION_WORDS["connecting_rod"][lang].replace(slide, rocker)
            for lang, slide, rocker in (
                ("de", "Kreuzkopfzapfen", "Schwingenzapfen"),
                ("en", "crosshead pin", "rocker pin"),
            )
        )
    ),
}


def _lettered(line: Label, drive: RockerCrank) -> Label:
    return re.sub(r"\bB\b", drive.letter, line)


def _signed(line: Label, strokes: set[int], side: int) -> Label:
    stroke, many = min(strokes), "both" if len(strokes) > 1 else ""
    upper = 1 if many else stroke
    parts = {
        "{±}": SIGNS[many, upper],
        "{lead}": "" if (many, upper) == ("", OUT) else f"{SIGNS[many, upper]} ",
        "{β±}": SIGNS[many, upper * side],
        "{β+}": SIGNS["", side],
        "{β-}": SIGNS["", -side],
    }
    return filled(line, parts.items())


def printed(value: Callable[[Kind], Numeric], decimals: int) -> str:
    """The digits of an angle in degrees to 3 decimals, or of the stroke or the time ratio to 4.

    No value of an arc crank lies on a rounding boundary. Sine and cosine of the angles have at most degree 4
    over the rationals, those of a boundary, a k/n of a turn with n a multiple of 128, at least 32. The stroke
    is transcendental (Lindemann). The time ratio (180° + Δ)/(180° - Δ) is transcendental (Gelfond-Schneider)
    or, where Δ is m/n of a turn, (n + 2 m)/(n - 2 m) with φ(n) <= 8, hence n <= 30: no denominator of a
    reduced one is a multiple of 32. Of a beam engine the angles have sines of degree 16 at most.
    """
    return digits_text(value, decimals)


class RockerMechanism(LinkageMechanism):
    """A crank that moves a rocker: what pages say of it, and what they call its parts."""

    loads = (FORCE, MASSES, STEAM, CARD, COMPRESSOR, PUMP, GAS)
    motion = (("path", "path"), ("velocity", "velocity"), ("acceleration", "acceleration"))
    drawing = "kurbel.plot.drawings:arc_standing"
    moving = "kurbel.plot.moving:rocker_scene"
    rod = "kurbel.linkage.rocker:rod"
    # What is said of a drive, by keys, and the keys of lines that pages of its motion have at their end.
    words: ClassVar[Mapping[str, Words]]
    further: ClassVar[tuple[str, ...]] = ()
    names: ClassVar[Mapping[str, str]]

    @abstractmethod
    def measures(self, drive: Any) -> Mapping[str, Label | None]:
        """Return the lengths of a drive as they are printed, by their letters; None of an infinite one."""

    def check_method(self, said: DescribedDrive) -> None:
        """Raise ProblemError for a method other than the exact one."""
        if said.method not in (None, "exact"):
            raise ProblemError(
                f'method "{said.method}" has no formulas for {self.title}; use exact,'
                " with --ratio 1:∞ for the infinite rod"
            )

    def loaded_notes(self, drives: Sequence[RockerCrank], lang: str) -> Sequence[Label]:
        return [self.words["piston"][lang], *(self.dead_centres(drive, lang) for drive in drives)]

    def rod_notes(self, drives: Sequence[RockerCrank], lang: str) -> Iterable[Label]:
        yield from super().rod_notes(drives, lang)
        yield from (self.dead_centres(one, lang) for one in drives)

    def masses_notes(
        self, crank: Crank, ratio_symbol: str, lang: str, shown: Collection[str] = ()
    ) -> Iterable[Label]:
        yield from moving_notes(crank, ratio_symbol, lang, self.words)
        yield from self.held(crank, shown, lang)

    def named(self, quantity: Quantity) -> Quantity:
        return named(quantity, self.names)

    def headed(self, column: Column) -> Column:
        return headed(column, self.names)

    def caption(self, request: LinkageRequest) -> Label:
        """Return the layout's caption with its quantities and the lengths that all drives have in common."""
        drives = request.drives
        ratio = [f"$R:L = {ratio_text(drives[0].crank.ratio)}$"] if len(drives) == 1 else []
        common = ", ".join([*ratio, f"${drives[0].letter} = {exact_text(drives[0].rocker)} R$"])
        return captioned(request, for_drive=self.words["for"][request.lang].format(drive=common))

    def notes(self, request: LinkageRequest) -> Iterator[Label]:
        """Yield the lines below the table: formulas, and what each drive does between its dead centres."""
        forces = force_lines(request, self.words["force"], self.words)
        yield from dict.fromkeys((*self._formula_lines(request), *forces))
        yield from self.held(
            request.drives[0].crank, [one.quantity.key for one in request.page_columns], request.lang
        )
        yield from (self.dead_centres(drive, request.lang) for drive in request.drives)
        yield from (self.words[key][request.lang] for key in self.further)

    def held(self, crank: Crank, shown: Iterable[str], lang: str) -> Iterator[Label]:
        """Yield what the force of the rocker holds of the mass that goes to and fro."""
        if crank.moving and crank.moving.reciprocating and any(one.startswith(GUIDE) for one in shown):
            yield self.words["held"][lang]

    def lengths(self, drive: RockerCrank) -> list[Label]:
        """Return the ratio and the lengths of a drive with their letters."""
        lengths = self.measures(drive).items()
        texts = (f"${letter} = {length} R$" for letter, length in lengths if length is not None)
        return [f"$R:L = {ratio_text(drive.crank.ratio)}$", *texts]

    def dead_centres(self, drive: RockerCrank, lang: str) -> Label:
        """Return the line with what a drive does between its dead centres."""
        angle, share = 3, 4

        return self.words["dead_centres"][lang].format(
            drive=", ".join(self.lengths(drive)),
            inner=printed(drive.inner, angle),
            outer=printed(drive.outer, angle),
            swing=printed(drive.swing, angle),
            stroke=printed(drive.way, share),
            times=printed(drive.time_ratio, share),
            least=printed(drive.least_transmission, angle),
        )

    def _formula_lines(self, request: LinkageRequest) -> Iterator[Label]:
        lang, columns = request.lang, request.page_columns
        strokes = {column.quantity.stroke for column in columns}
        side = 1 if request.drives[0].curvature > 0 else -1
        heavy = any(drive.crank.moving for drive in request.drives)
        shown = [
            # As they are printed with the pivot on this side; what masses add no line holds.
            (one, one.formulas[LEFT if side < 0 and LEFT in one.formulas else "exact"])
            for one in (column.quantity for column in columns)
            if not (heavy and LOADED in one.formulas)
        ]
        formulas = [
            formula.printed.replace("{part} ", f"{one.part[lang]} " if one.part else "")
            for one, formula in shown
            if formula.printed
        ]
        # The path's, which tells the strokes apart by name, comes first.
        formulas.sort(key=lambda line: line.startswith("$"))
        symbols = (symbol for _, formula in shown for symbol in formula.symbols)
        if line := ", ".join(dict.fromkeys((*formulas, *symbols))):
            yield _lettered(_signed(line, strokes, side), request.drives[0])
        if shown and any(drive.crank.ratio for drive in request.drives):
            closure = _lettered(_signed(CLOSURE, strokes, side), request.drives[0])
            yield self.words["closure"][lang].format(closure=closure)
        if shown:
            arcs = any(one.symbol == "$x$" for one, _ in shown)
            yield self.words["angles"][lang] + (self.words["radians"][lang] if arcs else "")
            turning = [column for column in columns if column.quantity.of is not Of.FORCE]
            if said := [one.quantity.direction[lang] for one in turning if one.quantity.direction]:
                yield "; ".join(dict.fromkeys(said))
                yield from direction_notes(request, turning)
        if RETURN in strokes:
            yield FORMULA_WORDS["offset_return"][lang].replace("{angle}", request.layout.angle_symbol)
        if shown and len(strokes) > 1:
            yield FORMULA_WORDS["signs"][lang]


class Arc(RockerMechanism):
    name = "arc"
    title = ArcCrank.title
    layout = "arc"
    forces_layout = "forces-arc"
    takes = (
        "ratio",
        "stroke",
        "rod",
        "speed",
        "acceleration",
        "offset",
        "rocker",
        "pivot",
        "circuit",
        "rocker_inertia",
        "method",
    )
    words = WORDS
    names = NAMES

    def measures(self, drive: ArcCrank) -> Mapping[str, Label | None]:
        ratio = drive.crank.ratio
        distance = drive.distance or (1 / ratio if ratio else None)
        lengths = {"B": drive.rocker, "D": distance, "H": drive.pivot_height}
        return {letter: None if one is None else exact_text(one) for letter, one in lengths.items()}

    def lacking(self, said: DescribedDrive) -> str:
        if said.rocker is not None:
            return ""
        return "the arc crank needs the length of its rocker; add --rocker, for example --rocker 6"

    def drives(self, said: DescribedDrive, ratios: Sequence[str]) -> tuple[ArcCrank, ...]:
        self.check_method(said)
        return tuple(_arc(said, crank) for crank in said._replace(offset=None).cranks(ratios))

    def solved(self, drives: Sequence[ArcCrank], method: str | None) -> tuple[ArcDrive, ...]:
        return tuple(map(ArcDrive, drives))


def _arc(said: DescribedDrive, crank: Crank) -> ArcCrank:
    rocker, places = radii(known(said.rocker), "rocker", crank.radius), _pivot(said, crank.radius)
    if said.offset is not None:
        crank = replace(crank, offset=radii(said.offset, "offset", crank.radius))
    # Without a place the pivot has none of its own.
    distance, height = places or (None, None)
    circuit = 1 if said.circuit is None else as_number(said.circuit, "circuit")
    return ArcCrank(crank, rocker, distance, height, circuit)


def _pivot(said: DescribedDrive, radius: Fraction | None) -> tuple[Fraction, Fraction] | tuple[()]:
    """D and H from "5;6" or a pair."""
    given = said.pivot
    if given is None:
        return ()
    parts = given.split(";") if isinstance(given, str) else given
    if not isinstance(parts, Sequence) or len(parts) != 2:
        raise NotationError(
            f'pivot "{str(given)[:40]}" is not a place; write its distance from the shaft along and across'
            " the slide in units of R as 'D;H', for example '5;6'"
        )
    distance, height = (radii(part, "pivot", radius) for part in parts)
    return distance, height


MECHANISM = Arc()
SUBJECT = linkage_subject(
    "arc crank",
    layout="arc",
    command="table --mechanism arc",
    quantities=arc_registry,
    caption=MECHANISM.caption,
    notes=MECHANISM.notes,
    ratios=True,
)
