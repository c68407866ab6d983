"""What the books draw: constructions with compasses and ruler, in steps, with the lengths that they give.

A construction is data (model.py): the points in pure geometry (placed.py) on any kind of number, steps
that draw lines between points, and the lengths that are read off, each beside its true value by the kernel.
Run in balls it gives certified digits, in floats the drawing (plot/construct.py). No module here draws.
construction_page.py knows them by their names.
"""
