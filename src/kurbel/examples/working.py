"""A part of a worked example worked out: line by line, each new figure as printed and as it is."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from typing import NamedTuple

from kurbel.exact.numerals import Label, degrees_text, finite_decimals
from kurbel.examples.figures import Figure
from kurbel.examples.formulas import FORMULAS, Formulas
from kurbel.examples.kinds import certified
from kurbel.examples.lines import exact_text, filled, names_in
from kurbel.examples.source import Example, Line, Part
from kurbel.examples.words import WORDS
from kurbel.reading.notation import plain

INDENT = "\u00a0\u00a0"
CONTINUED = ("$=", "$- ")


class Entry(NamedTuple):
    """A row: the line of the working, and the step that it introduces, if it does."""

    line: Label
    begins: bool
    step: str = ""
    symbol: Label = ""
    printed: Figure | None = None
    recomputed: Figure | None = None
    remark: Label = ""

    @property
    def difference(self) -> int | None:
        """Recomputed less printed in units of the last place; None without one."""
        if self.printed is None or self.recomputed is None or self.printed.form.fraction:
            return None
        return int(self.recomputed.value - self.printed.value)


class Working:
    """A part worked out: its lines with their figures."""

    def __init__(self, example: Example, part: Part, lang: str) -> None:
        self.example = example
        self.part = part
        self.lang = lang
        self.formulas: Formulas = FORMULAS[example.formulas]
        self.values: dict[str, Figure] = {}

    def entries(self) -> Iterator[Entry]:
        shown: set[str] = set()
        for line in self.part.lines:
            if line.when and not self.formulas.conditions[line.when](self.part.given):
                continue
            names = [name for name in names_in(line.text) if name in self.example.steps]
            new = [name for name in names if name not in shown]
            shown.update(new)
            text = self._line(line)
            yield self._entry(text, new[0]) if new else Entry(text, True)
            for name in new[1:]:
                yield self._entry(text, name)._replace(begins=False)

    def _entry(self, text: Label, name: str) -> Entry:
        symbol = f"${filled(self.example.steps[name].symbol, self._figure)}$"
        value, printed = self._value(name), self.part.printed.get(name)
        remark = "" if printed in (None, value) else self._remark(name, printed, value)
        return Entry(text, True, name, symbol, printed, value, remark)

    def _value(self, name: str) -> Figure:
        """Return the true value of a step in the form in which it is printed."""
        if name not in self.values:
            form = self.part.printed.get(name, self.example.steps[name].figure).form
            transcendental = name in self.formulas.transcendental
            self.values[name] = certified(self.formulas.steps[name], self.part.given, form, transcendental)
        return self.values[name]

    def _line(self, line: Line) -> Label:
        text = filled(line.text, self._figure)
        text = f"[{text}]" if line.added else text
        return INDENT + text if text.startswith(CONTINUED) else text

    def _figure(self, name: str) -> str:
        if name in self.example.steps:
            return self.part.printed.get(name, self._value(name)).text()
        if name == "angle":
            return angle_text(self.part.given[name])
        if name in WORDS:
            return WORDS[name][self.lang]
        return exact_text(self.formulas.exact[name](self.part.given))

    def _remark(self, name: str, printed: Figure | None, value: Figure) -> Label:
        assert printed is not None
        if name in self.part.remarks:
            return self.part.remarks[name][self.lang]
        form = printed.form
        if form.fraction:
            return WORDS["differs"][self.lang]
        units = abs(value.value - printed.value)
        if form.parts:
            return WORDS["arc"][self.lang].format(arc=arc_text(Figure(units, form)))
        return WORDS["unit" if units == 1 else "units"][self.lang].format(units=units)


def arc_text(arc: Figure) -> Label:
    """Return a small angle without its degrees of zero: 4'."""
    return str(arc.cell()).replace("$0°", "$").removeprefix("0°")


def angle_text(angle: Fraction) -> str:
    """Return an angle for a formula: 45°, 22.5°, 0°20'."""
    return degrees_text(angle) if finite_decimals(angle) is None else f"{plain(angle)}°"
