"""Words searched in all that kurbel says of itself, from commands to pages, and in problems of textbooks."""

from __future__ import annotations

import inspect
import re
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from functools import cache
from pathlib import Path
from typing import NamedTuple

import click

from kurbel.books.constructions.construction_page import construction, construction_names
from kurbel.cli import COMMANDS
from kurbel.cli.app import command_of
from kurbel.cli.listing import printing
from kurbel.cli.manual.command import TopicCommand
from kurbel.cli.manual.help import GAP, folded
from kurbel.cli.manual.topics import flag_of, options_of, topics_of, wants
from kurbel.errors import ChoiceError, OutputError
from kurbel.handbook.problems import Problem, problems_of
from kurbel.page.layouts import SUBJECTS, layout, layout_names
from kurbel.page.subject import subject
from kurbel.reading.names import did_you_mean

# What others call it, and what is searched for then.
_SYNONYMS = """
    mep, imep: mean pressure
    bmep: mean pressure, brake power
    rpm, revolutions: speed
    hp, horsepower: power
    four bar, fourbar, 4 bar: rocker, pivot
    crank rocker: rocker
    slider crank: motion of a piston, crank drive, piston path, crank ratio
    quick return: time ratio, offset crank
    desaxe: offset crank
    coefficient of fluctuation of energy, fluctuation of energy: energy fluctuation, energy swing
    coefficient of fluctuation: irregularity, energy fluctuation
    cyclic irregularity, speed fluctuation: irregularity
    cut off, cutoff: expansion ratio, cut off
    turning moment: turning effort, torque, turning moment
    crank effort: turning effort, tangential force
    side thrust, slide bars, slide bar, cylinder wall: guide force
    gudgeon pin, wrist pin, piston pin: crosshead pin
    bearing load: bearing force, crank pin force
    main bearing: bearing force
    shaking force: free force, balance of an engine
    shaking moment: free moment, balance of an engine
    dynamic balance, dynamic balancing: two planes, balance planes
    overbalance: counterweights
    tractive effort: tractive force
    throw: crank radius, crank
    coupler curve, coupler point: paths of points, point of the rod
    velocity diagram, velocity polygon: plan of velocities
    acceleration diagram, acceleration polygon: plan of accelerations
    connecting rod, conrod: rod
    obliquity: rod angle
    displacement: piston path
    dead center, tdc, bdc: dead centre
    fourier: harmonics
    primary, secondary: orders, balance
    punch, punching: press, shear
    punching press: press
    stamping: punch
    shearing machine: punch, shear
    rolling mill: load torque
    free air: delivery
    brake horsepower, bhp: brake power
    ihp: indicated power
    indicator diagram, p v diagram: indicator card
    inches: imperial
    excel: excel, xlsx
    tex: latex
"""
SYNONYMS: Mapping[str, Sequence[str]] = {
    name: ours.split(", ")
    for others, _, ours in (line.partition(": ") for line in _SYNONYMS.split("\n")[1:-1])
    for name in others.strip().split(", ")
}
# How many of a kind are listed.
MOST = {
    "Tasks": 4, "Commands": 4, "Problems": 4, "Options": 8, "Quantities": 6, "Layouts": 4, "Constructions": 4,
    "Pages": 6,
}  # fmt: skip
WIDEST = 22
# Words that tell nothing apart.
_SMALL = frozenset(
    ("a", "all", "an", "and", "as", "at", "by", "does", "for", "from", "how", "in", "is", "it", "its", "of",
     "on", "or", "that", "the", "this", "to", "what", "when", "which", "with")
)  # fmt: skip
_LISTED = re.compile(r"(?<=\d); (?=[+-]?\d)")
_ENDING = re.compile(r"(?<=\w{4})(?:ings?|ed)$|(?<=\w{3})(?:es|(?<!s)s)$")


class SearchHit(NamedTuple):
    """What there is: its kind, its name, what is said of it, the line that tells more, other words for it,
    and the commands that have it as well."""

    kind: str
    name: str
    told: str
    where: str
    words: str = ""
    others: str = ""


def search(text: str) -> tuple[str, Mapping[str, Sequence[SearchHit]]]:
    """Return in a sentence how it was searched, and what was found by its kind, the nearest first.

    Where nothing has all the words, or what they are called here, that is found which has most of them.
    Raises ChoiceError if nothing has half.
    """
    asked = " ".join(_words(text))
    ways, entries = _ways(asked), [*_all()]
    further = [way for way in ways if way != asked]
    told = f"Searched for, too: {', '.join(further)}." if further else ""
    ranks: Sequence[float | None] = [_rank(one, ways) for one in entries]
    near = ""
    if all(rank is None for rank in ranks):
        known = {word for one in entries for word in (*_words(one.name), one.name)} | SYNONYMS.keys()
        near = did_you_mean(asked, dict.fromkeys((*COMMANDS, *sorted(known - _SMALL))))
        told, ranks = "Nothing has all of these words; some have:", _partly(asked, entries)
    ranked = sorted((rank, place) for place, rank in enumerate(ranks) if rank is not None)
    if near or not ranked:
        raise ChoiceError(f'nothing is said of "{text[:60]}"{near}; kurbel help lists what one may want')
    # What has this very name is meant, of whatever kind.
    exact = {"Tasks", *(entries[place].kind for rank, place in ranked if rank == -len(ways))}
    found: dict[str, list[SearchHit]] = {
        kind: [] for kind in sorted(KINDS, key=lambda kind: kind not in exact)
    }
    for _, place in ranked:
        found[entries[place].kind].append(entries[place])
    return told, {kind: listed for kind, listed in found.items() if listed}


def _partly(asked: str, entries: Sequence[SearchHit]) -> Sequence[float | None]:
    """Return ranks of the entries that have most of the words, in whatever ending; None of those that have
    less, or not half."""
    stems = [_ENDING.sub("", word) for word in asked.split() if word not in _SMALL]
    having = [
        [
            any(known.startswith(stem) for known in _words(f"{one.name} {one.told} {one.words}"))
            for stem in stems
        ]
        for one in entries
    ]
    most = max(map(sum, having))
    if not most or 2 * most < len(stems):
        return [None] * len(entries)
    # Of words the rarest tell most.
    weights = [1 / max(1, sum(column)) for column in zip(*having, strict=True)]
    return [
        -sum(weight for weight, has in zip(weights, own, strict=True) if has) if sum(own) == most else None
        for own in having
    ]


def _ways(asked: str) -> Sequence[str]:
    """Return the words that are searched for: by themselves, and with synonyms in their place."""
    padded, ways = f" {asked} ", [asked]
    # A longer synonym, which has a shorter one in it, is the right one.
    for name in sorted(SYNONYMS, key=len, reverse=True):
        if f" {name} " in padded:
            ways += [padded.replace(f" {name} ", f" {one} ").strip() for one in SYNONYMS[name]]
            break
    return [*dict.fromkeys(ways)]


def _words(text: str) -> list[str]:
    return re.findall(r"[^\W_]+", text.lower())


def _rank(one: SearchHit, ways: Sequence[str]) -> int | None:
    """Return how near an entry is, of the least rank the nearest; None for one that is not meant."""
    for rank, text in enumerate((one.name, f"{one.name} {one.told}", f"{one.name} {one.words}")):
        there = _words(text)
        for place, words in enumerate(map(_words, ways)):
            if rank == 0 and words == there:
                return place - len(ways)
            if words and all(any(_begins(known, word) for known in there) for word in words):
                return rank * len(ways) + place
    return None


def _begins(known: str, word: str) -> bool:
    """Whether a word of an entry is meant by one that is searched, in the plural too."""
    return known.startswith(word) or (len(word) > 3 and known == word.removesuffix("s"))


def _commands() -> Iterator[SearchHit]:
    for name, (_, line) in COMMANDS.items():
        about = inspect.cleandoc(command_of(name).help or "").partition("\b")[0]
        yield SearchHit("Commands", name, line, f"kurbel {name} -h", about)


def _wants() -> Iterator[SearchHit]:
    for want in wants():
        lines = " ".join(what for _, what in want.lines)
        yield SearchHit("Tasks", want.name, want.sentence, f"kurbel help {want.name}", lines)


def _options() -> Iterator[SearchHit]:
    """Yield the options, of those that commands share the first."""
    homes: dict[tuple[str, str], list[str]] = {}
    told: dict[tuple[str, str], str] = {}
    for name in COMMANDS:
        command = command_of(name)
        for topic, options in topics_of(command) if isinstance(command, TopicCommand) else ():
            for one in options:
                key = (flag_of(one), topic.name)
                homes.setdefault(key, []).append(name)
                told.setdefault(key, one.help or "")
        if not isinstance(command, TopicCommand):
            for one in options_of(command).values():
                homes.setdefault((flag_of(one), ""), []).append(name)
                told.setdefault((flag_of(one), ""), one.help or "")
    for (flag, home), names in homes.items():
        where = f"kurbel {names[0]} --help {home}".rstrip()
        yield SearchHit("Options", flag, told[flag, home], where, home, ", ".join(names[1:]))


def _quantities() -> Iterator[SearchHit]:
    for about in map(subject, SUBJECTS):
        for one, command in about.entries():
            unit = one.plain_unit("en")
            told = f"{about.name_of(one, 'en')}{f', {unit}' if unit else ''}"
            yield SearchHit("Quantities", one.key, told, f"kurbel {command}", about.name_of(one, "de"))


def _layouts() -> Iterator[SearchHit]:
    for one in map(layout, layout_names()):
        yield SearchHit("Layouts", one.key, one.title["en"], printing(one, None), one.title["de"])


def _problems() -> Iterator[SearchHit]:
    for one, german in zip(*map(problems, ("en", "de")), strict=True):
        yield SearchHit("Problems", one.name, one.text, f"kurbel help {one.name}", german.text)


def _constructions() -> Iterator[SearchHit]:
    for name in construction_names():
        title = construction(name).given.title
        yield SearchHit("Constructions", name, title["en"], f"kurbel construct {name}", title["de"])


def _pages() -> Iterator[SearchHit]:
    for name in page_names():
        # Without what stands in blocks, where lines begin with # as well.
        title, *blocks = re.sub(r"```.*?```", "", page_text(name), flags=re.DOTALL).split("\n\n")
        heads = [one.strip("# ") for one in blocks if one.startswith("#")]
        first = next((one for one in blocks if one and not one.startswith("#")), "")
        told = "; ".join((title.strip("# "), *heads))
        yield SearchHit("Pages", name, told, f"kurbel help {name}", first)


KINDS: Mapping[str, Callable[[], Iterator[SearchHit]]] = {
    "Tasks": _wants,
    "Commands": _commands,
    "Problems": _problems,
    "Options": _options,
    "Quantities": _quantities,
    "Layouts": _layouts,
    "Constructions": _constructions,
    "Pages": _pages,
}


def _all() -> Iterable[SearchHit]:
    seen = set()
    for entries in KINDS.values():
        for one in entries():
            # Lists name again what another page has, too.
            if (one.kind, one.name, one.told) not in seen:
                seen.add((one.kind, one.name, one.told))
                yield one


@cache
def _folder(name: str) -> Path:
    """Return a folder that goes with the program: in the installed package, else in the checkout."""
    package = Path(__file__).parents[2]
    for folder in (package / name, package.parents[1] / name):
        if folder.is_dir():
            return folder
    raise OutputError(f"there is no folder {name} beside {package}; the installation is not complete")


def page_names() -> Sequence[str]:
    """Return the pages of the documentation that are there to be read: howto/latex."""
    folder = _folder("docs")
    names = (path.relative_to(folder).with_suffix("").as_posix() for path in sorted(folder.rglob("*.md")))
    return [name for name in names if name.partition("/")[0] in ("howto", "subjects", "books", "tutorial")]


def page_text(name: str) -> str:
    return (_folder("docs") / f"{name}.md").read_text(encoding="utf-8")


def problems(lang: str = "en") -> Iterator[Problem]:
    """Yield the problems that go with the program, with their first numbers, lists as they are typed."""
    for path in sorted(_folder("examples/problems").glob("*.toml")):
        if "[[problem]]" in path.read_text(encoding="utf-8"):
            for one in problems_of(str(path), lang, mark="."):
                # Formulas stand between dollars.
                yield one._replace(text=_LISTED.sub(";", one.text.replace("$", "")))


def write_found(found: Mapping[str, Sequence[SearchHit]], formatter: click.HelpFormatter) -> None:
    """Write what was found below the heads of its kinds, of each the nearest."""
    for kind, listed in found.items():
        near, more = listed[: MOST[kind]], len(listed) - MOST[kind]
        width = min(max(len(one.name) for one in near), WIDEST)
        with formatter.section(kind):
            for one in near:
                rows = [(one.name.ljust(width), _first(one.told))]
                if one.others:
                    rows.append((" " * width, f"also of {one.others}"))
                formatter.write_dl(rows, WIDEST)
                left = formatter.current_indent + width + GAP
                for line in folded(one.where, formatter.width - left).split("\n"):
                    formatter.write(f"{'':{left}}{line}\n")
            if more > 0:
                formatter.write_text(f"... and {more} more, which more words tell apart")


def _first(told: str) -> str:
    """Return the first sentence, without its end."""
    return re.split(r"; |[.?] (?=[A-Z])|[.]$", told)[0]
