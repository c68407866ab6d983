"""A flywheel by what is given of it: all figures that follow, what is taken beside it, what is missing."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import NamedTuple

from kurbel.engine.diagram.relations import DISC_RULES, LAWS, OF_DISC, RULES, SHOWN, figures_of, registry
from kurbel.errors import ProblemError
from kurbel.exact.numerals import number_text
from kurbel.exact.real import Product, Term
from kurbel.reading.notation import about

# What is taken where it is not given; pages say so.
ONE_TURN, RIM_ALONE, LIMIT = "one turn", "rim alone", "limit"
_OF_RIM = (
    *("rim_diameter", "rim_speed", "section", "breadth", "thickness", "proportion"),
    *("breadth_share", "thickness_share"),
)
# Shares of the diameter, and what they find.
_SHARES = {"breadth_share": "breadth", "thickness_share": "thickness", "disc_share": "disc_thickness"}
_RUN_UP = {"run_up_torque", "run_up_time", "run_up_turns"}
SWING_MISSING = "the swing needs --swing, --areas, --torque, --energy-fluctuation or an engine, --eps"
# An exact value that is longer is told to five figures.
LONGEST_TOLD = 10
_HALF = Fraction(1, 2)
# Figures beyond these do not fit a page.
LEAST, MOST = 1e-15, 1e15
# What answers no question by itself.
_ASIDE = {"mean_torque", "work", "cycles", "omega", "omega_max", "omega_min", "turns"}


class Known(NamedTuple):
    """A figure, and the options that give it."""

    value: Product
    options: tuple[str, ...]


Figures = Mapping[str, Known]


@dataclass(frozen=True, eq=False)
class SizedFlywheel:
    """A flywheel with all its figures that are known, and what was taken without being given."""

    figures: Figures
    taken: tuple[str, ...] = ()

    def knows(self, key: str) -> bool:
        """Whether a quantity is known."""
        return SHOWN[key].figure in self.figures


def sized(given: Figures, limit: Known | None = None) -> SizedFlywheel:
    """Return the flywheel of what is given, with the hoop stress to which its rim is limited if it is.

    Raises ProblemError where that contradicts itself or says too little.
    """
    figures, taken = completed(given), []
    if limit is not None:
        if "rim_speed" not in figures:
            figures = completed({**figures, "hoop_stress": limit})
            taken.append(LIMIT)
        _check_limit(figures, limit)
    assumed = {
        # First what the swing needs, of which a rim is made.
        ONE_TURN: ("turns", "energy_fluctuation" in figures and "swing" not in figures),
        RIM_ALONE: ("rim_share", any(name in given for name in _OF_RIM) or limit is not None),
    }
    for name, (figure, applies) in assumed.items():
        if applies and figure not in figures:
            more = completed({**figures, figure: Known(Product.of(1), ())})
            if len(more) > len(figures) + 1:
                figures = more
                taken.append(name)
    _check_turns(given, figures)
    if "proportion" in given and "breadth" not in figures:
        raise ProblemError(
            "--rim-section is the ratio of breadth to thickness of a rim whose section is not known; add"
            " --rim-diameter and --density, or leave it out"
        )
    for share, of in _SHARES.items():
        if share in given and of not in figures:
            raise ProblemError(
                f"{given[share].options[0]} is a share of a diameter that does not follow from what is given;"
                " add more, such as --density, or leave it out"
            )
    _check_rim(figures)
    _check_answered(given, figures)
    return SizedFlywheel(figures, tuple(taken))


def gathered(pairs: Iterable[tuple[str, Known]]) -> dict[str, Known]:
    """Return figures by their names. Raises ProblemError where one has two values."""
    found: dict[str, Known] = {}
    for figure, known in pairs:
        before = found.setdefault(figure, known)
        if not before.value.equals(known.value):
            raise ProblemError(_contradiction(figure, before, known))
    return found


def completed(given: Figures) -> dict[str, Known]:
    """Return what is given with all that follows. Raises ProblemError where it contradicts itself."""
    known = dict(given)
    disc = any(name.startswith("disc") for name in given)
    waiting = [*RULES, *(DISC_RULES if disc else ())]
    while ready := [rule for rule in waiting if known.keys() >= {*rule.needs}]:
        for rule in ready:
            waiting.remove(rule)
            value = rule.value({name: known[name].value for name in rule.needs})
            options = tuple(dict.fromkeys(one for name in rule.needs for one in known[name].options))
            found = Known(value, options)
            before = known.setdefault(rule.of, found)
            if before is not found and not before.value.equals(value):
                raise ProblemError(_contradiction(rule.of, before, found))
        if not any(known.keys() >= {*rule.needs} for rule in waiting):
            known |= _eliminated(known, [*LAWS, *(OF_DISC if disc else ())])
    return known


def told_by(figures: Figures, figure: str, of: str) -> bool:
    """Whether a figure would tell another."""
    if figure in figures:
        return False
    try:
        return of in completed({**figures, figure: Known(Product.of(1), ())})
    except ProblemError:
        return False


def _eliminated(known: Mapping[str, Known], laws: Sequence[Term]) -> dict[str, Known]:
    """Return the figures that follow from several laws together: each says one of its figures by others."""
    rows = []
    for law in laws:
        options = {one for name in law.powers if name in known for one in known[name].options}
        for name in law.powers.keys() & known.keys():
            law = law.put(name, Term(known[name].value))
        rows.append((law, options))
    found: dict[str, Known] = {}
    told: list[tuple[str, Term, set[str]]] = []
    while rows := [row for row in rows if row[0].powers]:
        row = min(rows, key=lambda one: len(one[0].powers))
        name = next(iter(row[0].powers))
        value = row[0].solved_for(name)
        told.append((name, value, row[1]))
        rows = [
            (law.put(name, value), options | row[1] if name in law.powers else options)
            for law, options in rows
            if law is not row[0]
        ]
    for name, value, options in reversed(told):
        for other in value.powers.keys() & found.keys():
            value, options = value.put(other, Term(found[other].value)), options | {*found[other].options}
        if not value.powers:
            found[name] = Known(value.known, tuple(sorted(options)))
    return found


def _contradiction(figure: str, before: Known, found: Known) -> str:
    key, shown = next(((key, one) for key, one in SHOWN.items() if one.figure == figure), ("", None))
    values = [shown.of(one.value) if shown else one.value for one in (before, found)]
    one, other = _apart(*values)
    name, unit = (registry()[key].name["en"], registry()[key].plain_unit("en")) if key else (figure, "")
    first, second = (_gives(known.options) for known in (before, found))
    said = f"{first} the {name[:1].lower()}{name[1:]} {one} {unit}".rstrip()
    return f"{said}, and {second} {other} {unit}".rstrip() + "; leave one of them out"


def _gives(options: tuple[str, ...]) -> str:
    *others, last = options
    return f"{', '.join(others)} and {last} give" if others else f"{last} gives"


def _apart(*values: Product) -> list[str]:
    """Return numbers for a sentence with as many figures as tell them apart."""
    texts = [_figures(one) for one in values]
    for decimals in range(3, 40, 3):
        if len({*texts}) == len(texts):
            break
        texts = [number_text(one.number(decimals, "half-away")) for one in values]
    return texts


def _figures(value: Product) -> str:
    exact = None if value.rational is None else about(value.rational)
    return figures_of(value) if exact is None or len(exact) > LONGEST_TOLD else exact


def _check_limit(figures: Figures, limit: Known) -> None:
    """Raise ProblemError where the rim is stressed more than is allowed, or that cannot be told."""
    if "density" not in figures:
        raise ProblemError("the hoop stress needs the density of the rim; add --density, such as 7200kg/m3")
    stress = figures.get("hoop_stress")
    if stress is None or stress.value.exceeds(limit.value):
        known, allowed = (SHOWN["hoop_stress"].of(one.value) for one in (stress or limit, limit))
        raise ProblemError(
            f"the hoop stress of the rim is {figures_of(known)} MPa, above the {figures_of(allowed)} MPa that"
            " --hoop-stress allows; give a smaller --rim-diameter, or leave it out to have it found"
        )


def _check_turns(given: Figures, figures: Figures) -> None:
    """Raise ProblemError where all else is given, and a cycle would take neither whole nor half turns."""
    turns = figures.get("turns")
    if turns is None or not turns.options or {"turns", "work", "cycles", "mean_torque"} & given.keys():
        return
    if turns.value.rational is None or turns.value.rational % _HALF:
        completed({**given, "turns": Known(Product.of(1), ())})


def _check_rim(figures: Figures) -> None:
    """Raise ProblemError where the rim has more than the whole flywheel, or would reach beyond its middle."""
    if {"thickness", "rim_diameter"} <= figures.keys():
        thickness, diameter = (figures[name].value for name in ("thickness", "rim_diameter"))
        if thickness.exceeds(diameter):
            raise ProblemError(
                f"the rim is {figures_of(thickness)} m thick at a mean diameter of {figures_of(diameter)} m,"
                " and would reach beyond its middle; give a thinner rim, or a disc, --disc-thickness"
            )
    share = figures.get("rim_share")
    if share is not None and share.value.exceeds(Product.of(1)):
        rim, whole = (figures_of(figures[name].value) for name in ("rim_inertia", "inertia"))
        raise ProblemError(
            f"the rim has the moment of inertia {rim} kg m², more than the whole flywheel with {whole} kg m²;"
            " give a smaller rim"
        )


def _check_answered(given: Figures, figures: Figures) -> None:
    """Raise ProblemError where what is given finds nothing, with the option that is missing."""
    for key, shown in SHOWN.items():
        if shown.figure in figures and not LEAST <= (value := float(figures[shown.figure].value)) <= MOST:
            name = registry()[key].name["en"]
            raise ProblemError(f"{name} is {value:.4g} in units of the SI; it must lie within 1e-15 and 1e15")
    unknown = {"swing", "inertia", "omega", "delta"} - figures.keys()
    found = figures.keys() - given.keys() - _ASIDE
    swing_alone = "swing" in given and {"inertia", "delta"} <= unknown
    if found and {"run_up_torque", "run_up_time"} <= figures.keys():
        return
    if "rim_mass" in found and unknown <= {"inertia", "omega"}:
        return
    if not unknown or ("delta" in unknown and {"swing", "inertia"} & unknown and found and not swing_alone):
        return
    raise ProblemError(_missing(unknown, given, figures))


def _missing(unknown: set[str], given: Figures, figures: Figures) -> str:
    """Return the sentence that names the option that is missing."""
    if _RUN_UP & given.keys() and "run_up_torque" not in figures.keys() - given.keys():
        return (
            "running up follows from three of --run-up-torque, --run-up-time, --run-up-turns, --speed and"
            " --inertia, or --mass and --radius for that; add one"
        )
    if "swing" in unknown and "energy_fluctuation" in figures:
        return (
            "the coefficient of fluctuation of energy is a share of the work of a cycle; add --work, or"
            " --power and --speed"
        )
    if "swing" in unknown and {"work", "cycles"} & given.keys():
        return (
            "the swing is a share of the work of a cycle; add that of a press, --share or --duration, or"
            " --energy-fluctuation"
        )
    if "swing" in unknown and unknown != {"swing", "omega"}:
        return SWING_MISSING
    if {"omega", "delta"} <= unknown and "rim_speed" in figures:
        return (
            "the flywheel needs --delta, to find the mass of its rim by the speed of that, or --rim-speed"
            " 26..28m/s, from the least to the greatest"
        )
    if "omega" in unknown:
        return "the flywheel needs the speed; add --speed, for example --speed 120/min"
    return (
        "the flywheel needs --delta, to find its moment of inertia, or --inertia or --mass and --radius, to"
        " find δ"
    )
