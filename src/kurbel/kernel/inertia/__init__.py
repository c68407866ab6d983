"""How the masses of the crank drive are accelerated: exactly or to first order, by an even crank or not."""
