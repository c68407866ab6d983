"""Tell which options are accepted and change nothing: what is read is not yet used.

    .venv/bin/python scripts/unused_options.py [--only REGEX] [--sample N]

Each option of each command is tried beside each of the command's cases (`cases` of corpus/pairs.toml, and
those of corpus/unused.toml), on the page and, if it is one of looks, on the drawing. Where two of its values
are accepted, what is printed must differ; where one is, or it is a flag, it must differ from what is printed
without it. What does not, stands in corpus/unused.toml with its reason. It ends with 1 for a pair that does
not stand there, for a reason without a pair, and for a traceback.

Values are those of corpus/pairs.toml or the examples of the option's help, names of which there are few, and
numbers beside them. A new option is tried without a line here.
"""

from __future__ import annotations

import argparse
import re
import shlex
import sys
import tempfile
import tomllib
from collections.abc import Iterator, Mapping, Sequence
from contextlib import chdir
from functools import cache
from itertools import islice
from pathlib import Path
from typing import Any, NamedTuple

import click
from command_lines import CORPUS
from same_bytes import kurbel, prepare

from kurbel.cli.app import command_of
from kurbel.cli.options import FileName, Type
from kurbel.commands.options import Choice, Columns, Count, LayoutName
from kurbel.commands.parts.drawing import DrawingOptions
from kurbel.commands.parts.sheet import Layouts, Sheet
from kurbel.errors import KurbelError

# How pages are written is tried by these, and by `-f` no more.
PAGES = ("json", "text", "latex", "csv", "html")
DRAWING = ("svg",)
NO_OPTIONS = frozenset(("format", "output", "machine", "short", "whole", "help"))
OF_LOOKS = frozenset((*DrawingOptions.options(), *Layouts.options(), *Sheet.options())) | {
    "decimal", "standalone", "interactive", "longtable", "siunitx", "plain", "excel",
}  # fmt: skip
# So many values are tried; of an option that is refused at first, fewer.
MOST, MOST_REFUSED = 9, 3
_NUMBER = re.compile(r"\d+(?:[.,]\d+)?")
_EXAMPLES = re.compile(r"(?:: |, | or |such as )'?([^\s,;()']*\d[^,;()']*?)'?(?=[,.;)] |[.,;)']*$| or )")


class Pair(NamedTuple):
    """An option beside a case of a command, on pages or on drawings."""

    command: str
    case: str
    option: click.Parameter
    formats: Sequence[str]

    def __str__(self) -> str:
        drawn = " -f svg" if self.formats is DRAWING else ""
        return f"{self.command} {self.case}{drawn} {self.flag}"

    @property
    def flag(self) -> str:
        return max(self.option.opts, key=len)


class Finding(NamedTuple):
    """What is wrong with a pair, and what was tried."""

    pair: Pair
    what: str
    tried: str

    @property
    def is_unused(self) -> bool:
        return not self.what.startswith("traceback")


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("--only", default="", metavar="REGEX", help='pairs with this: "^delta .*--rod$"')
    parser.add_argument("--sample", default=1, type=int, metavar="N", help="every Nth of them")
    chosen = parser.parse_args()
    unused = tomllib.loads((CORPUS / "unused.toml").read_text(encoding="utf-8"))
    cases = tomllib.loads((CORPUS / "pairs.toml").read_text(encoding="utf-8"))
    entries = [(one["pair"], re.compile(one["pair"]), one["reason"]) for one in unused["unused"]]
    tried = [one for one in pairs(cases["cases"], unused["cases"]) if re.search(chosen.only, str(one))]
    found, met = 0, set()
    with tempfile.TemporaryDirectory() as folder:
        prepare(Path(folder))
        with chdir(folder):
            for pair in tried[:: chosen.sample]:
                for finding in findings(pair, cases["values"] | unused["values"]):
                    known = {text for text, regex, _ in entries if regex.search(str(pair))}
                    met |= known
                    if not (finding.is_unused and known):
                        found += 1
                        print(f"{pair}: {finding.what}; tried: {finding.tried}", flush=True)
    stale = [text for text, _, _ in entries if text not in met]
    if stale and not chosen.only and chosen.sample == 1:
        print(*(f"unused.toml: {text}: there is no such pair" for text in stale), sep="\n")
        found += len(stale)
    print(f"{len(tried[:: chosen.sample])} pairs: {found} to be mended")
    return bool(found)


def pairs(*several: Mapping[str, Sequence[str]]) -> Iterator[Pair]:
    """Yield every option of the commands beside each of their cases, on pages and on drawings."""
    for cases in several:
        for name, beginnings in cases.items():
            params = [one for one in command_of(name).params if one.name not in NO_OPTIONS]
            for case in beginnings:
                page = DRAWING if name == "plot" or "-f svg" in case else PAGES
                case = case.replace("-f svg", "").strip()
                yield from (Pair(name, case, one, page) for one in params)
                if page is PAGES:
                    yield from (Pair(name, case, one, DRAWING) for one in params if one.name in OF_LOOKS)


def findings(pair: Pair, values: Mapping[str, str]) -> Iterator[Finding]:
    """Yield what is wrong with the pair, if anything."""
    if pair.formats is DRAWING and not printed(pair.command, pair.case, *DRAWING).startswith("ok"):
        return
    words = shlex.split(pair.case)
    place = next((at for at, word in enumerate(words) if word.split("=", 1)[0] == pair.flag), None)
    is_flag = getattr(pair.option, "is_flag", False) and getattr(pair.option, "flag_value", True) is True
    if is_flag and place is not None:
        return
    own = None
    if place is not None:
        _, sign, own = words[place].partition("=")
        if not sign:
            # An option that goes without a value has none behind it.
            if place + 1 == len(words) or words[place + 1].startswith("--"):
                return
            own = words.pop(place + 1)
    tried: list[str] = []
    accepted: list[str] = []
    for value in ["", *islice(candidates(pair, own, values), MOST)]:
        if not value:
            line = pair.case
        else:
            typed = pair.flag if is_flag else f"{pair.flag}={value}" if pair.flag[0] == "-" else value
            line = shlex.join(
                [*words[:place], typed, *words[place + 1 :]] if place is not None else [*words, typed]
            )
        outcomes = [printed(pair.command, line, one) for one in pair.formats]
        if crash := next((one for one in outcomes if one.startswith("traceback")), ""):
            yield Finding(pair, crash, line)
        if not value:
            base = line
            continue
        tried.append(value)
        if any(one.startswith("ok") for one in outcomes):
            accepted.append(line)
            if len(accepted) > 1 and differ(pair, accepted[0], line):
                return
        elif len(tried) >= MOST_REFUSED and not accepted:
            return
    if not tried:
        yield Finding(pair, "no value of it is known", "nothing")
    elif len(accepted) > 1:
        yield Finding(pair, "its values change nothing", ", ".join(tried))
    elif accepted and own is None and not has_default(pair.option) and not differ(pair, base, accepted[0]):
        yield Finding(pair, "it changes nothing", ", ".join(tried))


def has_default(option: click.Parameter) -> bool:
    """Whether a single value may be that which counts without the option."""
    return isinstance(option.type, Type) and isinstance(option.type.kind, Choice | LayoutName)


def differ(pair: Pair, line: str, other: str) -> bool:
    """Whether the lines print different bytes in one of the formats in which both are accepted."""
    for form in pair.formats:
        one, another = (printed(pair.command, each, form) for each in (line, other))
        if one != another and one.startswith("ok") and another.startswith("ok"):
            return True
    return False


@cache
def printed(command: str, line: str, form: str) -> str:
    """Return what the line prints in this format behind "ok", or that it is refused, or a traceback."""
    code, out, err = kurbel(words_of(command, line, form), {})
    if isinstance(code, str):
        return f"traceback {code}"
    return f"ok {out.decode()}" if code == 0 or out else f"refused {err.decode()}"


def words_of(command: str, line: str, form: str) -> tuple[str, ...]:
    # A page without a label of its own is called by its options.
    named = ("--label=same",) if form in PAGES and "--label" not in line else ()
    return (command, *shlex.split(line), *named, "-f", form)


def candidates(pair: Pair, own: str | None, values: Mapping[str, str]) -> Iterator[str]:
    """Yield values of the option, that of the case first."""
    option = pair.option
    kind = option.type.kind if isinstance(option.type, Type) else None
    if getattr(option, "is_flag", False) and kind is None:
        yield pair.flag
        return
    known = [own] if own is not None else []
    known += [values[option.name]] if option.name in values else []
    known += _EXAMPLES.findall(getattr(option, "help", None) or "")
    if isinstance(kind, Choice | LayoutName):
        known = [own] if own is not None else []
        known += [*kind.known({})]
    elif isinstance(kind, Count):
        known += [*kind.allowed]
    elif isinstance(kind, Columns):
        known += [*kind.offered("", {**params_of(pair), pair.command: True})]
    elif isinstance(option.type, FileName):
        known += [
            str(one) for name in known[:1] for one in sorted(Path(name).parent.iterdir()) if one.is_file()
        ]
    else:
        known += [each for one in known[:2] for each in beside(one)] or ["a", "b"]
    yield from dict.fromkeys(known)


def params_of(pair: Pair) -> Mapping[str, Any]:
    """Return what the case says, nothing where it is refused."""
    try:
        return command_of(pair.command).make_context("kurbel", shlex.split(pair.case)).params
    except (click.ClickException, KurbelError):
        return {}


def beside(text: str) -> Iterator[str]:
    """Yield the text with another number in place of one of them, or with a letter more."""
    numbers = [*_NUMBER.finditer(text)]
    for times, more in ((1.25, 0), (1, 1), (2, 0), (0.5, 0)):
        for number in dict.fromkeys(numbers[-1:] + numbers[:1]):
            changed = f"{float(number[0].replace(',', '.')) * times + more:.6g}"
            yield text[: number.start()] + changed + text[number.end() :]
    if not numbers:
        yield f"{text}b"


if __name__ == "__main__":
    sys.exit(main())
