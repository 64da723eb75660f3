"""The tests of the Python port, run within a changed one: the last that a change is put to."""

from __future__ import annotations

import sys
from pathlib import Path

import pytest

from occgrid_mutants.trials import Modules, Trial

# Which tests look at a module, and which of them. The others map whole scenarios, as the trials do.
TESTS = {
    "portable_math": ("test_portable_math.py", "not an_array"),
    "noise": ("test_noise.py", ""),
    "grid": ("test_grid.py", ""),
    "ray": ("test_ray.py", ""),
    "world": ("test_world.py", ""),
    "sensor": ("test_sensor.py", ""),
    "scenario": ("test_scenario.py", ""),
    "lesson": ("test_lesson.py", "trajectory or built_in"),
    "mapper": ("test_scenario.py", ""),
    "fast": (
        "test_fast.py",
        "not every_scenario and not longest and not printed",
    ),
}


def port_tests(root: Path) -> dict[str, Trial]:
    """The tests of each module."""
    folder = root / "python" / "tests"
    return {
        module: _tests(folder, file, chosen)
        for module, (file, chosen) in TESTS.items()
    }


def _tests(folder: Path, file: str, chosen: str) -> Trial:
    options = [
        *("-x", "-q", "-c", "/dev/null", "--import-mode=importlib"),
        *("-p", "no:cacheprovider", "-p", "no:xdist", "-k", chosen),
        f"--rootdir={folder}",
    ]

    def right(modules: Modules) -> bool:
        try:
            status = pytest.main([*options, str(folder / file)])
        finally:
            # the next port must not meet tests that hold this one's functions
            for name, module in list(sys.modules.items()):
                path = getattr(module, "__file__", None) or ""
                if path.startswith(str(folder)):
                    del sys.modules[name]
        return status == pytest.ExitCode.OK

    return Trial(f"unit tests {file}", right)
