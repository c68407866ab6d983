"""The places of a page: crank angles, in degrees or by what holds there."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace
from fractions import Fraction
from typing import TYPE_CHECKING, Any, ClassVar, TypeGuard

from kurbel.commands.options import Option, alone, amount, measure
from kurbel.commands.part import Part, Rivals, Values
from kurbel.errors import ProblemError
from kurbel.page.axes import shifted
from kurbel.page.layouts import Layout
from kurbel.reading import notation
from kurbel.reading.given import SHARE, as_angle, as_angles, as_shares
from kurbel.reading.notation import Progression

if TYPE_CHECKING:
    from kurbel.motion.motion_page import AngleQuestion

HALF_TURN, FULL_TURN = Fraction(180), Fraction(360)
STEP = Fraction(10)
ANGLE = "angle"
# What pages over the path are about.
OVER_PATH, FORCES_OVER_PATH = "over path", "forces over path"
# What runs through angles.
ENDS = ("from", "to", "step")
# What a page over the path is of where no shares of the stroke are given.
SHARES = "s=0..1:0.1"


def as_positions(given: object) -> Sequence[Fraction | str]:
    """Read crank angles, and conditions that hold at some, as texts; shares of the stroke each for itself."""
    texts = [given] if isinstance(given, str) or not isinstance(given, Iterable) else [*given]
    if not any(map(_is_condition, texts)):
        return as_angles(given)
    found: list[Fraction | str] = []
    for text in texts:
        parts = text.split(";") if isinstance(text, str) else [text]
        for part in parts:
            found += _conditions(part.strip()) if _is_condition(part) else as_angles(part)
    return tuple(dict.fromkeys(found))


def _is_condition(text: object) -> TypeGuard[str]:
    return isinstance(text, str) and ("=" in text or "|" in text)


def _conditions(text: str) -> list[str]:
    name, _, right = text.partition("=")
    if name.strip() != SHARE:
        return [text]
    return [f"{SHARE}={one}" for one in as_shares(right, "share")]


def in_degrees(
    angles: Sequence[Any],
    values: Values,
    ratios: Sequence[str],
    turn: Fraction = FULL_TURN,
    zero: Fraction = Fraction(0),
) -> Sequence[Fraction]:
    """Return crank angles that count from `zero` as φ, and those at which conditions hold, of one turn or of
    so much of it; a drive that no option gives is one of these ratios."""
    if isinstance(angles, Progression) or not any(isinstance(one, str) for one in angles):
        return shifted(angles, zero)
    from kurbel.commands.solve import angles_of

    several = (
        angles_of(one, values, ratios, turn) if isinstance(one, str) else (one + zero,) for one in angles
    )
    return tuple(dict.fromkeys(one for found in several for one in found))


class Angles(Part):
    """The crank angles of a page."""

    topic = "angles"

    rivals: ClassVar[Rivals] = (
        *((ANGLE, end) for end in ENDS),
        *((end, ANGLE) for end in ENDS),
    )

    angle: Option[Sequence[Fraction | str] | None] = measure(
        alone(as_positions),
        "Crank angles in degrees: 22.5, 2°30', lists '0;45;90', ranges 0..180:10; or what holds there, as"
        " --where of kurbel solve: 's=10%', 's=0..100%:5%', 'x=120mm', psi=max, c=max.", "ANGLES",
        unit="degrees", many=True,
    )  # fmt: skip
    from_ = measure(as_angle, "First angle; default 0.", "ANGLE", what="first angle")
    to = measure(
        as_angle,
        "Last angle; default 360, the whole turn, and 180 where outstroke and return stand side by side."
        " Beyond 180 a page is of whole turns, with one column a quantity.",
        "ANGLE", what="last angle",
    )  # fmt: skip
    step = measure(
        as_angle,
        "Step of the angles; default 10. Without any of these options a layout has its own angles.", "ANGLE",
    )  # fmt: skip
    zero = amount(
        "Where the angles of the page count from, if not from φ = 0: an angle, or outer for the outer dead"
        " centre, φ = 180°.",
        "ANGLE", unit="degrees",
    )  # fmt: skip

    @property
    def zero_angle(self) -> Fraction:
        """The angle φ that the page calls 0."""
        zero = self.zero
        named = zero.strip().lower() if isinstance(zero, str) else ""
        if zero is None or named == "inner":
            return Fraction(0)
        if named != "outer":
            return as_angle(zero, "zero")
        if self.says("offset") or self.values.values.get("mechanism") not in (None, "straight"):
            raise ProblemError(
                "--zero outer is for dead centres on the slide direction; of another drive give the angle,"
                " 180 for the slide direction itself"
            )
        return HALF_TURN

    def angles(self, page: Layout, turn: Fraction = FULL_TURN) -> Sequence[Fraction]:
        """Return the angles that are listed, or those of a run, or the layout's own, as φ; a run without an
        end is of so much of a `turn`."""
        return in_degrees(self._counted(page, turn), self.values, page.ratios, turn, self.zero_angle)

    def shares(self) -> Sequence[Fraction]:
        """Return the shares of the stroke, where nothing else is given; by default every tenth."""
        given = as_positions(SHARES) if self.angle is None else self.angle
        texts = [one for one in given if isinstance(one, str) and one.startswith(f"{SHARE}=")]
        return tuple(Fraction(one.partition("=")[2]) for one in texts) if len(texts) == len(given) else ()

    def ends(self, turn: Fraction = FULL_TURN) -> tuple[Fraction, Fraction]:
        """Return the first and the last angle, by default those of the whole turn, or of so much of it."""
        first, last = self.from_, self.to
        return first or Fraction(0), turn if last is None else last

    def check_whole(self, page: Layout) -> None:
        """Raise ProblemError where crank angles are given to a page of the whole turn."""
        for name in (ANGLE, *ENDS, "zero"):
            if self.says(name):
                raise ProblemError(f"layout {page.key} is of the whole turn; leave --{name} out")

    def over_strokes(self, question: AngleQuestion) -> AngleQuestion:
        """Return the question over both strokes, where these stand side by side at all of its angles; else
        over whole turns. Where no last angle is given, both strokes end at 180°."""
        from kurbel.motion.motion_page import is_beyond

        if not is_beyond(question.angles):
            return question
        ended = question.zero or self.says("to", ANGLE)
        if ended or not question.has_return or not 0 <= question.angles[0] <= HALF_TURN:
            return replace(question, whole_turns=True)
        angles = self.angles(question.layout, HALF_TURN)
        # Angles of a layout have no end to be given.
        return replace(
            question,
            angles=tuple(one for one in angles if one <= HALF_TURN) if is_beyond(angles) else angles,
        )

    def _counted(self, page: Layout, turn: Fraction) -> Sequence[Fraction | str]:
        angles = self.angle
        if not self.says(*ENDS):
            return as_angles(page.angles) if angles is None else angles
        if angles is not None:
            raise ProblemError(
                "--angle lists the angles and --from, --to, --step run through them; use one or the other"
            )
        first, last = self.ends(turn)
        if (step := self.step) is not None:
            return notation.progression(first, last, step)
        return notation.progression(first, last, min(STEP, last - first) if last > first else STEP)
