"""The parallel crank: two equal cranks, joined by a rod as long as their shafts are apart."""
