"""The masses that options describe and the steam that drives them: what makes an engine of a crank drive."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from os import PathLike
from typing import TYPE_CHECKING, Any, NamedTuple

from kurbel.commands.motion import cranks_of, sheet_of
from kurbel.commands.options import is_given
from kurbel.errors import ProblemError
from kurbel.page.layouts import Layout
from kurbel.reading.given import (
    Exact,
    as_crank_angles,
    as_length,
    as_mass,
    as_number,
    as_numbers,
    as_pressure,
    as_share,
    as_share_or_length,
    as_signed_mass,
    as_speed,
)

if TYPE_CHECKING:
    from kurbel.commands.parameters import Given, Names, Path
    from kurbel.drive.crank import Crank
    from kurbel.drive.rod import Rod
    from kurbel.engine.engine import Diagram, Load, Steam
    from kurbel.engine.request import EngineRequest

_UNKNOWN = "that of the rod is not known; add --stroke and one --ratio, or give a share of the rod's length"


class GivenRod(NamedTuple):
    """The connecting rod as it was given."""

    rod_mass: Exact | None = None
    centre: Exact | None = None
    gyration: Exact | None = None
    rod_file: Path | None = None

    @classmethod
    def of(cls, given: Mapping[str, Any]) -> GivenRod:
        return cls(*(given[name] for name in cls._fields))

    def between_pins(self, length: Fraction | None) -> Rod:
        """Return the rod between pins so far apart, in metres, if that is known."""
        from kurbel.drive.rod_given import given_rod

        return given_rod(
            self._share(self.centre, "centre of mass", length),
            self._share(self.gyration, "radius of gyration", length),
            self.rod_file,
            None if self.rod_mass is None else as_mass(self.rod_mass, "rod mass"),
            length,
        )

    @staticmethod
    def _share(value: Exact | None, what: str, length: Fraction | None) -> Fraction | None:
        return None if value is None else as_share_or_length(value, what, length, _UNKNOWN)


class Masses(NamedTuple):
    """The moving masses as they were given."""

    reciprocating: Exact | None = None
    rod: GivenRod = GivenRod()
    rotating: Exact | None = None

    @classmethod
    def of(cls, given: Mapping[str, Any]) -> Masses:
        return cls(given["reciprocating"], GivenRod.of(given), given.get("rotating"))

    @property
    def first(self) -> str:
        """The name of the first option that gives a mass, nothing if none does."""
        given = {"reciprocating": self.reciprocating, **self.rod._asdict(), "rotating": self.rotating}
        return next((name for name, value in given.items() if value is not None), "")

    def on(
        self, cranks: Sequence[Crank], speed: Exact | None, beside: Mapping[str, Any] | None = None
    ) -> list[Crank]:
        """Return the cranks with these masses, and the speed that makes forces of them.

        `beside` names the further options that every mass needs.
        """
        if not self.first:
            return list(cranks)
        self._check(cranks, {"speed": speed, **(beside or {})})
        assert speed is not None
        from kurbel.drive.moving import Moving

        # One rod for all ratios has a length of its own only if there is one ratio.
        length = cranks[0].rod_length if len(cranks) == 1 else None
        moving = Moving(
            Fraction(0) if self.reciprocating is None else as_mass(self.reciprocating, "reciprocating mass"),
            self.rod.between_pins(length) if any(one is not None for one in self.rod) else None,
            Fraction(0) if self.rotating is None else as_signed_mass(self.rotating, "rotating mass"),
        )
        return [replace(crank, speed=as_speed(speed), moving=moving) for crank in cranks]

    def _check(self, cranks: Sequence[Crank], needed: Mapping[str, Any]) -> None:
        missing = [f"--{name}" for name, value in needed.items() if value is None]
        if any(crank.radius is None for crank in cranks):
            missing.insert(0, "--stroke")
        if missing:
            raise ProblemError(
                f"--{self.first.replace('_', '-')} needs {', '.join(missing)} to become a force"
            )


MASSES = ("reciprocating", *GivenRod._fields, "rotating")


def is_heavy(values: Mapping[str, Any]) -> bool:
    """Whether any mass is among the options."""
    return any(values.get(name) is not None for name in MASSES)


def for_masses(*names: str) -> Callable[[Mapping[str, Any]], Mapping[str, str]]:
    """Return what refuses these options where there are no masses."""

    def refusals(values: Mapping[str, Any]) -> Mapping[str, str]:
        if is_heavy(values):
            return {}
        return {
            name: f"--{name} is for moving masses; add --reciprocating or a rod, --rod-mass" for name in names
        }

    return refusals


# What describes the steam, on the command line.
STEAM = ("eps", "back", "exponent", "clearance", "card", "other_side", "single_acting")


class GivenSteam(NamedTuple):
    """The steam as it was given, and what it works on: so many cranks, of a bore."""

    eps: Given | None = None
    back: Exact | None = None
    exponent: Exact | None = None
    clearance: Exact | None = None
    card: Path | Iterable[Path] | None = None
    other_side: Exact | None = None
    single_acting: bool = False
    bore: Exact | None = None
    pressure: Exact | None = None

    @classmethod
    def of(cls, given: Mapping[str, Any]) -> GivenSteam:
        return cls(*(given[name] for name in cls._fields))

    @property
    def carded(self) -> bool:
        return is_given(self.card)

    def cards(self, page: Layout) -> Sequence[Steam | Diagram]:
        """Return the indicator cards, or the ideal ones of all expansion ratios."""
        return self._measured() if self.carded else self._ideal(page)

    def _measured(self) -> Sequence[Diagram]:
        from kurbel.engine.card_file import read_card
        from kurbel.engine.engine import Diagram

        for name in ("eps", "back", "exponent", "clearance"):
            if is_given(getattr(self, name)):
                raise ProblemError(
                    f"--{name} describes an ideal card, and --card gives a measured one; leave one out"
                )
        if self.other_side is not None and not self.single_acting:
            raise ProblemError(
                "--other-side is for --single-acting; double-acting, the other end works as well"
            )
        other = None if self.other_side is None else float(as_pressure(self.other_side, "other side"))
        assert self.card is not None
        files = [self.card] if isinstance(self.card, str | PathLike) else self.card
        return [Diagram(read_card(file), other) for file in files]

    def _ideal(self, page: Layout) -> Sequence[Steam]:
        from kurbel.engine.engine import Steam

        if self.other_side is not None:
            raise ProblemError("--other-side is for --card; of an ideal card --back is the pressure there")
        back = None if self.back is None else as_share(self.back, "back pressure")
        exponent = as_number(1 if self.exponent is None else self.exponent, "exponent")
        clearance = as_share(0 if self.clearance is None else self.clearance, "clearance")
        given = page.expansions if self.eps is None else self.eps
        return [
            Steam(expansion, back, exponent, clearance) for expansion in as_numbers(given, "expansion ratio")
        ]

    @property
    def load(self) -> Load | None:
        """What makes newtons of the steam force, None if it is not known."""
        if self.bore is None and (self.carded or self.pressure is None):
            return None
        missing = [f"--{name}" for name, value in self.needed.items() if value is None]
        if missing:
            raise ProblemError(f"newtons need the bore and the steam pressure; add {missing[0]}")
        from kurbel.engine.engine import Load

        assert self.bore is not None
        pressure = None if self.pressure is None else as_pressure(self.pressure, "pressure")
        return Load(as_length(self.bore, "bore"), pressure)

    @property
    def needed(self) -> dict[str, Exact | None]:
        """What masses need to be weighed against this steam."""
        return {"bore": self.bore} if self.carded else {"bore": self.bore, "pressure": self.pressure}


def engine_question(
    page: Layout,
    steam: GivenSteam,
    masses: Masses,
    drives: Sequence[Crank],
    speed: Exact | None,
    cranks: Given | None,
    methods: Names | None,
    **rest: Any,
) -> EngineRequest:
    """Return what is asked for of the engines of these drives, bearing these masses under this steam.

    `cranks` are the angles by which the cranks of each engine follow the first.
    """
    from kurbel.engine.request import EngineRequest

    several = (methods,) if isinstance(methods, str) else methods or ()
    return EngineRequest(
        layout=page,
        steams=steam.cards(page),
        drives=masses.on(drives, speed, steam.needed),
        double=not steam.single_acting,
        cranks=as_crank_angles("0" if cranks is None else cranks),
        methods=tuple(dict.fromkeys(several)),
        load=steam.load,
        **rest,
    )


def engine_of(page: Layout, given: Mapping[str, Any], **rest: Any) -> EngineRequest:
    """Return the same of the engines that options describe, by their names."""
    steam = GivenSteam.of(given)
    drives = cranks_of(page, given["ratio"], given["stroke"], given["rod"])
    cranks, methods = given.get("cranks"), given["method"]
    return engine_question(
        page, steam, Masses.of(given), drives, given["speed"], cranks, methods, **sheet_of(given), **rest
    )
