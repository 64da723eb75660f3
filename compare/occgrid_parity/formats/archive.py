"""A folder as one archive: what is hashed, and what travels to another machine."""

from __future__ import annotations

import hashlib
import io
import stat
import tarfile
from collections.abc import Collection
from dataclasses import dataclass, field
from fnmatch import fnmatch
from pathlib import Path


class ArchiveError(Exception):
    """A folder that cannot be packed, in one line."""


@dataclass(frozen=True)
class Archive:
    """The files of a folder. The same files make the same bytes; ``left_out`` names what is no file."""

    data: bytes = field(repr=False)
    left_out: tuple[str, ...] = ()

    @property
    def digest(self) -> str:
        """The SHA-256 of the bytes."""
        return hashlib.sha256(self.data).hexdigest()


NOTHING = Archive(b"")


def pack(folder: Path, limit: int, without: Collection[str] = ()) -> Archive:
    """Packs a folder of at most ``limit`` bytes, but for what one of the patterns ``without`` names.

    Links are kept where they stay in the folder; other links, pipes and devices are left out and named. Raises
    ArchiveError where the folder is too large or a file cannot be read.
    """
    root = folder.resolve()
    text = io.BytesIO()
    left_out: list[str] = []
    total = 0
    with tarfile.open(
        fileobj=text, mode="w", format=tarfile.PAX_FORMAT
    ) as tar:
        for path in sorted(folder.rglob("*")):
            inside_it = path.relative_to(folder)
            if any(fnmatch(x, y) for x in inside_it.parts for y in without):
                continue
            name = inside_it.as_posix()
            try:
                about = path.lstat()
                entry = tarfile.TarInfo(name)
                entry.mode = 0o755 if about.st_mode & 0o111 else 0o644
                if stat.S_ISDIR(about.st_mode):
                    entry.type = tarfile.DIRTYPE
                    entry.mode = 0o755
                    tar.addfile(entry)
                elif stat.S_ISLNK(about.st_mode):
                    target = path.readlink()
                    inside = (path.parent / target).resolve()
                    if target.is_absolute() or not inside.is_relative_to(root):
                        left_out.append(name)
                        continue
                    entry.type = tarfile.SYMTYPE
                    entry.linkname = str(target)
                    tar.addfile(entry)
                elif stat.S_ISREG(about.st_mode):
                    total += about.st_size
                    if total > limit:
                        raise ArchiveError(
                            f"it is larger than {limit // 2**20} MiB"
                        )
                    data = path.read_bytes()
                    entry.size = len(data)
                    tar.addfile(entry, io.BytesIO(data))
                else:
                    left_out.append(name)
            except (OSError, ValueError) as error:
                raise ArchiveError(
                    f"{name!r} cannot be read: {error}"
                ) from error
    return Archive(text.getvalue(), tuple(left_out))


def unpack(data: bytes, folder: Path) -> None:
    """Writes the files of an archive into a new folder."""
    folder.mkdir(parents=True)
    with tarfile.open(fileobj=io.BytesIO(data)) as tar:
        # Python 3.11.4 and later filter, and warn where it is not said how
        tar.extraction_filter = getattr(tarfile, "tar_filter", None)
        tar.extractall(folder)
