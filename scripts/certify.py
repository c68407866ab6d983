"""Printed numbers, drawn over all commands, drives, loads and layouts, computed a second time.

    make certify N=10000 SEED=1

draws command lines of scripts/corpus that print a page, and lets `kurbel verify` compute the numbers of its
JSON once more, until N cells were looked at. Prints for each command how many are confirmed, wrong and not
computed, and of the last why not. Ends with 1 where any is wrong.
"""

from __future__ import annotations

import argparse
import random
import sys
import tempfile
from collections import Counter, defaultdict
from collections.abc import Iterable, Iterator
from contextlib import chdir
from itertools import islice
from pathlib import Path
from shutil import copytree

from command_lines import CORPUS, command_lines, commands_of
from same_bytes import kurbel

from kurbel.cli.asking import printing_commands
from kurbel.commands.verified import Cell, checked, read_page
from kurbel.verify import CONFIRMED, UNDECIDED, WRONG

# A page of so many cells has shown what it can.
MOST = 400


def pages(seed: int, only: str) -> Iterator[tuple[str, str, Iterable[Cell]]]:
    """Yield command, line and cells of the pages of numbers, in an order drawn by the seed."""
    known = printing_commands()
    lines = [line for line in command_lines() if line.partition(" ")[0] in known and " && " not in line]
    random.Random(seed).shuffle(lines)
    for line in lines:
        if not line.startswith(only):
            continue
        (command,) = commands_of(line)
        code, out, _ = kurbel((*command.words, "-f", "json", "-o", "-"), {})
        if code == 0 and out.startswith(b'{\n"table"'):
            page = Path("page.json")
            page.write_bytes(out)
            yield command.words[0], line, islice(checked(read_page(str(page))), MOST)


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("count", type=int)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--only", default="", help="what the lines begin with")
    asked = parser.parse_args()
    counted: dict[str, Counter[str]] = defaultdict(Counter)
    reasons: dict[str, Counter[str]] = defaultdict(Counter)
    looked = 0
    with tempfile.TemporaryDirectory() as work, chdir(work):
        copytree(CORPUS / "files", work, dirs_exist_ok=True)
        for name, line, cells in pages(asked.seed, asked.only):
            for cell in cells:
                looked += 1
                counted[name][cell.verdict] += 1
                if cell.verdict == WRONG:
                    print(f"{line}\n    {cell.place}: {cell.key} is {cell.printed}, right is {cell.told}")
                elif cell.verdict == UNDECIDED:
                    reasons[name][f"{cell.key}: {cell.told}"] += 1
            if looked >= asked.count:
                break
    for name, counts in sorted(counted.items()):
        share = counts[CONFIRMED] / counts.total()
        print(f"{name:12} {counts.total():7} cells {share:6.1%} confirmed, {counts[WRONG]} wrong")
        for reason, number in reasons[name].most_common():
            print(f"{number:20} {reason}")
    wrong = sum(counts[WRONG] for counts in counted.values())
    print(f"{looked} cells, {wrong} wrong")
    return int(bool(wrong))


if __name__ == "__main__":
    sys.exit(main())
