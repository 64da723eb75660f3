"""The C++ port says the same bits whatever the compiler and its optimisation."""

from __future__ import annotations

import json
import shlex
import shutil
from collections.abc import Callable
from pathlib import Path

import pytest

from occgrid_parity.compare.matrix_run import REFERENCE, Plan, run
from occgrid_parity.compare.run_record import RunRecord
from occgrid_parity.ports.building import Built, build_port
from occgrid_parity.ports.declaration import Port
from occgrid_parity.processes.pool import side_by_side
from occgrid_parity.report.run_table import explain_result
from occgrid_parity.suite.modes import DEFAULT_MODES
from occgrid_parity.suite.scenarios import choose_scenarios

from .conftest import JOBS, ROOT, unavailable

pytestmark = pytest.mark.long

COMPILERS = {"g++": "g++", "clang++": "clang"}
"""Command, and the package that brings it."""

FLAGS = ["-O0", "-O2", "-O3 -march=native"]
VARIANTS = [(compiler, flags) for compiler in COMPILERS for flags in FLAGS]


def variant_name(compiler: str, flags: str) -> str:
    words = [compiler.replace("+", "p"), *flags.replace("=", "-").split()]
    return "".join(words)


def variant(port: Port, compiler: str, flags: str, folder: Path) -> Port:
    """The C++ port under a name of its own, built by that compiler into ``folder``.

    The build type None keeps CMake from adding optimisation of its own.
    """
    settings = [
        f"-DCMAKE_CXX_COMPILER={compiler}",
        f"-DCMAKE_CXX_FLAGS={flags}",
        "-DCMAKE_BUILD_TYPE=None",
        "-DCMAKE_EXPORT_COMPILE_COMMANDS=ON",
    ]
    return Port(
        name=variant_name(compiler, flags),
        language=f"C++ by {compiler} {flags}",
        folder=port.folder,
        build=(
            ("cmake", "-S", "{port}", "-B", str(folder), *settings),
            ("cmake", "--build", str(folder), "--target", "occgrid"),
        ),
        run=(
            str(folder / "occgrid"),
            "{mode}",
            "--out",
            "{out}",
            "{scenarios}",
        ),
        timeout=4 * port.timeout,
    )


@pytest.fixture(scope="session")
def variants(
    built: dict[str, Built], tmp_path_factory: pytest.TempPathFactory
) -> dict[str, Built]:
    """The C++ port as every compiler that is here builds it."""
    if "cpp" not in built or built["cpp"].problem:
        return {}
    folder = tmp_path_factory.mktemp("compilers")
    ports = [
        variant(
            built["cpp"].port,
            compiler,
            flags,
            folder / variant_name(compiler, flags),
        )
        for compiler, flags in VARIANTS
        if shutil.which(compiler) is not None
    ]

    def build(port: Port, stop: object) -> Built:
        return build_port(port, folder)

    return {one.port.name: one for one in side_by_side(build, ports, JOBS)}


@pytest.fixture(scope="session")
def maps(
    built: dict[str, Built],
    variants: dict[str, Built],
    tmp_path_factory: pytest.TempPathFactory,
) -> RunRecord:
    """All variants over all scenarios."""
    everything = [built[REFERENCE], *variants.values()]
    plan = Plan(
        ports=[one.port for one in everything],
        scenarios=choose_scenarios(ROOT, []),
        modes=DEFAULT_MODES,
        folder=tmp_path_factory.mktemp("compiled-maps"),
        jobs=JOBS,
        built=everything,
    )
    return run(plan)


def need_compiler(name: str) -> None:
    """Skips the test where there is no such compiler."""
    if shutil.which(name) is None:
        unavailable(f"no {name}: install {COMPILERS[name]}")


@pytest.mark.parametrize(("compiler", "flags"), VARIANTS)
def test_the_same_bits(
    need: Callable[[str], Port],
    variants: dict[str, Built],
    maps: RunRecord,
    compiler: str,
    flags: str,
) -> None:
    need("cpp")
    need_compiler(compiler)
    name = variant_name(compiler, flags)
    found = [result for result in maps.results if result.port == name]
    assert len(found) == len(maps.scenarios) * len(maps.modes)
    wrong = [
        line
        for r in found
        if r.status != "identical"
        for line in explain_result(r)
    ]
    if wrong:
        pytest.fail("\n".join(wrong), pytrace=False)


@pytest.mark.parametrize(("compiler", "flags"), VARIANTS)
def test_is_built_with_these_flags(
    need: Callable[[str], Port],
    variants: dict[str, Built],
    compiler: str,
    flags: str,
) -> None:
    """The port's own build must not turn the flags into others."""
    need("cpp")
    need_compiler(compiler)
    one = variants[variant_name(compiler, flags)]
    assert not one.problem
    commands = json.loads(
        (Path(one.port.run[0]).parent / "compile_commands.json").read_text()
    )
    assert commands
    for command in commands:
        words = shlex.split(command["command"])
        assert Path(words[0]).name == compiler
        assert [w for w in words if w.startswith("-O")][-1] == flags.split()[0]
        assert set(flags.split()) <= set(words)
        assert "-ffast-math" not in words
