"""Names as people write them: another word for the same, capitals, letters of formulas; which is near; and
the names of a function's values."""

from __future__ import annotations

import inspect
import re
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from functools import wraps
from os import PathLike
from types import NoneType
from typing import ParamSpec, TypeVar

from kurbel.errors import KeywordError, KurbelError

# Words for the same, also before _return, _mm and the like: those that names have, then those that none has.
# Capitals, accents and signs between words do not count, and a number is a word.
_SAME = """
    x path coupler_path path_along | position piston_path piston_position displacement weg kolbenweg
    c velocity coupler_velocity | v piston_velocity geschwindigkeit kolbengeschwindigkeit
    p acceleration coupler_acceleration | a piston_acceleration beschleunigung kolbenbeschleunigung
    x_stroke path_stroke s | stroke_share
    path_along | xi
    path_across | eta
    phi crank_angle | angle kurbelwinkel winkel
    psi rod | rod_angle stangenwinkel schubstangenwinkel
    ratio | lambda crank_ratio kurbelverhaltnis
    epsilon eps | expansion
    torque | drehmoment
    turn | rocker_turn swing
    turn_velocity | rocker_velocity
    turn_acceleration | rocker_acceleration
    rod_force | stangenkraft
    guide_force | fuhrungsdruck fuhrungskraft
    tangential_force | tangentialkraft
    tangential | tangentialkraft
    radial_force | radialkraft
    speed rpm | drehzahl
    power | leistung
    work | arbeit
    de | deutsch german de_de de_at de_ch
    en | english englisch en_us en_gb
    series | first_order
    straight | slider_crank
    arc | four_bar fourbar
    infinite | unendlich inf
    inline | i l r straight reihe
    boxer | b flat
    v_2_90 | v_2
    v_6_90 | v_6
    v_8_90 | v_8
    v_12_60 | v_12
    latex | tex
    markdown | md
    text | txt
    xlsx | excel
    ods | libreoffice
"""
_GROUPS = [tuple(part.split() for part in line.split("|")) for line in _SAME.strip().splitlines()]
_LETTERS = str.maketrans(
    {"φ": "phi", "ϕ": "phi", "ψ": "psi", "λ": "lambda", "ε": "epsilon", "δ": "delta", "ω": "omega",
     "μ": "mu", "ν": "nu", "α": "alpha", "η": "eta", "θ": "theta", "ξ": "xi", "ä": "a", "ö": "o", "ü": "u",
     "∞": "inf", "%": " percent"}
)  # fmt: skip
_UNIT = re.compile(r"\s*\[.*")
_NUMBER = re.compile(r"[0-9]+")
# A line of a shell, or an option with what may be its value.
_OPTION = re.compile(
    r"kurbel [a-z]+ -[^;,]*|--([a-z][a-z-]*)(?:([ =])('[^']*'|\"[^\"]*\"|[^\s,;]*[^\s,;.]))?"
)
_VALUE = re.compile(r"['\"]|[+−-]?\d|\w+[=:]")
_PLAIN_NUMBER = re.compile(r"-?\d+(?:\.\d+)?")
_SIGNS = re.compile(r"[\W_]+|(?<=[^\W\d_])(?=\d)")
# What stands behind a locale: en_GB.UTF-8.
_ENCODING = re.compile(r"\.(?:utf-?8|iso-?8859.*)$")
_LONGEST = 60
# More are no answer.
MOST = 3
# What a column of the return stroke has in its name: where it is meant, it is said.
_RETURN = "return"
# Keywords that say how a page is written, and not what stands on it.
WRITING = frozenset(("format", "decimal", "output", "standalone", "longtable", "siunitx", "plain", "excel"))
# Annotations, with what a value must be.
_KINDS: Mapping[str, tuple[tuple[type, ...], str]] = {
    "str": ((str, NoneType), "text"),
    "str | None": ((str, NoneType), "text"),
    "str | os.PathLike[str]": ((str, PathLike), "the name of a file"),
}
Words = ParamSpec("Words")
Answer = TypeVar("Answer")


def otherwise(name: str, names: Sequence[str]) -> str | None:
    """Return which of the names is meant by another word for it, None if none or more than one is."""
    ways = _ways(names)
    return ways.get(spelled(name)) or None


def others(name: str, names: Iterable[str]) -> Iterator[str]:
    """Yield those of the names that are other words for one of them."""
    words = {*_other_words(spelled(name))}
    return (one for one in names if one != name and spelled(one) in words)


def near(name: str, names: Sequence[str], words: bool = False) -> list[str]:
    """Return the name that is nearest in letters or means the same, or two that this is a part of.

    With `words` what may be written is one of the other words for a name, too.
    """
    ways, asked = _ways(names), spelled(name[:_LONGEST])
    if ways.get(asked):
        return [ways[asked]]
    begun = _with_more(asked, names)
    if 0 < len(begun) <= MOST:
        return begun
    own = {spelled(one) for one in names}
    ranked = sorted(
        (distance, way not in own, place)
        for place, way in enumerate(ways)
        if ways[way] and (distance := _distance(asked, way)) is not None
    )
    if ranked and _tells_apart(asked, [[*ways][place] for _, _, place in ranked]):
        way = [*ways][ranked[0][2]]
        return [way if words and way not in own and way.isalpha() else ways[way]]
    found = [one for one in names if _is_part(asked, spelled(one))]
    return found if len(found) <= MOST else []


def _tells_apart(asked: str, ranked: Sequence[str]) -> bool:
    """Whether the nearest is more than one of several that have another number each."""
    besides = _NUMBER.sub("", asked)
    return ranked[0] == asked or sum(_NUMBER.sub("", way) == besides for way in ranked) < 2


def _with_more(asked: str, names: Sequence[str]) -> list[str]:
    """Return the names that begin with these words, or with others for them, and have more."""
    said = [asked]
    for keys, others in _GROUPS:
        for word in (*keys, *others):
            if asked == word or asked.startswith(f"{word}_"):
                said += (key + asked[len(word) :] for key in keys if key not in asked.split("_"))
    return [
        name
        for name in names
        for own in (spelled(name),)
        if any(own.startswith(f"{one}_") and _RETURN not in own.split("_") for one in said)
    ]


def spelled(name: str) -> str:
    """Return the words of a name: inline_4 of Inline-4 and of inline4."""
    plain = _ENCODING.sub("", _UNIT.sub("", name.strip().casefold()))
    return _SIGNS.sub("_", plain.translate(_LETTERS)).strip("_") or plain


def _ways(names: Sequence[str]) -> Mapping[str, str]:
    """Return the names by all ways of writing them, "" where two of them are written so."""
    ways: dict[str, str] = {}
    for name in names:
        own = spelled(name)
        ways[own] = own if own in names else "" if own in ways else name
    for name in names:
        for other in _other_words(spelled(name)):
            ways.setdefault(other, name)
    return ways


def _other_words(name: str) -> Iterator[str]:
    """Yield what the words may be called otherwise."""
    for names, others in _GROUPS:
        for word in names:
            if name == word or name.startswith(f"{word}_"):
                yield from (other + name[len(word) :] for other in (*names, *others) if other != word)


def _is_part(asked: str, name: str) -> bool:
    """Whether a name has these words and more, on the same stroke."""
    words, more = asked.split("_"), name.split("_")
    if len(asked) < 3 or (_RETURN in more and _RETURN not in words):
        return False
    return any(more[at : at + len(words)] == words for at in range(len(more)))


def _distance(asked: str, way: str) -> int | None:
    """Return by how many letters two names differ, None if they are not near."""
    if len(asked) < 2:
        return None
    if len(asked) >= 3 and _begins(asked, way):
        return 1
    words, others = asked.split("_"), way.split("_")
    if len(words) != len(others):
        # A sign between words may lack.
        return _edits(asked, way) if asked.replace("_", "") == way.replace("_", "") else None
    found = 0
    for word, other in zip(words, others, strict=True):
        if word.isdigit() != other.isdigit():
            return None
        most = max(1, len(word) // 3) if word[:1] == other[:1] else int(len(asked) > 2)
        if abs(len(word) - len(other)) > most or (edits := _edits(word, other)) > most:
            return None
        found += edits
    return found


def _begins(asked: str, way: str) -> bool:
    """Whether a word was not written to its end."""
    rest = way.removeprefix(asked)
    return rest != way and not rest.startswith("_") and len(rest) <= 2 * len(asked)


def _edits(one: str, other: str) -> int:
    """Return the least number of letters left out, put in, changed, or changed about with the next."""
    before: list[int] = []
    row: list[int] = [*range(len(other) + 1)]
    for place, letter in enumerate(one, 1):
        two, before, row = before, row, [place]
        for at, wanted in enumerate(other, 1):
            least = min(row[at - 1] + 1, before[at] + 1, before[at - 1] + (letter != wanted))
            if place > 1 and at > 1 and letter == other[at - 2] and one[place - 2] == wanted:
                least = min(least, two[at - 2] + 1)
            row.append(least)
    return row[-1]


def did_you_mean(name: str, names: Iterable[str], words: bool = False) -> str:
    """Return a question with the nearest of the names, or nothing if none is near."""
    found = near(name, [*names], words)
    return f" (did you mean {enumerated(found, 'or')}?)" if found else ""


def enumerated(names: Iterable[str], before_last: str = "and") -> str:
    """Return names as a sentence lists them: --bore, --stroke and --speed."""
    *first, last = names
    return f"{', '.join(first)} {before_last} {last}" if first else last


def checks_keywords(function: Callable[Words, Answer]) -> Callable[Words, Answer]:
    """Refuse wrong names of the function's values, and what is no text or file in place of one, by
    KeywordError."""
    signature = inspect.signature(function)

    @wraps(function)
    def called(*args: Words.args, **kwargs: Words.kwargs) -> Answer:
        for name, value in bound(function.__qualname__, signature, args, kwargs).arguments.items():
            kinds, needed = _KINDS.get(signature.parameters[name].annotation, (object, ""))
            if not isinstance(value, kinds):
                raise KeywordError(f"{name} is {str(value)[:60]}; it must be {needed}")
        with spelling_keywords(lambda: dict.fromkeys(signature.parameters, ())):
            return function(*args, **kwargs)

    return called


@contextmanager
def spelling_keywords(names: Callable[[], Mapping[str, Collection[str]]]) -> Iterator[None]:
    """Have a sentence name a function's values as Python does, where it has options of the command line.

    `names` are the keywords, each with those of its values that are words; of none, all options are such.
    """
    try:
        yield
    except KurbelError as error:
        error.args = (as_keywords(str(error), names()), *error.args[1:])
        raise


def as_keywords(sentence: str, names: Mapping[str, Collection[str]]) -> str:
    """Return the sentence with pin_friction=0.06 for --pin-friction 0.06, lines of a shell as they stand."""
    known = {name.rstrip("_").replace("_", "-"): name for name in names}

    def spelled(found: re.Match[str]) -> str:
        flag, between, value = found.groups()
        if flag is None or (names and flag not in known):
            return found[0]
        keyword = known.get(flag, flag.replace("-", "_"))
        if value is None:
            return keyword
        if not (_VALUE.match(value) or value in names.get(keyword, ())):
            return f"{keyword}{between}{value}"
        text = value.strip("'\"")
        return f"{keyword}={text}" if _PLAIN_NUMBER.fullmatch(text) else f'{keyword}="{text}"'

    return _OPTION.sub(spelled, sentence)


def bound(
    name: str, signature: inspect.Signature, args: Sequence[object], kwargs: Mapping[str, object]
) -> inspect.BoundArguments:
    """Return the values by the names of a function's parameters. Raises KeywordError."""
    try:
        return signature.bind(*args, **kwargs)
    except TypeError:
        raise KeywordError(_sentence(name, signature, args, kwargs)) from None


def unknown(
    function: str, keyword: str, known: Collection[str], listed: str = "", value: str = ""
) -> KeywordError:
    """Return the error of a keyword that the function has not, with the text that it was given; `listed` says
    where those are that it has."""
    if keyword in WRITING:
        value = '"latex"' if keyword == "format" else f"{keyword}=…"
        return KeywordError(
            f"kurbel.{function} has no keyword {keyword}, which is for a page once it is made:"
            f" kurbel.typeset(page, {value}), or page.save"
        )
    from kurbel.reading.foreign import ours

    option, written = ours(keyword, value, [one.replace("_", "-") for one in known])
    hint = did_you_mean(keyword, known, words=True)
    if option and option.replace("-", "_") not in near(keyword, [*known], words=True):
        hint = f"; write {as_keywords(f'--{option} {written}', {})}"
    listed = listed or f"help(kurbel.{function}) lists its keywords"
    return KeywordError(f'kurbel.{function} has no keyword "{keyword[:60]}"{hint}; {listed}')


def _sentence(
    name: str, signature: inspect.Signature, args: Sequence[object], kwargs: Mapping[str, object]
) -> str:
    parameters = dict(signature.parameters)
    if parameters.pop("self", None):
        args = args[1:]
    free = any(one.kind is one.VAR_KEYWORD for one in parameters.values())
    wrong = next((one for one in kwargs if one not in parameters), None)
    if wrong is not None and not free:
        # A number has no unit of ours behind it.
        text = value if isinstance(value := kwargs[wrong], str) else ""
        return str(unknown(name, wrong, parameters, value=text))
    first = [one.name for one in parameters.values() if one.kind is one.POSITIONAL_OR_KEYWORD]
    if len(args) > len(first):
        named = f"{', '.join(first)} can stand without a name" if first else "all have names"
        return f"kurbel.{name} is given {len(args)} values without a name; {named}, others as name=value"
    twice = next((one for one in first[: len(args)] if one in kwargs), None)
    if twice is not None:
        return f"kurbel.{name} is given {twice} twice, by its place and by its name; leave one out"
    missing = next(
        one.name
        for place, one in enumerate(parameters.values())
        if one.default is one.empty and one.name not in kwargs and place >= len(args)
    )
    return f"kurbel.{name} needs {missing}; help(kurbel.{name}) says what it is"
