"""The flywheel of an engine with its rim: the swing is the engine's, the rest as without one."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, Any

from kurbel.commands.flywheels.figures import figures_of
from kurbel.commands.flywheels.options import Rim
from kurbel.engine.captions import caption, engine_notes
from kurbel.engine.diagram.wheel.page import WheelRequest
from kurbel.engine.diagram.wheel.sizing import Known, Sizing, gathered, sized
from kurbel.engine.quantities import Where, engine_registry, value
from kurbel.errors import ProblemError
from kurbel.exact.product import Product
from kurbel.page.layouts import Layout

if TYPE_CHECKING:
    from kurbel.drive.flywheel import Flywheel
    from kurbel.engine.request import EngineRequest

_TAKEN = ("speed", "radius", *Rim.__annotations__)


def rims_of(
    engine: EngineRequest, given: Mapping[str, Any], page: Layout, sheet: Mapping[str, Any]
) -> WheelRequest:
    """Return what is asked for of one engine. Raises ProblemError for several, and for indicator cards."""
    if engine.carded:
        raise ProblemError(
            "the swing by an indicator card is an estimate, and a rim has certified digits; give what"
            " kurbel flywheel prints of it as --swing"
        )
    engines = len(engine.steams) * len(engine.ratios)
    if engines != 1 or len(engine.methods) > 1:
        raise ProblemError(f"a rim is that of one engine by one method; {engines} engines were given")
    return WheelRequest(
        layout=page,
        wheels=tuple(_sized(engine, one, given) for one in engine.flywheels),
        targets=tuple(one.irregularity for one in engine.flywheels),
        engine=(caption(engine), *engine_notes(engine)),
        columns=given["columns"],
        **sheet,
    )


def _sized(engine: EngineRequest, wheel: Flywheel, given: Mapping[str, Any]) -> Sizing:
    figures = gathered((*figures_of(given, _TAKEN), *_of_engine(engine, wheel)))
    return sized(figures, figures.pop("hoop_stress", None))


def _of_engine(engine: EngineRequest, wheel: Flywheel) -> Iterator[tuple[str, Known]]:
    """Yield the figures that the engine gives, its swing and its power."""
    turn = engine.turn(0, 0, engine.page_columns[0].method)
    where, registry = Where(flywheel=wheel), engine_registry()

    def enclosed(key: str) -> Product:
        return Product.about(lambda kind: value(registry[key], turn, where))

    yield "delta", Known(Product.of(wheel.irregularity), ("--delta",))
    yield "swing", Known(enclosed("swing"), ("the engine",))
    power = enclosed("power") if wheel.power is None else Product.of(wheel.power)
    yield "power", Known(power, ("--power",))
