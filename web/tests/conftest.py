"""The fixtures of the pages' tests."""

from __future__ import annotations

from pages_in_browser import browser, open_page, pages

__all__ = ["browser", "open_page", "pages"]
