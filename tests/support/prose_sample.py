"""A text with every construct and many characters that some format would obey."""

from __future__ import annotations

from html.parser import HTMLParser
from typing import Any, Literal

from hypothesis import strategies as st

import kurbel
from kurbel.documents.markdown import parse_prose
from kurbel.formats.documents import Reference, set_prose
from kurbel.formats.registry import by_name

SAMPLE = r"""# Kurbeltrieb mit $λ_1 = R/L$ & *mehr*

Der Kolben eilt bei 2°30' *vor*, und zwar **um $x/R = 1/4.5 · cos^2 φ$**; siehe
[](#delta), [die **Skizze**](#drive) und [](#start).\
50 % & 3 \$, a|b, #_{}~^\\, <b>fett</b> &amp;lt; "so" 'so' -- --- << >> ?\` !\` [x] @delta //x /*y*/ \*z\*
<https://example.org/a_b%20c?d=1&e=~x#f>, [Netz](https://example.org/$(1)), <mail@example.org>.

## Größe

- eins
- `a  b $x$ \o/ "q" 'q' -- ~^`
  1. innen
  2. noch einer

     > Zitat im Punkt
- ```
  if (a < b) { x = "y"; }  # 100 %
      weiter, mit 'Größe' -- und \n `~^_
  ```

7. sieben

8. acht

   mit Absatz

> Ein *Zitat*.
>
> - Liste

***

| Größe $x$ | links | Mitte | rechts |
|---|:--|:-:|--:|
| $a_1 · b_1 (c_1)$ | `a\|b` | *c* & [](#delta) | 1,5 |
| [-1] | * | 2°30' | 10 |

    0123456789012345678901234567890123456789012345678901234567890123456789012345678901234567890123456789
    !"#$%&'()*+,-./0123456789:;<=>?@ABCDEFGHIJKLMNOPQRSTUVWXYZ[\]^_`abcdefghijklmnopqrstuvwxyz{|}~ äöüÄÖÜß

    der letzte
"""

_MARKS = [*"*_`~<>[]()|#+-=.:!&\\/'\"^%{}@, \n", "a", "b1", "ä", "\u00a0", "&amp;", "&#42;", "&#32;", "<b>"]
_BLOCKS = [
    "    ",
    "\n\n",
    "- ",
    "1. ",
    "2) ",
    "> ",
    "```\n",
    "\\\n",
    "***",
    "---\n",
    "# ",
    "|a|b|\n|-|:-:|\n",
]
_WORDS = ["**", "*a*", "*a b*", "__c__", "`` ` ``", "[a](http://b.de/(c_d))", "[c]: http://d.de\n", "[c]"]
_PIECES = st.sampled_from(_MARKS + _BLOCKS + _WORDS)
TEXTS = st.one_of(st.text(max_size=40), st.lists(_PIECES, max_size=25).map("".join))

_Kind = Literal["table", "figure", "chapter"]
_PARTS: dict[str, tuple[_Kind, str, int]] = {
    "delta": ("table", "tab", 3),
    "drive": ("figure", "fig", 1),
    "start": ("chapter", "ch", 2),
}
_TARGETS = {
    "latex": "{}:{}",
    "typst": "{}-{}",
    "html": "#{}-{}",
    "markdown": "02-x.md#{}-{}",
    "text": "{}{}",
    "rst": "{}-{}",
}
_NAMES = {"table": "Tabelle", "figure": "Abbildung", "chapter": "Kapitel"}


class Parts:
    """Finds the parts of a handbook for one format."""

    def __init__(self, form: str) -> None:
        self.form = form

    def __call__(self, name: str) -> Reference:
        if name not in _PARTS:
            raise kurbel.KurbelError(f"no part has the name {name}")
        kind, prefix, number = _PARTS[name]
        target = _TARGETS[self.form].format(prefix, name)
        return Reference(kind, target, f"{_NAMES[kind]} {number}")


class Characters(HTMLParser):
    """What a page of HTML shows, without white space."""

    def __init__(self, page: str) -> None:
        super().__init__()
        self.found = ""
        self.feed(page)
        self.close()

    def handle_data(self, data: str) -> None:
        """Gather the characters between tags."""
        self.found += "".join(data.split())


def shown(page: str) -> str:
    return Characters(page).found


def parsed(text: str) -> Any:
    """Return the blocks of a text, or none if it is refused."""
    try:
        return parse_prose(text)
    except kurbel.KurbelError:
        return ()


def set_in(form: str, text: str, level: int = 1) -> str:
    """Return a text in a format; raises KurbelError if it cannot be set."""
    return set_prose(parse_prose(text), by_name(form), ",", Parts(form), level)  # type: ignore[arg-type]
