"""What engines with several cranks leave unbalanced at an angle of the crank."""
