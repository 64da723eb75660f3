"""The command ``occgrid-parity``, one module for each of its commands."""
