"""What the functions return: a table and a drawing that show themselves, and can be saved."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator
from dataclasses import dataclass, fields, replace
from typing import TYPE_CHECKING, Any

from kurbel.commands import frames
from kurbel.errors import ChoiceError, ProblemError
from kurbel.exact.numerals import DECIMAL_OF_LANGUAGE, DECIMALS
from kurbel.formats.registry import DEFAULT, DRAWINGS, BytesFormat, for_suffix
from kurbel.page.labels import plain
from kurbel.page.table import Table as Page
from kurbel.reading.given import choose

if TYPE_CHECKING:
    import numpy as np

    from kurbel.exact.numerals import Label
    from kurbel.plot.drawings import Drawing as Drawn
    from kurbel.plot.film import Film


@dataclass(frozen=True, slots=True, repr=False)
class Table(Page):
    """A table with its certified digits.

    `print` shows it as text and a notebook as HTML; `save` writes it in any format. It has as many rows as
    records, named tuples of floats and text, and `page["x"]` is the array of a column; pandas and polars make
    a DataFrame of it. With `exact` their numbers are Decimal, as printed. Crank ratios are text. `plot` draws
    its columns over their axis.
    """

    asked: Any = None

    @classmethod
    def of(cls, page: Page, asked: Any = None) -> Table:
        return cls(**{field.name: getattr(page, field.name) for field in fields(page)}, asked=asked)

    def plot(self, *, decimal: str | None = None, **options: Any) -> Drawing:
        """Return the page as a drawing: a panel a unit, both strokes as one turn.

        Options are width and height in mm, polar, over_path, infinite, animate and seconds, as the command
        line has them. Raises KurbelError for what cannot be drawn.
        """
        from kurbel.commands.drawn import plotted

        if self.asked is None:
            raise ProblemError("this page was not made by a command of kurbel, so it has nothing to draw")
        return plotted(self.asked, options, decimal)

    def __str__(self) -> str:
        return self.typeset()

    def __repr__(self) -> str:
        return f"<kurbel.Table {self.key}: {plain(self.caption)}>"

    def typeset(
        self,
        format: str = DEFAULT,
        *,
        decimal: str | None = None,
        standalone: bool = False,
        longtable: bool = False,
        siunitx: bool = False,
        plain: bool = False,
        excel: bool = False,
    ) -> str:
        """Return the page in a format, as `kurbel.typeset`."""
        from kurbel.formats.render import render

        return render(
            self,
            format,
            decimal=decimal,
            standalone=standalone,
            longtable=longtable,
            siunitx=siunitx,
            plain=plain,
            excel=excel,
        )

    def save(
        self,
        path: str | os.PathLike[str],
        *,
        decimal: str | None = None,
        standalone: bool = False,
        longtable: bool = False,
        siunitx: bool = False,
        plain: bool = False,
        excel: bool = False,
    ) -> None:
        """Write the page into a file, whole or not at all, in the format of its suffix.

        An interactive one is a whole document; .svg, .png and .pgf are its drawing. Raises KurbelError.
        """
        from kurbel.formats.render import whole_file

        if os.path.splitext(os.fspath(path))[1].lower()[1:] in DRAWINGS:
            self.plot(decimal=decimal).save(path)
            return
        standalone = standalone or self.steps is not None
        form = for_suffix(os.fspath(path))
        if isinstance(form, BytesFormat):
            content = form.content(self, decimal)
        else:
            content = self.typeset(
                form.name,
                decimal=decimal,
                standalone=standalone,
                longtable=longtable,
                siunitx=siunitx,
                plain=plain,
                excel=excel,
            ).encode()
        with whole_file(os.fspath(path)) as stream:
            stream.write(content)

    def __len__(self) -> int:
        return frames.count(self)

    def __bool__(self) -> bool:
        return True

    def __iter__(self) -> Iterator[Any]:
        return frames.rows(self)

    def __getitem__(self, key: str) -> np.ndarray[Any, Any]:
        return frames.column(self, key)

    def _repr_html_(self) -> str:
        from kurbel.formats.render import in_notebook

        # A notebook runs no script of a page.
        return in_notebook(replace(self, steps=None))

    def _repr_latex_(self) -> str:
        return self.typeset("latex")

    def _repr_markdown_(self) -> str:
        return self.typeset("markdown")

    def to_numpy(self) -> np.ndarray[Any, Any]:
        """Return the records as a structured array, whose fields are their keys."""
        return frames.to_numpy(self)

    def to_pandas(self, *, exact: bool = False) -> Any:
        """Return the records as a pandas DataFrame; what their columns mean is in its `attrs`."""
        return frames.to_pandas(self, exact)

    def to_polars(self, *, exact: bool = False) -> Any:
        """Return the records as a polars DataFrame."""
        return frames.to_polars(self, exact)

    def __arrow_c_stream__(self, requested_schema: object | None = None) -> object:
        """Hand the records to any library that takes Arrow; needs the extra `arrow`."""
        return frames.to_arrow(self).__arrow_c_stream__(requested_schema)


@dataclass(frozen=True, slots=True, repr=False)
class Drawing:
    """A drawing: matplotlib's figure and a title. A notebook shows it, `save` writes SVG, PNG, PDF or PGF.

    Of one that has steps or moves `page` makes an HTML page, of its SVG file. One that moves has a film, and
    is saved as GIF as well.
    """

    figure: Any
    title: Label
    lang: str
    mark: str
    about: Label = ""
    page: Callable[[str], str] | None = None
    film: Film | None = None

    @classmethod
    def of(cls, drawn: Drawn, lang: str, mark: str, page: Callable[[str], str] | None = None) -> Drawing:
        return cls(drawn.figure, drawn.title, lang, mark, drawn.about, page, drawn.film)

    def __repr__(self) -> str:
        return f"<kurbel.Drawing: {self.plain_title}>"

    @property
    def plain_title(self) -> str:
        """The title without formulas' marks, for readers that do not see the drawing."""
        return plain(self.title, self.mark)

    def image(self, format: str = "svg", *, text: bool = False) -> bytes:
        """Return the drawing as a file of the format svg, png, pdf or pgf; of SVG with `text` letters stay
        text. A construction in steps has html, too.

        One that moves has html and gif; it stands still in png, pdf and pgf. Raises KurbelError.
        """
        if self.page and format == "html" and (self.film or not text):
            return self.page(self.image(text=text).decode()).encode()
        about = plain(self.about, self.mark)
        if self.film is None:
            from kurbel.plot.style import image

            return image(self.figure, format, self.plain_title, about, text)
        return self._moving_image(format, about, text)

    def _moving_image(self, name: str, about: str, text: bool) -> bytes:
        """Return a drawing that moves as a file; in PNG, PDF and PGF it stands still."""
        from kurbel.plot.film import as_it_stands, moving
        from kurbel.plot.style import FORMATS, MOVING, image, style

        assert self.film is not None
        choose(name, dict.fromkeys((*MOVING, *FORMATS)), "drawing format")
        if name == "gif":
            if text:
                raise ChoiceError(
                    "--text is for SVG, whose letters are outlines without it; leave it out for gif"
                )
            from kurbel.plot.frames import gif

            with style():
                return gif(self.figure, self.film)
        if name != "svg":
            with as_it_stands(self.film):
                return image(self.figure, name, self.plain_title, about, text)
        still = image(self.figure, "svg", self.plain_title, about, text).decode()
        return moving(still, self.film, self.figure).encode()

    def save(self, path: str | os.PathLike[str], *, text: bool = False) -> None:
        """Write the drawing into a file, whole or not at all, in the format of its suffix.

        With `text` the letters of SVG stay text, which can be searched and edited. Raises KurbelError.
        """
        from kurbel.formats.render import whole_file
        from kurbel.plot.style import format_of

        name = os.fspath(path)
        is_page = self.page and name.lower().endswith((".html", ".htm"))
        form = "html" if is_page else format_of(name, moves=self.film is not None)
        content = self.image(form, text=text)
        with whole_file(os.fspath(path)) as stream:
            stream.write(content)

    def _repr_svg_(self) -> str:
        return self.image().decode()


def mark_of(lang: str, decimal: str | None) -> str:
    """Return the decimal mark of that name, by default that of the language."""
    return DECIMALS[decimal or DECIMAL_OF_LANGUAGE[lang]]
