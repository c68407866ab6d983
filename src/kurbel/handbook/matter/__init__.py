"""What a book has before and behind its chapters: notation, symbols, index, colophon."""
