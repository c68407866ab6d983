"""The layouts that pages of an engine have by themselves, and which options say something on them."""
