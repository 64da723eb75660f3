"""Occupancy grid mapping in NumPy, the same bits in every language.

The modules are the rooms of the suite: ``portable_math``, ``noise``, ``grid``, ``ray``, ``world``, ``sensor``,
``scenario``, ``lesson``, ``mapper``, ``map_writer`` and ``main``. SPEC.md is the contract behind them.
"""

__version__ = "1.0.0"
