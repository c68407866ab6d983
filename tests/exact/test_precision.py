"""Certified digits from several threads, and in processes that begin meanwhile: they share the precision."""

from __future__ import annotations

import multiprocessing
import shlex
import time
from concurrent.futures import ProcessPoolExecutor, ThreadPoolExecutor
from threading import Event, Thread, Timer

import flint
import pytest
from cli import kurbel as kurbel_line

import kurbel
from kurbel.exact.certify import BALLS, at_bits

DIGITS = (2, 5, 11, 18, 26, 33, 41, 49)
# What takes its digits from balls, here and there as floats: ends of strokes, corners, signs and drawings.
LINES = (
    "solve --mechanism arc --rocker 6 --where c=max",
    "turning --eps 3 --step 90 -f svg",
    "delta --eps 4 --flywheel 50 --resistance square",
    "turning --torque '5000 + 1500 sin(3φ)' --step 90 --inertia 1200kgm2",
    "pressures --eps 4 --reciprocating 300kg --stroke 60cm --bore 30cm --pressure 8bar --speed 2/s -f svg",
    "harmonics --eps 4 --quantity torque",
)


def digits_of(places: int) -> str:
    """Certified digits and pages with balls of another size for each number of places."""
    numbers = [str(kurbel.certified("x", "1:5", angle, digits=places)) for angle in range(1, 90, 22)]
    page = kurbel.turning(eps=4, ratio=f"1:{places + 3}", step=180, digits=places)
    return "\n".join((*numbers, page.typeset("csv")))


def test_eight_threads_have_the_digits_of_one_each_to_its_own_places() -> None:
    alone = [digits_of(places) for places in DIGITS]
    with ThreadPoolExecutor(len(DIGITS)) as pool:
        together = [*pool.map(digits_of, DIGITS)]
    assert together == alone


def test_no_thread_changes_the_balls_of_another() -> None:
    """The threads overlap, whatever a machine does: each looks, lets the others go on, and looks again."""
    before = flint.ctx.prec

    def sizes(bits: int) -> list[int]:
        found = []
        for _ in range(5):
            with at_bits(bits):
                found.append(flint.ctx.prec)
                time.sleep(0.001)
                with at_bits(2 * bits):
                    time.sleep(0.001)
                found.append(flint.arb.pi().rel_accuracy_bits())
        return found

    with ThreadPoolExecutor(len(DIGITS)) as pool:
        together = [*pool.map(sizes, [100 * places for places in DIGITS])]
    assert together == [sizes(100 * places) for places in DIGITS]
    assert flint.ctx.prec == before


@pytest.mark.parametrize("line", LINES)
def test_no_page_and_no_drawing_depends_on_the_precision_that_another_thread_has_left(line: str) -> None:
    usual = kurbel_line(*shlex.split(line))
    with at_bits(2):
        rough = kurbel_line(*shlex.split(line))
    assert usual.code == 0, usual.err
    assert rough == usual


def test_a_process_that_begins_while_another_thread_computes_does_not_wait_for_it() -> None:
    inside, done = Event(), Event()

    def compute() -> None:
        with at_bits(300):
            inside.set()
            done.wait(60)

    def begun(method: str) -> str:
        context = multiprocessing.get_context(method)
        with ProcessPoolExecutor(1, context) as pool:
            return pool.submit(digits_of, 7).result(120)

    thread = Thread(target=compute)
    thread.start()
    assert inside.wait(60)
    # A fork waits for the calculation, which ends soon; a spawned process knows nothing of it.
    alone = begun("spawn")
    Timer(0.05, done.set).start()
    assert begun("fork") == alone
    thread.join(60)
    assert BALLS.acquire(timeout=60)
    BALLS.release()
