"""How a starter is built, run and asked, in each language."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass


@dataclass(frozen=True)
class Declaration:
    """Keys of a port.toml. ``program`` holds its lines for ``build`` and ``run``, ``needs`` what a wall hides."""

    program: str
    probe: str
    timeout: int = 60
    needs: str = ""

    def toml(self) -> str:
        """The lines of the port.toml."""
        return f"{self.program}timeout = {self.timeout}\n{self.probe}"


DECLARATIONS: Mapping[str, Declaration] = {
    "python": Declaration(
        """\
build = []
run = ["{python}", "{port}/run.py", "{mode}", "--plain", "--out", "{out}", "{scenario}"]
""",
        """\
probe = ["{python}", "{port}/ask.py", "{function}", "{input}", "{output}"]
""",
        needs="{python} is the system's python3, which needs NumPy (Debian's package python3-numpy).",
    ),
    "cpp": Declaration(
        """\
build = [
    ["cmake", "-S", "{port}", "-B", "{port}/build", "-DCMAKE_BUILD_TYPE=Debug",
     "-DOCCGRID_WERROR=OFF", "-DOCCGRID_UNITY_BUILD=OFF"],
    ["cmake", "--build", "{port}/build", "--parallel", "2", "--target", "occgrid", "probe"],
]
run = ["{port}/build/occgrid", "{mode}", "--plain", "--out", "{out}", "{scenario}"]
""",
        """\
probe = ["{port}/build/probe", "{function}", "{input}", "{output}"]
""",
    ),
    "java": Declaration(
        """\
build = [
    ["javac", "-d", "{port}/classes", "-sourcepath", "{port}/src/main/java",
     "{port}/src/main/java/occgrid/Main.java", "{port}/src/test/java/occgrid/Probe.java"],
]
run = ["java", "-cp", "{port}/classes", "occgrid.Main", "{mode}", "--plain", "--out", "{out}", "{scenario}"]
""",
        """\
probe = ["java", "-cp", "{port}/classes", "occgrid.Probe", "{function}", "{input}", "{output}"]
""",
    ),
    "matlab": Declaration(
        """\
build = []
run = ["sh", "{port}/matlab.sh", "occgrid", "{mode}", "--plain", "--out", "{out}", "{scenario}"]
""",
        """\
probe = ["sh", "{port}/matlab.sh", "probe", "{function}", "{input}", "{output}"]
""",
        needs='MATLAB outside /usr must be among the folders that programs see: readable = ["/opt/matlab"].',
    ),
    "mathematica": Declaration(
        """\
build = []
run = ["sh", "{port}/wolfram.sh", "{port}/occgrid.wls", "{mode}", "--plain", "--out", "{out}", "{scenario}"]
""",
        """\
probe = ["sh", "{port}/wolfram.sh", "{port}/tests/probe.wls", "{function}", "{input}", "{output}"]
""",
        timeout=300,
        needs="A Wolfram kernel, or woxi, outside /usr must be among the folders that programs see (readable) and on "
        "their PATH (environment).",
    ),
}
