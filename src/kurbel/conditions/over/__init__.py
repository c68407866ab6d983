"""Pages over the path: what a drive does where its piston has gone equal shares of the stroke."""
