"""The small parsers of signatures: one definition of each kind in each language."""

from __future__ import annotations

from pathlib import Path

import pytest

from .port_signatures import Signatures, read_signatures


def signatures(folder: Path, suffix: str, text: str) -> Signatures:
    path = folder / f"source{suffix}"
    path.write_text(text)
    return read_signatures(path)


@pytest.mark.parametrize(
    ("suffix", "text"),
    [
        (".py", "def f(\n    a: int, b: dict[str, int] = {}\n) -> int:\n"),
        (".py", "class f:\n    def __init__(self, a: int, b=1) -> None:\n"),
        (".py", "class f(NamedTuple):\n    a: int\n    b: float = 1.0\n"),
        (".hpp", "std::vector<int> f(const int& a,\n    double b = g(1, 2));"),
        (".hpp", "class X {\n  explicit f(const Y& a, double b = 0.5);\n};"),
        (".hpp", "struct f {\n  int a;  ///< one\n  double b = 1.0;\n};"),
        (".hpp", "std::function<std::optional<Scan>()> f(\n    X a, Y b);"),
        (".java", "    public static int[] f(int[] a,\n        double b) {"),
        (".java", "    public record f(int a, List<Map<X, Y>> b) {"),
        (".java", "        public f(int a, double b) {"),
        (".java", "    public static List<X> f(X a, Y b) {"),
        (".m", "    function [x, y] = f( ...\n        a, b)\n"),
        (".m", "function f(a, b)\n"),
        (".wl", "f[c_] := 1;\nF[a_?q, b : {_, _}] := 2;\nF[___] := 0;"),
        (".wl", 'RangeScan::usage = "F[a, b] is one.";'),
        (".js", "export function* f(a, b = [1, 2]) {"),
        (".js", "export async function f(a, b) {"),
        (".js", "export class f {\n  constructor(a, b) {\n  }\n}"),
        (".js", "export class X {\n  f(a, b) {\n  }\n}"),
    ],
)
def test_reads_a_definition(tmp_path: Path, suffix: str, text: str) -> None:
    found = signatures(tmp_path, suffix, text)
    found = {name.lower(): several for name, several in found.items()}
    assert found["f"] == [("a", "b")]


@pytest.mark.parametrize(
    ("suffix", "text"),
    [
        (".py", '"""\ndef f(a):\n"""\n'),
        (".hpp", "// int f(int a);\n/* int f(int a); */\n"),
        (".hpp", "  return f(a);\n"),
        (".java", "    private int f(int a) {\n    static int f(int a) {\n"),
        (".m", "x = f(a);\n"),
        (".wl", "  F[a_] := 1;\ng[F[a_]] := 1;\n"),
        (".js", "function f(a) {\n}\n"),
        (".js", "class f {\n  constructor(a) {\n  }\n}"),
    ],
)
def test_takes_nothing_else(tmp_path: Path, suffix: str, text: str) -> None:
    found = signatures(tmp_path, suffix, text)
    assert "f" not in {name.lower() for name in found}


def test_reads_every_overload(tmp_path: Path) -> None:
    text = (
        "    public int f(int a) {\n    }\n    public int f(int b, int c) {\n"
    )
    found = signatures(tmp_path, ".java", text)
    assert found == {"f": [("a",), ("b", "c")]}
