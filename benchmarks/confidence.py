"""Confidence: whether it means the IoU that it says, and whether it finds the bad frames, with each shot left out.

The model of `roam_core.propagate.frame.confidence` is fitted to the frames of all shots but one and rates the frames of
that one; below, the model that ships rates them. `worst fifth`: of a shot's frames under IoU 0.9, the share among the
fifth that is rated worst; on a shot with more such frames than a fifth not even the best rating finds all of them, so
the best possible share stands beside it.
`off` is the mean distance of confidence from IoU, `bias` the same of their means over tenths of the frames.
"""

from __future__ import annotations

import argparse
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from benchmarks import chart, logistic, processes, rated, report, shots
from benchmarks.rated import CARRIED, FILLED, Rated
from roam_core.arrays import Array, Bools
from roam_core.errors import RoamError
from roam_core.params import DOUBTFUL, params_for

GOOD, SHARE = 0.9, 0.2
"""IoU under which a frame is bad; the share of frames, rated worst, in which bad ones are looked for."""
PROTOCOLS = (*CARRIED, *FILLED)
LEFT_OUT = "bus"
"""The shot whose mask falls into hundreds of pieces."""
HEAD = ["frames", "number", "bad", "worst fifth", "best possible", "of that", "off", "bias", "doubtful", "of these bad"]


def arguments(parser: argparse.ArgumentParser) -> None:
    """What `confidence` may be told."""
    parser.add_argument("--protocols", metavar="A,B", default=",".join(PROTOCOLS), help=f"of {', '.join(PROTOCOLS)}")
    parser.add_argument("--shots", metavar="A,B", help=f"these shots only; without it all but {LEFT_OUT}")
    parser.add_argument("--publish", action="store_true", help="put the table into docs/BENCHMARKS.md")


def run(given: argparse.Namespace) -> None:
    """Measure, fit with each shot left out, and report."""
    protocols = given.protocols.split(",")
    if unknown := sorted(set(protocols) - set(PROTOCOLS)):
        raise RoamError(f"There is no protocol {unknown[0]!r}; choose from {', '.join(PROTOCOLS)}.")
    names = [name for name in shots.names(given.shots) if given.shots or name != LEFT_OUT]
    jobs = [(name, protocol) for name in names for protocol in protocols]
    frames = dict(zip(jobs, processes.each(rated.of_job, jobs), strict=True))
    rows, lines, result = [], [chart.line("as it should be", [0.0, 1.0], [0.0, 1.0])], dict[str, Any]()
    for model in (CARRIED, tuple(FILLED)):
        known = {job: found for job, found in frames.items() if job[1] in model and found}
        if len({name for name, _ in known}) < 2:
            continue
        confidence, weights = left_out(known)
        result[" and ".join(model)] = {"weights": np.round(weights, 3).tolist()}
        for protocol in model:
            shown = {name: (_ious(known[name, p]), confidence[name, p]) for name, p in known if p == protocol}
            if shown:
                rows += [[protocol, *_cells(shown)], ["as it ships", *_cells(as_it_ships(known, protocol))]]
                lines.append(chart.line(protocol, *calibration(shown)))
                result[protocol] = {name: [np.round(v, 3).tolist() for v in pair] for name, pair in shown.items()}
    axes = chart.Axes("Confidence, and the IoU that frames of that confidence have", "confidence", "IoU", (0.0, 1.0))
    chart.write(report.OUT / "confidence.png", axes, lines)
    title = f"Confidence of `best` on {len(names)} shots, each rated by a model fitted to the others. "
    text = f"{title}{report.circumstances()}.\n\n{report.table(HEAD, rows)}"
    whole = given.shots is None and set(protocols) == set(PROTOCOLS)
    report.write("confidence" if whole else "confidence some", text, result, publish=given.publish)


def left_out(frames: Mapping[tuple[str, str], Sequence[Rated]]) -> tuple[dict[tuple[str, str], Array], Array]:
    """The confidence `(M,)` of each job's frames, by a model of the other shots; and the weights from all shots."""
    names = sorted({name for name, _ in frames})
    found = {}
    for name in names:
        weights = weights_of({job: each for job, each in frames.items() if job[0] != name})
        found.update({job: confidences(each, weights) for job, each in frames.items() if job[0] == name})
    return found, weights_of(frames)


def as_it_ships(frames: Mapping[tuple[str, str], Sequence[Rated]], protocol: str) -> dict[str, tuple[Array, Array]]:
    """The IoU and the confidence `(M,)` of a protocol's frames by shot, by the weights of the engine."""
    region = params_for("best").region
    assert region is not None
    params = region.confidence
    weights = np.array(params.features if protocol in CARRIED else params.span_features)
    return {
        name: (_ious(each), confidences(each, weights)) for (name, other), each in frames.items() if other == protocol
    }


def weights_of(frames: Mapping[tuple[str, str], Sequence[Rated]]) -> Array:
    """Constant and weights of the model; each shot counts the same, frames on which nothing was found not at all."""
    features, shares, counts = [], [], []
    for (name, _), each in frames.items():
        total = sum(len(others) for (other, _), others in frames.items() if other == name)
        for frame in each:
            found = [(share, values) for share, values in frame.known if share > 0.0]
            if found:
                features.append(np.average([v for _, v in found], axis=0, weights=[share for share, _ in found]))
                shares.append(frame.iou)
                counts.append(1.0 / total)
    return logistic.fitted(np.array(features), np.array(shares), np.array(counts))


def confidences(frames: Sequence[Rated], weights: Array) -> Array:
    """The confidence `(M,)` of whole frames: that of their objects by area, nothing for what was not found."""
    return np.array(
        [
            frame.apart + sum(share * float(logistic.expected(np.array(v), weights)) for share, v in frame.known)
            for frame in frames
        ]
    )


def worst_fifth(ious: Array, confidence: Array) -> tuple[float, float]:
    """The share of the bad frames among those rated worst, and the greatest share that any rating could have."""
    bad = ious < GOOD
    count = round(SHARE * len(ious))
    rated_worst = np.argsort(confidence, kind="stable")[:count]
    return float(bad[rated_worst].sum() / bad.sum()), min(1.0, count / int(bad.sum()))


def calibration(shown: Mapping[str, tuple[Array, Array]], parts: int = 10) -> tuple[Array, Array]:
    """Mean confidence and mean IoU `(parts,)` of all frames, sorted by confidence and cut into equal parts."""
    ious, confidence = (np.concatenate(values) for values in zip(*shown.values(), strict=True))
    cut = [part for part in np.array_split(np.argsort(confidence, kind="stable"), parts) if len(part)]
    return np.array([confidence[p].mean() for p in cut]), np.array([ious[p].mean() for p in cut])


def _ious(frames: Sequence[Rated]) -> Array:
    return np.array([frame.iou for frame in frames])


def _cells(shown: Mapping[str, tuple[Array, Array]]) -> list[str]:
    ious, confidence = (np.concatenate(values) for values in zip(*shown.values(), strict=True))
    finds = np.array([worst_fifth(*pair) for pair in shown.values() if (pair[0] < GOOD).any()])
    said, meant = calibration(shown)
    found, possible = finds.mean(axis=0) if len(finds) else (1.0, 1.0)
    doubted: Bools = confidence < DOUBTFUL
    return [
        str(len(ious)),
        f"{(ious < GOOD).mean():.2f}",
        f"{found:.2f}",
        f"{possible:.2f}",
        f"{(finds[:, 0] / finds[:, 1]).mean() if len(finds) else 1.0:.2f}",
        f"{np.abs(ious - confidence).mean():.3f}",
        f"{np.abs(said - meant).mean():.3f}",
        f"{doubted.mean():.2f}",
        f"{(ious[doubted] < GOOD).mean():.2f}" if doubted.any() else "-",
    ]
