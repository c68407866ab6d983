"""The commands about rotors and locomotives."""
