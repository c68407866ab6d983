"""Options, commands, ranges and lists as books and other programs write them, and how they are written here.

Loaded where there is no option or command of a name, and where a text is no number and no range, or has a
comma. An option that kurbel has stands here, too, where it is taken for another, as --cut-off of steam.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Collection, Sequence
from fractions import Fraction
from typing import NamedTuple

from kurbel.errors import KurbelError, NotationError
from kurbel.exact.numerals import exact_text
from kurbel.reading.names import spelled
from kurbel.reading.notation import angle, clipped, in_shell, quoted, share

_BARE = re.compile(r"[+−-]?[\d.,]+(?:\s*/\s*[\d.,]+)?")
_LONGEST = 60
# A number, or an angle with its marks.
_NUMBER = r"\d+(?:[.,]\d+)?"
_ONE = rf"[+−-]?{_NUMBER}(?:/{_NUMBER})?(?:\s*(?:°|deg\b)(?:\s*{_NUMBER}\s*['′’])?)?"
_TO = r"\s*(?:\.{2,}|…|[-–—]|\b(?:to|bis|until|through)\b)\s*"
_BY = r"\s*(?:\.{2,}|…|:|,|;|\b(?:by|in steps of|steps? of|step|in Schritten von|Schritt|alle)\b)\s*"
_FROM_TO = re.compile(rf"({_ONE}){_TO}({_ONE})(?:{_BY}({_ONE}))?", re.IGNORECASE)
_COLONS = re.compile(rf"({_ONE})\s*:\s*({_ONE})(?:\s*:\s*({_ONE}))?")
_MEMBER = rf"(?:1[:/])?{_ONE}"
_LIST = re.compile(rf"{_MEMBER}(?:(?:\s+|\s*\|\s*){_MEMBER})+|{_MEMBER}(?:\s*[-–—]\s*{_MEMBER}){{2,}}")
_TWO = re.compile(rf"{_ONE}\s*[-–—]\s*{_ONE}")
_BETWEEN = re.compile(r"\s*[-–—|]\s*|\s+")
_CALL = re.compile(r"(?:\w+\.)?(linspace|arange|range)\s*\(([^()]*)\)")
_IN_BRACKETS = re.compile(r"[\[({]\s*(.*?)\s*[\])}]")
# Of a ratio the second part ranges; 1: may stand before its end, too.
_RATIO = re.compile(r"(1\s*[:/])\s*(.*)")
_AGAIN = re.compile(r"((?:\.{2,}|…|[-–—]|\bto\b|\bbis\b)\s*)1\s*[:/]\s*")
_LONGEST_RANGE = 120
_WHOLE = re.compile(r"[+-]?\d+", re.ASCII)


def _with(unit: str) -> Callable[[str], str]:
    """Return what gives a bare number this unit."""
    return lambda value: f"{value}{unit}" if _BARE.fullmatch(value) else value


def _of(way: str) -> Callable[[str], str]:
    """Return what writes a length as a stroke in this way."""
    return lambda value: f"{way}:{_with('mm')(value.removeprefix(f'{way}:'))}"


def _same(value: str) -> str:
    return value


def _expansion(value: str) -> str:
    """Return ε of the share of the stroke before the cut-off; nothing for what is no such share."""
    share = cut_off(value)
    return exact_text(1 / share) if share else ""


def _always(value: str) -> Callable[[str], str]:
    return lambda _: value


class Alias(NamedTuple):
    """An option of ours, an example of its value, what becomes of a value that was typed, and what others
    call the option; of those with equal words the first counts that the command has and that fits."""

    option: str
    example: str
    read: Callable[[str], str]
    words: str


OPTIONS = (
    Alias("speed", "120rpm", _with("rpm"), "rpm n rev revs revolutions turns drehzahl rotational_speed"),
    Alias("speed", "12.5rad/s", _with("rad/s"), "omega angular_velocity angular_speed"),
    Alias("speed", "2Hz", _with("Hz"), "hz frequency"),
    Alias("eps", "4", _expansion, "cutoff cut_off admission fullung fill filling"),
    Alias("cut-off", "2", _same, "cutoff"),
    Alias("eps", "4", _same, "epsilon expansion expansion_ratio"),
    Alias("compression", "6", _same, "cr compression_ratio"),
    Alias("delta", "1:100", _same, "cs coefficient_of_fluctuation irregularity ungleichformigkeit"),
    Alias("ratio", "1:5", _same, "lambda lam crank_ratio rl r_l l_r"),
    Alias("stroke", "600mm", _with("mm"), "hub stroke_length s"),
    Alias("stroke", "crank:300mm", _of("crank"), "crank crank_radius crank_length throw radius kurbelradius"),
    Alias("stroke", "true:600mm", _of("true"), "true_stroke"),
    Alias("rod", "1500mm", _with("mm"), "rod_length conrod connecting_rod length l stange"),
    Alias("bore", "300mm", _with("mm"), "diameter piston_diameter cylinder_diameter piston bohrung d"),
    Alias("offset", "0.2", _same, "eccentricity excentricity desaxe schrankung e"),
    Alias("angle", "30", _same, "theta phi crank_angle angles degrees deg winkel alpha"),
    Alias("angles", "0;90", _same, "angle theta phi"),
    Alias("step", "10", _same, "increment stepsize step_size interval dphi schritt"),
    Alias("from", "0", _same, "start begin first von"),
    Alias("to", "180", _same, "end stop until last bis"),
    Alias("force", "10kN", _with("kN"), "piston_force load kraft kolbenkraft"),
    Alias("pressure", "8bar", _with("bar"), "steam_pressure inlet_pressure boiler_pressure p dampfdruck"),
    Alias("head-pressure", "0.3bar", _with("bar"), "cover_pressure gas_pressure"),
    Alias("crank-pressure", "0.3bar", _with("bar"), "crank_side_pressure under_pressure back_side_pressure"),
    Alias("pressure-difference", "2bar", _with("bar"), "differential_pressure net_pressure delta_p"),
    Alias("back", "0.1", _same, "back_pressure condenser gegendruck"),
    Alias("mean-pressure", "3bar", _with("bar"), "mep imep pm pmi mean_effective_pressure"),
    Alias("exponent", "1.3", _same, "gamma kappa polytropic polytropic_exponent"),
    Alias("power", "50kW", _with("kW"), "kw leistung"),
    Alias("power", "68PS", _with("PS"), "ps"),
    Alias("power", "68hp", _with("hp"), "hp horsepower"),
    Alias("reciprocating", "200kg", _with("kg"), "piston_mass reciprocating_mass recip crosshead_mass"),
    Alias("revolving", "200kg", _with("kg"), "rotating revolving_mass"),
    Alias("balance-radius", "300mm", _with("mm"), "balance_radii counterweight_radius"),
    Alias("balance-radii", "300mm", _with("mm"), "balance_radius"),
    Alias("rod-mass", "150kg", _with("kg"), "conrod_mass connecting_rod_mass mass_of_rod"),
    Alias("radius", "1m", _with("m"), "radius_of_gyration k"),
    Alias("gyration", "300mm", _with("mm"), "radius_of_gyration k"),
    Alias("centre", "300mm", _with("mm"), "cg center centre_of_mass centre_of_gravity"),
    Alias("swing", "5kJ", _with("kJ"), "energy fluctuation_of_energy excess_energy"),
    Alias("mechanism", "arc", _always("arc"), "four_bar fourbar four_bar_linkage"),
    Alias("slope", "90°", _always("90°"), "vertical upright"),
    Alias("specific-volume", "0.24m3/kg", _with("kg/m3"), "steam_density"),
    Alias("quantity", "x", _same, "quantities column"),
    Alias("columns", "phi,x,c,p", _same, "cols column fields quantity quantities show"),
    Alias("where", "p=0", _same, "condition when find solve"),
    Alias("cranks", "0;90", _same, "crank_angles"),
    Alias("engine", "inline-4", _same, "type cylinders arrangement"),
    Alias("digits", "5", _same, "decimals precision places decimal_places prec stellen"),
    Alias("method", "series", _same, "approximation formula formulas"),
    Alias("caption", "Weg", _same, "title heading"),
    Alias("output", "page.html", _same, "out outfile file save"),
    Alias("machine", "engine.toml", _same, "config toml machine_file"),
    Alias("units", "imperial", _always("imperial"), "imperial inches inch us"),
    Alias("units", "metric", _always("metric"), "metric si"),
    Alias("units", "imperial", _same, "unit"),
    Alias("lang", "en", _always("en"), "english en englisch"),
    Alias("lang", "de", _always("de"), "german de deutsch"),
    Alias("lang", "en", _same, "language locale sprache"),
    *(
        Alias("format", name, _always(name), words)
        for name, words in {
            "latex": "latex tex", "html": "html htm", "markdown": "markdown md", "typst": "typst",
            "pdf": "pdf", "csv": "csv", "json": "json", "xlsx": "xlsx", "text": "txt", "ods": "ods",
        }.items()
    ),
    Alias("layout", "verfahren", _same, "style page"),
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
    asked = spelled(name.lstrip("-"))
    for one in OPTIONS:
        if asked in one.words.split() and one.option in options and asked != spelled(one.option):
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
    asked = spelled(name.lstrip("-"))
    return next((one for one, words in COMMANDS.items() if asked in words.split()), "")


def cut_off(value: str) -> Fraction | None:
    """Return the share of the stroke before a cut-off, None for what is none."""
    try:
        found = share(value)
    except KurbelError:
        return None
    return found if 0 < found < 1 else None


def respelled(text: str, ratios: bool = False, lists: bool = False) -> str:
    """Return a range or list of another spelling in kurbel's, nothing for a text that is neither.

    Two numbers with a dash are a range, or one of the `lists`.
    """
    text = text.strip()
    if len(text) > _LONGEST_RANGE:
        return ""
    if called := _CALL.fullmatch(text):
        return _of_call(called[1], [part.strip() for part in called[2].split(",")])
    bracketed = _IN_BRACKETS.fullmatch(text)
    inner = bracketed[1] if bracketed else text
    if lists and _TWO.fullmatch(inner):
        return ";".join(_BETWEEN.split(inner))
    if ratios and (start := _RATIO.fullmatch(inner)):
        found = _range(_AGAIN.sub(r"\1", start[2]), colons=False)
        found = f"{start[1]}{found}" if found else ""
    else:
        found = _range(inner, colons=not ratios)
    if not found and _LIST.fullmatch(inner):
        return ";".join(_BETWEEN.split(inner))
    if not found and bracketed and re.search("[,;]", inner):
        return ";".join(part.strip() for part in re.split("[,;]", inner))
    return found


def check_commas(text: str, read: Callable[[str], Fraction], what: str) -> None:
    """Raise NotationError if commas could part a list: 2,3 or 1:4,1:5; in 1:4,5 they cannot."""
    parts = [part.strip() for part in text.split(",")]
    if len(parts) == 1 or not all(_is_read(part, read) for part in parts):
        return
    listed = in_shell(clipped(";".join(parts)))
    if not _is_read(text, read):
        raise NotationError(
            f"{what} {quoted(text)} has commas between its values; write the list as {listed}"
        )
    if all(_WHOLE.fullmatch(part) for part in parts):
        decimal = ".".join(parts)
        raise NotationError(
            f"{what} {quoted(text)} can be read as the number {decimal} or the list {listed};"
            f" write {decimal} or {listed}"
        )


def _is_read(text: str, read: Callable[[str], Fraction]) -> bool:
    try:
        read(text)
    except NotationError:
        return False
    return True


def _range(text: str, colons: bool) -> str:
    match = _FROM_TO.fullmatch(text)
    if match is None and colons and (match := _COLONS.fullmatch(text)):
        first, middle, last = match.groups()
        if last is None:
            # 3:1 is a ratio.
            return f"{first}..{middle}" if _steps("0", first, middle) else ""
        return _written(first, last, middle) if _steps(first, middle, last) else _written(first, middle, last)
    return _written(*match.groups()) if match else ""


def _written(first: str, last: str, step: str | None) -> str:
    if step is None and "/" in last and "/" not in first:
        # The step of 0-180/10.
        last, step = last.split("/")
    found = f"{first.strip()}..{last.strip()}"
    return f"{found}:{step.strip()}" if step else found


def _steps(first: str, step: str, last: str) -> bool:
    """Whether the middle of three numbers is the step: 0:10:180, but not 0:180:10."""
    try:
        return angle(step) <= angle(last) - angle(first)
    except NotationError:
        return True


def _of_call(name: str, parts: Sequence[str]) -> str:
    """Return the range of linspace(first, last, count), or of arange(first, beyond, step)."""
    try:
        numbers = [Fraction(part) for part in parts]
        if name == "linspace" and len(numbers) == 3:
            first, last, count = numbers
            return _written(parts[0], parts[1], exact_text((last - first) / (count - 1)))
        if name != "linspace" and len(numbers) in (2, 3):
            first, beyond = numbers[:2]
            step = numbers[2] if len(numbers) == 3 else Fraction(1)
            whole = first + step * (-(-(beyond - first) // step) - 1)
            return _written(parts[0], exact_text(whole), exact_text(step))
    except (ValueError, ZeroDivisionError):
        return ""
    return ""
