"""Set a few tables with kurbel and each of its peers, in every medium, and lay the pictures side by side.

python docs/gallery/peers writes the pictures beside its own files; it needs the dependency group `peers`,
Chromium, TeX and poppler. docs/gallery/peers.md says what is seen in them.
"""

from __future__ import annotations

import base64
import html
import io
import subprocess
import tempfile
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from importlib import import_module, metadata
from pathlib import Path
from typing import Any, Literal

import makers
from data import LONG, TALL, USUAL, WIDE, Case
from playwright.sync_api import Browser, sync_playwright

PICTURES = Path(__file__).parent
Makers = Mapping[str, Callable[[Case], str]]
TEXT: Makers = {
    "kurbel": makers.kurbel_text, "rich": makers.rich_text, "tabulate": makers.tabulate_text,
}  # fmt: skip
HTML: Makers = {
    "kurbel": makers.kurbel_html, "great_tables": makers.great_tables_html, "pandas": makers.pandas_html,
}  # fmt: skip
LATEX: Makers = {
    "kurbel": makers.kurbel_latex, "by hand": makers.hand_latex, "great_tables": makers.great_tables_latex,
    "pandas": makers.pandas_latex,
}  # fmt: skip
TYPST: Makers = {"kurbel": makers.kurbel_typst, "by hand": makers.hand_typst}
PAGE = (
    "<!doctype html><meta charset='utf-8'><style>body{margin:0;padding:12px;background:%s;color:%s}</style>%s"
)
# The width of a picture, and that of the screens.
SHOWN, DESKTOP, TELEPHONE, HIGH = 640, 900, 390, 844


def main() -> None:
    with browser() as tab:
        terminal = {name: shot(tab, console(made(USUAL)), width=SHOWN + 80) for name, made in TEXT.items()}
        montage(tab, "terminal", terminal)
        for scheme in ("light", "dark"):
            montage(
                tab,
                f"html-{scheme}",
                {name: shot(tab, made(USUAL), scheme=scheme) for name, made in HTML.items()},
            )
        phones = {name: phone(tab, made(USUAL)) for name, made in HTML.items()}
        montage(tab, "phone", phones, width=300)
        montage(tab, "print", {name: printed(tab, made(USUAL)) for name, made in HTML.items()})
        montage(tab, "latex", {name: by_tex(made(USUAL)) for name, made in LATEX.items()})
        montage(tab, "typst", {name: by_typst(made(USUAL)) for name, made in TYPST.items()})
        # What a page ends with is seen, too.
        for one, case in (("tall", TALL), ("wide", WIDE), ("long", LONG)):
            pages = {name: sheets(pdf_by_tex(made(case))) for name, made in LATEX.items()}
            montage(tab, f"latex-{one}", pages, width=900 if one != "wide" else 660, across=2)
        montage(tab, "wide", {name: shot(tab, made(WIDE)) for name, made in HTML.items()})
        montage(tab, "wide-phone", {name: phone(tab, made(WIDE)) for name, made in HTML.items()}, width=300)
        papers = {name: sheets(pdf_of(tab, made(LONG))) for name, made in HTML.items()}
        montage(tab, "long-print", papers, width=900, across=1)


@contextmanager
def browser() -> Iterator[Browser]:
    flags = [
        "--headless",
        "--no-sandbox",
        "--disable-gpu",
        "--no-first-run",
        "--disable-background-networking",
    ]
    with sync_playwright() as playwright:
        opened = playwright.chromium.launch(executable_path="/usr/bin/chromium", args=flags)
        yield opened
        opened.close()


def console(text: str) -> str:
    """Return a terminal that shows a text, as a page."""
    ansi = import_module("rich.text").Text.from_ansi(text)
    stream = import_module("rich.console").Console(
        file=io.StringIO(), record=True, width=makers.COLUMNS + 2, force_terminal=True
    )
    stream.print(ansi)
    code = "<pre style=\"margin:0;font:14px/1.25 'DejaVu Sans Mono'\">{code}</pre>"
    return PAGE % ("#fff", "#000", stream.export_html(inline_styles=True, code_format=code))


def shot(tab: Browser, page: str, width: int = DESKTOP, scheme: Literal["light", "dark"] = "light") -> bytes:
    view = tab.new_page(viewport={"width": width, "height": 600}, color_scheme=scheme)
    view.set_content(page)
    picture = view.screenshot(full_page=True)
    view.close()
    return picture


def phone(tab: Browser, page: str) -> bytes:
    """Return the screen of a telephone after one swipe, which is where a table is read."""
    size: Any = {"width": TELEPHONE, "height": HIGH}
    view = tab.new_page(viewport=size, device_scale_factor=2, is_mobile=True, has_touch=True)
    view.set_content(page)
    view.mouse.move(TELEPHONE / 2, HIGH / 2)
    view.mouse.wheel(0, 420)
    view.wait_for_function("() => true")
    picture = view.screenshot()
    view.close()
    return picture


def printed(tab: Browser, page: str) -> bytes:
    return rendered(pdf_of(tab, page))


def pdf_of(tab: Browser, page: str) -> bytes:
    view = tab.new_page()
    view.set_content(page)
    content = view.pdf(format="A4", margin={"top": "2cm", "bottom": "2cm", "left": "2cm", "right": "2cm"})
    view.close()
    return content


def by_tex(document: str) -> bytes:
    return rendered(pdf_by_tex(document))


def pdf_by_tex(document: str) -> bytes:
    with tempfile.TemporaryDirectory() as folder:
        Path(folder, "page.tex").write_text(document, encoding="utf-8")
        run = ["pdflatex", "-interaction=nonstopmode", "page.tex"]
        for _ in range(2):
            ended = subprocess.run(run, cwd=folder, capture_output=True, check=False)
        if not (made := Path(folder, "page.pdf")).exists():
            raise SystemExit(ended.stdout.decode("latin-1")[-2000:])
        return made.read_bytes()


def by_typst(document: str) -> bytes:
    return rendered(import_module("typst").compile(document.encode()))


def rendered(document: bytes) -> bytes:
    """Return the first page of a PDF, without the empty margins."""
    run = ["pdftoppm", "-png", "-r", "150", "-singlefile", "-"]
    content = subprocess.run(run, input=document, capture_output=True, check=True).stdout
    images, chops = import_module("PIL.Image"), import_module("PIL.ImageChops")
    picture = images.open(io.BytesIO(content)).convert("RGB")
    left, top, right, bottom = chops.invert(picture).getbbox()
    stream = io.BytesIO()
    picture.crop((left - 40, top - 40, right + 40, bottom + 40)).save(stream, "PNG")
    return stream.getvalue()


def sheets(document: bytes) -> bytes:
    """Return the first two pages of a PDF beside each other, as they are."""
    images = import_module("PIL.Image")
    with tempfile.TemporaryDirectory() as folder:
        run = ["pdftoppm", "-png", "-r", "80", "-l", "2", "-", f"{folder}/page"]
        subprocess.run(run, input=document, capture_output=True, check=True)
        pages = [images.open(path).convert("RGB") for path in sorted(Path(folder).glob("*.png"))]
    width, height = (max(sizes) for sizes in zip(*(one.size for one in pages), strict=True))
    both = images.new("RGB", (len(pages) * (width + 4) - 4, height), "#cccccc")
    for place, one in enumerate(pages):
        both.paste(one, (place * (width + 4), 0))
    stream = io.BytesIO()
    both.save(stream, "PNG")
    return stream.getvalue()


def montage(
    tab: Browser, name: str, pictures: Mapping[str, bytes], width: int = SHOWN, across: int = 0
) -> None:
    """Write the pictures side by side, or so many `across`, each under its name and version."""
    figures = "".join(
        f"<figure><figcaption>{html.escape(versioned(one))}</figcaption>"
        f"<img width={width} src='data:image/png;base64,{base64.b64encode(picture).decode()}'></figure>"
        for one, picture in pictures.items()
    )
    count = across or len(pictures)
    style = (
        f"<style>body{{display:grid;gap:16px;align-items:start;grid:auto/repeat({count},{width}px)}}"
        "figcaption{font:15px sans-serif;margin-bottom:8px}figure{margin:0}"
        "img{border:1px solid #ccc;box-sizing:border-box}</style>"
    )
    content = shot(tab, PAGE % ("#fff", "#000", style + figures), width=count * (width + 16) + 8)
    images = import_module("PIL.Image")
    picture = images.open(io.BytesIO(content)).convert("RGB").quantize(64)
    picture.save(PICTURES / f"{name}.png", optimize=True)


def versioned(name: str) -> str:
    if name in ("kurbel", "by hand"):
        return name
    return f"{name} {metadata.version(name.replace('_', '-'))}"


if __name__ == "__main__":
    main()
