"""How people write: numbers, ratios, angles, units, conditions, choices, TOML, CSV."""
