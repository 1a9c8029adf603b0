"""Mattes as sequences of pictures: of all shapes jointly, of every layer or of every shape, frame by frame."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from roam_core.atomic_write import make_folder, write_atomically
from roam_core.cancel import CancelToken, Progress
from roam_core.errors import RoamError
from roam_core.interchange.matte_style import (
    MATTES,
    OTHER_SUFFIXES,
    SUFFIXES,
    Gathering,
    MatteFile,
    MatteStyle,
    Parts,
)
from roam_core.interchange.mattes.cryptomatte import RANKS, write_cryptomatte
from roam_core.interchange.mattes.files import JOINT, encode_png, write_picture
from roam_core.interchange.mattes.manifest import Manifest, manifests_of
from roam_core.interchange.mattes.timecode import Moment
from roam_core.interchange.naming import file_words, is_numbered, numbering
from roam_core.interchange.out_of_sight import without_points
from roam_core.interchange.protocol import STANDARD, ExportOptions, artists_alone, with_chosen_keys
from roam_core.matte import Patch, render_matte, shape_patch
from roam_core.matte.compose import Draw
from roam_core.matte.visible import visible_shares
from roam_core.roto import Layer, Project, RotoShape
from roam_core.translatable import N_, sentence

Shapes = Project | Layer | Sequence[RotoShape]
NAME = "{name}"
"""In a file's name: where the word of the layer or shape goes."""

PNG = MatteStyle()


class MatteExporter:
    """Writes mattes of the visible shapes for every frame of the clip, or for those that are asked for."""

    name = MATTES
    title = N_("Mattes (PNG, EXR, TIFF)")
    suffix = ".png"

    def export(self, project: Project, path: Path, options: ExportOptions = STANDARD) -> tuple[str, ...]:
        """Write the pictures of every frame in the style of the options.

        A `path` without the suffix of a picture is a folder, made when missing, for `matte.1001.png` and so on; one
        that says where a frame's number goes, and is no folder yet, gets the suffix of the style. With a suffix, that
        says what kind of file is written, and the frame's number goes in place of `####` or `%04d` in the file's name,
        or before the suffix where there is neither; the name of a layer or shape goes in place of `{name}`, there or in
        the folder's, or makes a folder of its own.
        """
        clip = project.require_clip()
        folder, name_for, style = self._place(path, options)
        notes: list[str] = []
        root = artists_alone(project, options).root
        root = without_points(root, True) if options.smoothing > 0.0 else root  # smoothing opens a point again
        shown = replace(project, root=with_chosen_keys(root, options, notes))
        written = write_mattes(
            shown,
            options.frames_of(clip),
            folder,
            name_for,
            (clip.size[1], clip.size[0]),
            style=style,
            pixel_aspect=clip.pixel_aspect,
            fps=clip.fps,
            frame_offset=options.frame_offset,
            progress=options.progress,
            token=options.token,
        )
        notes += written.notes
        return (*notes, written.report()) if written.kept else tuple(notes)

    def files(self, project: Project, path: Path, options: ExportOptions = STANDARD) -> tuple[Path, ...]:
        """The pictures that `export` would write now."""
        folder, name_for, style = self._place(path, options)
        return planned(project, options.frames_of(project.require_clip()), folder, name_for, style)

    def _place(self, path: Path, options: ExportOptions) -> tuple[Path, Callable[[int], str], MatteStyle]:
        """The folder, the names by frame, and the style that the suffix of `path` asks for."""
        style = options.mattes
        if path.suffix.lower() in OTHER_SUFFIXES and not path.is_dir():
            raise RoamError(
                sentence("Mattes are written as PNG, EXR or TIFF; {name} would be none of these.", name=path.name)
            )
        if is_numbered(path.name) and path.suffix.lower() not in SUFFIXES and not path.is_dir():
            path = path.with_name(f"{path.name}{style.suffix}")
        if path.suffix.lower() in SUFFIXES:
            folder, pattern = path.parent, path.name
            style = style_for(path, style)
            require_places(pattern, style)
            if not folder.is_dir():
                require_places(str(folder), style)
        else:
            folder, pattern = path, f"matte.####{style.suffix}"
        return folder, numbering(pattern, options.frame_offset), style


def require_places(pattern: str, style: MatteStyle) -> None:
    """Refuse a pattern with places in braces that nothing would be put in, and that would stay in the files' names.

    Raises `RoamError` for all but `{name}`, and for that where no layer or shape has a file of its own.
    """
    for place in _PLACE.findall(pattern):
        if place != NAME:
            raise RoamError(
                sentence(
                    "{pattern}: nothing is put in place of {place}; {name} stands for a layer or shape.",
                    pattern=pattern,
                    place=place,
                    name=NAME,
                )
            )
        if _is_single(style):
            raise RoamError(
                sentence(
                    "{pattern}: {name} stands for a layer or shape, but there is one matte of all; ask for one "
                    "per layer or per shape, or take it out.",
                    pattern=pattern,
                    name=NAME,
                )
            )


_PLACE = re.compile(r"\{\w+\}")


def _is_single(style: MatteStyle) -> bool:
    """Whether a frame has one file."""
    return style.parts is Parts.ALL or style.gathering is not Gathering.FILES


def style_for(path: Path, style: MatteStyle) -> MatteStyle:
    """The style with the kind of file that the suffix of `path` names.

    Raises `RoamError` when a style that was chosen for another kind does not fit.
    """
    kind = SUFFIXES[path.suffix.lower()]
    if kind is style.file:
        return style
    if style.file is not MatteFile.PNG:
        raise RoamError(
            sentence(
                "{name} is the name of {kind} files, but {asked} is asked for.",
                name=path.name,
                kind=kind.upper(),
                asked=style.file.upper(),
            )
        )
    return replace(style, file=kind)


@dataclass(frozen=True)
class Part:
    """What has a matte of its own: a word for files and channels, its name, and shapes or a layer."""

    word: str
    name: str
    content: Layer | tuple[RotoShape, ...]


def parts_of(shapes: Shapes, parts: Parts) -> list[Part]:
    """What has a matte of its own, bottom first.

    A shape's own matte shows it alone, as if it were added; a layer's what the layer joins, without those around it.
    Shapes that lie in the root beside its layers are a part by its name. What is invisible has none.
    """
    if parts is Parts.ALL:
        return []
    root = _root(shapes)
    found: list[tuple[str, Layer | tuple[RotoShape, ...]]]
    if parts is Parts.SHAPE:
        found = [(shape.name, (shape,)) for shape in _shown_shapes(root)]
    else:
        loose = tuple(child for child in root.children if isinstance(child, RotoShape) and child.visible)
        found = [(root.name, loose)] if loose and root.visible else []
        found += [(layer.name, layer) for layer in _shown_layers(root)]
    words = file_words(name for name, _ in found)
    return [Part(word, name, content) for word, (name, content) in zip(words, found, strict=True)]


def _root(shapes: Shapes) -> Layer:
    root = shapes.plate_root if isinstance(shapes, Project) else shapes
    return root if isinstance(root, Layer) else Layer("root", "Root", tuple(root))


@dataclass(frozen=True)
class Written:
    """The pictures of a run, in the order of the frames: those `made` now, and those `kept` as they were.

    `crowded` are the frames of Cryptomattes with pixels that show more than has room in them.
    """

    made: tuple[Path, ...]
    kept: tuple[Path, ...] = ()
    crowded: tuple[int, ...] = ()

    @property
    def notes(self) -> list[str]:
        """What was left out."""
        if not self.crowded:
            return []
        return [
            sentence(
                "Pixels of {frames} frame(s), the first is {first}, show more than {most} shapes: "
                "the Cryptomatte has those that cover most.",
                frames=len(self.crowded),
                first=self.crowded[0],
                most=RANKS,
            )
        ]

    def report(self, place: str = "") -> str:
        """One sentence on how many there are of each; `place` tells where, such as " to mattes"."""
        made, kept = len(self.made), len(self.kept)
        if not kept:
            return sentence("Wrote {made} matte(s){place}.", made=made, place=place)
        return sentence("Wrote {made} matte(s){place}; {kept} there already.", made=made, place=place, kept=kept)


def write_mattes(
    shapes: Shapes,
    frames: Iterable[int],
    folder: Path,
    name_for: Callable[[int], str],
    size: tuple[int, int],
    *,
    style: MatteStyle = PNG,
    pixel_aspect: float = 1.0,
    fps: float | None = None,
    frame_offset: int = 0,
    progress: Progress | None = None,
    token: CancelToken | None = None,
) -> Written:
    """Render and write the pictures of each frame; each appears under its name only when it is whole.

    Parameters
    ----------
    shapes : a project, a layer or shapes in the order of compositing, as for `render_matte`.
    frames : the plate's frame numbers.
    folder : made when it is missing.
    name_for : gives the file name of a frame. Where every layer or shape has files of its own, its word goes in place
        of `{name}` there or in `folder`, or is the name of a folder in `folder`.
    size : (h, w) of the pictures.
    style : kind, depth and compression of the files, and what has one.
    pixel_aspect : of the pictures, noted in EXR and TIFF files.
    fps : frames a second, noted in EXR files with the time code of each frame; None notes neither.
    frame_offset : added to the plate's frame numbers for the time code.
    progress, token : told of, and asked before, every frame; a cancelled run leaves the frames that are finished.

    Returns
    -------
    The files that were written and those that were there already.

    Raises
    ------
    RoamError
        when two files have one name, a name is none, or a file cannot be written.
    Cancelled
        when the token was cancelled.
    """
    parts, manifests = _contents(shapes, style)
    plan = _plan(frames, folder, name_for, parts, style)
    folders = {path.parent for paths in plan.values() for path in paths}
    for place in sorted(folders if NAME in str(folder) and not _is_single(style) else folders | {folder}):
        make_folder(place)
    made: list[Path] = []
    kept: list[Path] = []
    crowded: list[int] = []
    for done, (frame, paths) in enumerate(plan.items()):
        if token is not None:
            token.check()
        if progress is not None:
            progress(done / len(plan), sentence("Matte of frame {frame}", frame=frame))
        if _is_kept(paths, style):
            kept += paths
        else:
            moment = None if fps is None else Moment(frame + frame_offset, fps)
            if manifests:
                shares = visible_shares(_root(shapes), frame, size, _remembering())
                if write_cryptomatte(paths[0], manifests, *shares, style, pixel_aspect, moment):
                    crowded.append(frame)
            else:
                _write_frame(shapes, frame, size, parts, paths, style, pixel_aspect, moment)
            made += paths
    written = Written(tuple(made), tuple(kept), tuple(crowded))
    if progress is not None:
        progress(1.0, written.report())
    return written


def planned(
    shapes: Shapes, frames: Iterable[int], folder: Path, name_for: Callable[[int], str], style: MatteStyle = PNG
) -> tuple[Path, ...]:
    """The files that `write_mattes` would write now: without those that are there already, where the style resumes.

    Raises `RoamError` as it does for names.
    """
    plan = _plan(frames, folder, name_for, _contents(shapes, style)[0], style)
    return tuple(path for paths in plan.values() if not _is_kept(paths, style) for path in paths)


def _contents(shapes: Shapes, style: MatteStyle) -> tuple[list[Part], tuple[Manifest, ...]]:
    """What has a matte of its own, or the Cryptomattes."""
    if style.gathering is Gathering.CRYPTOMATTE:
        return [], manifests_of(_root(shapes), style.parts)
    return parts_of(shapes, style.parts), ()


def write_matte(shapes: Shapes, frame: int, path: Path, size: tuple[int, int]) -> None:
    """Render one frame's matte `(h, w)` = `size` and write it as 8-bit PNG: beside `path` first, then renamed.

    Raises `RoamError` when the file cannot be written.
    """
    write_atomically(path, encode_png(render_matte(shapes, frame, size), 8))


def _write_frame(
    shapes: Shapes,
    frame: int,
    size: tuple[int, int],
    parts: list[Part],
    paths: list[Path],
    style: MatteStyle,
    pixel_aspect: float,
    moment: Moment | None,
) -> None:
    """The pictures of one frame; a shape that stands in several of them is filled once."""
    drawn = _remembering()

    def matte(content: Shapes) -> Patch:
        return Patch(0, 0, render_matte(content, frame, size, drawn))

    def own(part: Part) -> Patch:
        if style.parts is Parts.SHAPE and isinstance(part.content, tuple):
            return drawn(part.content[0], frame, size)
        return matte(part.content)

    if style.gathering is Gathering.CHANNELS:
        channels = {f"{part.word}.{JOINT}": own(part) for part in parts} | {JOINT: matte(shapes)}
        names = {f"{part.word}.{JOINT}": part.name for part in parts}
        write_picture(paths[0], channels, size, style, pixel_aspect, names, moment)
    elif style.parts is Parts.ALL:
        write_picture(paths[0], {JOINT: matte(shapes)}, size, style, pixel_aspect, {}, moment)
    else:
        for part, path in zip(parts, paths, strict=True):
            write_picture(path, {JOINT: own(part)}, size, style, pixel_aspect, {JOINT: part.name}, moment)


def _remembering() -> Draw:
    """Fills the shapes of one frame, each of them once."""
    filled: dict[str, Patch] = {}

    def drawn(shape: RotoShape, at: float, size: tuple[int, int]) -> Patch:
        if shape.id not in filled:
            filled[shape.id] = shape_patch(shape, at, size)
        return filled[shape.id]

    return drawn


def _plan(
    frames: Iterable[int], folder: Path, name_for: Callable[[int], str], parts: list[Part], style: MatteStyle
) -> dict[int, list[Path]]:
    """The files of each frame: plain names, no two of them equal."""
    plan: dict[int, list[Path]] = {}
    taken: dict[Path, int] = {}
    is_single = _is_single(style)
    for frame in frames:
        name = name_for(frame)
        if name in ("", ".", "..") or name != Path(name).name or "\0" in name:
            raise RoamError(
                sentence("{name!r} is no file name for the matte of frame {frame}.", name=name, frame=frame)
            )
        if is_single:
            paths = [folder / name]
        elif NAME in str(folder / name):
            paths = [Path(str(folder / name).replace(NAME, part.word)) for part in parts]
        else:
            paths = [folder / part.word / name for part in parts]
        for path in paths:
            if taken.setdefault(path, frame) != frame:
                raise RoamError(
                    sentence(
                        "The mattes of frames {other} and {frame} would both be named {name!r}.",
                        other=taken[path],
                        frame=frame,
                        name=path.name,
                    )
                )
        plan[frame] = paths
    return plan


def _is_kept(paths: list[Path], style: MatteStyle) -> bool:
    """Whether the pictures of a frame stay as they are."""
    return style.resumes and all(path.is_file() and path.stat().st_size > 0 for path in paths)


def _shown_shapes(layer: Layer) -> list[RotoShape]:
    shown: list[RotoShape] = []
    for child in layer.children if layer.visible else ():
        if isinstance(child, Layer):
            shown += _shown_shapes(child)
        elif child.visible:
            shown.append(child)
    return shown


def _shown_layers(layer: Layer) -> list[Layer]:
    """The visible layers below a visible one that hold something, those around others first."""
    shown: list[Layer] = []
    for child in layer.children if layer.visible else ():
        if isinstance(child, Layer) and child.visible and any(child.shapes()):
            shown += [child, *_shown_layers(child)]
    return shown
