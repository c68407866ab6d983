"""A cylinder of an engine as it is given: in a machine's file, in a text, or in Python."""

from collections.abc import Callable, Iterable, Mapping
from copy import copy
from os import PathLike
from typing import Annotated, Any, TypeAlias, cast, get_args, get_type_hints

from kurbel.commands.options import Kind, Option
from kurbel.errors import NotationError
from kurbel.reading.given import Exact

Described: TypeAlias = str | Mapping[str, Any]
# What is said or not, and how it is written in a text.
FLAGS = ("single_acting", "two_stroke")
SAID: Mapping[Any, bool] = {"true": True, "false": False, True: True, False: False}
EXAMPLE = "angle=90 bore=500mm pressure=3bar eps=2"


class OneCylinder(Kind):
    """The entries of a cylinder, each as the option of its name is written: angle=90 bore=500mm eps=2."""

    name = "cylinder"

    def read(self, text: Any, typed: Mapping[str, Any]) -> Mapping[str, Any]:
        if isinstance(text, Mapping):
            return text
        entries: dict[str, Any] = {}
        for part in text.split():
            key, equals, value = part.partition("=")
            key = key.replace("-", "_")
            if key in entries:
                raise NotationError(f"{key} of a cylinder is given twice; leave one out")
            entries[key] = value if equals else True
        return _checked(entries)

    def taken(self, value: Any, name: str) -> Mapping[str, Any]:
        if isinstance(value, str):
            return self.read(value, {})
        if not isinstance(value, Mapping):
            raise NotationError(f"{name} is {str(value)[:40]}; give each as a mapping, or as {EXAMPLE}")
        return _checked(dict(value))

    def with_files(self, value: Mapping[str, Any], file: Callable[[Any], Any]) -> Mapping[str, Any]:
        # A cylinder of a machine's file knows where it stands there.
        found: Any = copy(value)
        for name in _files() & value.keys():
            named = value[name]
            found[name] = file(named) if isinstance(named, str | PathLike) else [*map(file, named)]
        return cast("Mapping[str, Any]", found)


def _files() -> set[str]:
    """Return the entries that name files."""
    from kurbel.drive.sections import Cylinder, File, Files

    return {name for name, kind in get_type_hints(Cylinder).items() if {File, Files} & {*get_args(kind)}}


def _checked(entries: dict[str, Any]) -> Mapping[str, Any]:
    """Return the entries if a cylinder has such ones."""
    from kurbel.drive.sections import Cylinder
    from kurbel.reading.given import choose

    for key, value in entries.items():
        choose(key, Cylinder.__struct_fields__, "entry of a cylinder,")
        if value is True and key not in FLAGS:
            raise NotationError(f"{key} of a cylinder has no value; write it as {EXAMPLE}")
        if key in FLAGS and value not in SAID:
            raise NotationError(f"{key} of a cylinder is {str(value)[:40]}; it must be true or false")
    said = {key: SAID[value] if key in FLAGS else value for key, value in entries.items()}
    if "crank" not in said:
        return said
    from kurbel.drive.size.given import in_strokes

    return in_strokes(said)


Cylinders = Annotated[
    Iterable[Described] | None,
    Option(
        f"A cylinder of an engine of unlike ones, in the words of the options: '{EXAMPLE}'; beside it all"
        " options say what the cylinders have in common. Machines have them as [[cylinder]].",
        "ENTRIES", OneCylinder(), many=True,
    ),
]  # fmt: skip
Of = Annotated[
    Exact | None,
    Option("Of several cylinders unlike: the one whose forces these are; default 1, the first.", "NUMBER"),
]
