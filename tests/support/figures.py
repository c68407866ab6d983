"""Tables of kurbel's as rows of texts, and as columns of figures."""

from __future__ import annotations

import csv
import io
from collections.abc import Iterable
from typing import Any

import numpy as np

import kurbel


def rows(page: Any) -> list[dict[str, str]]:
    """Return the rows of a table of kurbel's by their keys."""
    return list(csv.DictReader(io.StringIO(kurbel.typeset(page, "csv"), newline="")))


def figures(page: Any, keys: Iterable[str]) -> Any:
    """Return the figures of the rows of a table under these keys."""
    return np.array([[float(row[key]) for key in keys] for row in rows(page)])
