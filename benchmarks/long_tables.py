"""Long tables as whole commands, each digit certain, beside textbook floats and each cell in balls."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from benchmarks.race import Race, Row, Run, Task, kurbel, python

RATIO = 5
EPS = 4
# The balls are computed at one place in so many.
EVERY = 40
BITS = 100
# A tenth of 16 times, which all cells in balls took before.
AIM = 1.6
INERTIA = "--centre 0.65 --gyration 0.35 --layout inertia-errors"

# Floats that nobody has certified: the same columns to as many decimals.
FLOATS = """
import numpy, polars
phi = numpy.linspace(0, 180, {rows})
sine, cosine = numpy.sin(numpy.radians(phi)), numpy.cos(numpy.radians(phi))
double = numpy.cos(2 * numpy.radians(phi))
def columns(ratio):
    square = sine * sine
    w = numpy.sqrt(1 - ratio * ratio * square)
    return [1 - cosine + (1 - w) / ratio, sine + ratio * sine * cosine / w,
            cosine + ratio * (double + ratio * ratio * square * square) / (w * w * w)]
both = dict(enumerate([phi, *columns(1 / {ratio}), *columns(-1 / {ratio})]))
polars.DataFrame({{str(key): column for key, column in both.items()}}).write_csv(
    "table.csv", float_precision=4)
"""


def motion_in_balls(rows: int) -> Run:
    """x, c and p of both strokes, to four decimals."""
    return _in_balls(rows, 180, lambda phi: [one for rod in (1, -1) for one in _motion(phi, rod)])


def turning_in_balls(rows: int) -> Run:
    """The turning effort, its mean, its excess and the work of that, as `kurbel turning` has them."""
    return _in_balls(rows, 360, _turning)


def _in_balls(rows: int, last: int, columns: Any) -> Run:
    from flint import arb, ctx, fmpq

    def text() -> list[str]:
        ctx.prec = BITS
        places = [fmpq(last * row, rows - 1) for row in range(0, rows, EVERY)]
        return [",".join(_decimals(value) for value in columns(arb(place))) for place in places]

    return text


def _decimals(value: Any) -> str:
    from flint import arb

    scaled = int(float((value * 10000 + arb(0.5)).floor()))
    return f"{'-' if scaled < 0 else ''}{abs(scaled) // 10000}.{abs(scaled) % 10000:04}"


def _motion(phi: Any, rod: int) -> tuple[Any, Any, Any]:
    sine, cosine, ratio = (phi / 180).sin_pi(), (phi / 180).cos_pi(), _ratio() * rod
    w = (1 - (ratio * sine) ** 2).sqrt()
    double = 1 - 2 * sine**2
    return (
        1 - cosine + (1 - w) / ratio,
        sine + ratio * sine * cosine / w,
        cosine + ratio * (double + ratio**2 * sine**4) / w**3,
    )


def _turning(phi: Any) -> list[Any]:
    from flint import arb

    back = arb(1) / EPS
    mean = 2 / arb.pi() * ((1 + arb(EPS).log()) / EPS - back)
    returns = phi > 180
    x, c, _ = _motion(phi - 180 if returns else phi, -1 if returns else 1)
    cut = arb(2) / EPS
    admitted = x < cut
    tangential = c * ((1 if admitted else cut / x) - back)
    work = x if admitted else cut * (1 + (x / cut).log())
    turned = (phi - 180 if returns else phi) * arb.pi() / 180
    return [tangential, mean, tangential - mean, work - back * x - mean * turned]


def _ratio() -> Any:
    from flint import arb

    return arb(1) / RATIO


def races(quick: bool) -> Iterator[Race]:
    step, rows = ("0.005", 36_001) if quick else ("0.0005", 360_001)
    words = f"table --ratio 1:{RATIO} --step {step}"
    longer = f"table --ratio 1:{RATIO} --step {step.replace('5', '05')} -f csv"
    yield Race(
        {
            "kurbel": kurbel(f"{words} -f csv -o table.csv"),
            f"`kurbel {longer}`": kurbel(f"{longer} -o table.csv"),
            "textbook NumPy and polars": python(FLOATS.format(rows=rows, ratio=RATIO), needs="polars"),
            "each cell in flint's balls": Task(motion_in_balls, (rows,), share=1 / EVERY),
        },
        [
            Row(f"`kurbel {words} -f csv`", "kurbel", name, times=rows)
            for name in ("textbook NumPy and polars", "each cell in flint's balls")
        ]
        + [
            Row(
                f"`kurbel {words} -f csv`",
                "kurbel",
                f"`kurbel {longer}`",
                times=rows,
                its_times=10 * rows - 9,
            )
        ],
    )
    step, rows = ("0.1", 3601) if quick else ("0.01", 36_001)
    words = f"turning --ratio 1:{RATIO} --eps {EPS} --step {step}"
    yield Race(
        {
            "kurbel": kurbel(f"{words} -f csv -o turning.csv"),
            "each cell in flint's balls": Task(turning_in_balls, (rows,), share=1 / EVERY),
        },
        [Row(f"`kurbel {words} -f csv`", "kurbel", "each cell in flint's balls", AIM, rows)],
        rounds=3,
    )
    words, usual = (f"inertia --ratio {ratio} {INERTIA}" for ratio in ("0.999999", "1:5"))
    yield Race(
        {"near": kurbel(words), f"`kurbel {usual}`": kurbel(usual)},
        [Row(f"`kurbel {words}`", "near", f"`kurbel {usual}`")],
        rounds=2,
    )
