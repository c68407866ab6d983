"""What pages can be about: by its name in a layout, where each subject stands."""

from __future__ import annotations

from collections.abc import Mapping

SUBJECTS: Mapping[str, str] = {
    "motion": "kurbel.motion.page:MOTION",
    "inertia": "kurbel.motion.page:INERTIA",
    "inertia errors": "kurbel.motion.inertia_page:SUBJECT",
    "tangent": "kurbel.motion.tangent_page:SUBJECT",
    "arc crank": "kurbel.linkage.page:ARC",
    "parallel crank": "kurbel.linkage.page:PARALLEL",
    "dead centres": "kurbel.linkage.beam_page:SUBJECT",
    "roots": "kurbel.solve.page:SUBJECT",
    "collation": "kurbel.books.collate_page:SUBJECT",
    "irregularity": "kurbel.engine.page:IRREGULARITY",
    "strokes": "kurbel.engine.page:STROKES",
    "turning": "kurbel.engine.page:TURNING",
    "crank forces": "kurbel.engine.page:CRANK_FORCES",
    "machine": "kurbel.engine.page:MACHINE",
    "flywheel": "kurbel.engine.page:FLYWHEEL",
    "harmonics": "kurbel.balance.harmonics_page:SUBJECT",
    "balance": "kurbel.balance.page:SUBJECT",
}
