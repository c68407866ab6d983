"""From a formula to a settled digit: balls, separation bounds, surds, roots with proof, printed numbers."""
