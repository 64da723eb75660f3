"""Pictures of programs that are no ports: PGM, and by Pillow whatever else keeps grey values as they are."""

from __future__ import annotations

import io
import warnings
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from PIL import Image, UnidentifiedImageError

from occgrid_parity.formats.errors import MAX_CELLS, OutputError
from occgrid_parity.formats.pgm import Pixels, read_any_pgm, scaled

EXACT = ("PNG", "BMP", "GIF", "PPM", "TIFF")
"""Kinds of pictures that give back the grey values that were put in."""

SUFFIXES = (".png", ".bmp", ".gif", ".ppm", ".pnm", ".tif", ".tiff")
BYTES = 8 * MAX_CELLS


@dataclass(frozen=True)
class Picture:
    """A picture: its levels, scaled to 255 from its own maximum ``top``. ``kind`` is empty for PGM, else its name."""

    pixels: Pixels
    top: int
    kind: str = ""


class WrongKind(OutputError):
    """A picture that cannot hold a map, or a file that is no picture that anybody knows."""


class CutOff(OutputError):
    """A picture that ends too early."""


def read_picture(path: Path) -> Picture:
    """The grey picture in a file.

    Raises WrongKind, CutOff or OutputError where there is none, and OSError where the file cannot be read.
    """
    with path.open("rb") as file:
        if file.read(2) in (b"P2", b"P5"):
            return Picture(*read_any_pgm(path))
        file.seek(0)
        data = file.read(BYTES)
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", Image.DecompressionBombWarning)
            image = Image.open(io.BytesIO(data))
    except UnidentifiedImageError as error:
        shown = data[:8].decode("ascii", "backslashreplace").split("\n")[0]
        raise WrongKind(
            path, f"begins with {shown!r}, a PGM picture with P2 or P5"
        ) from error
    except (Image.DecompressionBombError, ValueError) as error:
        raise OutputError(path, str(error)) from error
    kind = image.format or ""
    if kind not in EXACT:
        raise WrongKind(
            path,
            f"is a {kind} picture, which need not keep grey values as they are; PGM and PNG do",
        )
    if image.width * image.height > MAX_CELLS:
        size = f"{image.width} x {image.height}"
        raise OutputError(path, f"{size} is not from 1 to {MAX_CELLS} cells")
    try:
        image.load()
    except (OSError, ValueError, SyntaxError) as error:
        raise CutOff(path, f"a {kind} picture: {error}") from error
    levels, top = _grey(path, kind, image)
    return Picture(scaled(levels, top), top, kind)


def _grey(
    path: Path, kind: str, image: Image.Image
) -> tuple[NDArray[np.int64], int]:
    """The levels of an image, and their maximum."""
    if image.mode == "1":
        raise WrongKind(
            path,
            f"is a {kind} picture of two colours; a map has 256 levels of grey",
        )
    if image.mode.startswith("I"):
        return np.asarray(image, dtype=np.int64), 65535
    if image.mode == "L":
        return np.asarray(image, dtype=np.int64), 255
    colours = np.asarray(image.convert("RGBA"), dtype=np.int64)
    red, green, blue, alpha = np.moveaxis(colours, -1, 0)
    wrong = (red != green) | (green != blue) | (alpha != 255)
    if wrong.any():
        row, column = (int(k) for k in np.argwhere(wrong)[0])
        found = ", ".join(str(v) for v in colours[row, column])
        raise OutputError(
            path,
            f"a {kind} picture with colours: the pixel in row {row + 1}, column {column + 1} has red, green, blue and "
            f"opacity {found}; in a grey picture the first three are equal and the last is 255",
        )
    return red, 255
