"""The gallery: a picture of every layout and of every kind of drawing, with the command that makes it."""

from __future__ import annotations

import html
import shlex
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import NamedTuple

from markdown import fenced, plain, toctree
from pictures import Picture, picture_of

from kurbel.books.constructions.construction_page import construction, construction_names
from kurbel.cli.app import command_of
from kurbel.cli.asking import asked
from kurbel.commands.shown import Drawing, Table
from kurbel.page.labels import plain as without_formulas
from kurbel.page.layouts import SUBJECTS, layout, layout_names

FOLDER, PICTURES = "gallery", "_static/pictures"
EXAMPLES = Path(__file__).parents[2] / "examples"


class Group(NamedTuple):
    """Pages that belong together, where their subject is told of, and the commands that print them."""

    title: str
    guide: str
    commands: Sequence[str]


GROUPS: Mapping[str, Group] = {
    "motion": Group("Motion", "subjects/motion", ("table", "deadcentres")),
    "forces": Group("Forces", "subjects/effort", ("forces", "inertia")),
    "engines": Group("Engines", "subjects/engines", ("delta", "turning", "pressures", "power")),
    "flywheels": Group("Flywheels", "subjects/flywheels", ("flywheel",)),
    "balance": Group(
        "Balance", "subjects/balance", ("harmonics", "balance", "rotor", "locomotive", "firing")
    ),
    "conditions": Group("Conditions", "subjects/solve", ("solve",)),
    "books": Group("Books", "books/index", ("collate",)),
    "drawings": Group("Drawings", "subjects/drawings", ("plot",)),
    "constructions": Group("Constructions", "subjects/constructions", ("construct",)),
}
# Pages as drawings, and mechanisms beside the examples in the help of `kurbel plot`.
DRAWINGS = (
    "table --ratio 1:5 --infinite -f svg -o motion",
    "table --ratio 1:5 --layout over-path --infinite -f svg -o velocity-ellipse",
    "forces --machine engine.toml -f svg -o forces",
    "forces --polar --ratio 1:5 --force 10kN -f svg -o crank-pin-force",
    "forces --polar --eps 4 --bore 300mm --pressure 8bar -f svg -o pin-of-an-engine",
    "turning --eps 4 --flywheel 50 --speed 120/min -f svg -o turning-effort",
    "turning --torque '5000 + 1500 sin(3φ)' --load-torque '5000 + 600 sin φ' -f svg -o torques",
    "pressures --machine engine.toml -f svg -o pressures",
    "delta --eps 1.5..10:0.5 --ratio '1:4;1:5' -f svg -o irregularity",
    "harmonics --ratio '1:4;1:5' -f svg -o spectrum",
    "balance --engine inline-4 -f svg -o free-force",
    "plot --positions '30;150' --ratio 1:4 --offset 0.5 -o offset-crank",
)
# What describes the drive of a construction that does not hold for the straight crank.
DRIVES: Mapping[str, Sequence[str]] = {"beam": ("--beam", "3")}


class Shown(NamedTuple):
    """What the gallery shows: its name, what it is, the words of the command that makes it, and a picture."""

    name: str
    title: str
    words: Sequence[str]
    picture: Picture

    @property
    def command(self) -> str:
        return shlex.join(("kurbel", *self.words))

    @property
    def group(self) -> str:
        """Layouts of forces are printed by `kurbel table`, too, for a force that is given."""
        if self.name.startswith("drawing-") and self.words[0] != "construct":
            return "drawings"
        if self.words[0] == "table" and "forces" in self.name:
            return "forces"
        return next(name for name, group in GROUPS.items() if self.words[0] in group.commands)


def _image(place: str, alt: str, width: int, height: int) -> str:
    size = f'width="{width}" height="{height}"'
    return f'<img src="../{PICTURES}/{place}" alt="{html.escape(alt)}" {size} loading="lazy">'


def shown() -> Iterator[Shown]:
    for name in layout_names():
        page = layout(name)
        words = (*_sample(page.subject), "--layout", name, "--lang", "en")
        yield Shown(name, page.title["en"], words, picture_of(page_or_drawing(words)))
    names: dict[str, int] = {}
    for line in _drawings():
        *typed, _, file = shlex.split(line)
        drawing = page_or_drawing((*typed, "--lang", "en"))
        assert isinstance(drawing, Drawing)
        stem = Path(file).stem
        names[stem] = names.get(stem, 0) + 1
        name = f"drawing-{stem}-{names[stem]}" if names[stem] > 1 else f"drawing-{stem}"
        plain = [one for one in typed if one not in ("-f", "svg")]
        own = (*plain, "--lang", "en", "-o", f"{stem}.svg")
        yield Shown(name, without_formulas(drawing.title), own, picture_of(drawing))


def page_or_drawing(words: Sequence[str]) -> Table | Drawing:
    made = asked(words, {}, folder=str(EXAMPLES)).made
    return made if isinstance(made, Drawing) else Table.of(made)


def _sample(subject: str) -> list[str]:
    """Return the words of a command that prints a page of a subject."""
    return shlex.split(SUBJECTS[subject].sample.partition(" --layout ")[0])


def _drawings() -> Iterator[str]:
    for line in (command_of("plot").help or "").splitlines():
        if line.strip().startswith("kurbel plot "):
            yield line.strip().removeprefix("kurbel ")
    yield from DRAWINGS
    for subject in SUBJECTS:
        words = _sample(subject)
        if words[:2] == ["table", "--mechanism"]:
            yield shlex.join(("plot", "--positions", "30", *words[1:], "-o", words[2]))
    for name in construction_names():
        drive = DRIVES.get(construction(name).given.holds[0], ())
        yield shlex.join(("construct", name, *drive, "-o", name))


def pages() -> Iterator[tuple[str, bytes]]:
    found: dict[str, list[Shown]] = {name: [] for name in GROUPS}
    for one in shown():
        found[one.group].append(one)
        yield f"{PICTURES}/{one.name}{one.picture.suffix}", one.picture.content
        yield f"{PICTURES}/small/{one.name}.png", one.picture.small
    for name, entries in found.items():
        yield f"{FOLDER}/{name}.md", ("\n\n".join(_group(GROUPS[name], entries)) + "\n").encode()
    yield f"{FOLDER}/index.md", ("\n\n".join(_index(found)) + "\n").encode()


def _group(group: Group, entries: Sequence[Shown]) -> Iterator[str]:
    yield f"# {group.title}"
    yield f"What these pages say is told in {{doc}}`/{group.guide}`."
    for one in entries:
        yield f"(gallery-{one.name})=\n## {plain(one.title)}"
        yield _region(one)
        yield fenced("sh", (one.command,))
        command = one.words[0]
        yield f"All options: {{doc}}`kurbel {command} </reference/command-line/{command}>`."


def _region(one: Shown) -> str:
    """Return the picture in what scrolls, by keyboard too, where the screen is narrower."""
    alt = f"{one.title}, as the command below makes it"
    image = _image(f"{one.name}{one.picture.suffix}", alt, one.picture.width, one.picture.height)
    # No two pictures of a page have the same name.
    label = html.escape(one.command)
    return f'<div class="kurbel-picture" tabindex="0" role="region" aria-label="{label}">{image}</div>'


def _index(found: Mapping[str, Sequence[Shown]]) -> Iterator[str]:
    yield "# Gallery"
    yield "Every layout and every kind of drawing, with the command that makes it."
    yield "[Beside its peers](peers.md) stands one table as others set it."
    for name, entries in found.items():
        yield f"## [{GROUPS[name].title}]({name}.md)"
        yield "\n".join(('<ul class="kurbel-gallery">', *(_card(name, one) for one in entries), "</ul>"))
    yield toctree((*found, "peers"), ":hidden:")


def _card(page: str, one: Shown) -> str:
    inner = f"{_image(f'small/{one.name}.png', '', 240, 150)}<span>{html.escape(one.title)}</span>"
    return f'<li><a href="{page}.html#gallery-{one.name}">{inner}</a></li>'
