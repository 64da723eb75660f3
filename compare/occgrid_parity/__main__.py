"""``python -m occgrid_parity``: the same as the command ``occgrid-parity``."""

from occgrid_parity.commands.app import main

if __name__ == "__main__":
    main()
