"""Runs of sweeps on this machine: what becomes of their parts, and the same bytes however they ended."""

from __future__ import annotations

import errno
import json
import os
import resource
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from threading import Event
from typing import Any

import pyarrow.dataset
import pyarrow.parquet
import pytest
from small_parts import DEADLY, KILLS, InThreads, Running, SmallParts, StoppedError, plan_of, run, small

import kurbel
from kurbel.sweeps.hands import Threads
from kurbel.sweeps.parts import Parts

SWEEP = SmallParts(plan_of(6))
PARTS = 9


@pytest.fixture(scope="module")
def whole(tmp_path_factory: pytest.TempPathFactory) -> bytes:
    """What a run that nothing disturbed writes."""
    target = tmp_path_factory.mktemp("whole") / "delta.parquet"
    outcome = run(SWEEP, str(target), Running(jobs=1))
    # Without expansion there is no best back pressure.
    ((said, refused),) = outcome.refused.items()
    assert (outcome.rows, refused, said[:24]) == (18, 3, "expansion ratio ε = 1 at")
    assert [path.name for path in target.parent.iterdir()] == ["delta.parquet"]
    return target.read_bytes()


@pytest.fixture
def target(tmp_path: Path) -> str:
    return str(tmp_path / "delta.parquet")


def stopped_after(count: int, error: BaseException | Callable[[], None]) -> Callable[[int], None]:
    """Return what raises an error, or does something, when so many parts are done."""
    seen = []

    def watch(rows: int) -> None:
        seen.append(rows)
        if len(seen) == count:
            if isinstance(error, BaseException):
                raise error
            error()

    return watch


def ended(target: str, parts: int = 4) -> str:
    """End a run by Ctrl-C when so many parts are done, and return what is said."""
    with pytest.raises(StoppedError) as raised:
        run(SWEEP, target, Running(jobs=1, watch=stopped_after(parts, KeyboardInterrupt())))
    assert not Path(target).exists()
    return str(raised.value)


def computed(monkeypatch: pytest.MonkeyPatch) -> list[int]:
    """Return a list to which the first row of each part goes as it is computed."""
    starts: list[int] = []
    part = SmallParts.computed

    def noted(self: SmallParts, start: int, stop: int) -> Any:
        starts.append(start)
        return part(self, start, stop)

    monkeypatch.setattr(SmallParts, "computed", noted)
    return starts


def test_a_run_that_was_ended_goes_on_with_its_parts(
    target: str, whole: bytes, monkeypatch: pytest.MonkeyPatch
) -> None:
    folder = f"{target}.parts"
    said = f"stopped; finished parts are kept in {folder}: the same command with --resume goes on"
    assert ended(target) == said
    with pytest.raises(kurbel.KurbelError, match="--resume goes on with them, --restart begins anew"):
        run(SWEEP, target)
    starts = computed(monkeypatch)
    run(SWEEP, target, Running(jobs=1, resume=True))
    assert starts == [8, 10, 12, 14, 16]
    assert Path(target).read_bytes() == whole
    assert os.listdir(os.path.dirname(target)) == ["delta.parquet"]


def test_a_run_can_begin_anew(target: str, whole: bytes, monkeypatch: pytest.MonkeyPatch) -> None:
    ended(target)
    starts = computed(monkeypatch)
    run(SWEEP, target, Running(jobs=1, restart=True))
    assert len(starts) == PARTS
    assert Path(target).read_bytes() == whole


def test_without_a_finished_part_nothing_is_left(target: str) -> None:
    with pytest.MonkeyPatch.context() as patch, pytest.raises(KeyboardInterrupt):
        patch.setattr(SmallParts, "computed", lambda *rows: stopped_after(1, KeyboardInterrupt())(0))
        run(SWEEP, target, Running(jobs=1))
    assert os.listdir(os.path.dirname(target)) == []


@pytest.mark.parametrize("cut", ["shorter", "other"])
def test_a_broken_part_is_computed_again(
    cut: str, target: str, whole: bytes, monkeypatch: pytest.MonkeyPatch
) -> None:
    ended(target)
    broken = sorted(Path(f"{target}.parts").rglob("*.arrow"))[2]
    content = broken.read_bytes()
    broken.write_bytes(content[:-9] if cut == "shorter" else bytes(len(content)))
    starts = computed(monkeypatch)
    run(SWEEP, target, Running(jobs=1, resume=True))
    assert starts == [4, 8, 10, 12, 14, 16]
    assert Path(target).read_bytes() == whole


def test_parts_of_another_sweep_or_of_other_libraries_are_refused_and_stay(target: str, whole: bytes) -> None:
    ended(target)
    with pytest.raises(
        kurbel.KurbelError, match="has parts of another sweep; give what that run was given, or --restart"
    ):
        run(SmallParts(plan_of(7)), target, Running(resume=True))
    noted = Path(f"{target}.parts/sweep.json")
    mine = noted.read_text()
    noted.write_text(json.dumps(json.loads(mine) | {"numpy": "1.0"}))
    with pytest.raises(
        kurbel.KurbelError, match=r"were computed by numpy 1\.0 in place of [2-9].*with --restart"
    ):
        run(SWEEP, target, Running(resume=True))
    noted.write_text(mine)
    run(SWEEP, target, Running(jobs=1, resume=True))
    assert Path(target).read_bytes() == whole


def test_parts_of_a_card_that_has_changed_are_those_of_another_sweep(target: str, tmp_path: Path) -> None:
    card, head = tmp_path / "card.csv", "position [%];p_forward [bar];p_return [bar]\n"
    card.write_text(head + "".join(f"{place};8.0;1.5\n" for place in range(0, 101, 10)))
    sweep = small(ratio=["1:4;1:5;1:6"], cylinder=f"card={card}")
    with pytest.raises(StoppedError):
        run(sweep, target, Running(jobs=1, watch=stopped_after(1, KeyboardInterrupt())))
    card.write_text(card.read_text().replace("8.0", "7.0"))
    with pytest.raises(kurbel.KurbelError, match="has parts of another sweep"):
        run(small(ratio=["1:4;1:5;1:6"], cylinder=f"card={card}"), target, Running(resume=True))


def test_a_second_run_of_one_target_is_refused(target: str, whole: bytes) -> None:
    def again() -> None:
        with pytest.raises(kurbel.KurbelError, match=rf"another run writes {target} at this moment"):
            run(SWEEP, target)

    run(SWEEP, target, Running(jobs=1, watch=stopped_after(2, again)))
    assert Path(target).read_bytes() == whole


def test_a_folder_of_ones_own_is_left_as_it_is(target: str, whole: bytes) -> None:
    own = Path(f"{target}.parts/of-mine.txt")
    own.parent.mkdir()
    own.write_text("mine")
    run(SWEEP, target, Running(jobs=1))
    assert Path(target).read_bytes() == whole
    assert [path.name for path in own.parent.iterdir()] == ["of-mine.txt"]


def test_a_full_disk_is_one_sentence_and_parts_stay(target: str, whole: bytes) -> None:
    soft, hard = resource.getrlimit(resource.RLIMIT_FSIZE)

    def fill() -> None:
        resource.setrlimit(resource.RLIMIT_FSIZE, (100, hard))

    try:
        with pytest.raises(kurbel.KurbelError) as raised:
            run(SWEEP, target, Running(jobs=1, watch=stopped_after(3, fill)))
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, (soft, hard))
    folder = f"{target}.parts"
    said = f"{os.strerror(errno.EFBIG)}; finished parts are kept in {folder}: the same command with --resume"
    assert said in str(raised.value)
    assert str(raised.value).startswith("cannot write ")
    assert len([*Path(folder).rglob("*.arrow*")]) == 3
    run(SWEEP, target, Running(jobs=1, resume=True))
    assert Path(target).read_bytes() == whole


def test_few_parts_of_the_largest_sweep_are_asked_for_at_once(
    target: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    endless = SmallParts(plan_of(10**9, "0.00000001"))
    starts = computed(monkeypatch)
    with pytest.raises(StoppedError):
        run(endless, target, Running(jobs=1, watch=stopped_after(3, KeyboardInterrupt())))
    assert starts == [0, 2, 4]


@pytest.mark.slow
def test_threads_processes_and_one_that_dies_give_the_same_bytes(
    target: str, whole: bytes, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    kills = tmp_path / KILLS
    kills.touch()
    sweep = SmallParts(plan_of(DEADLY + 4))
    run(sweep, "deadly.parquet", Running(jobs=2))
    assert not kills.exists()
    run(sweep, "calm.parquet", Running(jobs=1))
    run(InThreads(sweep.plan), "threads.parquet", Running(jobs=3))
    assert Path("deadly.parquet").read_bytes() == Path("calm.parquet").read_bytes()
    assert Path("threads.parquet").read_bytes() == Path("calm.parquet").read_bytes()


def small_partitions(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("kurbel.sweeps.arrow.GROUP", 4)
    monkeypatch.setattr("kurbel.sweeps.arrow.GROUPS", 2)
    monkeypatch.setattr("kurbel.sweeps.parts.ROWS", 8)


def test_a_second_ctrl_c_finds_threads_that_leave_their_partitions(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    small_partitions(monkeypatch)
    begun, stopped, impatient = Event(), Event(), [KeyboardInterrupt()]
    starts, part, let_go = computed(monkeypatch), SmallParts.computed, Threads.let_go
    shutdown = ThreadPoolExecutor.shutdown

    def waiting(self: SmallParts, start: int, stop: int) -> Any:
        if start == 8:
            begun.set()
        # The first partition is done in the middle of the second one, which goes on when the run is stopped.
        assert (begun if start < 8 else stopped).wait(5)
        return part(self, start, stop)

    def left(self: Threads) -> None:
        let_go(self)
        stopped.set()

    def interrupted(self: ThreadPoolExecutor, **options: bool) -> None:
        if impatient:
            raise impatient.pop()
        shutdown(self, **options)

    target, sweep = f"{tmp_path}/out/", InThreads(plan_of(6))
    with monkeypatch.context() as patch, pytest.raises(StoppedError, match="--resume goes on"):
        patch.setattr(SmallParts, "computed", waiting)
        patch.setattr(Threads, "let_go", left)
        patch.setattr(ThreadPoolExecutor, "shutdown", interrupted)
        run(sweep, target, Running(jobs=2, watch=stopped_after(1, KeyboardInterrupt())))
    assert not {10, 12, 14} & {*starts} and not impatient
    # The third partition has one part, and may have been begun as well.
    kept = {int(path.name.partition(".")[0]) for path in Path(f"{tmp_path}/out.parts").rglob("*.parquet")}
    assert 0 in kept <= {0, 2}
    assert run(sweep, target, Running(jobs=2, resume=True)).rows == 18
    assert os.listdir(tmp_path) == ["out"]


def test_partitions_that_are_done_outlast_a_full_disk(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    small_partitions(monkeypatch)
    target, sweep, part = f"{tmp_path}/out/", InThreads(plan_of(6)), SmallParts.computed

    def full(self: SmallParts, start: int, stop: int) -> Any:
        if start == 12:
            raise OSError(errno.ENOSPC, "No space left on device")
        return part(self, start, stop)

    with (
        monkeypatch.context() as patch,
        pytest.raises(kurbel.KurbelError, match=r"No space .* --resume goes on"),
    ):
        patch.setattr(SmallParts, "computed", full)
        run(sweep, target, Running(jobs=2))
    kept = [path.name[:12] for path in Path(f"{tmp_path}/out.parts").rglob("*.parquet")]
    assert f"{1:012d}" not in kept and f"{0:012d}" in kept
    starts = computed(monkeypatch)
    run(sweep, target, Running(jobs=2, resume=True))
    assert {*starts} >= {8, 10, 12, 14} and not {0, 2, 4, 6} & {*starts}


def test_partitions_are_the_same_whoever_writes_them(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    small_partitions(monkeypatch)
    sweep, joined, apart = InThreads(plan_of(6)), f"{tmp_path}/joined/", f"{tmp_path}/apart/"
    with monkeypatch.context() as patch:
        # From parts, as what is computed slowly is.
        patch.setattr("kurbel.sweeps.parts.unit_of", lambda sweep, form: Parts(sweep))
        outcome = run(sweep, joined, Running(jobs=1))
    with pytest.raises(StoppedError):
        run(sweep, apart, Running(jobs=1, watch=stopped_after(2, KeyboardInterrupt())))
    assert len([*Path(f"{tmp_path}/apart.parts").rglob("*.parquet")]) == 2
    assert run(sweep, apart, Running(jobs=1, resume=True)) == outcome
    names = [f"part-00000{number}.parquet" for number in range(3)]
    assert sorted(os.listdir(joined)) == sorted(os.listdir(apart)) == names
    assert sorted(os.listdir(tmp_path)) == ["apart", "joined"]
    for name in names:
        assert Path(joined, name).read_bytes() == Path(apart, name).read_bytes()
    run(sweep, f"{tmp_path}/one.parquet", Running(jobs=1))
    in_one = pyarrow.parquet.read_table(f"{tmp_path}/one.parquet")
    assert pyarrow.dataset.dataset(joined).to_table().equals(in_one)
