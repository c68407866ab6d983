"""The axes of pages: crank ratios, crank angles, and columns."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from functools import cached_property
from typing import Protocol

from kurbel.exact.numerals import Label, Number, degrees_text, finite_decimals
from kurbel.page.angles import angle_decimals, angle_number
from kurbel.page.arrange import Axis, Place
from kurbel.page.layouts import Layout
from kurbel.page.quantity import Column, words
from kurbel.page.table import Field
from kurbel.reading.notation import plain, ratio_text

RATIO = words("Kurbelverhältnis R:L|Crank ratio R:L")
PHI = words("Kurbelwinkel|Crank angle")


class OfPage(Protocol):
    """What has a layout and a language."""

    @property
    def layout(self) -> Layout: ...
    @property
    def lang(self) -> str: ...


class OfRatios(OfPage, Protocol):
    """A question about crank ratios."""

    @property
    def ratios(self) -> Sequence[Fraction]: ...


class OfAngles(OfPage, Protocol):
    """A question about crank angles."""

    @property
    def angles(self) -> Sequence[Fraction]: ...


class OfColumns(OfPage, Protocol):
    """A question with columns."""

    @property
    def page_columns(self) -> Sequence[Column]: ...


class RatioAxis(Axis):
    """The crank ratios R:L."""

    key = "ratio"

    def __init__(self, question: OfRatios) -> None:
        super().__init__(len(question.ratios))
        self.layout, self.lang, self.ratios = question.layout, question.lang, question.ratios

    def field(self) -> Field:
        return Field("ratio", RATIO[self.lang], f"${self.layout.ratio_symbol}$")

    def value(self, place: Place) -> Label:
        return f"${ratio_text(self.ratios[place['ratio']])}$"

    def stub_heading(self) -> Label:
        return f"${self.layout.ratio_symbol}$"

    def heads(self, place: Place) -> tuple[Label, ...]:
        return (self.value(place),)

    def over_group(self, place: Place) -> Label:
        return f"${self.layout.ratio_symbol} = {ratio_text(self.ratios[place['ratio']])}$"


class LetteredRatioAxis(RatioAxis):
    """Crank ratios with their letters, for heads that stand alone."""

    def heads(self, place: Place) -> tuple[Label, ...]:
        return (self.over_group(place),)


class AngleAxis(Axis):
    """Crank angles in degrees; in pairs an angle stands over its mirror image, in records each for itself."""

    key = "phi"

    def __init__(self, question: OfAngles) -> None:
        self.layout, self.lang = question.layout, question.lang
        self.all = question.angles
        self.angles = angle_pairs(self.all) if self.layout.pairs else self.all
        self.lines = 2 if self.layout.pairs else 1
        super().__init__(len(self.angles), len(self.all))

    @cached_property
    def decimals(self) -> int | None:
        """How many decimals write every angle exactly, None if no number of them does."""
        return angle_decimals(self.all)

    def field(self) -> Field:
        return Field("phi", PHI[self.lang], f"${self.layout.angle_symbol}$", "°", self.decimals)

    def value(self, place: Place) -> Number:
        return angle_number(self.all[place["angle"]], self.decimals)

    def stub_heading(self) -> Label:
        heading = f"${self.layout.angle_symbol}$" + (" in °" if self.decimals is not None else "")
        return heading

    def heads(self, place: Place) -> tuple[Label, ...]:
        angle = self.angles[place["angle"]]
        return (
            (_angle_label(angle), _angle_label(360 - angle)) if self.layout.pairs else (_angle_label(angle),)
        )

    def stub(self, place: Place) -> Number | Label:
        angle = self.angles[place["angle"]]
        return f"${degrees_text(angle)}$" if self.decimals is None else angle_number(angle, self.decimals)


class ColumnAxis(Axis):
    """The columns with their heads, in which the ratio of the row may stand."""

    def __init__(self, question: OfColumns) -> None:
        super().__init__(len(question.page_columns))
        self.layout, self.lang, self.columns = question.layout, question.lang, question.page_columns
        self.ratios: Sequence[Fraction] = getattr(question, "ratios", ())

    def stub_heading(self) -> Label:
        return ""

    def heads(self, place: Place) -> tuple[Label, ...]:
        column = self.columns[place["column"]]
        labels = column.spanners + column.heading
        if "ratio" in self.layout.across:
            # The ratios stand below without their letters: "Hingang, R:L" over 1:4, 1:5.
            return (*labels[:-1], f"{labels[-1]}, ${self.layout.ratio_symbol}$")
        return self._with_ratio(labels, place)

    def stub(self, place: Place) -> Label:
        return self._with_ratio(self.columns[place["column"]].heading, place)[-1]

    over_group = stub

    def _with_ratio(self, labels: tuple[Label, ...], place: Place) -> tuple[Label, ...]:
        if "ratio" not in place or not self.ratios:
            return labels
        return tuple(with_ratio(label, self.ratios[place["ratio"]]) for label in labels)


def angle_pairs(angles: Sequence[Fraction]) -> tuple[Fraction, ...]:
    """Return each pair of angles once, by the one up to 180°: 200° stands in the pair of 160°."""
    within = (angle % 360 for angle in angles)
    return tuple(dict.fromkeys(min(angle, 360 - angle) for angle in within))


def with_ratio(label: Label, ratio: Fraction) -> Label:
    """Put the ratio as a fraction where the label has {ratio}: 1/4.5."""
    return label.replace("{ratio}", ratio_text(ratio).replace(":", "/") if ratio else "0")


def _angle_label(angle: Fraction) -> Label:
    return f"${plain(angle) if finite_decimals(angle) is not None else degrees_text(angle)}$"
