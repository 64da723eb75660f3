"""One build of everything, for all tests."""

from __future__ import annotations

import pytest

from built_handouts import Handouts, build_into


@pytest.fixture(scope="session")
def handouts(tmp_path_factory: pytest.TempPathFactory) -> Handouts:
    """The one build."""
    return build_into(tmp_path_factory.mktemp("handouts") / "out")
