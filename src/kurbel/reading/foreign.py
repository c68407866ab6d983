"""Options and commands as books and other programs call them, and how they are written here.

Loaded where there is no option or command of a name. An option that kurbel has stands here, too, where it is
taken for another, as --cut-off of steam.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Collection
from fractions import Fraction
from typing import NamedTuple

from kurbel.errors import KurbelError
from kurbel.exact.numerals import exact_text
from kurbel.reading.notation import in_shell

_BARE = re.compile(r"[+−-]?[\d.,]+(?:\s*/\s*[\d.,]+)?")
_LONGEST = 60


def _with(unit: str) -> Callable[[str], str]:
    """Return what gives a bare number this unit."""
    return lambda value: f"{value}{unit}" if _BARE.fullmatch(value) else value


def _same(value: str) -> str:
    return value


def _expansion(value: str) -> str:
    """Return ε of the share of the stroke before the cut-off; nothing for what is no such share."""
    share = cut_off(value)
    return exact_text(1 / share) if share else ""


def _always(value: str) -> Callable[[str], str]:
    return lambda _: value


class Ours(NamedTuple):
    """An option of ours, an example of its value, what becomes of a value that was typed, and what others
    call the option; of those with equal words the first counts that the command has and that fits."""

    option: str
    example: str
    read: Callable[[str], str]
    words: str


OPTIONS = (
    Ours("speed", "120rpm", _with("rpm"), "rpm n rev revs revolutions turns drehzahl rotational_speed"),
    Ours("speed", "12.5rad/s", _with("rad/s"), "omega angular_velocity angular_speed"),
    Ours("speed", "2Hz", _with("Hz"), "hz frequency"),
    Ours("eps", "4", _expansion, "cutoff cut_off admission fullung fill filling"),
    Ours("cut-off", "2", _same, "cutoff"),
    Ours("eps", "4", _same, "epsilon expansion expansion_ratio"),
    Ours("compression", "6", _same, "cr compression_ratio"),
    Ours("delta", "1:100", _same, "cs coefficient_of_fluctuation irregularity ungleichformigkeit"),
    Ours("ratio", "1:5", _same, "lambda lam crank_ratio rl r_l l_r"),
    Ours("stroke", "600mm", _with("mm"), "hub stroke_length s"),
    Ours("crank", "300mm", _with("mm"), "crank_radius crank_length throw radius kurbelradius"),
    Ours("rod", "1500mm", _with("mm"), "rod_length conrod connecting_rod length l stange"),
    Ours("bore", "300mm", _with("mm"), "diameter piston_diameter cylinder_diameter piston bohrung d"),
    Ours("offset", "0.2", _same, "eccentricity excentricity desaxe schrankung e"),
    Ours("angle", "30", _same, "theta phi crank_angle angles degrees deg winkel alpha"),
    Ours("angles", "0;90", _same, "angle theta phi"),
    Ours("step", "10", _same, "increment stepsize step_size interval dphi schritt"),
    Ours("from", "0", _same, "start begin first von"),
    Ours("to", "180", _same, "end stop until last bis"),
    Ours("force", "10kN", _with("kN"), "piston_force load kraft kolbenkraft"),
    Ours("pressure", "8bar", _with("bar"), "steam_pressure inlet_pressure boiler_pressure p dampfdruck"),
    Ours("back", "0.1", _same, "back_pressure condenser gegendruck"),
    Ours("mean-pressure", "3bar", _with("bar"), "mep imep pm pmi mean_effective_pressure"),
    Ours("exponent", "1.3", _same, "gamma kappa polytropic polytropic_exponent"),
    Ours("power", "50kW", _with("kW"), "kw leistung"),
    Ours("power", "68PS", _with("PS"), "ps"),
    Ours("power", "68hp", _with("hp"), "hp horsepower"),
    Ours("reciprocating", "200kg", _with("kg"), "piston_mass reciprocating_mass recip crosshead_mass"),
    Ours("revolving", "200kg", _with("kg"), "rotating revolving_mass"),
    Ours("swing", "5kJ", _with("kJ"), "energy fluctuation_of_energy excess_energy"),
    Ours("mechanism", "arc", _always("arc"), "four_bar fourbar four_bar_linkage"),
    Ours("quantity", "x", _same, "quantities column"),
    Ours("columns", "phi,x,c,p", _same, "cols column fields quantity quantities show"),
    Ours("where", "p=0", _same, "condition when find solve"),
    Ours("cranks", "0;90", _same, "crank_angles"),
    Ours("engine", "inline-4", _same, "type cylinders arrangement"),
    Ours("digits", "5", _same, "decimals precision places decimal_places prec stellen"),
    Ours("method", "series", _same, "approximation formula formulas"),
    Ours("caption", "Weg", _same, "title heading"),
    Ours("output", "page.html", _same, "out outfile file save"),
    Ours("machine", "engine.toml", _same, "config toml machine_file"),
    Ours("units", "imperial", _always("imperial"), "imperial inches inch us"),
    Ours("units", "metric", _always("metric"), "metric si"),
    Ours("units", "imperial", _same, "unit"),
    Ours("lang", "en", _always("en"), "english en englisch"),
    Ours("lang", "de", _always("de"), "german de deutsch"),
    Ours("lang", "en", _same, "language locale sprache"),
    *(
        Ours("format", name, _always(name), words)
        for name, words in {
            "latex": "latex tex", "html": "html htm", "markdown": "markdown md", "typst": "typst",
            "pdf": "pdf", "csv": "csv", "json": "json", "xlsx": "xlsx", "text": "txt", "ods": "ods",
        }.items()
    ),
    Ours("layout", "verfahren", _same, "style page"),
)  # fmt: skip

COMMANDS = {
    "table": "motion kinematics position velocity acceleration path piston kolbenweg weg",
    "forces": "kinetics dynamics kraefte krafte",
    "turning": "torque moment crank_effort turning_moment drehmoment drehkraft tangential",
    "delta": "irregularity fluctuation ungleichformigkeit cs",
    "flywheel": "wheel schwungrad",
    "deadcentres": "dead_centers deadcenters dead_centers dead_centres totpunkte",
    "balance": "balancing massenausgleich",
    "firing": "firing_order zundfolge",
    "harmonics": "fourier spectrum",
    "power": "mep",
    "plot": "draw drawing chart graph zeichne",
    "handbook": "appendix book build",
    "collate": "compare check",
    "example": "examples problem problems",
    "sources": "books",
}


def ours(name: str, value: str, options: Collection[str]) -> tuple[str, str]:
    """Return the option of ours that is meant, among these, and its value as it is written here, both empty
    where none is known; a value that is not given is an example."""
    asked = _spelled(name)
    for one in OPTIONS:
        if asked in one.words.split() and one.option in options and asked != _spelled(one.option):
            written = one.read(value.strip()) if value else one.example
            if written:
                return one.option, written
    return "", ""


def line(name: str, value: str, options: Collection[str]) -> str:
    """Return the same as it is typed, nothing where no option is known."""
    option, written = ours(name, value, options)
    shown = written if len(written) <= _LONGEST else "VALUE"
    return f"--{option} {in_shell(shown)}" if option else ""


def command(name: str) -> str:
    """Return the command of ours that is meant, nothing if none is known."""
    asked = _spelled(name)
    return next((one for one, words in COMMANDS.items() if asked in words.split()), "")


def cut_off(value: str) -> Fraction | None:
    """Return the share of the stroke before a cut-off, None for what is none."""
    from kurbel.reading.shares import share

    try:
        found = share(value)
    except KurbelError:
        return None
    return found if 0 < found < 1 else None


def _spelled(name: str) -> str:
    from kurbel.reading.names import spelled

    return spelled(name.lstrip("-"))
