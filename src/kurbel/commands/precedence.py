"""What gives way to what was typed: defaults from a machine's file and from the environment."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from enum import Enum
from typing import TYPE_CHECKING, Any

from kurbel.commands.loads import NAMES, OWN
from kurbel.commands.options import is_given
from kurbel.commands.subject import SPELLED, spelling
from kurbel.errors import ProblemError
from kurbel.reading.given import as_length, as_ratios
from kurbel.reading.notation import ratio_text

if TYPE_CHECKING:
    from kurbel.commands.subject import Command

# An option, and those that outdo it where they are all typed.
Rivals = Sequence[tuple[str, str]]
_ANGLES: Rivals = (
    *(("angle", other) for other in ("from", "to", "step")),
    *((other, "angle") for other in ("from", "to", "step")),
)
_STEAM: Rivals = (
    *((name, "card") for name in ("eps", "back", "exponent", "clearance", "pressure")),
    ("card", "eps"),
)
_ROD: Rivals = (
    *((name, "rod_file") for name in ("rod_mass", "centre", "gyration", "pendulum", "pendulum_from")),
    *(("rod_file", name) for name in ("centre", "gyration", "pendulum")),
    *(("gyration", name) for name in ("pendulum", "pendulum_from")),
    *((name, "gyration") for name in ("pendulum", "pendulum_from")),
)
_WHEEL: Rivals = (("flywheel", "inertia"), ("inertia", "flywheel"))
# A flywheel is given by its inertia, its mass or its sizes, or is to keep an irregularity.
_SIZES: Rivals = (
    *(("inertia", other) for other in ("mass", "rim_diameter", "disc_diameter", "delta")),
    *((other, "inertia") for other in ("mass", "disc_diameter", "delta")),
    ("speed", "least_speed"),
    ("delta", "least_speed"),
)
RIVALS: Mapping[str, Rivals] = {
    "table": (*_ANGLES, ("mechanism", "layout"), ("layout", "mechanism")),
    # A force that is typed outdoes the steam of a machine.
    "forces": (*_ANGLES, *_STEAM, *_ROD, *((key, "force") for key in OWN)),
    "inertia": (*_ANGLES, *_ROD),
    **dict.fromkeys(("delta", "turning", "plot"), (*_STEAM, *_ROD, *_WHEEL)),
    "flywheel": (*_STEAM, *_ROD, *_SIZES),
    "power": _STEAM,
    "balance": (("engine", "cranks"), *((name, "engine") for name in ("cranks", "positions", "banks"))),
}
_LENGTHS = ("ratio", "stroke", "rod")


class Origin(Enum):
    """Where the value of an option comes from, if it is not the default."""

    TYPED = "typed"
    ENVIRONMENT = "environment"
    MACHINE = "machine"


class Values:
    """The values of a command's options by their names, and where they come from."""

    def __init__(self, values: Mapping[str, Any], origins: Mapping[str, Origin | None]) -> None:
        self.values, self.origins = dict(values), dict(origins)

    def typed(self, name: str) -> bool:
        """Whether an option was typed, or given in Python; a default from elsewhere gives way."""
        return self.origins.get(name) is Origin.TYPED

    def drop(self, name: str) -> None:
        """Make an option one that was not given."""
        value = self.values[name]
        self.values[name] = () if isinstance(value, tuple) else False if value is True else None

    def settle(self, rivals: Rivals) -> None:
        """Drop what is outdone by what was typed."""
        for name, other in rivals:
            if not self.typed(name) and self.typed(other):
                self.drop(name)

    def settle_loads(self) -> None:
        """Drop the loads that one which was typed outdoes, with all that describes them alone."""
        typed = [key for key in OWN if key in self.values and self.typed(key)]
        if not typed or not any(key in self.values and is_given(self.values[key]) for key in NAMES):
            return
        others = [key for key in OWN if key not in typed and is_given(self.values.get(key))]
        for name in {option for key in others for option in (key, *OWN[key][1])}:
            if name in self.values and not self.typed(name):
                self.drop(name)

    def settle_sizes(self, command: Command) -> str:
        """Give the stroke its value by the option that was given, and return the name of that; settle the
        units of the page."""
        if spelling(self.values) != "stroke":
            names = [name for name in ("stroke", *SPELLED[:-1]) if is_given(self.values.get(name))]
            if any(map(self.typed, names)):
                for name in names:
                    if not self.typed(name):
                        self.drop(name)
        if (spelled := spelling(self.values)) != "stroke":
            self.origins["stroke"] = self.origins[spelled]
            if is_given(self.values.get("time_ratio")):
                self.origins["rod"] = self.origins[spelled]
        self.values = dict(command.settled(self.values))
        return spelled

    def settle_unknown(self) -> None:
        """Drop what is asked for as --unknown."""
        name = self.values.get("unknown")
        if name in self.values and not self.typed(name):
            self.drop(name)

    def settle_lengths(self) -> None:
        """Keep two of crank ratio, stroke and length of the rod at the most, for two give the third.

        Raises ProblemError where what is left says two different things.
        """
        if self.typed("ratio") and self.origins["rod"] is Origin.ENVIRONMENT:
            self.drop("rod")
        if not all(is_given(self.values[name]) for name in _LENGTHS):
            return
        if not self.typed("ratio"):
            if not (self.typed("stroke") or self.typed("rod")):
                self._check_agreement()
            self.drop("ratio")
        elif self.typed("stroke") != self.typed("rod"):
            self.drop("rod" if self.typed("stroke") else "stroke")
        elif not self.typed("rod"):
            raise ProblemError(
                "stroke and rod are known and give the ratio; beside --ratio give the stroke or the rod"
                " as well"
            )

    def _check_agreement(self) -> None:
        ratio, stroke, rod = (self.values[name] for name in _LENGTHS)
        share = as_length(stroke, "stroke") / 2 / as_length(rod, "rod")
        if set(as_ratios(ratio)) != {share}:
            raise ProblemError(
                f"stroke {stroke} and rod {rod} give R:L = {ratio_text(share)},"
                f" and the ratio is {';'.join(ratio)}; leave one of the three out"
            )

    def resolved(self, command: Command, rivals: Rivals = ()) -> dict[str, Any]:
        """Return the values by the names of options, settled with one another.

        Raises ProblemError for what was typed in vain.
        """
        self.settle(rivals)
        self.settle_loads()
        self.settle_unknown()
        own = {one.name for one in command.parameters.values()}
        spelled = self.settle_sizes(command)
        values = {name: value for name, value in self.values.items() if name in own}
        command.refuse(values, self.typed, spelled)
        for name in command.foreign(values):
            self.drop(name)
        if own.issuperset(_LENGTHS):
            self.settle_lengths()
        # What may be repeated and was not given is an empty tuple for click.
        defaults = {one.name: one.default for one in command.parameters.values()}
        return {
            name: defaults[name] if value == () else value
            for name, value in self.values.items()
            if name in own
        }

    def arguments(self, command: Command, rivals: Rivals = ()) -> dict[str, Any]:
        """Return the same as the command's function takes them."""
        return command.arguments(self.resolved(command, rivals))
