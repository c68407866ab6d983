"""Pages in steps: which options are sliders, and the page of every step."""
