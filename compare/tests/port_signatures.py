"""The public names of a port's sources and their parameters, read by one small parser for each language.

A parser is a regular expression that finds definitions; what it needs of the language is how a definition begins and
where the name stands in a parameter. It knows the style of these ports, and no more of the language than that.
"""

from __future__ import annotations

import re
from collections import defaultdict
from collections.abc import Callable, Iterator
from pathlib import Path

Found = Iterator[tuple[str, tuple[str, ...]]]
Signatures = dict[str, list[tuple[str, ...]]]
"""A name's definitions: more than one where it is overloaded."""

BRACKETS = {"(": ")", "[": "]", "{": "}", "<": ">"}


def read_signatures(path: Path) -> Signatures:
    """What a source file defines: name to the parameters of each definition."""
    found: Signatures = defaultdict(list)
    text = path.read_text(encoding="utf-8")
    for name, parameters in PARSERS[path.suffix](text):
        found[name].append(parameters)
    return dict(found)


def inside(text: str, start: int) -> str:
    """What stands between the bracket at ``start`` and the one that closes it."""
    opening, closing = text[start], BRACKETS[text[start]]
    depth = 0
    for at in range(start, len(text)):
        depth += (text[at] == opening) - (text[at] == closing)
        if depth == 0:
            return text[start + 1 : at]
    raise ValueError(f"not closed: {text[start : start + 60]}")


def split(text: str) -> list[str]:
    """The parts between the commas that stand in no bracket."""
    parts, depth = [""], 0
    for character in text:
        depth += (character in "([{<") - (character in ")]}>")
        if character == "," and depth == 0:
            parts.append("")
        else:
            parts[-1] += character
    return [part.strip() for part in parts if part.strip()]


def definitions(
    text: str, pattern: str, name_of: Callable[[str], str]
) -> Found:
    """Each match of the pattern, whose group 1 is the name, and which ends with the bracket before the parameters."""
    for match in re.finditer(pattern, text, re.MULTILINE):
        parameters = split(inside(text, match.end() - 1))
        yield match[1], tuple(map(name_of, parameters))


def first_word(parameter: str) -> str:
    return str(re.findall(r"\w+", parameter)[0])


def last_word(parameter: str) -> str:
    """The last word before a default value."""
    return str(re.findall(r"\w+", parameter.partition("=")[0])[-1])


def fields(body: str) -> tuple[str, ...]:
    """The fields of a record: the last word of each declaration, without its value."""
    return tuple(last_word(part) for part in body.split(";") if part.strip())


def python(text: str) -> Found:
    """Functions, methods (without self), records by their fields, classes by __init__; the last of its overloads."""
    text = re.sub(r'""".*?"""', "", text, flags=re.DOTALL)
    text = re.sub(r"@overload\n *def (?:.|\n)*?: \.\.\.\n", "", text)
    yield from constants(text, r"^(pi)\b")
    for match in re.finditer(r"^class (\w+).*:\n((?: .*\n|\n)*)", text, re.M):
        record = re.findall(r"^    (\w+): [^\n]*$", match[2], re.MULTILINE)
        if "def __init__" not in match[2] and record:
            yield match[1], tuple(record)
    name = ""
    for match in re.finditer(
        r"^(?:class (\w+)| *(?:async )?def (\w+)\()", text, re.MULTILINE
    ):
        if match[1]:
            name = match[1]
            continue
        parameters = [
            first_word(part)
            for part in split(inside(text, match.end() - 1))
            if part not in ("self", "*", "/")
        ]
        yield (
            name if match[2] == "__init__" else match[2],
            tuple(parameters),
        )


def constants(text: str, pattern: str) -> Found:
    for match in re.finditer(pattern, text, re.MULTILINE):
        yield match[1], ()


def without_c_comments(text: str) -> str:
    return re.sub(r"/\*.*?\*/|//[^\n]*", "", text, flags=re.DOTALL)


def cpp(text: str) -> Found:
    """What a header declares: functions, methods, constructors, records by their fields."""
    text = without_c_comments(text).replace("()>", ">")
    yield from constants(text, r"^constexpr double (pi)\b")
    for match in re.finditer(r"^struct (\w+) \{", text, re.MULTILINE):
        body = inside(text, match.end() - 1)
        body = re.sub(r"^.*\) const;", "", body, flags=re.MULTILINE)
        yield match[1], fields(body)
    yield from definitions(text, r"^ *explicit (\w+)\(", last_word)
    yield from definitions(
        text,
        r"^ *(?! |return\b|explicit\b)[\w:<>,\s*&]+?[\s&>](\w+)\(",
        last_word,
    )


def java(text: str) -> Found:
    """What is public: methods, constructors, records."""
    text = without_c_comments(text)
    yield from constants(text, r"public static final double (PI)\b")
    yield from definitions(
        text,
        r"^ *public (?:static )?(?:final )?(?:record )?"
        r"(?:[\w.]+(?:<[^()]*?>)?(?:\[\])* )?(\w+)\(",
        last_word,
    )


def octave(text: str) -> Found:
    """Functions, the static methods of a class among them."""
    text = text.replace("...\n", "")
    yield from definitions(
        text, r"^ *function (?:[\w\[\], ]+? = )?(\w+)\(", first_word
    )


def wolfram(text: str) -> Found:
    """Definitions at the beginning of a line, but those that refuse wrong arguments; records by their usage."""
    yield from constants(text, r"^(PortablePi) =")
    for name, parameters in definitions(
        text, r"^([A-Z]\w*)\[", lambda part: part
    ):
        if parameters != ("___",):
            yield name, tuple(re.split("[_ ]", part)[0] for part in parameters)
    yield from definitions(
        text, r'^(?:Pose|Segment|RangeScan)::usage = "(\w+)\[', first_word
    )


def javascript(text: str) -> Found:
    """Exported functions, and of exported classes the constructor and the methods."""
    text = without_c_comments(text)
    yield from constants(text, r"^export const (PI)\b")
    yield from definitions(
        text, r"^export (?:async )?function\*? (\w+)\(", first_word
    )
    for match in re.finditer(r"^export class (\w+)[^{]*\{", text, re.M):
        body = inside(text, match.end() - 1)
        for name, parameters in definitions(body, r"^  (\w+)\(", first_word):
            yield (match[1] if name == "constructor" else name), parameters


def nothing(text: str) -> Found:
    yield from ()


PARSERS: dict[str, Callable[[str], Found]] = {
    ".py": python,
    ".hpp": cpp,
    ".cpp": nothing,
    ".h": cpp,
    ".java": java,
    ".m": octave,
    ".wl": wolfram,
    ".wls": nothing,
    ".js": javascript,
    ".mjs": nothing,
}
