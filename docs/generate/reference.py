"""The reference: pages made of the program itself. `python docs/generate/reference.py` prints them all."""

from __future__ import annotations

import sys

import commands
import files
import functions
import registries


def pages() -> dict[str, str]:
    """Return the pages by their places in docs."""
    return {name: text for part in (commands, functions, registries, files) for name, text in part.pages()}


if __name__ == "__main__":
    sys.stdout.write("\n".join(pages().values()))
