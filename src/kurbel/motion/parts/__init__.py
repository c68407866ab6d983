"""The parts of the rod's inertia, as Ensslin parts them, as what pages can show."""
