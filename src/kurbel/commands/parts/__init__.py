"""What commands ask for, part by part: the options of each, and what they make."""
