"""The table model: table, labels, formulas, axes, arrangement, layouts, and what makes a page."""
