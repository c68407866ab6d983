"""What acts on piston, rod and pins beside a force and inertia: weight, friction of pins."""
