"""Random sweeps, and what the single command says of each of their cells."""

from __future__ import annotations
