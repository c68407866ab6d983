"""What a turn's forces do between its dead centres and corners: smooth formulas, their zeros and extremes."""
