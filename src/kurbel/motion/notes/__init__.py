"""What pages say below their tables of the rod, and of masses and cranks that are accelerated."""
