"""A command as one text and as words, in the way of this system."""

from __future__ import annotations

import shlex
import subprocess
import sys
from collections.abc import Sequence
from pathlib import PurePath

WINDOWS = sys.platform == "win32"


def split_words(text: str, windows: bool = WINDOWS) -> list[str]:
    """The words of a command, as a shell splits them; on Windows a backslash is a letter like others.

    Raises ValueError where a quotation mark has no partner.
    """
    if not windows:
        return shlex.split(text)
    lexer = shlex.shlex(text, posix=True)
    lexer.whitespace_split = True
    lexer.commenters = lexer.escape = ""
    return list(lexer)


def join_words(words: Sequence[str], windows: bool = WINDOWS) -> str:
    """The words as a text that the system's shell splits into them again."""
    return subprocess.list2cmdline(words) if windows else shlex.join(words)


def is_path(word: str) -> bool:
    """Whether a word says where a file is, and not only its name."""
    return PurePath(word).name != word
