"""What `python -m kurbel` runs."""

from kurbel.cli import main

if __name__ == "__main__":
    main()
