"""`roam explain P.roam --frame F`: what each term says at every node and landmark, as a table, JSON or a picture."""

from __future__ import annotations

import argparse
import sys
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import cv2
import numpy as np

from roam_core.arrays import UInt8
from roam_core.atomic_write import write_atomically
from roam_core.cli.explain_picture import TOTAL, choices, drawn
from roam_core.cli.lines import print_json
from roam_core.cli.overwriting import add_overwrite
from roam_core.cli.paths import path_word
from roam_core.cli.picking import add_shapes, picked
from roam_core.cli.plate import Plate, loaded, opened
from roam_core.cli.stopping import cancelling
from roam_core.cli.targets import require_target
from roam_core.errors import RoamError
from roam_core.features import PreparedFrame
from roam_core.interchange.authorship import Kind
from roam_core.interchange.mattes.files import signed_png
from roam_core.interchange.targets import Sources, require_free
from roam_core.roto import Origin, Project, RotoShape

if TYPE_CHECKING:
    from roam_core.propagate.explain import Explanation
    from roam_core.propagate.parts.edges import Edges

Row = Mapping[str, object]


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the command's options."""
    parser.add_argument("project", type=path_word, metavar="P.roam")
    parser.add_argument("--frame", type=int, required=True, metavar="F", help="frame to explain")
    add_shapes(parser, "only this shape, or these; default: all that hold a key there")
    parser.add_argument("--json", action="store_true", help="print one line of JSON a shape")
    parser.add_argument("--picture", type=path_word, metavar="OUT.png", help="draw the terms over the frame")
    parser.add_argument(
        "--term",
        metavar="TERM",
        help="what the picture shows: local, gradient, l2, global, joint, landmark, star, region, a cue by its name, "
        "or total (default total)",
    )
    add_overwrite(parser)


def run(arguments: argparse.Namespace) -> int:
    """Carry out the command."""
    if arguments.term is not None and arguments.picture is None:
        raise RoamError("--term says what the picture shows; name that with --picture OUT.png, too.")
    project, term = loaded(arguments.project), arguments.term or TOTAL
    wanted = keyed_shapes(project, arguments.project, arguments.frame, arguments.shape)
    if arguments.picture is not None:
        require_target(arguments.picture)
    with opened(str(project.require_clip().path), project.clip) as plate:
        if arguments.picture is not None:
            require_free(
                [(arguments.picture, Kind.PICTURE)],
                Sources.of(plate.source, arguments.project),
                overwrite=arguments.overwrite,
            )
            if arguments.picture.suffix.lower() != ".png":
                raise RoamError(f"The picture is written as PNG; {arguments.picture.name} does not end in .png.")
        if arguments.frame not in plate.source.frames:
            raise RoamError(f"Frame {arguments.frame} is missing from the clip {plate.source.path}; choose another.")
        explanations = explained(plate, project, arguments.frame, wanted)
        if arguments.picture is not None:
            require_term(explanations, term)
            image = PreparedFrame(plate.read(arguments.frame)).image
            write_atomically(arguments.picture, encoded(drawn(image, explanations, term)))
    for each in explanations:
        if arguments.json:
            print_json(line_of(each))
        else:
            print("\n".join(text_of(each)), flush=True)
    if arguments.picture is not None:
        print(f"Drew {term} of {len(explanations)} shape(s) to {arguments.picture}.", file=sys.stderr)
    return 0


def keyed_shapes(project: Project, path: Path, frame: int, names: Sequence[str] | None) -> list[RotoShape]:
    """The closed shapes that hold a key on the frame, or those asked for of them; one sentence if there is none."""
    clip = project.require_clip()
    if not clip.first <= frame <= clip.last:
        raise RoamError(f"--frame {frame} lies outside the clip's frames {clip.first}-{clip.last}.")
    closed = [shape for shape in picked(project, names) if shape.closed]
    keyed = [shape for shape in closed if shape.key_at(frame) is not None]
    if closed and not keyed and not any(shape.exists_at(frame) for shape in closed):
        raise RoamError(f"Frame {frame} lies outside the lifetime of every closed shape asked for; choose another.")
    if not keyed:
        raise RoamError(
            f"No closed shape of {path} holds a key on frame {frame}; track or fill up to there first. Frames whose "
            "picture is missing or damaged get none."
        )
    return keyed


def explained(plate: Plate, project: Project, frame: int, wanted: Sequence[RotoShape]) -> list[Explanation]:
    """The wanted shapes' keys taken apart; shapes that were tracked with them are carried along."""
    from roam_core.propagate.explain import explain  # numba: a command's help must not wait for it

    names = {shape.id for shape in wanted}
    with cancelling() as token:
        return explain(
            lambda number: PreparedFrame(plate.read(number)), project.shapes, frame, project.clip, token, names
        )


def encoded(picture: UInt8) -> bytes:
    """An RGB picture as PNG."""
    return signed_png(cv2.imencode(".png", np.ascontiguousarray(picture[..., ::-1]))[1].tobytes())


def require_term(explanations: Sequence[Explanation], term: str) -> None:
    """Refuse a term that none of the shapes has, naming those that there are."""
    known = choices(explanations)
    if term not in known:
        raise RoamError(f"There is no term {term!r} here; choose from {', '.join(known)}.")


def line_of(each: Explanation) -> dict[str, object]:
    """The explanation of one shape for a line of JSON."""
    return {
        "shape": each.shape.name,
        "frame": each.key.frame,
        "origin": each.key.origin.value,
        "config": each.config,
        "unit": "nats for the outline" if each.account.more_is_better else "energy",
        "apart": round(each.apart, 6),
        "as_one_piece": None if each.account.as_one_piece is None else round(each.account.as_one_piece, 6),
        "edges": _shares(each.edges),
        "key_frame": None if each.on_key is None else each.on_key[0],
        "edges_on_key": None if each.on_key is None else _shares(each.on_key[1]),
        "sums": {name: round(value, 6) for name, value in each.account.sums.items()},
        "nodes": node_rows(each),
        "landmarks": landmark_rows(each),
    }


def node_rows(each: Explanation) -> list[Row]:
    """One row a node: where it lies on the spline and in the picture, and what the terms say there."""
    total = each.account.total
    return [
        {
            "node": n,
            "point": round(int(each.account.segment[n]) + float(each.account.t[n]), 3),
            "x": round(float(x), 3),
            "y": round(float(y), 3),
            **{name: round(float(values[n]), 6) for name, values in each.account.terms.items()},
            "total": round(float(total[n]), 6),
        }
        | (
            {
                "inside": {name: round(float(inside[n]), 6) for name, (inside, _) in each.account.sides.items()},
                "outside": {name: round(float(outside[n]), 6) for name, (_, outside) in each.account.sides.items()},
            }
            if each.account.sides
            else {}
        )
        for n, (x, y) in enumerate(each.account.nodes)
    ]


def landmark_rows(each: Explanation) -> list[Row]:
    """One row a landmark: who it is, where it was found, and what the terms say there."""
    found, total = each.account.landmarks, each.account.landmark_total
    if found is None:
        return []
    return [
        {
            "id": int(found.ids[m]),
            "x": round(float(x), 3),
            "y": round(float(y), 3),
            **{name: round(float(values[m]), 6) for name, values in found.terms.items()},
            "total": round(float(total[m]), 6),
        }
        for m, (x, y) in enumerate(found.positions)
    ]


def text_of(each: Explanation) -> list[str]:
    """The explanation of one shape as lines of text."""
    head = f"{each.shape.name!r}, frame {each.key.frame}: "
    if each.key.origin is Origin.ARTIST:
        return [f"{head}the artist made this key; nothing was solved.", *edge_lines(each)]
    head += f"{each.config}, {len(each.account.nodes)} nodes on {each.shape.point_count} points"
    if not each.account.terms:
        return [f"{head}. The shape had left the picture: it was carried on as it moved.", *edge_lines(each)]
    if each.account.landmarks is not None:
        head += f", {len(each.account.landmarks.ids)} landmarks"
    lines = [head, *_apart_lines(each), *_piece_lines(each), *edge_lines(each), "", *_sum_lines(each), ""]
    if each.account.more_is_better:
        lines.append("Nats for the object just inside / just outside of the outline at each node; their difference:")
        lines += table([_beside(row) for row in node_rows(each)])
    else:
        lines.append("Energy of each node; less is better:")
        lines += table(node_rows(each))
    if each.account.landmarks is not None and len(each.account.landmarks.ids):
        lines += ["", "Energy of each landmark; less is better:", *table(landmark_rows(each))]
    return [*lines, ""]


def edge_lines(each: Explanation) -> list[str]:
    """How much of the outline is free, a seam or hidden, on the frame and on the artist's key."""
    if each.edges is None:
        return []
    lines = [f"Of its outline {_told(each.edges)}."]
    if each.on_key is not None and each.on_key[0] != each.key.frame:
        lines.append(f"On its key, frame {each.on_key[0]}, {_told(each.on_key[1])}.")
    return lines


def _told(found: Edges) -> str:
    from roam_core.propagate.parts.edges import Edge

    words = {Edge.FREE: "is free", Edge.SEAM: "a seam", Edge.HIDDEN: "hidden", Edge.UNKNOWN: "outside the picture"}
    shares = [(word, found.share(kind)) for kind, word in words.items()]
    return ", ".join(f"{share:.0%} {word}" for word, share in shares if share or word != "outside the picture")


def _shares(found: Edges | None) -> Row | None:
    return None if found is None else {name: round(share, 6) for name, share in found.shares.items()}


def _apart_lines(each: Explanation) -> list[str]:
    if each.apart < 0.01:
        return []
    way = ", for it was filled from both sides" if each.key.inputs.startswith("fill:") else ""
    return [f"The key lies up to {each.apart:.1f} px from what a run from the artist's key finds here and now{way}."]


def _piece_lines(each: Explanation) -> list[str]:
    if each.account.as_one_piece is None:
        return []
    return [
        f"It was carried as one piece, whatever the cues say: {each.account.as_one_piece:.0%} of the corners "
        "of the key were found where its motion puts them."
    ]


def _sum_lines(each: Explanation) -> list[str]:
    """Each term's sum and its share of what all terms weigh."""
    from roam_core.propagate.engines.protocol import REGION

    sums = {name: value for name, value in each.account.sums.items() if name != REGION}
    weight = sum(abs(value) for value in sums.values()) or 1.0
    rows: list[Row] = [
        {"term": name, "sum": value, "share": f"{100.0 * abs(value) / weight:.0f} %"} for name, value in sums.items()
    ]
    return table([*rows, {"term": "total", "sum": sum(sums.values()), "share": ""}])


def _beside(row: Row) -> Row:
    """A node's row with both sides of each cue in one column."""
    inside, outside = row["inside"], row["outside"]
    assert isinstance(inside, Mapping)
    assert isinstance(outside, Mapping)
    place = {name: row[name] for name in ("node", "point", "x", "y")}
    both = {name: f"{inside[name]:+.1f}/{outside[name]:+.1f}" for name in inside}
    return place | both | {"difference": row["total"]}


def table(rows: Sequence[Row]) -> list[str]:
    """Rows under one heading, columns aligned to the right; numbers with as many places as there is room for."""
    cells = [[str(name) for name in rows[0]], *([_cell(name, value) for name, value in row.items()] for row in rows)]
    widths = [max(len(line[k]) for line in cells) for k in range(len(cells[0]))]
    return ["  ".join(text.rjust(width) for text, width in zip(line, widths, strict=True)) for line in cells]


def _cell(name: str, value: object) -> str:
    if isinstance(value, float):
        return f"{value:.1f}" if name in ("x", "y") else f"{value:.2f}" if name == "point" else f"{value:+.3f}"
    return str(value)
