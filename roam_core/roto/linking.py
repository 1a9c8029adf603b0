"""Verbs on what is solved together, and how its shapes hang and lie: link, attachment and depth of shapes."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import count

from roam_core.errors import RoamError
from roam_core.roto.project import Project
from roam_core.roto.shape import RotoShape
from roam_core.translatable import sentence

BEHIND, AS_STACKED, IN_FRONT = -1, 0, 1
"""The levels of `RotoShape.depth`."""


def links(project: Project) -> dict[str, tuple[str, ...]]:
    """The links of a project, each with the ids of the shapes that bear it, bottom first."""
    found: dict[str, tuple[str, ...]] = {}
    for shape in project.root.shapes():
        if shape.link:
            found[shape.link] = (*found.get(shape.link, ()), shape.id)
    return found


def linked(project: Project, shape_ids: Collection[str], link: str = "") -> Project:
    """The project with these shapes solved as one whole object: they bear `link`, or else a new one.

    Shapes that are one object already, with no others in it, keep their link.

    Raises
    ------
    RoamError
        where a new link would hold fewer than two shapes.
    """
    chosen = set(shape_ids)
    if not link:
        if len(chosen) < 2:
            raise RoamError(sentence("One object takes two shapes or more; select them all, or a layer."))
        if any(set(held) == chosen for held in links(project).values()):
            return project
        link = next(_free(links(project)))
    return _with_links(project, dict.fromkeys(chosen, link))


def unlinked(project: Project, shape_ids: Iterable[str]) -> Project:
    """The project with it left to the outlines of these shapes what they belong to."""
    return _with_links(project, dict.fromkeys(shape_ids, ""))


def apart(project: Project, shape_ids: Collection[str]) -> Project:
    """The project with each of these shapes solved by itself: with a link of its own."""
    held = links(project)
    alone = {shape_ids[0] for shape_ids in held.values() if len(shape_ids) == 1}
    chosen = [shape.id for shape in project.root.shapes() if shape.id in set(shape_ids) - alone]
    return _with_links(project, dict(zip(chosen, _free(held), strict=False)))


def attached(project: Project, shape_ids: Iterable[str], on: bool) -> Project:
    """The project with these shapes hanging by joints on the parts that they overlap, or free of them."""
    return _each(project, shape_ids, lambda shape: replace(shape, attached=on))


def set_depth(project: Project, shape_ids: Iterable[str], frame: int, level: int) -> Project:
    """The project with these shapes in front (1), behind (-1) or as stacked (0) from a frame on, to the next change."""
    return _each(project, shape_ids, lambda shape: replace(shape, depth=_with_pair(shape.depth, frame, level)))


def lie_alike(one: Project, other: Project) -> bool:
    """Whether the same shapes lie before one another alike on every frame, in two states of a project."""
    shapes, others = tuple(one.root.shapes()), tuple(other.root.shapes())
    starts = {start for shape in (*shapes, *others) for start, _ in shape.depth}
    frames = sorted(starts | {start - 1 for start in starts})
    return all(_bottom_first(shapes, frame) == _bottom_first(others, frame) for frame in frames)


def _bottom_first(shapes: Sequence[RotoShape], frame: int) -> list[str]:
    """The ids of shapes that come as they are stacked, the farthest on a frame first."""
    return [shape.id for shape in sorted(shapes, key=lambda shape: shape.depth_at(frame))]


def relinked(project: Project, copies: Sequence[RotoShape]) -> list[RotoShape]:
    """Copies that are about to join a project: linked with each other as their originals are, with those no more.

    So are their compounds: copies are the outlines of things of their own.
    """
    names, compounds = fresh_links(project, copies), fresh_compounds(project, copies)
    return [
        replace(copy, link=names.get(copy.link, copy.link), compound=compounds.get(copy.compound, copy.compound))
        for copy in copies
    ]


def fresh_links(project: Project, shapes: Iterable[RotoShape]) -> dict[str, str]:
    """The links of shapes that are about to join a project which has some of the name, and free names for them."""
    return _renamed(links(project), {shape.link for shape in shapes}, "object")


def fresh_compounds(project: Project, shapes: Iterable[RotoShape]) -> dict[str, str]:
    """The compounds of shapes that are about to join a project which has some of the name, and free names for them."""
    taken = {shape.compound for shape in project.root.shapes()}
    return _renamed(taken, {shape.compound for shape in shapes}, "compound")


def free_compound(project: Project) -> str:
    """A name for a compound that no shape of a project bears."""
    return next(_free({shape.compound for shape in project.root.shapes()}, "compound"))


def _renamed(taken: Collection[str], names: Collection[str], kind: str) -> dict[str, str]:
    """Free names for those of `names` that are taken."""
    free = _free({*taken, *names}, kind)
    return {name: next(free) for name in sorted(names) if name and name in taken}


def _free(taken: Collection[str], kind: str = "object") -> Iterator[str]:
    """Names of a kind that none bears."""
    return (name for number in count(1) if (name := f"{kind}-{number}") not in taken)


def _with_links(project: Project, chosen: Mapping[str, str]) -> Project:
    return _each(project, chosen, lambda shape: replace(shape, link=chosen[shape.id]))


def _each(project: Project, shape_ids: Iterable[str], verb: Callable[[RotoShape], RotoShape]) -> Project:
    for shape_id in shape_ids:
        project = project.map_item(shape_id, verb)
    return project


def _with_pair(depth: tuple[tuple[int, int], ...], frame: int, level: int) -> tuple[tuple[int, int], ...]:
    """Pairs (frame, level) with one more on its frame, without those that change nothing."""
    pairs: list[tuple[int, int]] = []
    for start, there in sorted({**dict(depth), frame: level}.items()):
        if there != (pairs[-1][1] if pairs else AS_STACKED):
            pairs.append((start, there))
    return tuple(pairs)
