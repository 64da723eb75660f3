"""What the scenarios ask of the port's functions. A change that answers all of it alike cannot alter a map.

Most changes that no scenario sees are in the last bits of constants, and to map every scenario for each takes long.
Many functions hang on their arguments alone: it is enough to ask them again. Where an answer is another one, only the
trials that asked for it can differ.
"""

from __future__ import annotations

import ast
import copy
import hashlib
import itertools
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass, field, fields, is_dataclass
from types import ModuleType
from typing import Any

import numpy as np

from occgrid_mutants.sites import Site

# The functions that are asked again. Each hangs on nothing but its arguments.
FUNCTIONS = {
    "portable_math": ("sin", "cos", "exp", "log"),
    "noise": ("add_range_noise",),
    "grid": ("logit", "sigmoid"),
    "ray": ("bresenham",),
    "world": (
        "build_box_world",
        "add_vertical_wall",
        "add_horizontal_wall",
        "ray_segment_intersection",
        "simulate_lidar_scan",
    ),
    "sensor": (
        "beam_angles",
        "flaser_angles",
        "read_ranges",
        "beam_endpoints",
    ),
}
# The modules of which the others use no function but these: any change in them is answered by these.
WHOLE = ("portable_math", "noise", "ray", "world")

# What else the others take from these, but for their types.
VALUES = {"portable_math": ("pi",), "ray": ("MAX_STEPS",)}

Bits = tuple[Any, ...]


def bits(value: Any) -> Bits:
    """Type and content of a value; equal exactly where these are, last bits, zeros' signs and NaNs included."""
    if isinstance(value, np.ndarray | np.generic):
        data = value.tobytes()
        if len(data) > 64:
            data = hashlib.sha256(data).digest()
        return type(value).__name__, value.dtype.str, value.shape, data
    kind = f"{type(value).__module__}.{type(value).__qualname__}"
    if isinstance(value, float):
        return kind, value.hex()
    if isinstance(value, list | tuple):
        return kind, *map(bits, value)
    if is_dataclass(value) and not isinstance(value, type):
        return kind, *(bits(getattr(value, f.name)) for f in fields(value))
    if value is None or isinstance(value, int | str):
        return kind, value
    raise TypeError(f"cannot compare a {kind}")


@dataclass
class Call:
    """One of the distinct calls: what was asked, what came back, and in which trials."""

    function: str
    args: tuple[Any, ...]
    kwargs: dict[str, Any]
    asked: Bits
    given: Bits
    shared: tuple[bool, ...]
    trials: set[str] = field(default_factory=set)

    def alike(self, module: ModuleType) -> bool:
        """Whether a changed module gives the same, from arguments that it leaves as they are."""
        args, kwargs = _copied(self.args), _copied(self.kwargs)
        try:
            answer = getattr(module, self.function)(*args, **kwargs)
            return (
                bits(answer) == self.given
                # a caller may write into what it was given
                and _shared(args, kwargs, answer) == self.shared
                and (
                    (args is self.args and kwargs is self.kwargs)
                    or _asked(args, kwargs) == self.asked
                )
            )
        except Exception:
            return False


class Calls:
    """The distinct calls of FUNCTIONS."""

    def __init__(self) -> None:
        self._calls: dict[tuple[str, str, Bits], Call] = {}
        self._incomplete: set[str] = set()
        self._values: dict[str, list[Bits]] = {}

    def __len__(self) -> int:
        return len(self._calls)

    @contextmanager
    def recorded(
        self, modules: Mapping[str, ModuleType], trial: str
    ) -> Iterator[None]:
        """Notes the calls within the ``with`` statement as those of a trial."""
        replaced: list[tuple[ModuleType, str, Any]] = []
        for place, functions in FUNCTIONS.items():
            self._values.setdefault(place, _values(place, modules[place]))
            for name in functions:
                original = getattr(modules[place], name)
                noting = self._noting(place, name, original, trial)
                for module in modules.values():
                    for held, value in list(vars(module).items()):
                        if value is original:
                            replaced.append((module, held, original))
                            setattr(module, held, noting)
        try:
            yield
        finally:
            for module, held, original in replaced:
                setattr(module, held, original)

    def differing(
        self,
        site: Site,
        tree: ast.Module,
        covering: set[str],
        modules: Mapping[str, ModuleType],
    ) -> set[str] | None:
        """The trials whose questions a changed port answers otherwise; None where asking again does not tell.

        ``tree`` is that of the module, and ``covering`` are the trials that run the line of the change.
        """
        place = site.module
        module = modules[place]
        functions = _asked_through(site, tree)
        if (
            not functions
            or place in self._incomplete
            or _values(place, module) != self._values[place]
        ):
            return None
        found: set[str] = set()
        for (where, name, _), call in self._calls.items():
            if where == place and name in functions:
                # a trial that is to be mapped in any case needs no more answers
                open_ones = (call.trials & covering) - found
                if open_ones and not call.alike(module):
                    found |= open_ones
        return found

    def _noting(
        self, place: str, name: str, original: Callable[..., Any], trial: str
    ) -> Callable[..., Any]:
        def call(*args: Any, **kwargs: Any) -> Any:
            asked = _asked(args, kwargs)
            kept = self._calls.get((place, name, asked))
            if kept is not None:
                kept.trials.add(trial)
                return original(*args, **kwargs)
            before = _copied(args), _copied(kwargs)
            try:
                answer = original(*args, **kwargs)
            except BaseException:
                self._incomplete.add(place)
                raise
            shared = _shared(args, kwargs, answer)
            self._calls[place, name, asked] = Call(
                name, *before, asked, bits(answer), shared, {trial}
            )
            return answer

        return call


def _asked_through(site: Site, tree: ast.Module) -> set[str]:
    """The functions through whose answers alone a change can reach a map; empty where there may be other ways."""
    place = site.module
    changed = site.function.split(".")[0]
    functions = FUNCTIONS.get(place, ())
    if site.function in functions:
        return {site.function}
    if place not in WHOLE:
        return set()
    if any(
        isinstance(node, ast.ClassDef) and node.name == changed
        for node in tree.body
    ):
        return set()
    used = _used_names(tree)
    return {name for name in functions if changed in _reached(name, used)}


def _used_names(tree: ast.Module) -> dict[str, set[str]]:
    """For each name at a module's top, the names in what defines it. A site is named after the first of several."""
    used: dict[str, set[str]] = {}
    for node in tree.body:
        inside = {n.id for n in ast.walk(node) if isinstance(n, ast.Name)}
        if isinstance(node, ast.FunctionDef):
            used.setdefault(node.name, set()).update(inside)
        elif isinstance(node, ast.Assign | ast.AnnAssign):
            # with tuples of names: each leads to all of them
            for name in {
                n.id
                for n in ast.walk(node)
                if isinstance(n, ast.Name) and isinstance(n.ctx, ast.Store)
            }:
                used.setdefault(name, set()).update(inside)
    return used


def _reached(name: str, used: Mapping[str, set[str]]) -> set[str]:
    found = {name}
    new = [name]
    while new:
        for other in used.get(new.pop(), set()) - found:
            found.add(other)
            new.append(other)
    return found


def _asked(args: tuple[Any, ...], kwargs: dict[str, Any]) -> Bits:
    return bits([args, [[key, value] for key, value in kwargs.items()]])


def _copied(value: Any) -> Any:
    """A copy whose arrays can be written into; what holds none is given back as it is."""
    return (
        copy.deepcopy(value)
        if next(_arrays(value), None) is not None
        else value
    )


def _arrays(value: Any) -> Iterator[Any]:
    if isinstance(value, np.ndarray):
        yield value
    elif isinstance(value, list | tuple):
        for part in value:
            yield from _arrays(part)
    elif isinstance(value, dict):
        yield from _arrays(list(value.values()))


def _shared(
    args: tuple[Any, ...], kwargs: dict[str, Any], answer: Any
) -> tuple[bool, ...]:
    """Which arrays of the answer share memory with an argument, or with one another."""
    asked = list(_arrays([args, kwargs]))
    given = list(_arrays(answer))
    pairs = [
        *itertools.product(given, asked),
        *itertools.combinations(given, 2),
    ]
    return tuple(np.may_share_memory(a, b) for a, b in pairs)


def _values(place: str, module: ModuleType) -> list[Bits]:
    return [
        bits(getattr(module, name, None)) for name in VALUES.get(place, ())
    ]
