"""Zip files that are the same at every build."""

from __future__ import annotations

import io
import time
import zipfile
from collections.abc import Mapping

# the first moment that a zip file can hold
EARLIEST = 315532800


def zip_bytes(
    folder: str,
    files: Mapping[str, bytes],
    programs: frozenset[str],
    seconds: int,
) -> bytes:
    """A zip file with one folder in it; ``programs`` are the names of the files that may be executed."""
    date = time.gmtime(max(seconds, EARLIEST))[:6]
    buffer = io.BytesIO()
    with zipfile.ZipFile(buffer, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, content in sorted(files.items()):
            entry = zipfile.ZipInfo(f"{folder}/{name}", date)
            mode = 0o755 if name in programs else 0o644
            entry.external_attr = mode << 16
            entry.create_system = 3  # Unix, wherever it is made
            entry.compress_type = zipfile.ZIP_DEFLATED
            archive.writestr(entry, content)
    return buffer.getvalue()
