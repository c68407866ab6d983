"""What kurbel costs beside its peers: `python -m benchmarks` prints the table of docs/speed.md."""
