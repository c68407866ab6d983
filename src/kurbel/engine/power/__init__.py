"""What engines and driven machines do: mean pressure, power, sizes, and the steam that they take."""
