"""Build the documentation: python docs/generate/website.py build/site [--playground].

The pages that are written by hand and those made of the program itself are laid into one folder beside the
site, and Sphinx makes the site of them, and manual pages in the folder `man` beside it.
"""

from __future__ import annotations

import shutil
import subprocess
import sys
from collections.abc import Mapping
from pathlib import Path

import gallery
import reference
from sphinx.cmd.build import build_main

DOCS = Path(__file__).parents[1]
WRITTEN = (".md", ".png", ".svg", ".css", ".js", ".html", ".py")
NOT_SHOWN = ("generate", "gallery/peers/*.py", "playground")
PLAYGROUND = DOCS / "playground" / "build.py"


# No warning is let pass, and all of them are shown.
STRICTLY = ("-W", "--keep-going", "-n", "-q")


def main() -> int:
    site = Path(sys.argv[1]).absolute()
    source, read = (site.with_name(f"{site.name}-{one}") for one in ("source", "read"))
    playable = "--playground" in sys.argv and playground(site / "playground")
    lay(pages() | {"playground.md": playground_page(playable).encode()}, source)
    # What is left of another build would be taken for a page of this one.
    for old in (read, *(one for one in site.glob("*") if one.name != "playground")):
        shutil.rmtree(old) if old.is_dir() else old.unlink(missing_ok=True)
    places = {"html": site, "man": site.with_name("man")}
    shutil.rmtree(places["man"], ignore_errors=True)
    return max(
        build_main([*STRICTLY, "-b", kind, "-d", str(read), str(source), str(place)])
        for kind, place in places.items()
    )


def playground(target: Path) -> bool:
    """Build the playground, where npm can fetch what it needs, and return whether there is one."""
    if not shutil.which("npm"):
        print("npm is not installed, and the site is built without the playground", file=sys.stderr)
        return False
    if subprocess.run([sys.executable, str(PLAYGROUND), str(target)], check=False).returncode:
        raise SystemExit("the playground could not be built; docs/generate/website.py builds the site alone")
    return True


def playground_page(playable: bool) -> str:
    about = "# Playground\n\nkurbel itself in this browser: you type a command, and see what it prints."
    if not playable:
        return f"{about}\n\nThis copy of the site is without it; `make docs` builds it, where there is npm.\n"
    link = '<a class="sd-btn sd-btn-primary" href="playground/index.html">Open the playground</a>'
    served = "```sh\npython3 -m http.server --directory build/site    # then http://localhost:8000\n```"
    own = f"On a machine of one's own browsers want it from a server:\n\n{served}"
    return f"{about}\nNothing that is typed is sent anywhere.\n\n{link}\n\n{own}\n"


def pages() -> dict[str, bytes]:
    """Return all pages of the site and what they need by their places."""
    made = {name: text.encode() for name, text in reference.pages().items()}
    changes = {"changes.md": (DOCS.parent / "CHANGELOG.md").read_bytes()}
    return by_hand() | made | changes | dict(gallery.pages())


def by_hand() -> dict[str, bytes]:
    found = {}
    for path in sorted(DOCS.rglob("*")):
        name = path.relative_to(DOCS)
        hidden = any(name.is_relative_to(one) or name.match(one) for one in NOT_SHOWN)
        if path.suffix in WRITTEN and not hidden:
            found[name.as_posix()] = path.read_bytes()
    return found


def lay(pages: Mapping[str, bytes], folder: Path) -> None:
    """Write the pages into a folder that has nothing else afterwards; what is there already is left alone."""
    for name, content in pages.items():
        path = folder / name
        if not path.exists() or path.read_bytes() != content:
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_bytes(content)
    for path in folder.rglob("*"):
        if path.is_file() and path.relative_to(folder).as_posix() not in pages:
            path.unlink()


if __name__ == "__main__":
    sys.exit(main())
