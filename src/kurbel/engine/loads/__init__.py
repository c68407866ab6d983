"""What acts on the piston beside steam and cards: compressors, pumps, and the cycles of gas engines."""
