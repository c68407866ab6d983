"""The page of every step: the command asks once for each, and everything on a page is what it answers."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import partial
from typing import Any

from kurbel.commands.options import is_given
from kurbel.commands.part import Values
from kurbel.commands.steps.sliders import (
    Choice,
    check_count,
    check_numbers,
    choices,
    steps,
    usual_cut_offs,
    usual_ratios,
)
from kurbel.commands.steps.tracks import Run, run_of
from kurbel.commands.subject import Command
from kurbel.drive.crank import Crank
from kurbel.drive.load import STEAM
from kurbel.errors import KurbelError, ProblemError
from kurbel.motion.mechanism import mechanism
from kurbel.page.steps import Scene, Step, Steps
from kurbel.page.subject import Question
from kurbel.page.table import Table
from kurbel.reading.given import as_numbers, found_at

NOTHING = (
    "an interactive page needs something to choose, and here is nothing; give an option several values, for"
    " example --ratio 1:3..6, or leave --interactive out"
)


def stepped(command: Command, values: Values) -> Table:
    """Return the page of the step that is shown first, with all steps if there is anything to choose.

    `values` are those of all options, which are settled here; a page is called by them.
    """
    command.settle(values)
    named = values.values
    asking = _Asking(command, values, tuple(choices(command.options, named)))
    check_count(asking.choices)
    question = asking.first()
    found = (*asking.usual(question), *asking.choices)
    check_count(found)
    asking = replace(asking, choices=found)
    question = asking.first()
    if not isinstance(question, Question):
        # The pages of examples have no columns, and nothing runs along them.
        return command.built(question, values)
    check_numbers(len(question) * len(question.page_columns), found)
    run = asking.run(question)
    page = command.built(question, values)
    if not found and run is None:
        return page
    ratio = question.layout.ratio_symbol
    return replace(
        page,
        steps=Steps(
            tuple(one.slider(question.lang, ratio) for one in found),
            run.cursor if run else None,
            run.columns if run else (),
            partial(asking.pages, page, run),
        ),
    )


@dataclass(frozen=True)
class _Asking:
    """A command with the values of its options, some of which are chosen."""

    command: Command
    values: Values
    choices: tuple[Choice, ...]

    def question(self, chosen: Mapping[str, Any]) -> Question:
        """Return what is asked for by these values."""
        question: Question = self.command.question(self.values.instead(chosen))
        return question

    def first(self) -> Question:
        """Return what is asked for at the step that is shown first."""
        return self.question({one.name: one.values[one.start] for one in self.choices})

    def usual(self, question: Question) -> Iterator[Choice]:
        """Yield what can be chosen where nothing is said of it: the crank ratio, and of steam ε."""
        said = {name for name, value in self.values.values.items() if is_given(value)}
        ratios = [ratio for ratio in getattr(question, "ratios", ()) if ratio]
        if "ratio" in self.command.options and ratios and said.isdisjoint(("ratio", "rod")):
            yield usual_ratios(ratios, self.turns)
        steams = [one.name for one in getattr(question, "steams", ())]
        if "angle" in self.command.options and "eps" not in said and steams and {*steams} == {STEAM}:
            yield usual_cut_offs(as_numbers(question.layout.expansions, "expansion ratio"))

    def turns(self, ratio: Fraction) -> bool:
        """Whether the drive turns with a ratio at every step."""
        try:
            for chosen, _ in steps(self.choices):
                self.question({**chosen, "ratio": ratio})
        except ProblemError:
            return False
        return True

    def run(self, question: Question) -> Run | None:
        """Return what runs along the page, nothing for one of no crank drive, or without numbers along it."""
        return run_of(question, "angle" in self.command.options) if "ratio" in self.command.options else None

    def pages(self, first: Table, run: Run | None) -> Iterator[Step]:
        """Yield the page of every step, called as the first. Raises KurbelError, which names the step."""
        scenes: dict[Any, Scene | None] = {}
        for chosen, said in steps(self.choices):
            try:
                yield self.page(chosen, first, run, scenes)
            except KurbelError as error:
                raise type(error)(f"{error}; this is of the step {said}") from None

    def page(
        self, chosen: Mapping[str, Any], first: Table, run: Run | None, scenes: dict[Any, Scene | None]
    ) -> Step:
        question = self.question(chosen)
        table = self.command.built(question, self.values.instead(chosen))
        table = replace(table, key=first.key, variant=first.variant)
        tracks, units = run.tracks(question, self.along(chosen, run)) if run else ((), ())
        return Step(table, tracks, units, _scene(question, scenes))

    def along(self, chosen: Mapping[str, Any], run: Run) -> Question | None:
        """Return the same question at the angles that a page runs through, where it runs through these."""
        if not run.angles:
            return None
        whole = {**dict.fromkeys(("from", "to", "step")), "angle": run.angles, "columns": run.keys}
        known = self.command.options
        return self.question({**chosen, **{name: one for name, one in whole.items() if name in known}})


def _scene(question: Question, scenes: dict[Any, Scene | None]) -> Scene | None:
    """Return what moves, once for drives that move alike."""
    if question.moving is None:
        return None
    name, drive = question.moving
    # What acts on a drive is nothing to its way.
    bare = drive.of(Crank(drive.crank.ratio, drive.crank.offset))
    if bare not in scenes:
        scenes[bare] = found_at(mechanism(name).moving)(bare)
    return question.carrying(scenes[bare])
