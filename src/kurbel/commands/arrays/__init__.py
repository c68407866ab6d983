"""Values without a page, at arrays of crank angles."""
