"""Whether a text is one expression of the Wolfram Language: all brackets, strings and comments pair."""

from __future__ import annotations

_PAIRS = {"]": "[", "}": "{", ")": "("}


class SyntaxProblem(ValueError):
    """What does not pair, and where."""


def check_expression(text: str, head: str) -> None:
    """Raises SyntaxProblem unless the text is ``head[...]``, balanced, and nothing but comments around it."""
    code = _without_comments(text)
    body = code.strip()
    if not body.startswith(head + "["):
        raise SyntaxProblem(f"does not begin with {head}[")
    open_at: list[tuple[str, int]] = []
    in_string = escaped = False
    previous = ""
    for at, character in enumerate(body):
        if in_string:
            if escaped:
                escaped = False
            elif character == "\\":
                escaped = True
            elif character == '"':
                in_string, previous = False, '"'
            continue
        if character == '"':
            if previous in ('"', "]", "}"):
                raise SyntaxProblem(f"a comma is missing at {at}")
            in_string = True
        elif character in "[{(":
            open_at.append((character, at))
        elif character in _PAIRS:
            if not open_at or open_at[-1][0] != _PAIRS[character]:
                raise SyntaxProblem(f"{character} at {at} closes nothing")
            if previous == ",":
                raise SyntaxProblem(f"nothing after a comma at {at}")
            open_at.pop()
            if not open_at and at != len(body) - 1:
                raise SyntaxProblem(f"more than one expression, at {at}")
        if not character.isspace():
            previous = character
    if in_string:
        raise SyntaxProblem("a string is never closed")
    if open_at:
        raise SyntaxProblem(f"{open_at[-1][0]} at {open_at[-1][1]} is open")


def _without_comments(text: str) -> str:
    """The text without (* comments *), which nest; strings stay as they are."""
    kept: list[str] = []
    depth = at = 0
    in_string = False
    while at < len(text):
        two = text[at : at + 2]
        if in_string:
            step = 2 if two[:1] == "\\" else 1
            kept.append(text[at : at + step])
            in_string = two[:1] != '"'
            at += step
        elif two == "(*":
            depth, at = depth + 1, at + 2
        elif two == "*)" and depth:
            depth, at = depth - 1, at + 2
        else:
            if not depth:
                kept.append(text[at])
                in_string = text[at] == '"'
            at += 1
    if depth:
        raise SyntaxProblem("a comment is never closed")
    return "".join(kept)
