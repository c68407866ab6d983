"""The parts of a drawing of curves: its data, its plan on the page, its marks."""
