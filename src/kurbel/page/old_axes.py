"""The axes of pages: crank ratios, crank angles, and columns."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import Protocol

from kurbel.exact.numerals import Label, Number, degrees_text, finite_decimals
from kurbel.page.angles import angle_decimals, angle_number
from kurbel.page.arrange import Axis, Place
from kurbel.page.layouts import Layout
from kurbel.reading.notation import plain, ratio_text


class Headed(Protocol):
    """A column of a page with its heads."""

    @property
    def spanners(self) -> tuple[Label, ...]: ...
    @property
    def heading(self) -> tuple[Label, ...]: ...


class RatioAxis(Axis):
    """The crank ratios R:L."""

    def __init__(self, layout: Layout, ratios: Sequence[Fraction], lang: str) -> None:
        super().__init__(len(ratios))
        self.layout = layout
        self.lang = lang
        self.ratios = ratios

    def stub_heading(self) -> Label:
        return self.layout.stub_heading("ratio", f"${self.layout.ratio_symbol}$", self.lang)

    def heads(self, place: Place) -> tuple[Label, ...]:
        return (f"${ratio_text(self.ratios[place['ratio']])}$",)

    def over_group(self, place: Place) -> Label:
        return f"${self.layout.ratio_symbol} = {ratio_text(self.ratios[place['ratio']])}$"


class AngleAxis(Axis):
    """Crank angles in degrees; in pairs an angle stands over its mirror image."""

    def __init__(self, layout: Layout, angles: Sequence[Fraction], lang: str) -> None:
        super().__init__(len(angles))
        self.layout = layout
        self.lang = lang
        self.angles = angles
        self.decimals = angle_decimals(angles)
        self.lines = 2 if layout.pairs else 1

    def stub_heading(self) -> Label:
        heading = f"${self.layout.angle_symbol}$" + (" in °" if self.decimals is not None else "")
        return self.layout.stub_heading("angle", heading, self.lang)

    def heads(self, place: Place) -> tuple[Label, ...]:
        angle = self.angles[place["angle"]]
        return (
            (_angle_label(angle), _angle_label(360 - angle)) if self.layout.pairs else (_angle_label(angle),)
        )

    def stub(self, place: Place) -> Number | Label:
        angle = self.angles[place["angle"]]
        return f"${degrees_text(angle)}$" if self.decimals is None else angle_number(angle, self.decimals)


class ColumnAxis(Axis):
    """The columns of a layout with their heads, in which the ratio of the row may stand."""

    def __init__(
        self, layout: Layout, columns: Sequence[Headed], ratios: Sequence[Fraction], lang: str
    ) -> None:
        super().__init__(len(columns))
        self.layout = layout
        self.lang = lang
        self.columns = columns
        self.ratios = ratios

    def stub_heading(self) -> Label:
        return self.layout.stub_heading("column", "", self.lang)

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
        if "ratio" not in place:
            return labels
        return tuple(with_ratio(label, self.ratios[place["ratio"]]) for label in labels)


def angle_pairs(angles: Sequence[Fraction]) -> tuple[Fraction, ...]:
    """Return each pair of angles once, by the one up to 180°: 200° stands in the pair of 160°."""
    within = (angle % 360 for angle in angles)
    return tuple(dict.fromkeys(min(angle, 360 - angle) for angle in within))


def _angle_label(angle: Fraction) -> Label:
    return f"${plain(angle) if finite_decimals(angle) is not None else degrees_text(angle)}$"


def with_ratio(label: Label, ratio: Fraction) -> Label:
    """Put the ratio as a fraction where the label has {ratio}: 1/4.5."""
    return label.replace("{ratio}", _fraction(ratio))


def _fraction(ratio: Fraction) -> str:
    if not ratio:
        return "0"
    return ratio_text(ratio).replace(":", "/")
