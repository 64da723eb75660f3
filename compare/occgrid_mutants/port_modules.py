"""The modules of the Python port, loaded anew with one of them changed."""

from __future__ import annotations

import ast
import sys
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from types import CodeType, ModuleType

PACKAGE = "occgrid"
# in the order in which they import one another; the changes are made in those but the last
CHANGED = (
    "portable_math",
    "noise",
    "grid",
    "ray",
    "world",
    "sensor",
    "scenario",
    "lesson",
    "mapper",
    "fast",
)
MODULES = (*CHANGED, "map_writer")


def sources(root: Path) -> dict[str, Path]:
    """Where the modules are."""
    folder = root / "python" / PACKAGE
    return {name: folder / f"{name}.py" for name in MODULES}


def parse(path: Path) -> ast.Module:
    """The tree of a module."""
    return ast.parse(path.read_text("utf-8"), str(path))


def compiled(root: Path) -> dict[str, CodeType]:
    """The code of every module as it is."""
    return {
        name: compile(parse(path), str(path), "exec")
        for name, path in sources(root).items()
    }


@contextmanager
def loaded(code: Mapping[str, CodeType]) -> Iterator[dict[str, ModuleType]]:
    """The port made of this code; it stands in sys.modules within the ``with`` statement."""
    kept = {
        name: sys.modules.pop(name)
        for name in list(sys.modules)
        if name.split(".")[0] == PACKAGE
    }
    try:
        package = ModuleType(PACKAGE)
        package.__path__ = []
        package.__version__ = "0"  # type: ignore[attr-defined]
        sys.modules[PACKAGE] = package
        modules = {}
        for name in MODULES:
            module = ModuleType(f"{PACKAGE}.{name}")
            sys.modules[module.__name__] = module
            setattr(package, name, module)
            exec(code[name], module.__dict__)
            modules[name] = module
        yield modules
    finally:
        for name in list(sys.modules):
            if name.split(".")[0] == PACKAGE:
                del sys.modules[name]
        sys.modules.update(kept)
