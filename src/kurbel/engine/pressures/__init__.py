"""The pressure that the masses take to be accelerated, beside that of steam or gas on the piston."""
