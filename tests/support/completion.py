"""What a shell is told of the commands that there are, and of their options."""

from __future__ import annotations

from cli import printed


def described(*words: str) -> dict[str, str]:
    """Return what zsh would offer for the last word, each with what is said of it."""
    line = " ".join(("kurbel", *words))
    lines = printed(
        _KURBEL_COMPLETE="zsh_complete", COMP_WORDS=line, COMP_CWORD=str(len(words))
    ).out.splitlines()
    # Three lines an entry: kind, word, description.
    return dict(zip(lines[1::3], lines[2::3], strict=True))


COMMANDS = tuple(described(""))
# Those of `sweep` are those that print a table.
GROUPS = ("handbook", "sweep")
PRINTING = tuple(described("sweep", ""))
EVERY = (*((one,) for one in COMMANDS), *((one, below) for one in GROUPS for below in described(one, "")))
