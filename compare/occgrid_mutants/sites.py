"""The places where the sources can be changed, and how: an operator, constant, branch, argument or statement."""

from __future__ import annotations

import ast
import math
import re
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from functools import partial
from typing import Any

OPERATORS: dict[type[ast.AST], tuple[type[Any], ...]] = {
    ast.Add: (ast.Sub,),
    ast.Sub: (ast.Add,),
    ast.Mult: (ast.Div,),
    ast.Div: (ast.Mult,),
    ast.FloorDiv: (ast.Mult,),
    ast.Mod: (ast.Mult,),
    ast.Pow: (ast.Mult,),
    ast.LShift: (ast.RShift,),
    ast.RShift: (ast.LShift,),
    ast.BitAnd: (ast.BitOr,),
    ast.BitOr: (ast.BitAnd,),
    ast.BitXor: (ast.BitOr,),
    ast.Lt: (ast.LtE, ast.GtE),
    ast.LtE: (ast.Lt, ast.Gt),
    ast.Gt: (ast.GtE, ast.LtE),
    ast.GtE: (ast.Gt, ast.Lt),
    ast.Eq: (ast.NotEq,),
    ast.NotEq: (ast.Eq,),
    ast.Is: (ast.IsNot,),
    ast.IsNot: (ast.Is,),
    ast.In: (ast.NotIn,),
    ast.NotIn: (ast.In,),
    ast.And: (ast.Or,),
    ast.Or: (ast.And,),
}
HEX_WORD = re.compile(r"\b[0-9A-F]{6}(?:[0-9A-F]{10})?\b")


@dataclass(frozen=True)
class Site:
    """One change: where it is, what it is, and how it is made in the tree of its module."""

    module: str
    function: str  # or the name of what is defined at the module's top
    line: int
    lines: tuple[int, int]  # the first and last of what runs with it
    kind: str
    before: str
    after: str
    at_import: bool  # the line runs when the module is imported
    change: Callable[[], None] = field(repr=False, compare=False)

    @property
    def name(self) -> str:
        """Says what is changed; lines move, this does not."""
        return f"{self.module}.{self.function}: {self.before} -> {self.after}"


def sites(module: str, tree: ast.Module) -> list[Site]:
    """Every change of a module. Each acts on ``tree`` itself, which is thus to be used once."""
    return list(_Finder(module).body(tree, [], at_import=True))


class _Finder:
    def __init__(self, module: str) -> None:
        self.module = module
        self.lines = (0, 0)

    def body(
        self, node: ast.AST, path: list[str], at_import: bool
    ) -> Iterator[Site]:
        """The changes in the statements of a node, and in what these hold."""
        for name, value in ast.iter_fields(node):
            if isinstance(node, ast.FunctionDef) and name == "args":
                at_import = True  # defaults
            elif isinstance(node, ast.FunctionDef):
                at_import = False
            if name in ("annotation", "returns", "type_params"):
                continue
            if name == "decorator_list" or isinstance(value, str):
                continue
            if isinstance(value, list):
                for i in range(len(value)):
                    yield from self.child(node, value, i, path, at_import)
            elif isinstance(value, ast.AST):
                yield from self.one(
                    value, _setter(node, name), node, path, at_import
                )

    def child(
        self,
        node: ast.AST,
        values: list[Any],
        i: int,
        path: list[str],
        at_import: bool,
    ) -> Iterator[Site]:
        """The changes of one of a list of nodes."""
        child = values[i]
        if not isinstance(child, ast.AST):
            return

        def put(new: ast.AST) -> None:
            values[i] = new

        if isinstance(child, ast.stmt):
            if _is_docstring(child) or isinstance(
                child, ast.Import | ast.ImportFrom
            ):
                return
            here = _named(child, path)
            if isinstance(child, ast.FunctionDef | ast.ClassDef):
                inside = at_import and isinstance(child, ast.ClassDef)
                if any(
                    isinstance(d, ast.Name) and d.id == "overload"
                    for d in child.decorator_list
                ):
                    return
                yield from self.body(child, here, inside)
                return
            self.lines = _lines(child)
            yield from self.statement(child, put, here, at_import)
            if isinstance(child, ast.AugAssign):
                yield from self.operator(child, here, at_import)
            yield from self.body(child, here, at_import)
            return
        if isinstance(child, ast.match_case):
            self.lines = (child.pattern.lineno, child.pattern.lineno)
        yield from self.one(child, put, node, path, at_import)

    def statement(
        self,
        node: ast.stmt,
        put: Callable[[ast.AST], None],
        path: list[str],
        at_import: bool,
    ) -> Iterator[Site]:
        """A statement left out."""
        left_out = (
            ast.Expr | ast.AugAssign | ast.Raise | ast.Break | ast.Continue
        )
        if isinstance(node, left_out) or (
            isinstance(node, ast.Assign)
            and not isinstance(node.targets[0], ast.Name)
            and not isinstance(node.targets[0], ast.Tuple)
        ):
            yield self.site(
                node,
                path,
                at_import,
                "statement",
                "pass",
                lambda: put(_at(ast.Pass(), node)),
            )
        elif isinstance(node, ast.Return) and node.value is not None:
            yield self.site(
                node,
                path,
                at_import,
                "statement",
                "return None",
                lambda: put(_at(ast.Return(None), node)),
            )
        elif (
            isinstance(node, ast.Assign | ast.AnnAssign)
            and path[:1]
            and not at_import
        ):
            # a name that is assigned anew keeps what it had
            yield self.site(
                node,
                path,
                at_import,
                "statement",
                "pass",
                lambda: put(_at(ast.Pass(), node)),
            )
        if isinstance(node, ast.If | ast.While):
            test = node.test
            for value in (
                (True, False) if isinstance(node, ast.If) else (False,)
            ):

                def decide(value: bool = value) -> None:
                    node.test = _at(ast.Constant(value), test)

                yield self.site(
                    test, path, at_import, "branch", str(value), decide
                )

    def one(
        self,
        node: ast.AST,
        put: Callable[[ast.AST], None],
        parent: ast.AST,
        path: list[str],
        at_import: bool,
    ) -> Iterator[Site]:
        """The changes of an expression and of what it holds."""
        if isinstance(node, ast.BinOp | ast.BoolOp):
            yield from self.operator(node, path, at_import)
        elif isinstance(node, ast.Compare):
            for i, op in enumerate(node.ops):
                for new in OPERATORS.get(type(op), ()):
                    yield self.compared(node, i, new, path, at_import)
        elif isinstance(node, ast.UnaryOp) and not isinstance(
            node.op, ast.UAdd
        ):
            operand = node.operand
            yield self.site(
                node,
                path,
                at_import,
                "operator",
                ast.unparse(operand),
                lambda: put(operand),
            )
        elif isinstance(node, ast.IfExp):
            for new_value in (node.body, node.orelse):
                yield self.site(
                    node,
                    path,
                    at_import,
                    "branch",
                    ast.unparse(new_value),
                    partial(put, new_value),
                )
        elif isinstance(node, ast.comprehension):
            for i, test in enumerate(node.ifs):

                def drop(i: int = i, test: ast.expr = test) -> None:
                    node.ifs[i] = _at(ast.Constant(True), test)

                yield self.site(test, path, at_import, "branch", "True", drop)
        elif isinstance(node, ast.Constant):
            yield from self.constant(node, path, at_import)
            return
        elif isinstance(node, ast.Call):
            yield from self.arguments(node, path, at_import)
        elif isinstance(node, ast.Subscript) and (
            ast.unparse(node.value) == "Literal"
        ):
            return  # a type
        yield from self.body(node, path, at_import)

    def operator(
        self,
        node: ast.BinOp | ast.BoolOp | ast.AugAssign,
        path: list[str],
        at_import: bool,
    ) -> Iterator[Site]:
        """Another operator."""
        kept = node.op
        for new in OPERATORS.get(type(kept), ()):
            node.op = new()
            after = ast.unparse(node)
            node.op = kept

            def change(new: type[Any] = new) -> None:
                node.op = new()

            yield self.site(node, path, at_import, "operator", after, change)

    def compared(
        self,
        node: ast.Compare,
        i: int,
        new: type[Any],
        path: list[str],
        at_import: bool,
    ) -> Site:
        """Another comparison."""
        kept = node.ops[i]

        def change() -> None:
            node.ops[i] = new()

        change()
        after = ast.unparse(node)
        node.ops[i] = kept
        return self.site(node, path, at_import, "operator", after, change)

    def constant(
        self, node: ast.Constant, path: list[str], at_import: bool
    ) -> Iterator[Site]:
        """Another constant: the next one, or one unit in the last place away."""
        value = node.value
        for new in _neighbours(value):

            def change(new: object = new) -> None:
                node.value = new  # type: ignore[assignment]

            yield self.site(
                node,
                path,
                at_import,
                "constant",
                _shown(new, value),
                change,
                _shown(value, new),
            )

    def arguments(
        self, node: ast.Call, path: list[str], at_import: bool
    ) -> Iterator[Site]:
        """Two arguments that stand side by side are swapped; one with a name is left out."""
        args = node.args

        def swap(i: int) -> None:
            args[i], args[i + 1] = args[i + 1], args[i]

        for i in range(len(args) - 1):
            if ast.dump(args[i]) == ast.dump(args[i + 1]):
                continue
            swap(i)
            after = ast.unparse(node)
            swap(i)
            yield self.site(
                node, path, at_import, "argument", after, partial(swap, i)
            )
        for keyword in list(node.keywords):
            node.keywords.remove(keyword)
            after = ast.unparse(node)
            node.keywords.append(keyword)
            yield self.site(
                node,
                path,
                at_import,
                "argument",
                after,
                partial(node.keywords.remove, keyword),
            )

    def site(
        self,
        node: Any,
        path: list[str],
        at_import: bool,
        kind: str,
        after: str,
        change: Callable[[], None],
        before: str | None = None,
    ) -> Site:
        """A change with its place."""
        return Site(
            self.module,
            ".".join(path) or "top",
            node.lineno,
            self.lines,
            kind,
            _short(ast.unparse(node) if before is None else before),
            _short(after),
            at_import,
            change,
        )


def _neighbours(value: object) -> Iterator[object]:
    if isinstance(value, bool):
        yield not value
    elif isinstance(value, int):
        yield from (value + 1, value - 1)
    elif isinstance(value, float):
        yield value + 1.0
        if value != 0.0 and math.isfinite(value):
            yield math.nextafter(value, math.inf)
            yield math.nextafter(value, -math.inf)
    elif isinstance(value, str):
        words = list(HEX_WORD.finditer(value))
        for word in words:
            end = word.end() - 1
            digit = f"{int(value[end], 16) ^ 1:X}"
            yield value[:end] + digit + value[end + 1 :]
        if not words:
            yield value + "0"
    elif isinstance(value, bytes):
        yield value + b"0"


def _shown(value: object, other: object) -> str:
    """A constant; of a table of words only the one that changes."""
    if isinstance(value, str) and isinstance(other, str):
        mine, others = value.split(), other.split()
        if len(mine) == len(others) > 1:
            for word, instead in zip(mine, others, strict=True):
                if word != instead:
                    return word
    return repr(value)


def _lines(node: ast.stmt) -> tuple[int, int]:
    """The lines of a statement, without those of the statements in it."""
    inner = getattr(node, "body", None)
    if isinstance(inner, list) and inner:
        return node.lineno, max(node.lineno, inner[0].lineno - 1)
    if isinstance(node, ast.Match):
        return node.lineno, node.lineno
    return node.lineno, node.end_lineno or node.lineno


def _setter(node: ast.AST, name: str) -> Callable[[ast.AST], None]:
    return lambda new: setattr(node, name, new)


def _at(new: Any, old: ast.AST) -> Any:
    return ast.fix_missing_locations(ast.copy_location(new, old))


def _is_docstring(node: ast.stmt) -> bool:
    return isinstance(node, ast.Expr) and (
        isinstance(node.value, ast.Constant)
    )


def _named(node: ast.stmt, path: list[str]) -> list[str]:
    if isinstance(node, ast.FunctionDef | ast.ClassDef):
        return [*path, node.name]
    if not path and isinstance(node, ast.Assign | ast.AnnAssign):
        target = (
            node.targets[0] if isinstance(node, ast.Assign) else node.target
        )
        return [ast.unparse(target).split(",")[0].strip("(")]
    return path


def _short(text: str) -> str:
    line = " ".join(text.split())
    return line if len(line) <= 90 else f"{line[:87]}..."
