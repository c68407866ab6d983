"""What is asked of engines by orders: harmonics, firing orders."""
