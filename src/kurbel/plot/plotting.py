"""Curves over the crank angle: one or several panels above each other, sharing the angle axis."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, NamedTuple

from kurbel.errors import ProblemError
from kurbel.plot.marks import (
    BESIDE_SWING,
    draw_areas,
    draw_ends,
    draw_spots,
    draw_strokes,
    draw_swing,
    strip_of,
)
from kurbel.plot.panel import (
    MOST_STEPS,
    NOTHING_AROUND,
    Panel,
    PanelFrame,
    check_panel,
    over_angle,
    round_step,
    value_ticks,
)
from kurbel.plot.plan import (
    ABOVE,
    BELOW,
    LEFT,
    LEGEND_ROW,
    RIGHT,
    PanelRoom,
    Plan,
    draw_legend,
    lined,
    plan_of,
    plans_to_scale,
    with_one_legend,
)
from kurbel.plot.style import (
    BLACK,
    LINES,
    MEDIUM,
    MM,
    STRONG,
    TEXT_SIZE,
    THIN,
    USUAL,
    Line,
    Size,
    page,
    style,
    text_of,
)

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure


HEIGHTS = {1: 72.0, 2: 50.0}
LOWEST = 38.0
TICK_HEIGHT = 7.5
# A number below the panel needs so much.
TICK_WIDTH = 7.8
# A comparison's line: dots as long as it is wide.
DOTS = (1.0, 2.5)
# Of a drawing whose height is given: no panel is lower.
LEAST_HEIGHT, LEAST_WIDTH = 15.0, 30.0


def curves(
    panels: Sequence[Panel], lang: str, mark: str, around: PanelFrame = NOTHING_AROUND, size: Size = USUAL
) -> Figure:
    """Return a drawing of panels above each other that share an axis, by default the angle's.

    The curves of a panel have their labels beside them where all find room, else in a legend; panels of like
    curves share the legend of the first. They differ in colour and in pattern, for print in black and for
    eyes that tell no colours. Where a value jumps its curve ends and begins anew, and a thin line leads from
    the one end to the other. Raises ProblemError for a panel of more curves than can be told apart, or
    without any finite value, for a single angle, and for a size that is too small.
    """
    with style():
        return charted(panels, lang, mark, around, size).figure


class Chart(NamedTuple):
    """A drawing of panels, with their axes and their plans."""

    figure: Figure
    axes: list[Axes]
    plans: list[Plan]


def charted(
    panels: Sequence[Panel], lang: str, mark: str, around: PanelFrame, size: Size, above: float = 0.0
) -> Chart:
    """Return such a drawing, with so many mm free above it. Only inside `style`."""
    for panel in panels:
        check_panel(panel)
    span = _span(panels)
    axis = around.across or over_angle(lang)
    own = size if size.height is None else size._replace(height=size.height - above)
    plans = _plans(panels, span, around, own, mark, above)
    figure, axes = _laid_out(plans, own, above)
    span = plans[0].span
    for number, (one, plan) in enumerate(zip(axes, plans, strict=True), 1):
        _draw(one, plan, number)
        draw_areas(one, plan, number)
        draw_ends(one, plan)
        draw_spots(one, plan)
        draw_swing(one, plan, mark)
        _value_axis(one, plan, mark)
        most = min(MOST_STEPS, int(plan.room.width / TICK_WIDTH))
        places, texts = axis.ticks(*span, mark, most)
        one.set_xticks(places, texts if number == len(plans) else [""] * len(texts))
        lined(one)
    _said(axes[0], plans[0])
    if around.strokes:
        draw_strokes(axes[0], plans[0], around.strokes, mark)
    axes[-1].set_xlabel(text_of(axis.label, mark), labelpad=3)
    return Chart(figure, axes, plans)


def _span(panels: Sequence[Panel]) -> tuple[float, float]:
    angles = [angle for panel in panels for curve in panel.curves for angle in curve.angles]
    span = (min(angles), max(angles))
    if span[0] == span[1]:
        raise ProblemError(f"the only crank angle is {span[0]:.6g}°; a curve needs two")
    return span


def _plans(
    panels: Sequence[Panel],
    span: tuple[float, float],
    around: PanelFrame,
    size: Size,
    mark: str,
    above: float,
) -> list[Plan]:
    """Return the panels as they fill a page of this size, with so many mm more above it."""
    beside = BESIDE_SWING if any(panel.swing for panel in panels) else RIGHT
    width = size.width - LEFT - beside
    if width < LEAST_WIDTH:
        raise ProblemError(
            f"the width is {size.width:.6g} mm; these curves need {LEAST_WIDTH + LEFT + beside:.6g} mm"
        )
    ends = tuple(end for end in (around.strokes.ends if around.strokes else ()) if span[0] <= end <= span[1])
    room = PanelRoom(width, HEIGHTS.get(len(panels), LOWEST), 0.0, "", ends)
    strip = strip_of(around.strokes, span, width, mark) if around.strokes else 0.0
    first = room._replace(strip=strip, said=text_of(around.said, mark))

    rooms = [first, *[room] * (len(panels) - 1)]

    def planned(ends: tuple[float, float], rooms: Sequence[PanelRoom]) -> list[Plan]:
        each = zip(panels, rooms, strict=True)
        return with_one_legend([plan_of(one, ends, has, mark) for one, has in each])

    if any(panel.scale for panel in panels):
        return plans_to_scale(panels, span, rooms, size, planned)
    plans = planned(span, rooms)
    # In less height a legend may take the place of labels, which takes some height itself.
    for _ in range(2 if size.height else 0):
        assert size.height is not None
        tops = sum(plan.top() for plan in plans)
        height = (size.height - BELOW - tops) / len(panels)
        if height < LEAST_HEIGHT:
            raise ProblemError(
                f"the height is {size.height + above:.6g} mm; these curves need"
                f" {BELOW + tops + LEAST_HEIGHT * len(panels) + above:.6g} mm"
            )
        plans = planned(span, [has._replace(height=height) for has in rooms])
    return plans


def _laid_out(plans: Sequence[Plan], size: Size, above: float) -> tuple[Figure, list[Axes]]:
    """Return the page and its empty panels."""
    top = size.height or BELOW + sum(plan.top() + plan.room.height for plan in plans)
    total = top + above
    # What is to scale may be narrower.
    width = LEFT + plans[0].room.width + RIGHT if any(plan.room.limits for plan in plans) else size.width
    figure = page(total, width)
    axes: list[Axes] = []
    for plan in plans:
        top -= plan.top() + plan.room.height
        box = (LEFT / width, top / total, plan.room.width / width, plan.room.height / total)
        axes.append(figure.add_axes(box, label=f"panel {len(axes) + 1}"))
    return figure, axes


def _draw(axes: Axes, plan: Plan, number: int) -> None:
    drawn = []
    curves = zip(plan.panel.curves, LINES, strict=False)
    looks = [Line(BLACK, DOTS, STRONG * 0.7) if curve.dotted else line for curve, line in curves]
    for count, (course, look) in enumerate(zip(plan.courses, looks, strict=True), 1):
        artist = axes.plot(*course.broken())[0]
        artist.set(color=look.colour, linewidth=look.width, zorder=3, clip_on=False)
        artist.set_linestyle((0, look.dashes) if look.dashes else "-")
        artist.set_gid(f"curve-{number}-{count}")
        drawn.append(artist)
        jumps = course.jumps()
        if len(jumps.angles):
            artist = axes.plot(*jumps, color=look.colour, linewidth=THIN, zorder=3)[0]
            artist.set(clip_on=False, gid=f"jumps-{number}-{count}")
    axes.set(xlim=plan.span, ylim=plan.limits)
    if plan.labels:
        colours = {text: look.colour for text, look in zip(plan.texts, looks, strict=True)}
        for one in plan.labels:
            x, y = one.place / plan.size
            colour = colours[one.text]
            axes.text(x, y, one.text, color=colour, transform=axes.transAxes, ha="center", va="center")
    elif plan.columns:
        above = plan.room.strip + plan.apart * LEGEND_ROW * (1 + plan.heading.count("\n"))
        draw_legend(axes, drawn, plan.texts, plan.columns, above / plan.room.height, "lower right")


def _said(axes: Axes, plan: Plan) -> None:
    """Write what is drawn at the right of the first heading, or above all where that has no room."""
    if plan.room.said:
        above = plan.top() - ABOVE if plan.legend_is_apart else plan.room.strip
        place = (1, 1 + above / plan.room.height)
        axes.annotate(
            plan.room.said, place, xytext=(0, 4), xycoords="axes fraction", textcoords="offset points",
            ha="right", va="baseline",
        )  # fmt: skip


def _value_axis(axes: Axes, plan: Plan, mark: str) -> None:
    low, high = plan.limits
    step = round_step((high - low) * TICK_HEIGHT / plan.room.height)
    ticks = value_ticks(low, high, step, plan.panel.power, mark)
    axes.set_yticks(ticks.places, ticks.texts)
    axes.set_title(
        plan.heading, loc="left", pad=4 + plan.room.strip * MM, fontsize=TEXT_SIZE, linespacing=1.0
    )
    for edge, value in (("bottom", low), ("top", high)):
        if not value:
            axes.spines[edge].set_linewidth(MEDIUM)
    if low < 0 < high:
        axes.axhline(0, color=BLACK, linewidth=MEDIUM, zorder=2)
