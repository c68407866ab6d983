"""From options with their values to a plan: what varies, in which order, and what is the same everywhere."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from math import floor, log10, prod
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from kurbel.commands.options import TEXT, Option, is_given
from kurbel.commands.part import Values, flag_of
from kurbel.commands.sliders import figures, parted, several
from kurbel.commands.subject import Command
from kurbel.errors import KurbelError, NotationError, ProblemError
from kurbel.motion.motion_page import AngleQuestion, is_beyond
from kurbel.page.axes import AngleAxis, shifted
from kurbel.page.subject import Question
from kurbel.reading import notation
from kurbel.reading.given import allowed_name, as_angle
from kurbel.reading.notation import Progression
from kurbel.sweeps.condition import Condition, named_axes
from kurbel.sweeps.coordinates import is_readable
from kurbel.sweeps.plan import MOST_ROWS, Axis, Plan
from kurbel.sweeps.records import questions

KINDS = ("random", "sobol", "halton", "lhs")
MOST_POINTS = 10**6
# So many steps between the ends of a range: a value has about six figures.
STEPS = 6
_RANGE = re.compile(r"(1\s*[:/∶])?(.+?)\.\.(?:1\s*[:/∶](?=.))?([^:]+)(:.+)?")


@dataclass(frozen=True)
class Design:
    """How points are chosen: of which kind, how many, and by which seed."""

    kind: str
    size: int
    seed: int

    def __str__(self) -> str:
        return f"{self.kind}:{self.size}, seed {self.seed}"

    @classmethod
    def read(cls, text: str, seed: int) -> Design:
        """Return the design of a text such as sobol:1024. Raises KurbelError."""
        name, _, count = text.partition(":")
        kind = allowed_name(name.strip(), KINDS, "design")
        size = int(count) if re.fullmatch(r"[0-9]{1,9}", count.strip()) else 0
        if not 1 <= size <= MOST_POINTS:
            raise NotationError(
                f'design "{text[:40]}" does not say how many points; write a number from 1 to 10^6 behind a'
                f" colon: {kind}:1024"
            )
        if kind == "sobol" and size & (size - 1):
            below = 1 << (size.bit_length() - 1)
            raise ProblemError(
                f"a Sobol design of {size} points is out of balance; take a power of two, {below} or"
                f" {2 * below}"
            )
        return cls(kind, size, seed)

    def unit(self, dimensions: int) -> NDArray[np.float64]:
        """Return the points in the unit cube, a row each."""
        if self.kind == "random":
            return np.random.default_rng(self.seed).random((self.size, dimensions))
        from scipy.stats import qmc

        makers = {"sobol": qmc.Sobol, "halton": qmc.Halton, "lhs": qmc.LatinHypercube}
        found: NDArray[np.float64] = makers[self.kind](dimensions, seed=self.seed).random(self.size)
        return found


class _Range(NamedTuple):
    """The ends between which values lie, to so many decimals; of rods they are the lengths L/R."""

    first: Fraction
    last: Fraction
    unit: str
    rods: bool

    def at(self, share: float) -> object:
        decimals = max(0, STEPS - floor(log10(self.last - self.first)))
        value = Fraction(round((self.first + (self.last - self.first) * Fraction(share)) * 10**decimals))
        value = min(max(value / 10**decimals, self.first), self.last)
        return 1 / value if self.rods else f"{figures(value)}{self.unit}"


class _List(NamedTuple):
    """Values of which any may be taken."""

    values: Sequence[object]

    def at(self, share: float) -> object:
        return self.values[int(share * len(self.values))]


def _each(given: object) -> Sequence[object]:
    return given if isinstance(given, list | tuple) else [given]


def is_varied(option: Option[object], given: object) -> bool:
    """Whether an option has several values, or a range without a step."""
    texts = _each(given)
    if option.whole:
        return len(texts) > 1 and not option.many
    return len(texts) > 1 or (isinstance(texts[0], str) and (";" in texts[0] or ".." in texts[0]))


def _space(option: Option[object], given: object) -> _Range | _List:
    texts = _each(given)
    one = texts[0]
    if len(texts) > 1 or not isinstance(one, str) or ";" in one or option.whole:
        return _List(several(option, texts))
    name = option.name
    match = _RANGE.fullmatch(one.strip())
    if match is None:
        raise NotationError(f"{name} {notation.quoted(one)} is not a range; write it as 2..6")
    rods, first, last, step = match.groups()
    if step:
        raise ProblemError(
            f"{flag_of(name)} {one} has a step, and a sample takes any value between the ends;"
            f" write {one.removesuffix(step)}"
        )
    if option.unit == "degrees":
        ends, unit = [notation.angle(first), notation.angle(last)], ""
    else:
        parts = [parted(first), parted(last)]
        units = dict.fromkeys(unit for _, unit in parts if unit)
        if len(units) > 1:
            raise NotationError(f"{name} {notation.quoted(one)} has two units; give both ends in one")
        ends, unit = [notation.number(shown, name) for shown, _ in parts], next(iter(units), "")
    if not ends[0] < ends[1]:
        raise NotationError(f"{name} {notation.quoted(one)} has its end before its start")
    if rods and ends[0] <= 0:
        raise NotationError(f"crank ratio {notation.quoted(one)} contains 1:0; the rod must have a length")
    return _Range(ends[0], ends[1], unit, bool(rods))


RUN = ("from", "to", "step")


def left_of(command: Command, options: Values) -> dict[str, object]:
    """Return what options are given that say something, in their order, but for what others outdo."""
    given = {
        name: value
        for name, value in options.values.items()
        if name in command.options and options.origins.get(name) and is_given(value)
    }
    if all(map(options.typed, given)):
        return given
    first = {name: values_of(command.options[name], value)[0] for name, value in given.items()}
    trial = Values({**command.defaults, **first}, options.origins)
    try:
        command.ask(trial)
    except KurbelError:
        # What is refused everywhere is refused at the first combination, too.
        return given
    return {name: value for name, value in given.items() if name == "time_ratio" or trial.says(name)}


def values_of(option: Option[object], given: object) -> Sequence[object]:
    """Return the values that an option was given, each as the command takes it. Raises NotationError."""
    if isinstance(given, bool) or not is_given(given):
        return (given,)
    if option.name == "angle" and any("=" in str(one) for one in _each(given)):
        # What holds at crank angles, of which every point has its own.
        return (given,)
    if option.whole and option.many:
        return (option.taken(given),)
    found = several(option, _each(given))
    numbers = option.kind is TEXT and option.numbers and not option.whole
    for one in found if numbers and isinstance(found, tuple) and len(found) > 1 else ():
        if isinstance(one, str) and not is_readable(option, one):
            raise NotationError(
                f'{option.name} "{one[:40]}" is no number; give numbers, with their unit where they have one'
            )
    return found


def planned(
    command: str,
    options: Values,
    *,
    linked: Iterable[str | Sequence[str]] = (),
    digits: int | None = None,
    bounds: bool = False,
    strict: bool = False,
    only: str = "",
    sample: str = "",
    seed: int = 0,
) -> Plan:
    """Return the plan of a command, found at this place, by the values of its options in their order.

    An option with several values varies; those that are `linked`, "eps,back", vary together. Raises
    KurbelError.
    """
    if bounds and digits is not None:
        raise ProblemError(
            f"bounds are of floats, and with --digits {digits} every decimal is certified; leave one of"
            " --bounds and --digits out"
        )
    plan = Plan(command, {}, (), digits, bounds, strict=strict, only=only)
    known, left = plan.asking.options, left_of(plan.asking, options)
    plan = replace(plan, defaults=tuple(name for name in left if not options.typed(name)))
    if sample:
        plan = _designed(plan, left, Design.read(sample, seed))
        if [*linked]:
            raise ProblemError("a sample links all options that vary; leave --zip out")
    values = {name: values_of(known[name], one) for name, one in left.items() if name not in plan.axes}
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
        plan = _with_angles(plan, [*left])
    _check_size(plan)
    if only:
        named_axes(plan, Condition(only))
        # What holds nowhere is said at once.
        len(plan)
    return plan


def _designed(plan: Plan, given: Mapping[str, object], design: Design) -> Plan:
    """Return the plan with the points of a design on those options that vary, but for the run of angles."""
    options = [plan.asking.options[name] for name in given]
    varied = [one for one in options if is_varied(one, given[one.name])]
    if not varied:
        raise ProblemError("a sample needs something that varies; give a range, such as --eps 1..10")
    spaces = [_space(one, given[one.name]) for one in varied]
    axes = tuple(
        Axis(one.name, tuple(map(space.at, shares.tolist())))
        for one, space, shares in zip(varied, spaces, design.unit(len(spaces)).T, strict=True)
    )
    return replace(plan, groups=(axes,), design=str(design))


def _grouped(axes: Sequence[Axis], linked: Iterable[str | Sequence[str]]) -> tuple[tuple[Axis, ...], ...]:
    """Return the groups of axes in their order, a group where its first axis stands."""
    by_name = {axis.option: axis for axis in axes}
    groups: dict[str, tuple[Axis, ...]] = {axis.option: (axis,) for axis in axes}
    for text in linked:
        if not by_name:
            raise ProblemError(
                "no option has several values, so that there is nothing to link; leave --zip out, or give"
                " several, --eps '2;3;4'"
            )
        names = text.replace(";", ",").split(",") if isinstance(text, str) else text
        plain = (name.strip().replace("-", "_") for name in names)
        found = [allowed_name(name, by_name, "option with several values") for name in plain]
        if len(found) == 1:
            raise ProblemError(
                f"--zip {flag_of(found[0])[2:]} links one option to nothing; name those that go through"
                " their values together: --zip eps,back"
            )
        sizes = {name: len(by_name[name].values) for name in found}
        if len({*sizes.values()}) > 1:
            said = ", ".join(f"{size} of {flag_of(name)}" for name, size in sizes.items())
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
    question = None if plan.held else next(questions(plan), None)
    if question is None or not any(isinstance(axis, AngleAxis) for axis in question.axes.values()):
        return plan
    if axis := plan.axes.get("angle"):
        if not isinstance(axis.values, Progression):
            # As exact numbers, however they are written.
            values = tuple(one if isinstance(one, int) else as_angle(one) for one in axis.values)
            exact = axis._replace(values=values)
            groups = (tuple(exact if one is axis else one for one in group) for group in plan.groups)
            axis, plan = exact, replace(plan, groups=tuple(groups))
        return _over_strokes(plan, question, shifted(axis.values, question.zero))
    angles: Sequence[Fraction] = getattr(question, "angles", ())
    plan = _over_strokes(plan, question, angles)
    axis = Axis("angle", shifted(angles, -question.zero))
    given = {name: value for name, value in plan.given.items() if name not in (*RUN, "angle")}
    typed = [order.index(name) for name in RUN if name in order]
    before = [group for group in plan.groups if typed and order.index(group[0].option) < min(typed)]
    place = len(before) if typed else len(plan.groups)
    return replace(plan, given=given, groups=(*plan.groups[:place], (axis,), *plan.groups[place:]))


def _over_strokes(plan: Plan, question: Question, angles: Sequence[Fraction]) -> Plan:
    """Return the plan over both strokes, or over whole turns where these angles go beyond a stroke."""
    apart = "zero" in plan.axes or is_beyond(angles)
    return replace(plan, whole_turns=isinstance(question, AngleQuestion) and apart)


def _check_size(plan: Plan) -> None:
    if (count := prod(plan.sizes)) > MOST_ROWS:
        said = " x ".join(f"{len(group[0].values)} of --{group[0].option}" for group in plan.groups)
        raise ProblemError(
            f"the sweep would have {count} rows ({said}), and at most 10^12 are computed; give wider steps,"
            " or divide it"
        )
