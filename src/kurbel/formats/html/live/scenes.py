"""What moves on an interactive page, as its script reads it: lengths are in thousandths of R."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any

from kurbel.page.steps import Joint, Point, Scene


def scenes_of(scenes: Sequence[Scene | None]) -> dict[str, Any]:
    """Return the joints that scenes have in common, each scene once, and which one each step has."""
    known = list(dict.fromkeys(scene for scene in scenes if scene is not None))
    joints: dict[Joint, int] = {}
    told = [_scene(scene, joints) for scene in known]
    return {
        "joints": [_flat(joint) for joint in joints],
        "scenes": told,
        "moves": [None if scene is None else known.index(scene) for scene in scenes],
    }


def _scene(scene: Scene, joints: dict[Joint, int]) -> dict[str, Any]:
    def named(joint: Joint) -> int:
        return joints.setdefault(joint, len(joints))

    return {
        "box": _flat((scene.low, scene.high)),
        "fixed": [[line.kind, *_flat(line.points)] for line in scene.fixed],
        "links": [[link.kind, named(link.start), named(link.end), link.letter] for link in scene.links],
        "pins": [named(pin) for pin in scene.pins],
        "heads": [named(head) for head in scene.heads],
        "path": None if scene.path is None else _flat((scene.path,)),
    }


def _flat(points: Iterable[Point]) -> list[int]:
    return [round(1000 * one) for point in points for one in point]
