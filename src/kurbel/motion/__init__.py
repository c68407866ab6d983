"""The piston's motion and the forces of the drive: quantities, certified digits, pages."""
