"""Flywheels without an engine, by what options say of them."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

from kurbel.commands.diagram.given import fluctuation_of, is_diagram
from kurbel.commands.flywheels.figures import figures_of
from kurbel.commands.flywheels.press import press_of, share_of
from kurbel.commands.options import is_given
from kurbel.drive.flywheel import check_irregularity
from kurbel.engine.diagram.areas import Areas
from kurbel.engine.diagram.fluctuation import Fluctuation
from kurbel.engine.diagram.wheel import captions
from kurbel.engine.diagram.wheel.page import WheelRequest
from kurbel.engine.diagram.wheel.sizing import Known, gathered, sized
from kurbel.errors import ProblemError
from kurbel.exact.kind import floats
from kurbel.exact.product import Product
from kurbel.page.layouts import Layout
from kurbel.reading.given import as_irregularities


def wheels_of(given: Mapping[str, Any], page: Layout, sheet: Mapping[str, Any]) -> WheelRequest:
    """Return what is asked for, one flywheel for each irregularity to keep. Raises KurbelError."""
    if given["area_scale"] is not None and not (is_given(given["areas"]) or is_given(given["triangles"])):
        raise ProblemError("--area-scale is for --areas or --triangles; add these, or leave it out")
    diagram = fluctuation_of(given) if is_diagram(given) else None
    # The turns of a diagram are those of its cycle, which a load may make longer.
    described = {**given, "turns": None} if diagram else given
    of_diagram = _of_diagram(diagram) if diagram else ()
    figures = gathered((*figures_of(described), *press_of(given), *of_diagram))
    share = share_of(given, figures)
    if share is not None:
        swing = Known(share.rest, (share.option,))
        figures = gathered((*figures.items(), ("energy_fluctuation", swing)))
    limit = figures.pop("hoop_stress", None)
    targets = as_irregularities(given["delta"]) if is_given(given["delta"]) else ()
    for target in targets:
        check_irregularity(target)
    wheels = [
        sized(gathered((*figures.items(), ("delta", Known(Product.of(target), ("--delta",))))), limit)
        for target in targets
    ] or [sized(figures, limit)]
    return WheelRequest(
        layout=page,
        wheels=tuple(wheels),
        targets=tuple(targets),
        known_from=_source(given),
        fluctuation=diagram,
        press=(share.working, share.rest) if share else None,
        columns=given["columns"],
        **sheet,
    )


def _of_diagram(diagram: Fluctuation) -> Iterator[tuple[str, Known]]:
    """Yield the figures that a diagram gives."""
    options = ("--areas",) if isinstance(diagram, Areas) else ("the torque",)
    yield "swing", Known(_swing(diagram), options)
    if diagram.turns is not None:
        yield "turns", Known(Product.of(diagram.turns), options)
    mean = diagram.mean_torque(floats())
    # That of a shaft which is driven back has no power of its own to print.
    if mean is not None and mean > 0:
        torque = Product.reduced(diagram.mean_torque)
        # Of a torque with π the work has none.
        yield ("work", Known(Product.about(diagram.work), options)) if torque.pi else (
            "mean_torque", Known(torque, options),
        )  # fmt: skip


def _swing(diagram: Fluctuation) -> Product:
    if isinstance(diagram, Areas):
        scale = diagram.scale
        return Product.of((max(diagram.levels) - min(diagram.levels)) * scale.energy, int(scale.of_pi))
    return Product.reduced(diagram.swing)


def _source(given: Mapping[str, Any]) -> str:
    """Return what the swing is known from, for the caption."""
    sources = {
        captions.AREAS: given["areas"],
        captions.TORQUE: is_diagram(given),
        captions.SWING: given["swing"],
        captions.PRESS: given["share"] if given["duration"] is None else given["duration"],
        captions.FLUCTUATION: given["energy_fluctuation"],
    }
    return next((source for source, value in sources.items() if is_given(value)), "")
