"""The irregularity δ of very many double-acting engines with one crank, for arrays."""
