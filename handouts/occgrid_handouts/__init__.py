"""Builds the course handouts: one text, five languages, code from the tested sources.

``python handouts/build.py --out build/handouts`` writes PDF and HTML pages, an index, and the notebook or script that
people of a language expect. Listings are the named snippets of the ports (CONTRIBUTING.md), numbers and figures come
from runs of the Python port that are made while building.
"""
