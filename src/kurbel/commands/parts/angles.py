"""The places of a page: crank angles, or shares of the piston's path."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from fractions import Fraction
from typing import TYPE_CHECKING, ClassVar

from kurbel.commands.options import Choice, Option, alone, amount, measure, word
from kurbel.commands.part import Part, Rivals
from kurbel.errors import NotationError, ProblemError
from kurbel.page.axes import shifted
from kurbel.page.layouts import Layout
from kurbel.reading import notation
from kurbel.reading.given import as_angle, as_angles, as_share, as_shares

if TYPE_CHECKING:
    from kurbel.motion.page import AngleQuestion

HALF_TURN, FULL_TURN = Fraction(180), Fraction(360)
STEP = Fraction(10)
ANGLE, PATH = "angle", "path"
AXES = (ANGLE, PATH)
# What pages over the path are about.
OVER_PATH, FORCES_OVER_PATH = "over path", "forces over path"
# What runs through angles, or through shares of the stroke.
ENDS = ("from", "to", "step")
SHARE, SHARES = "share of the stroke", Fraction(1, 10)


class Angles(Part):
    """The crank angles of a page."""

    topic = "angles"

    rivals: ClassVar[Rivals] = (
        *((ANGLE, end) for end in ENDS),
        *((end, ANGLE) for end in ENDS),
    )

    angle: Option[Sequence[Fraction] | None] = measure(
        alone(as_angles),
        "Crank angles in degrees: 22.5, 2°30', lists '0;45;90', ranges 0..180:10.", "ANGLES", unit="degrees",
        many=True,
    )  # fmt: skip
    from_ = measure(as_angle, "First angle; default 0.", "ANGLE", unit="degrees", what="first angle")
    to = measure(
        as_angle,
        "Last angle; default 360, the whole turn, and 180 where outstroke and return stand side by side."
        " Beyond 180 a page is of whole turns, with one column a quantity.",
        "ANGLE", unit="degrees", what="last angle",
    )  # fmt: skip
    step = measure(
        as_angle,
        "Step of the angles; default 10. Without any of these options a layout has its own angles.", "ANGLE",
        unit="degrees",
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
        return shifted(self._counted(page, turn), self.zero_angle)

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
        from kurbel.motion.page import is_beyond

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

    def _counted(self, page: Layout, turn: Fraction) -> Sequence[Fraction]:
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


class Over(Angles):
    """What a page runs over: the crank angle, or the piston's path."""

    over = word(
        "What the page runs over: angle (default), or path, at equal shares of the stroke, both strokes"
        " beside each other; with --step 5% or --shares.",
        kind=Choice("axis", AXES), default=ANGLE,
    )  # fmt: skip
    shares: Option[Sequence[Fraction] | None] = measure(
        as_shares,
        "With --over path: shares of the stroke, 25%, lists '0;0.5;1', ranges; default 0..1:0.1.",
        "SHARES",
        many=True,
        what=SHARE,
    )

    def unread(self, option: Option[object]) -> str:
        if option.name == "shares":
            return "--shares are those of the stroke, with --over path; add that"
        if "shares" not in self.values.read or option.name not in (ANGLE, "zero"):
            return ""
        why = "is for pages over the crank angle; with --over path give shares of the stroke"
        if option.name == "zero":
            return f"--zero {why}, which count from the dead centre where the stroke begins"
        return f"--{option.name} {why}, --shares '0;50%;100%' or --step 5%"

    def path_shares(self) -> Sequence[Fraction]:
        """Return the shares that are listed, or those of a run, by default every tenth of the stroke."""
        if (shares := self.shares) is not None:
            if self.says(*ENDS):
                raise ProblemError(
                    "--shares lists the shares and --from, --to, --step run through them; use one or the"
                    " other"
                )
            return shares
        first, last, step = (self._share(name) for name in ENDS)
        start, stop = first or Fraction(0), Fraction(1) if last is None else last
        if step is None:
            step = min(SHARES, stop - start) if stop > start else SHARES
        return notation.progression(start, stop, step, "share")

    def _share(self, name: str) -> Fraction | None:
        """Return where a run of shares begins or ends, or its step; what is no share is of angles, and is
        left out where it is not typed."""
        value = self.raw(name)
        if value is None:
            return None
        try:
            found = as_share(value, SHARE)
        except NotationError:
            if self.values.typed(name):
                raise
            return None
        if 0 <= found <= 1:
            return found
        if not self.values.typed(name):
            return None
        text = str(value).strip()[:40]
        instead = f"; write --{name} {text}%" if text.isdigit() and found <= 100 else ""
        raise ProblemError(
            f"--{name} {text} is no share of the stroke, which runs from 0 to 1, that is 0% to 100%{instead}"
        )
