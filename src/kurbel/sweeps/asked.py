"""From options with their values to a plan: what varies, in which order, and what is the same everywhere."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from math import prod
from typing import Any

from kurbel.commands.options import TEXT, Option, is_given
from kurbel.commands.part import Values
from kurbel.commands.steps.several import several
from kurbel.commands.subject import SPELLED, Command
from kurbel.errors import KurbelError, NotationError, ProblemError
from kurbel.motion.page import AngleQuestion, is_beyond
from kurbel.page.axes import AngleAxis, shifted
from kurbel.page.subject import Question
from kurbel.reading.given import as_angles, meant
from kurbel.sweeps.kept import named_axes
from kurbel.sweeps.measures import is_readable
from kurbel.sweeps.only import Condition
from kurbel.sweeps.plan import MOST_ROWS, Axis, Plan
from kurbel.sweeps.sample import Design, is_varied, sampled
from kurbel.sweeps.ways.records import DECIMALS, tried

RUN = ("from", "to", "step")
# Longer lists are not tried one by one.
MOST_TRIED = 1000


def not_outdone(command: Command, given: Values, first: Mapping[str, Any]) -> set[str]:
    """Return the names of those options, with the first value of each, that are not outdone by others."""
    trial = Values({**given.values, **first}, given.origins)
    try:
        command.ask(trial)
    except KurbelError:
        # What is refused everywhere is refused at the first combination, too.
        return set(first)
    return {name for name in first if name in SPELLED or trial.says(name)}


def values_of(parameter: Option[Any], given: Any) -> Sequence[Any]:
    """Return the values that an option was given, each as the command takes it. Raises NotationError."""
    if isinstance(given, bool) or not is_given(given):
        return (given,)
    if parameter.whole and parameter.many:
        return (parameter.taken(given),)
    found = several(parameter, given if isinstance(given, list | tuple) else [given])
    numbers = not parameter.whole and parameter.numbers
    if parameter.kind is TEXT and numbers and isinstance(found, tuple):
        for one in found if len(found) > 1 else ():
            if isinstance(one, str) and not is_readable(parameter, one):
                raise NotationError(
                    f'{parameter.name} "{one[:40]}" is no number; give numbers, with their unit where they'
                    " have one"
                )
    return found


def planned(
    command: str,
    options: Mapping[str, Any],
    *,
    linked: Iterable[Collection[str]] = (),
    defaults: Collection[str] = (),
    digits: int | None = None,
    bounds: bool = False,
    strict: bool = False,
    only: str = "",
    sample: str = "",
    seed: int = 0,
) -> Plan:
    """Return the plan of a command, found at this place, by the values of its options in their order.

    An option with several values varies; those that are `linked` vary together. Raises KurbelError.
    """
    if bounds and digits is not None:
        raise ProblemError(
            f"bounds are of floats, and with --digits {digits} every decimal is certified; leave one of"
            " --bounds and --digits out"
        )
    plan = Plan(command, {}, (), digits, bounds, tuple(defaults), strict, only)
    known = {one.name: one for one in plan.asking.parameters.values()}
    for one in known.values():
        if one.required and one.name not in options:
            raise ProblemError(f"{one.flag} is missing, without which there is nothing to compute")
    if sample:
        plan = _designed(plan, known, options, Design.read(sample, seed))
        if [*linked]:
            raise ProblemError("a sample links all options that vary; leave --zip out")
    values = {name: values_of(known[name], one) for name, one in options.items() if name not in plan.varied}
    axes = [Axis(name, found) for name, found in values.items() if len(found) > 1]
    for axis in axes:
        if axis.option in RUN:
            raise ProblemError(
                f"--{axis.option} takes one value, {len(axis.values)} were given; several angles are --angle"
                " '0;45;90' or --angle 0..360:10"
            )
    given = {name: found[0] for name, found in values.items() if len(found) == 1}
    plan = replace(plan, given=given, groups=plan.groups or _grouped(axes, linked))
    if "angle" in known:
        plan = _with_angles(plan, [*options])
    _check_size(plan)
    if only:
        named_axes(plan, Condition(only))
        # What holds nowhere is said at once.
        len(plan)
    return plan


def _designed(
    plan: Plan, known: Mapping[str, Option[Any]], options: Mapping[str, Any], design: Design
) -> Plan:
    """Return the plan with the points of a design on those options that vary, but for the run of angles."""
    varied = {name: (known[name], one) for name, one in options.items() if is_varied(known[name], one)}
    if not varied:
        raise ProblemError("a sample needs something that varies; give a range, such as --eps 1..10")
    return replace(plan, groups=(sampled(design, varied),), design=str(design))


def _grouped(axes: Sequence[Axis], linked: Iterable[Collection[str]]) -> tuple[tuple[Axis, ...], ...]:
    """Return the groups of axes in their order, a group where its first axis stands."""
    by_name = {axis.option: axis for axis in axes}
    groups: dict[str, tuple[Axis, ...]] = {axis.option: (axis,) for axis in axes}
    for names in linked:
        found = [meant(name, by_name, "option with several values") for name in names]
        if len(found) == 1:
            raise ProblemError(
                f"--zip {found[0].replace('_', '-')} links one option to nothing; name those that go through"
                " their values together: --zip eps,back"
            )
        sizes = {name: len(by_name[name].values) for name in found}
        if len({*sizes.values()}) > 1:
            said = ", ".join(f"{size} of --{name.replace('_', '-')}" for name, size in sizes.items())
            raise ProblemError(f"linked options go through their values together, and there are {said}")
        if any(len(groups.get(name, ())) != 1 for name in found) or len({*found}) != len(found):
            raise ProblemError("an option is linked twice; name each once")
        order = [name for name in by_name if name in found]
        groups[order[0]] = tuple(by_name[name] for name in order)
        for name in order[1:]:
            del groups[name]
    return tuple(groups.values())


def _with_angles(plan: Plan, order: Sequence[str]) -> Plan:
    """Return the plan with the crank angles of the command's page as an axis, where it has such."""
    question = _first(plan)
    if question is None or not any(isinstance(axis, AngleAxis) for axis in question.axes.values()):
        return plan
    if varied := [axis.values for group in plan.groups for axis in group if axis.option == "angle"]:
        return _over_strokes(plan, question, shifted(as_angles(varied[0]), question.zero))
    angles: Any = getattr(question, "angles", ())
    plan = _over_strokes(plan, question, angles)
    axis = Axis("angle", shifted(angles, -question.zero))
    given = {name: value for name, value in plan.given.items() if name not in (*RUN, "angle")}
    typed = [order.index(name) for name in RUN if name in order]
    before = [group for group in plan.groups if typed and order.index(group[0].option) < min(typed)]
    place = len(before) if typed else len(plan.groups)
    return replace(plan, given=given, groups=(*plan.groups[:place], (axis,), *plan.groups[place:]))


def _over_strokes(plan: Plan, question: Question, angles: Sequence[Fraction]) -> Plan:
    """Return the plan over both strokes, or over whole turns where these angles go beyond a stroke."""
    apart = "zero" in plan.varied or is_beyond(angles)
    return replace(plan, whole_turns=isinstance(question, AngleQuestion) and apart)


def _first(plan: Plan) -> Question | None:
    """Return what is asked at the first combination that is not refused, of those that are tried."""
    for point in tried(plan):
        try:
            return plan.question(plan.at(point), DECIMALS)
        except KurbelError:
            continue
    return None


def _check_size(plan: Plan) -> None:
    if (count := prod(plan.sizes)) > MOST_ROWS:
        said = " x ".join(f"{len(group[0].values)} of --{group[0].option}" for group in plan.groups)
        raise ProblemError(
            f"the sweep would have {count} rows ({said}), and at most 10^12 are computed; give wider steps,"
            " or divide it"
        )
