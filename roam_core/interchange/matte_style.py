"""How mattes are written: kind of file, depth, compression, what stands in a file of its own."""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum

from roam_core.errors import RoamError
from roam_core.translatable import sentence

MATTES = "mattes"
"""The name of the format that is pictures; all others hold shapes."""


class MatteFile(StrEnum):
    """Kinds of picture files."""

    PNG = "png"
    EXR = "exr"
    TIFF = "tiff"


class Depth(StrEnum):
    """What a pixel is written as: whole numbers of 8 or 16 bits, or floating point of 16 or 32."""

    BITS_8 = "8"
    BITS_16 = "16"
    HALF = "half"
    FLOAT = "float"


class Parts(StrEnum):
    """What has a matte of its own: all shapes jointly, every layer, or every shape."""

    ALL = "all"
    LAYER = "layer"
    SHAPE = "shape"


class Gathering(StrEnum):
    """Where the mattes of one frame go: each into its own file, or all into one, as channels or as Cryptomatte."""

    FILES = "files"
    CHANNELS = "channels"
    CRYPTOMATTE = "cryptomatte"


class DataWindow(StrEnum):
    """Which pixels an EXR file holds: all, or only the rectangle outside of which everything is black."""

    FULL = "full"
    TIGHT = "tight"


DEPTHS = {
    MatteFile.PNG: (Depth.BITS_8, Depth.BITS_16),
    MatteFile.EXR: (Depth.HALF, Depth.FLOAT),
    MatteFile.TIFF: (Depth.BITS_8, Depth.BITS_16, Depth.FLOAT),
}
"""Depths that a kind of file can hold; the first is taken when nothing is asked for."""

COMPRESSIONS = {
    MatteFile.PNG: ("zip",),
    MatteFile.EXR: ("zip", "zips", "piz", "rle", "none"),
    MatteFile.TIFF: ("zip", "lzw", "packbits", "none"),
}
"""Compressions by kind of file, all without loss; the first is taken when nothing is asked for."""

SUFFIXES = {".png": MatteFile.PNG, ".exr": MatteFile.EXR, ".tif": MatteFile.TIFF, ".tiff": MatteFile.TIFF}
OTHER_SUFFIXES = {
    ".jpg",
    ".jpeg",
    ".dpx",
    ".tga",
    ".bmp",
    ".gif",
    ".webp",
    ".psd",
    ".sgi",
    ".mov",
    ".mp4",
    ".avi",
    ".mkv",
}
"""Of pictures and movies that are not written: a path with one of these is no folder that somebody means."""


@dataclass(frozen=True)
class MatteStyle:
    """How mattes are written.

    Attributes
    ----------
    file : the kind of the pictures.
    depth : None is the file's own: 8 bits, or half for EXR, or float for Cryptomatte, which has no other.
    compression : None is the file's own: zip.
    parts : what has a matte of its own.
    gathering : whether mattes of one frame are files, channels or Cryptomatte; the last two are EXR's alone. Under
        Cryptomatte `parts` say what is told apart: layers, shapes, or for all of them both.
    window : which pixels an EXR file holds.
    resumes : skip frames whose files are all there. Files appear under their names only when they are whole; whether
        the shapes have changed since is not looked at.

    Raises
    ------
    ValueError
        when a word is none of those that are meant.
    RoamError
        when the kind of file cannot hold what is asked for.
    """

    file: MatteFile = MatteFile.PNG
    depth: Depth | None = None
    compression: str | None = None
    parts: Parts = Parts.ALL
    gathering: Gathering = Gathering.FILES
    window: DataWindow = DataWindow.FULL
    resumes: bool = False

    def __post_init__(self) -> None:
        for field, kind in (("file", MatteFile), ("parts", Parts), ("gathering", Gathering), ("window", DataWindow)):
            object.__setattr__(self, field, kind(getattr(self, field)))
        object.__setattr__(self, "depth", None if self.depth is None else Depth(self.depth))
        name = self.file.upper()
        if self.depth is not None and self.depth not in DEPTHS[self.file]:
            raise RoamError(
                sentence(
                    "{name} mattes are {choice} deep, not {depth}.",
                    name=name,
                    choice=_choice(DEPTHS[self.file]),
                    depth=self.depth,
                )
            )
        if self.compression is not None and self.compression not in COMPRESSIONS[self.file]:
            raise RoamError(
                sentence(
                    "{name} mattes are compressed by {choice}, not {compression!r}.",
                    name=name,
                    choice=_choice(COMPRESSIONS[self.file]),
                    compression=self.compression,
                )
            )
        if self.file is not MatteFile.EXR and self.gathering is Gathering.CHANNELS:
            raise RoamError(sentence("{name} files hold no channels with names; ask for EXR.", name=name))
        if self.file is not MatteFile.EXR and self.gathering is Gathering.CRYPTOMATTE:
            raise RoamError(sentence("{name} files hold no Cryptomatte; ask for EXR.", name=name))
        if self.gathering is Gathering.CRYPTOMATTE and self.depth not in (None, Depth.FLOAT):
            raise RoamError(
                sentence(
                    "Cryptomatte is {own} deep, not {depth}: its numbers stand for names.",
                    own=Depth.FLOAT,
                    depth=self.depth,
                )
            )
        if self.file is not MatteFile.EXR and self.window is DataWindow.TIGHT:
            raise RoamError(
                sentence(
                    "{name} files hold all pixels; ask for EXR to leave out the black around the shapes.", name=name
                )
            )

    @property
    def suffix(self) -> str:
        """Of the files, with the dot."""
        return {MatteFile.PNG: ".png", MatteFile.EXR: ".exr", MatteFile.TIFF: ".tif"}[self.file]

    @property
    def depth_or_own(self) -> Depth:
        """The depth that is written."""
        if self.depth is not None:
            return self.depth
        return Depth.FLOAT if self.gathering is Gathering.CRYPTOMATTE else DEPTHS[self.file][0]

    @property
    def compression_or_own(self) -> str:
        """The compression that is written."""
        return COMPRESSIONS[self.file][0] if self.compression is None else self.compression


def _choice(words: tuple[str, ...]) -> str:
    if len(words) == 1:
        return words[0]
    return sentence("{names} or {last}", names=", ".join(words[:-1]), last=words[-1])
