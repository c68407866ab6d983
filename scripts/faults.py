"""Runs that are killed and disturbed at random moments: the same bytes in the end, nothing half, no litter.

    make faults N=100 SEED=1

ends N runs at a random moment by `kill -9`, and every second of those again that go on: pages, drawings,
sweeps to one file, to folders, Zarr and NetCDF, handbooks, documents, and a watch. Then each job meets, once
for each hundred of them, what else may happen: signals, a full disk, a file that grows too long, a folder
that can only be read or that goes, a second writer, a locale that knows no letters, and, where a cluster may
do it, a worker and a scheduler that die. Afterwards the job is done again, or goes on, and all files are
those of a run that nobody disturbed. At no time is a file half there: it has its old content or its new one.
Ends with 1 where anything is wrong.
"""

from __future__ import annotations

import argparse
import os
import random
import re
import resource
import shlex
import shutil
import signal
import subprocess
import sys
import time
from collections import Counter
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass, field
from functools import cached_property
from hashlib import sha256
from pathlib import Path
from tempfile import TemporaryDirectory

from tabulate import tabulate

# Seconds in which processes notice that the one that started them is gone, and in which anything ends.
PATIENCE, LONGEST = 60.0, 900.0
# Bytes of a disk with enough of them.
ROOM = 1 << 30
ENVIRONMENT = {**os.environ, "SOURCE_DATE_EPOCH": "1000000000", "PYTHONHASHSEED": "0"}
LOCALE_C = {"LC_ALL": "C", "LANG": "C", "PYTHONUTF8": "0", "PYTHONCOERCECLOCALE": "0"}
OLD = "what stood there before\n"
# What a handbook knows of its last build depends on when that was.
STATE = ".kurbel"
DOCUMENT_NAMES = "book/pages/[^/]+"
MANIFEST = """\
title = "Tafeln"
formats = ["text", "csv", "html", "latex"]
[[chapter]]
title = "Bewegung"
""" + "".join(
    f'[[chapter.part]]\nrun = "table --ratio 1:{length} --step 10"\nname = "motion-{length}"\n'
    for length in range(3, 9)
)
DOCUMENT = "# Notes\n\n" + "".join(
    f"<!-- kurbel: table --ratio 1:{length} -->\n{OLD}<!-- /kurbel -->\n\n" for length in range(3, 9)
)
SWEEP = "sweep table --ratio 1:3..8:0.1 --step 0.05 --columns x,c,p"
State = Mapping[str, str]


@dataclass
class Job:
    """What is run in a folder, and what then is run there after it was disturbed."""

    name: str
    words: str
    again: str = ""
    files: Mapping[str, str] = field(default_factory=dict)
    # It ends by a signal alone.
    endless: bool = False

    def __post_init__(self) -> None:
        self._place = TemporaryDirectory(prefix="kurbel-calm-")

    @property
    def is_sweep(self) -> bool:
        return self.words.startswith("sweep")

    @property
    def by_cluster(self) -> bool:
        return self.is_sweep or self.words.startswith("handbook build")

    def line(self, again: bool = False, more: str = "") -> list[str]:
        words = (self.again or self.words) if again else self.words
        return [sys.executable, "-m", "kurbel", *shlex.split(f"{words} {more}")]

    def fill(self, folder: Path) -> None:
        shutil.rmtree(folder, ignore_errors=True)
        for name, text in self.files.items():
            (folder / name).parent.mkdir(parents=True, exist_ok=True)
            (folder / name).write_text(text, encoding="utf-8")
        folder.mkdir(parents=True, exist_ok=True)

    @cached_property
    def calm(self) -> Path:
        """The folder of a run that nobody disturbs."""
        return Path(self._place.name) / "work"

    @cached_property
    def undisturbed(self) -> tuple[State, State, float]:
        """The files before and after such a run, and how long it takes, its caches warm."""
        for _ in range(2):
            self.fill(self.calm)
            before, start = state(self.calm), time.monotonic()
            line = self.line(again=self.endless)
            done = subprocess.run(line, cwd=self.calm, env=ENVIRONMENT, capture_output=True, text=True)
            seconds = time.monotonic() - start
            assert done.returncode == 0, done.stderr
        return before, state(self.calm), seconds

    @property
    def sizes(self) -> list[int]:
        """How long the files are that such a run leaves."""
        assert self.undisturbed
        return [path.stat().st_size for path in self.calm.rglob("*") if path.is_file()]


def sweep(name: str, target: str, words: str = SWEEP) -> Job:
    return Job(name, f"{words} -o {target}", f"{words} -o {target} --resume")


JOBS = (
    Job("page", "table --ratio 1:5 -o page.html", files={"page.html": OLD}),
    Job("drawing", "forces --eps 4 --ratio 1:5 -o forces.svg", files={"forces.svg": OLD}),
    Job("PDF", "table --ratio 1:5 -o page.pdf", files={"page.pdf": OLD}),
    Job("long page", "table --ratio 1:5 --step 0.002 -o long.csv", files={"long.csv": OLD}),
    sweep("sweep in threads", "s.parquet"),
    sweep("sweep in processes", "s.parquet", "sweep harmonics --ratio 1:3..8:0.02"),
    sweep("sweep to a folder", "parts/"),
    sweep("sweep to Zarr", "s.zarr"),
    sweep("sweep to NetCDF", "s.nc"),
    Job("handbook", "handbook build book", files={"book/handbook.toml": MANIFEST}),
    Job("documents", "inject a.md b.md", files={"a.md": DOCUMENT, "b.md": DOCUMENT}),
    Job(
        "watch", "handbook watch book", "handbook build book", {"book/handbook.toml": MANIFEST}, endless=True
    ),
)


def state(folder: Path) -> State:
    """Return the files of a folder, each with a hash of what stands in it."""
    found = {}
    for path in sorted(folder.rglob("*")):
        name = path.relative_to(folder)
        if STATE not in name.parts and path.is_file():
            found[name.as_posix()] = sha256(path.read_bytes()).hexdigest()
    return found


def started(
    line: list[str],
    folder: Path,
    *,
    most: int | None = None,
    quiet: bool = False,
    variables: Mapping[str, str] = {},
) -> subprocess.Popen[str]:
    """Start a program, which can write files of so many bytes at most."""

    def ready() -> None:
        for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
            signal.signal(number, signal.SIG_DFL)
        if most is not None:
            resource.setrlimit(resource.RLIMIT_FSIZE, (most, most))

    return subprocess.Popen(
        line, cwd=folder, env={**ENVIRONMENT, **variables}, preexec_fn=ready, start_new_session=True,
        stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL if quiet else subprocess.PIPE, text=True,
    )  # fmt: skip


def ended(process: subprocess.Popen[str], after: float, number: int) -> tuple[int, str]:
    """Send a signal after some seconds; return the exit code and standard error, once all processes went."""
    try:
        process.wait(after)
    except subprocess.TimeoutExpired:
        process.send_signal(number)
    try:
        _, said = process.communicate(timeout=LONGEST)
    finally:
        wait_for_the_others(process.pid)
    return process.returncode, said


def wait_for_the_others(group: int) -> None:
    """Return when no process of a group runs; they end with the one that started them."""
    end = time.monotonic() + PATIENCE
    while time.monotonic() < end:
        try:
            os.killpg(group, 0)
        except ProcessLookupError:
            return
        time.sleep(0.01)
    os.killpg(group, signal.SIGKILL)
    raise SystemExit(f"processes that an ended run had started still ran {PATIENCE:.0f} s later")


class Wrong(Exception):
    """What a disturbed run left, or said, and should not have."""


def check_whole(job: Job, folder: Path, code: int = 0) -> None:
    """Raise Wrong for a file that has neither its old content nor its new one.

    A handbook that fails, in part, goes on: its documents and their list say what is missing.
    """
    before, after, _ = job.undisturbed
    found = state(folder)
    for name, content in found.items():
        tells = code and re.fullmatch(DOCUMENT_NAMES, name)
        if name in after and content not in (before.get(name), after[name]) and not tells:
            raise Wrong(f"{name} is half there")
    if job.is_sweep and found.keys() & after.keys() not in (set(), {*after}):
        raise Wrong(f"of the files of a sweep {len(found.keys() & after.keys())} are there")


def check_said(said: str, code: int, *codes: int) -> None:
    """Raise Wrong for a traceback, another exit code and an error without a sentence."""
    if "Traceback" in said:
        raise Wrong(f"a traceback: {said[-400:]}")
    if code not in codes:
        raise Wrong(f"ended with {code}: {said[-400:]}")
    if code in (1, 2) and not said.startswith("kurbel: "):
        raise Wrong(f"ended with {code} and said {said[-400:]!r}")


def check_clean(job: Job, folder: Path, said: str) -> None:
    """Raise Wrong for a file that was there neither before nor after, but for the parts of a sweep."""
    before, after, _ = job.undisturbed
    left = [
        name for name in state(folder)
        if name not in before and name not in after and not (job.is_sweep and ".parts" in name)
    ]  # fmt: skip
    if left:
        raise Wrong(f"left {', '.join(left[:3])}: {said[-200:]}")


def go_on(job: Job, folder: Path) -> None:
    """Do the job again; raise Wrong where the files are not those of a run that nobody disturbed."""
    line = job.line(again=True)
    done = subprocess.run(line, cwd=folder, env=ENVIRONMENT, capture_output=True, text=True)
    if done.returncode:
        raise Wrong(f"cannot go on: {done.stderr[-400:]}")
    found, wanted = state(folder), job.undisturbed[1]
    if found != wanted:
        differ = sorted(name for name in {*found, *wanted} if found.get(name) != wanted.get(name))
        raise Wrong(f"other bytes, or left: {', '.join(differ[:3])}")


def moment(job: Job, chance: random.Random) -> float:
    """Return some seconds within a run, half of them in its last part, where files are written."""
    return chance.uniform(chance.choice((0, 0.6)), 1.02) * job.undisturbed[2]


# What may happen.


def kill(job: Job, folder: Path, chance: random.Random) -> None:
    again = False
    while True:
        process = started(job.line(again and job.is_sweep), folder)
        code, said = ended(process, moment(job, chance), signal.SIGKILL)
        check_said(said, code, 0, -signal.SIGKILL)
        check_whole(job, folder)
        if code == 0 or chance.random() < 0.5:
            return
        again = True


def end_by_signal(job: Job, folder: Path, chance: random.Random) -> None:
    number = chance.choice((signal.SIGINT, signal.SIGTERM, signal.SIGHUP))
    # Before Python has set its handlers the system ends it.
    code, said = ended(started(job.line(), folder), moment(job, chance), number)
    check_said(said, code, 0, 128 + number, -number)
    check_whole(job, folder)
    check_clean(job, folder, said)


def lack_room(job: Job, folder: Path, chance: random.Random) -> None:
    """A disk with less room than the job needs."""
    with mounted(folder, max(1 << 16, int(chance.random() * sum(job.sizes)))) as work:
        job.fill(work)
        fail(job, work)
        mount("-o", f"remount,size={ROOM}", str(work.parent))
        go_on(job, work)


def be_cut_short(job: Job, folder: Path, chance: random.Random) -> None:
    """No file may be longer than some of those that the job writes."""
    fail(job, folder, most=int(chance.random() * max(job.sizes)))


def write_nowhere(job: Job, folder: Path, chance: random.Random) -> None:
    """A folder that can only be read."""
    with mounted(folder, ROOM) as work:
        job.fill(work)
        mount("-o", "remount,ro", str(work.parent))
        before = state(work)
        fail(job, work)
        if state(work) != before:
            raise Wrong("wrote where nothing can be written")
        mount("-o", "remount,rw", str(work.parent))
        go_on(job, work)


def lose_the_folder(job: Job, folder: Path, chance: random.Random) -> None:
    process = started(job.line(again=job.endless), folder)
    time.sleep(moment(job, chance))
    while folder.exists():
        shutil.rmtree(folder, ignore_errors=True)
    code, said = ended(process, LONGEST, signal.SIGKILL)
    check_said(said, code, 0, 1, 2)
    if folder.exists():
        raise Wrong("the folder is there again")
    job.fill(folder)


def meet_another(job: Job, folder: Path, chance: random.Random) -> None:
    """Two writers of the same files."""
    first = started(job.line(again=job.endless), folder)
    time.sleep(moment(job, chance) / 2)
    second = started(job.line(again=job.endless), folder)
    ends = [ended(one, LONGEST, signal.SIGKILL) for one in (first, second)]
    for code, said in ends:
        check_said(said, code, 0, 1, 2)
    if all(code for code, _ in ends):
        raise Wrong(f"neither wrote: {ends[0][1]}")
    check_whole(job, folder)


def know_no_letters(job: Job, folder: Path, chance: random.Random) -> None:
    process = started(job.line(again=job.endless), folder, variables=LOCALE_C)
    code, said = ended(process, LONGEST, signal.SIGKILL)
    check_said(said, code, 0)
    if state(folder) != job.undisturbed[1]:
        raise Wrong("other bytes")


def lose_a_worker(job: Job, folder: Path, chance: random.Random) -> None:
    lose(job, folder, chance, whom=1)


def lose_the_scheduler(job: Job, folder: Path, chance: random.Random) -> None:
    lose(job, folder, chance, whom=0)


def lose(job: Job, folder: Path, chance: random.Random, whom: int) -> None:
    """Kill one of a scheduler and two workers as they make the job."""
    with TemporaryDirectory(prefix="kurbel-cluster-") as place:
        file = Path(place) / "scheduler.json"
        own = ("--host=127.0.0.1", "--no-dashboard")
        lines = [["scheduler", "--port=0", f"--scheduler-file={file}", *own]]
        lines += [["worker", f"--scheduler-file={file}", "--nthreads=1", "--no-nanny", *own]] * 2
        cluster = [started([sys.executable, "-m", "dask", *line], Path(place), quiet=True) for line in lines]
        try:
            process = started(job.line(more=f"--scheduler {file}"), folder)
            # It waits for the scheduler's file, and for workers.
            while not file.exists() and process.poll() is None:
                time.sleep(0.05)
            time.sleep(moment(job, chance))
            cluster[whom].kill()
            code, said = ended(process, LONGEST, signal.SIGKILL)
        finally:
            for one in cluster:
                one.kill()
                one.wait()
    check_said(said, code, 0, *((1,) if whom == 0 else ()))
    check_whole(job, folder)
    check_clean(job, folder, said)


def fail(job: Job, folder: Path, most: int | None = None) -> None:
    """Run a job that may fail, in a sentence."""
    code, said = ended(started(job.line(again=job.endless), folder, most=most), LONGEST, signal.SIGKILL)
    check_said(said, code, 0, 1)
    check_whole(job, folder, code)
    check_clean(job, folder, said)


@contextmanager
def mounted(folder: Path, size: int) -> Iterator[Path]:
    """A disk of its own with so much room, and a folder on it."""
    disk = folder.with_name("disk")
    disk.mkdir(exist_ok=True)
    mount("-t", "tmpfs", "-o", f"size={size}", "tmpfs", str(disk))
    try:
        yield disk / "work"
    finally:
        subprocess.run(["umount", "--lazy", str(disk)], check=True)


def mount(*words: str) -> None:
    subprocess.run(["mount", *words], check=True, capture_output=True)


def can_mount() -> bool:
    with TemporaryDirectory() as place:
        try:
            with mounted(Path(place) / "work", ROOM):
                return True
        except (OSError, subprocess.CalledProcessError):
            return False


Fault = Callable[[Job, Path, random.Random], None]
ON_DISKS: tuple[Fault, ...] = (lack_room, write_nowhere)
IN_CLUSTERS: tuple[Fault, ...] = (lose_a_worker, lose_the_scheduler)
OTHERS: tuple[Fault, ...] = (
    end_by_signal, be_cut_short, *ON_DISKS, lose_the_folder, meet_another, know_no_letters, *IN_CLUSTERS,
)  # fmt: skip


def attempts(count: int) -> Iterator[tuple[Fault, Job]]:
    """Yield so many kills, all jobs in turn, and every other fault of each job once for each hundred."""
    yield from ((kill, JOBS[number % len(JOBS)]) for number in range(count))
    others = [one for one in OTHERS if one not in ON_DISKS or can_mount()]
    if count >= 100 and len(others) < len(OTHERS):
        print("No disk can be mounted: a full one and one that can only be read are not tried.")
    for _ in range(count // 100):
        for fault in others:
            yield from ((fault, job) for job in JOBS if fault not in IN_CLUSTERS or job.by_cluster)


def main() -> int:
    reader = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    reader.add_argument("count", type=int, help="how many runs are killed")
    reader.add_argument("--seed", type=int, default=1)
    reader.add_argument("--only", default="", metavar="REGEX", help="faults and jobs: 'kill, sweep'")
    asked = reader.parse_args()
    tried, wrong = Counter[str](), Counter[str]()
    start = time.monotonic()
    with TemporaryDirectory(prefix="kurbel-faults-") as place:
        folder = Path(place) / "work"
        for number, (fault, job) in enumerate(attempts(asked.count)):
            name = fault.__name__.replace("_", " ")
            if not re.search(asked.only, f"{name}, {job.name}"):
                continue
            tried[name] += 1
            job.fill(folder)
            try:
                fault(job, folder, random.Random(f"{asked.seed} {number}"))
                if folder.exists():
                    go_on(job, folder)
            except Wrong as found:
                wrong[name] += 1
                print(f"{name}, {job.name}, number {number}, seed {asked.seed}: {found}", flush=True)
    rows = [(name, count, wrong[name]) for name, count in tried.items()]
    print(tabulate(rows, ("", "runs", "wrong")))
    print(f"seed {asked.seed}, {time.monotonic() - start:.0f} s: {wrong.total()} wrong")
    return int(wrong.total() > 0)


if __name__ == "__main__":
    sys.exit(main())
