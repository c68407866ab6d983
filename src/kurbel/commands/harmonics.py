"""The harmonics of the piston's motion and of the tangential force that turns the crank."""

from __future__ import annotations

from kurbel.balancing.harmonics import HARMONICS, MOST_ORDERS, HarmonicsRequest
from kurbel.commands.options import Choice, Count, Option, word
from kurbel.commands.part import CommandOptions, flag_of
from kurbel.commands.parts.drive import Linked, Speed
from kurbel.commands.parts.engine import Engine
from kurbel.commands.parts.sheet import Layouts, Sheet, columns_option, layout_option
from kurbel.commands.subject import function
from kurbel.drive.crank import DescribedDrive
from kurbel.errors import ProblemError
from kurbel.page.subject import Question

TORQUE = "torque"
OF_TORQUE = ("torque", "excitation")


class HarmonicsOptions(Engine, Layouts, Sheet, CommandOptions):
    """Print the harmonics of the piston's motion, coefficients of cos φ, cos 2φ, ..., or those of the torque.

    \b
    kurbel harmonics --ratio 1:5  # of the motion
    kurbel harmonics --machine engine.toml --quantity torque  # of the torque
    kurbel harmonics --ratio 1:5 --orders 8 --digits 6  # up to the eighth
    kurbel harmonics --quantity torque --eps 4 --cranks '0;90'
    kurbel harmonics --layout excitation --machine engine.toml -f csv -o excitation.csv
    \f
    >>> import kurbel
    >>> print(kurbel.typeset(kurbel.harmonics("1:5", orders=4), "csv"), end="")
    order,ratio,value
    1,1:5,1.000000
    2,1:5,0.202038
    4,1:5,-0.002062
    """

    topic = "question"

    unnamed = "ratio"
    sequence = (
        "quantity orders method pressure_ratio suction_loss delivery_loss pump small_area suction_pressure"
        " delivery_pressure compression cycle peak_pressure cut_off heat expansion_exponent exhaust_pressure"
        " two_stroke back exponent clearance card other_side single_acting bore pressure cranks cylinder"
        " rod_mass centre gyration pendulum pendulum_from rod_file slope gravity piston_rod tail_rod"
        " friction offset stroke time_ratio rod mechanism rocker pivot circuit beam eps"
        " reciprocating rocker_inertia speed columns"
    )
    in_short = "ratio quantity orders machine eps bore pressure stroke speed reciprocating cranks columns"

    ratio = Linked.ratio.but(help="Crank ratio: 1:5; lists '1:4;1:5' and ranges 1:3..6:0.5.")
    method = word(
        "exact, series (first order in λ) or infinite (rod of infinite length).",
        kind=Choice("method", "kurbel.motion.evaluation:METHODS"), default="exact", topic="crank",
    )  # fmt: skip
    speed = Speed.speed.but(help="Speed, for frequencies and masses: 120/min, 12.5rad/s.")
    quantity = word(
        "x (path), c (velocity), p (acceleration, default), or torque, of an engine.",
        kind=Choice("quantity", (*HARMONICS, TORQUE)),
    )
    orders: Option[int] = Option(
        f"Orders up to N, 1 to {MOST_ORDERS}; odd ones above 1 are 0 and left out of the motion.",
        "N",
        Count("orders", 1, MOST_ORDERS, "does not say up to which one"),
        default=6,
    )
    columns = columns_option("torque-harmonics", "order,amplitude,phase")
    layout = layout_option("harmonics", *OF_TORQUE)

    def question(self) -> Question:
        if self.of_torque():
            return self._torque()
        if self.says("offset"):
            raise ProblemError(
                "the crank is offset; harmonics of the motion are known for the straight crank, without"
                " --offset"
            )
        page = self.page("harmonics", "harmonics")
        stroke, rod = (None, None) if self.lone_lengths() else (self.stroke, self.rod)
        return HarmonicsRequest(
            layout=page,
            ratios=tuple(one.ratio for one in DescribedDrive(self.ratio, stroke, rod).cranks(page.ratios)),
            quantity=self.quantity or "",
            last_order=self.orders,
            method=self.method,
            **self.printed(),
        )

    def of_torque(self) -> bool:
        """Whether the torque is meant, by its name or by a layout."""
        return self.quantity == TORQUE if self.quantity else self.layout_subject in OF_TORQUE

    def is_sized(self) -> bool:
        return self.of_torque() and super().is_sized()

    def unread(self, option: Option[object]) -> str:
        if self.of_torque():
            return ""
        if option.name in ("stroke", "rod"):
            other = "rod" if option.name == "stroke" else "stroke"
            flag = flag_of(option.name)
            return f"{flag} gives the ratio with --{other}; add that, or leave {flag} out"
        return f"{flag_of(option.name)} is for the harmonics of the torque; add --quantity torque"

    def _torque(self) -> Question:
        """Return what is asked for of the torque of an engine. Raises KurbelError."""
        from kurbel.engine.torque_harmonics import TorqueRequest

        page, names = self.page("torque-harmonics", *OF_TORQUE), self.names("order,amplitude")
        if self.method == "infinite":
            raise ProblemError("the torque of an infinite rod is that of --ratio 1:∞; leave --method out")
        engines, speed = self.of_page(page), self.speed
        # Beside masses it makes the frequencies of columns.
        if not (self.is_heavy() or self.is_several() or self.layout or names):
            self.refuse("speed")
        return TorqueRequest(
            columns=names,
            last_order=self.orders,
            speed=speed,
            **engines,
            **self.printed(),
        )


harmonics = function(HarmonicsOptions, "harmonics")
