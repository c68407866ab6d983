"""The files of a drawing that moves: SVG and GIF; in PNG, PDF and PGF it stands still."""

from __future__ import annotations

from typing import TYPE_CHECKING

from kurbel.errors import ChoiceError
from kurbel.reading.given import choose

if TYPE_CHECKING:
    from kurbel.commands.shown import Drawing


def file_of(drawing: Drawing, name: str, about: str, text: bool) -> bytes:
    """Return a drawing that moves as a file of a format. Raises KurbelError."""
    from kurbel.plot.film.model import as_it_stands
    from kurbel.plot.film.svg import moving
    from kurbel.plot.style import FORMATS, MOVING, image, style

    film, figure = drawing.film, drawing.figure
    assert film is not None
    choose(name, dict.fromkeys((*MOVING, *FORMATS)), "drawing format")
    if name == "gif":
        if text:
            raise ChoiceError(
                "--text is for SVG, whose letters are outlines without it; leave it out for gif"
            )
        from kurbel.plot.film.frames import gif

        with style():
            return gif(figure, film)
    if name != "svg":
        with as_it_stands(film):
            return image(figure, name, drawing.plain_title, about, text)
    return moving(image(figure, "svg", drawing.plain_title, about, text).decode(), film, figure).encode()
