"""Occupancy grid mapping in NumPy, the same bits in every language.

The modules, each built on those before it: ``portable_math``, ``noise``, ``grid``, ``ray``, ``world``, ``sensor``,
``scenario``, ``lesson``, ``mapper``; ``fast``, the same maps in less time; ``map_writer``, ``picture`` and ``main``.
SPEC.md is the contract behind them.
"""

__version__ = "1.0.0"
