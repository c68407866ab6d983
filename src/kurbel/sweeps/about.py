"""What a file says of a sweep and of its columns: who computed what, of what, and in which units."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction

import kurbel
from kurbel.commands.sliders import SpacedValues
from kurbel.exact.numerals import Label, exact_text
from kurbel.motion.captions import formula_lines
from kurbel.motion.motion_page import Request
from kurbel.page.labels import plain
from kurbel.page.subject import Question
from kurbel.page.table import Note
from kurbel.reading.amounts import factors_of
from kurbel.reading.notation import Progression
from kurbel.sweeps.columns import Column
from kurbel.sweeps.plan import text_of
from kurbel.sweeps.records import questions
from kurbel.sweeps.rows import Sweep

BOUND = "the true value lies at most so far from {}"
DECIMALS = "each digit is certified: the exact value, correctly rounded to {} decimals"


@dataclass(frozen=True)
class SweepDescription:
    """What is known of a sweep: `questions` are those of two combinations, or of one.

    What they both say holds everywhere.
    """

    sweep: Sweep
    questions: tuple[Question, ...]

    @classmethod
    def of(cls, sweep: Sweep) -> SweepDescription:
        # Of sweeps of which all of these are refused one that is asked elsewhere.
        found = [*questions(sweep.plan, 0, 8)] or [next(questions(sweep.plan, 0))]
        return cls(sweep, (*found[:1], *found[1:][-1:]))

    def file(self) -> dict[str, object]:
        """Return what is said of the whole file."""
        said = {
            "title": self.title,
            "kurbel": kurbel.__version__,
            "source": self._common(lambda one: [one.origin]),
            "notes": self._common(_notes),
            "inputs": self.inputs(),
        }
        return {name: value for name, value in said.items() if value}

    @property
    def command(self) -> str:
        """The command that prints pages of this."""
        return self.questions[0].subject.command.split()[0]

    @property
    def title(self) -> str:
        names = dict.fromkeys(one.name or one.key for one in self.sweep.columns if one.role == "value")
        axes = [one.key for one in self.sweep.columns if one.role == "axis"]
        return f"{'; '.join(names)} over {', '.join(axes)}"

    def inputs(self) -> dict[str, object]:
        """Return the exact inputs as they can be typed again."""
        plan = self.sweep.plan
        unsaid = plan.asking.defaults
        given = {name: _text(value) for name, value in plan.given.items() if value != unsaid[name]}
        axes = [{axis.option: _text(axis.values) for axis in group} for group in plan.groups]
        said = {
            "command": self.command,
            "options": given,
            "axes": axes,
            "only": plan.only or None,
            "design": plan.design or None,
            "digits": plan.digits,
            "bounds": plan.bounds or None,
        }
        return {name: value for name, value in said.items() if value is not None}

    def column(self, column: Column) -> dict[str, str]:
        """Return what is said of a column, as plain text; what there is nothing to say of is left out."""
        said = {
            "name": column.name,
            "symbol": plain(column.symbol),
            "unit": plain(column.unit),
            "formula": column.formula or "; ".join(self._common(lambda one: [*_formulas(one, column.key)])),
            "source": column.source,
            "role": column.role,
            "note": _note(column),
        }
        return {name: text for name, text in said.items() if text}

    def _common(self, lines: Callable[[Question], Iterable[Label]]) -> list[str]:
        """Return the lines that all questions say."""
        first, *others = ([plain(line) for line in lines(one) if line] for one in self.questions)
        return [line for line in first if all(line in other for other in others)]


def _notes(question: Question) -> Iterator[str]:
    for note in question.below():
        yield note.text if isinstance(note, Note) else note


def _formulas(question: Question, key: str) -> Iterator[str]:
    """Yield the formula of a quantity as pages print it, and what its letters are."""
    for column in question.page_columns:
        if column.key != key:
            continue
        if isinstance(question, Request):
            # The line also says what its letters are, which alone is no formula.
            if any(one.printed for one in column.quantity.formulas.values()):
                yield from formula_lines(question, [column])
        else:
            for method in column.methods:
                formula = column.quantity.formulas.get(method)
                if formula and formula.printed and "{" not in formula.printed:
                    yield formula.printed


def _note(column: Column) -> str:
    if column.role == "bound":
        return BOUND.format(column.key.removesuffix("_bound"))
    return DECIMALS.format(column.decimals) if column.kind == "decimal" else ""


def _text(value: object) -> object:
    """Return a value, or several, as text that can be typed."""
    if isinstance(value, SpacedValues):
        return f"{_range(value.numbers)}{value.unit}"
    if isinstance(value, Progression):
        return _range(value)
    if isinstance(value, str | bool | int):
        return value
    if isinstance(value, Mapping):
        return " ".join(f"{key}={text_of(one)}" for key, one in value.items())
    if isinstance(value, Sequence):
        return [_text(one) for one in value]
    return exact_text(value) if isinstance(value, Fraction) else str(value)


def _range(values: Progression) -> str:
    return f"{exact_text(values[0])}..{exact_text(values[-1])}:{exact_text(values.step)}"


# Units as udunits spells them, where that is not the letter itself, and those that it has by their letters.
SPELLED: Mapping[str, str] = {"rad": "radian", "min": "minute", "h": "hour"}
OWN = frozenset(("m", "mm", "cm", "km", "kg", "s", "N", "J", "W", "kW", "Pa", "kPa", "MPa", "bar", "Hz"))


def cf_of_file(about: SweepDescription) -> dict[str, str]:
    """Return the attributes of a file."""
    said = about.file()
    return {
        "Conventions": "CF-1.11",
        "title": about.title,
        "source": f"kurbel {kurbel.__version__}",
        "kurbel": json.dumps(said, ensure_ascii=False),
    }


def cf_of(about: SweepDescription, column: Column) -> dict[str, str]:
    """Return the attributes of an array. `units` are those of udunits, "1" where the unit is one of the drive
    itself, such as R; `unit` is that as pages print it."""
    said = about.column(column)
    said.pop("role")
    if "name" in said:
        said["long_name"] = said.pop("name")
    if column.kind == "number":
        said["units"] = udunits(said.get("unit", ""))
    if "source" in said:
        said["references"] = said.pop("source")
    return said


def udunits(unit: str) -> str:
    """Return a unit as udunits spells it: m/s² is "m s-2"; "1" for one that it does not know."""
    if unit == "°" or unit.startswith("%"):
        return "degree" if unit == "°" else "percent"
    try:
        factors = [*factors_of(unit.replace("kWh", "kW/h" if "/kWh" in unit else "kW h"))]
    except ValueError:
        return "1"
    if not factors or not all(name in OWN or name in SPELLED for name, _ in factors):
        return "1"
    return " ".join(f"{SPELLED.get(name, name)}{'' if power == 1 else power}" for name, power in factors)
