"""Interactive pages in HTML: a static table, and beside it what a small script makes of its steps."""
