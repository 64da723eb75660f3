"""``python -m occgrid`` is the command ``occgrid``."""

from occgrid.main import main

if __name__ == "__main__":
    raise SystemExit(main())
