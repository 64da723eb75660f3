"""Flags that change the map's bits are refused: by the program when it starts, by the compiler, and by CMake.

Each flag is seen refused in a program that is built without CMake (all of it as one source), and most of them when
CMake configures the port. Flags that change nothing are seen accepted, with the same map.
"""

from __future__ import annotations

import platform
import tempfile
from pathlib import Path

from building import PORT, arguments, include_flags, must, run, unity

CHANGE_BITS = [
    "-funsafe-math-optimizations",
    "-fassociative-math -fno-signed-zeros -fno-trapping-math",
    "-freciprocal-math",
    "-ffast-math -fno-finite-math-only",
    "-ffast-math",
    "-Ofast",
]
X86 = platform.machine() in ("x86_64", "AMD64")
FUSED = "-ffp-contract=fast -mfma" if X86 else "-ffp-contract=fast"
"""CMake's build puts -ffp-contract=off behind it, which gives the right bits."""
HARMLESS = ["-O0", "-O3 -march=native -ffp-contract=off"]

AT_START = "flags that change the map's bits"
IN_COMPILATION = ("without -ffast-math", "no extended precision")
IN_CMAKE = "flags change the map's bits"


def refused_by_the_program(compiler: str, flags: str, folder: Path) -> str:
    """'' where the program is refused as it should be, else what is wrong."""
    program = folder / "occgrid"
    program.unlink(missing_ok=True)
    status, text = run(
        [
            compiler,
            "-O2",
            *include_flags(),
            *flags.split(),
            unity(folder),
            "-o",
            program,
        ]
    )
    if status != 0:
        return "" if any(m in text for m in IN_COMPILATION) else text[-2000:]
    for more in ([], ["--plain"], ["--out", str(folder / "maps")]):
        status, text = run([program, *more])
        if status != 1 or AT_START not in text or text.count("\n") != 1:
            return f"{more}: status {status}, {text[:300]!r}"
    return "a map was written" if (folder / "maps").exists() else ""


def refused_by_cmake(compiler: str, flags: str, folder: Path) -> str:
    """The same for the port's own build."""
    # the -O2 of a release would come behind -Ofast and take it back
    release = "_RELEASE" if flags == "-Ofast" else ""
    command: list[str | Path] = [
        "cmake",
        "-S",
        PORT,
        "-B",
        folder / "configured",
    ]
    command += [f"-DCMAKE_CXX_COMPILER={compiler}"]
    command += [f"-DCMAKE_CXX_FLAGS{release}={flags}"]
    status, text = run(command)
    if status != 0 and IN_CMAKE in " ".join(text.split()):
        return ""
    return f"status {status}: {text[-500:]}"


def main() -> None:
    options = arguments()
    compiler = options.compiler
    lesson = must([options.build / "occgrid", "--noise-free"])
    clang = "clang" in must([compiler, "--version"])
    wrong = 0

    def report(what: str, problem: str) -> None:
        nonlocal wrong
        wrong += bool(problem)
        print(
            f"{'FAILED' if problem else 'ok'}: {what}  {problem}", flush=True
        )

    with tempfile.TemporaryDirectory() as temporary:
        folder = Path(temporary)
        programs = [*CHANGE_BITS, FUSED]
        if X86 and not clang:
            programs.append("-mfpmath=387")
        for flags in programs:
            report(
                f"{flags}: the program is refused",
                refused_by_the_program(compiler, flags, folder),
            )
        for number, flags in enumerate(programs):
            if flags == FUSED:
                continue
            own = folder / str(number)
            report(
                f"{flags}: CMake refuses",
                refused_by_cmake(compiler, flags, own),
            )
        for flags in HARMLESS:
            program = folder / "harmless"
            must(
                [
                    compiler,
                    "-O2",
                    *include_flags(),
                    *flags.split(),
                    unity(folder),
                    "-o",
                    program,
                ]
            )
            same = must([program, "--noise-free"]) == lesson
            report(f"{flags}: accepted", "" if same else "another map")
    raise SystemExit(1 if wrong else 0)


if __name__ == "__main__":
    main()
