"""Landmarks as Tracker4 nodes, taken apart by Tcl: lives and gaps, names, choice, and a run against the true motion."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pytest

from roam_core.arrays import Array
from roam_core.errors import RoamError
from roam_core.geometry import bezier, similarity
from roam_core.interchange.nuke.landmarks import LEAST_FRAMES, MOST_TRACKS, LandmarkPaths, write_landmarks
from roam_core.propagate import FrameResult, Landmarks, Termination, TrackResult, track
from roam_core.roto import Clip, Keyframe, RotoShape
from tests.golden.shots import Shot, blob, inverse, pose
from tests.unit.interchange import tcl
from tests.unit.interchange.conftest import CLIP

SQUARE = bezier.polygon_points([(0, 0), (10, 0), (10, 10), (0, 10)])


@dataclass
class Row:
    """One track as Nuke would know it: where it is on its frames, when its switch is turned, what it moves."""

    name: str
    places: dict[int, tuple[float, float]]
    switch: dict[int, bool]
    moves: str

    def enabled(self, frame: int) -> bool:
        """Steps hold to the next one, and the first one before itself."""
        steps = [value for at, value in self.switch.items() if at <= frame]
        return steps[-1] if steps else next(iter(self.switch.values()))


@dataclass
class Node:
    """A Tracker4: its knobs and the rows of its table."""

    knobs: dict[str, str]
    rows: list[Row]


def judged(path: Path, height: int = 1080) -> list[Node]:
    """The nodes of a script, which must hold nothing but trackers."""
    split = tcl.available().split
    words = split(path.read_text(encoding="utf-8").removeprefix("# Written by ROAM\n"))
    assert words[:3] == ["version", "9.0", "v1"]
    assert set(words[3::2]) == {"Tracker4"}
    nodes = []
    for body in words[4::2]:
        entries = split(body)
        knobs = dict(zip(entries[::2], entries[1::2], strict=True))
        head, columns, table = split(knobs["tracks"])
        rows = [split(row) for row in split(table)]
        assert split(head) == ["1", "31", str(len(rows))]
        assert {len(row) for row in rows} == {31} == {len(split(columns))}
        nodes.append(Node(knobs, [_row(row, height) for row in rows]))
    return nodes


def _row(words: Sequence[str], height: int) -> Row:
    (across, kinds), (up, others), (switch, steps) = (_curve(words[k]) for k in (2, 3, 0))
    assert (kinds, others, steps) == ({"L"}, {"L"}, {"K"})
    assert list(across) == list(up)
    places = {frame: (x, height - up[frame]) for frame, x in across.items()}
    return Row(words[1], places, {frame: bool(value) for frame, value in switch.items()}, "".join(words[6:9]))


def _curve(text: str) -> tuple[dict[int, float], set[str]]:
    word, *rest = tcl.available().split(text)
    assert word == "curve"
    keys = {int(time[1:]): float(value) for time, value in zip(rest[1::3], rest[2::3], strict=True)}
    return keys, set(rest[::3])


def place(number: int, frame: int) -> tuple[float, float]:
    return 100.0 + 7.0 * number + 0.25 * frame, 50.0 + 3.0 * number


def results(
    lives: dict[int, Iterable[int]], frames: Sequence[int], name: str = "Blob", key: int = 1001, shape_id: str = "s"
) -> list[FrameResult]:
    """A run in which each landmark is found on the frames of its life."""
    shape = RotoShape(shape_id, name, (Keyframe(key, SQUARE),))
    made = []
    for frame in frames:
        ids = sorted(number for number, life in lives.items() if frame in life)
        places = np.array([place(number, frame) for number in ids], dtype=np.float64).reshape(-1, 2)
        marks = Landmarks(np.array(ids, dtype=np.intp), places, key)
        made.append(FrameResult(frame, (TrackResult(frame, shape, 1.0, {}, Termination.CONVERGED, landmarks=marks),)))
    return made


def written(tmp_path: Path, *made: list[FrameResult], frame_offset: int = 0) -> tuple[list[Node], tuple[str, ...]]:
    path = tmp_path / "landmarks.nk"
    paths = LandmarkPaths.of(result for run in made for result in run)
    notes = write_landmarks(paths, CLIP, path, frame_offset)
    return judged(path), notes


RUN = range(1001, 1021)


def test_each_landmark_has_its_own_life(tmp_path: Path) -> None:
    lives = {0: RUN, 1: range(1001, 1009), 2: range(1008, 1021), 3: [*range(1001, 1005), *range(1010, 1015)]}
    ((node,), notes) = written(tmp_path, results(lives, RUN))
    assert notes == ()
    assert [row.name for row in node.rows] == ["Blob 1001-0", "Blob 1001-1", "Blob 1001-2", "Blob 1001-3"]
    for number, row in enumerate(node.rows):
        assert list(row.places) == sorted(lives[number])
        assert [frame for frame in RUN if row.enabled(frame)] == sorted(lives[number])
        for frame, at in row.places.items():
            assert at == pytest.approx(place(number, frame), abs=1e-5)
    assert [row.moves for row in node.rows] == ["111", "000", "000", "000"]
    # Outside of the run nothing is known of any track: what was enabled at its ends stays so.
    assert [row.enabled(990) for row in node.rows] == [True, True, False, True]
    assert [row.enabled(1030) for row in node.rows] == [True, False, True, False]
    assert node.knobs["reference_frame"] == "1001"
    assert node.knobs["label"] == "Landmarks of Blob"


def test_a_frame_that_nobody_looked_at_ends_no_life(tmp_path: Path) -> None:
    """A picture that is missing, or an object outside of it: the track goes straight across, enabled all the while."""
    frames = [frame for frame in RUN if frame != 1007]
    ((node,), notes) = written(tmp_path, results({0: frames}, frames))
    assert notes == ()
    (row,) = node.rows
    assert 1007 not in row.places
    assert (row.switch, row.moves) == ({1001: True}, "111")


def test_frames_without_any_lasting_landmark_are_known_too(tmp_path: Path) -> None:
    """Landmark 0 is lost in the middle; what was found later did not last and has no track, but was looked for."""
    lives = {0: range(1001, 1011), **{k: [1010 + k] for k in range(1, 11)}}
    ((node,), notes) = written(tmp_path, results(lives, RUN))
    assert notes == ("No landmark of 'Blob' was found on every frame: in Nuke, tick T, R and S of those to go by.",)
    (row,) = node.rows
    assert (row.switch, row.moves) == ({1001: True, 1011: False}, "000")


def test_what_does_not_last_is_no_track(tmp_path: Path) -> None:
    lives = {0: RUN[: LEAST_FRAMES - 1], 1: RUN[:LEAST_FRAMES], 2: [1001, 1003, 1005, 1007, 1009]}
    ((node,), _) = written(tmp_path, results(lives, RUN))
    assert [row.name for row in node.rows] == ["Blob 1001-1", "Blob 1001-2"]


def test_a_short_run_has_the_landmarks_of_all_its_frames(tmp_path: Path) -> None:
    ((node,), notes) = written(tmp_path, results({0: RUN[:2], 1: RUN[:1]}, RUN[:2]))
    assert ([row.name for row in node.rows], notes) == (["Blob 1001-0"], ())


def test_of_too_many_the_longest_lives_are_taken(tmp_path: Path) -> None:
    lives = {number: RUN[: LEAST_FRAMES + number % 12] for number in range(3 * MOST_TRACKS)}
    ((node,), notes) = written(tmp_path, results(lives, RUN))
    assert len(node.rows) == MOST_TRACKS
    chosen = [int(row.name.removeprefix("Blob 1001-")) for row in node.rows]
    assert chosen == sorted(chosen)
    left = set(lives) - set(chosen)
    assert min(len(lives[number]) for number in chosen) >= max(len(lives[number]) for number in left)
    assert notes[0] == "Of 300 landmarks of 'Blob' the 100 of the longest lives were written."


def test_both_directions_from_one_key_are_one_track(tmp_path: Path) -> None:
    forward, backward = range(1010, 1021), range(1010, 1000, -1)
    ((node,), notes) = written(
        tmp_path, results({0: forward}, forward, key=1010), results({0: backward}, backward, key=1010)
    )
    assert notes == ()
    assert list(node.rows[0].places) == list(RUN)
    assert node.knobs["reference_frame"] == "1010"


def test_the_same_ids_of_another_key_are_other_landmarks(tmp_path: Path) -> None:
    first, second = RUN[:10], RUN[10:]
    ((node,), notes) = written(tmp_path, results({0: first}, first), results({0: second}, second, key=1011))
    assert [row.name for row in node.rows] == ["Blob 1001-0", "Blob 1011-0"]
    assert [row.switch for row in node.rows] == [{1001: True, 1011: False}, {1001: False, 1011: True}]
    assert len(notes) == 1


def test_what_is_said_of_a_frame_again_stands_in_place_of_the_first(tmp_path: Path) -> None:
    run = results({0: RUN, 1: RUN}, RUN)
    ((node,), _) = written(tmp_path, run, results({0: RUN}, RUN[:3]))
    assert list(node.rows[1].places) == list(RUN[3:])


def test_every_shape_has_a_node_and_one_without_tracks_is_named(tmp_path: Path) -> None:
    runs = [
        results({0: RUN}, RUN, name="One", shape_id="a"),
        results({0: [1001]}, RUN, name="Two", shape_id="b"),
        results({0: RUN}, RUN, name="Three", shape_id="c"),
    ]
    nodes, notes = written(tmp_path, *runs)
    assert [node.knobs["label"] for node in nodes] == ["Landmarks of One", "Landmarks of Three"]
    assert notes == ("No landmark of 'Two' was found on 5 frames or more; it has no tracks.",)


def test_frames_are_shifted_everywhere(tmp_path: Path) -> None:
    ((node,), _) = written(tmp_path, results({0: RUN, 1: RUN[5:]}, RUN), frame_offset=-1000)
    assert list(node.rows[0].places) == list(range(1, 21))
    assert node.rows[1].switch == {1: False, 6: True}
    assert node.knobs["reference_frame"] == "1"


@pytest.mark.parametrize("name", ["[exit]", "{", "}", 'a"b', "$x", "a\\", "\n", "[python {1}]", "\N{HAIRCUT}", ""])
def test_names_are_inert(tmp_path: Path, name: str) -> None:
    ((node,), _) = written(tmp_path, results({0: RUN}, RUN, name=name))
    assert node.rows[0].name == f"{name} 1001-0"
    assert node.knobs["label"] == f"Landmarks of {name}".replace("[", "(").replace("]", ")")


@pytest.mark.parametrize("lives", [{}, {0: [1001, 1003]}])
def test_nothing_to_write_is_refused(tmp_path: Path, lives: dict[int, Iterable[int]]) -> None:
    with pytest.raises(RoamError, match=r"No landmark was found on 5 frame\(s\) or more"):
        written(tmp_path, results(lives, RUN))
    with pytest.raises(RoamError, match="No landmark was found"):
        write_landmarks(LandmarkPaths(), CLIP, tmp_path / "landmarks.nk")
    assert list(tmp_path.iterdir()) == []


def test_a_place_that_is_none_is_refused_and_nothing_written(tmp_path: Path) -> None:
    shape = RotoShape("s", "Blob", (Keyframe(1001, SQUARE),))
    marks = Landmarks(np.array([0]), np.array([[math.nan, 1.0]]), 1001)
    result = FrameResult(1001, (TrackResult(1001, shape, 1.0, {}, Termination.CONVERGED, landmarks=marks),))
    with pytest.raises(RoamError, match="Blob 1001-0"):
        written(tmp_path, [result])
    assert list(tmp_path.iterdir()) == []


# ---- a run against what is true --------------------------------------------------------------------------------------


def tracked(shot: Shot, config: str, path: Path) -> Node:
    """The node of the landmarks of a shot that is really tracked, as Tcl reads it."""
    run: list[FrameResult] = []
    for result in track(shot.read, [shot.shape()], shot.frames, config, begun=run.append):
        run.append(result)
    height, width = shot.size
    clip = Clip(Path("plate"), shot.frames[0], shot.frames[-1], (width, height))
    write_landmarks(LandmarkPaths.of(run), clip, path)
    (node,) = judged(path, height)
    return node


def strayed(row: Row, shot: Shot) -> Array:
    """How far each place of a track lies from where the body carries its first one, pixels."""
    frames = list(row.places)
    on_body = similarity.apply(inverse(shot.poses[frames[0] - shot.first]), np.array([row.places[frames[0]]]))
    true = np.vstack([similarity.apply(shot.poses[frame - shot.first], on_body) for frame in frames])
    return np.asarray(np.hypot(*(np.array(list(row.places.values())) - true).T))


def depth(row: Row, shot: Shot) -> float:
    """How far inside the true outline a track begins, pixels."""
    frame = next(iter(row.places))
    return float(np.hypot(*(bezier.flatten(shot.truth(frame)) - row.places[frame]).T).min())


@pytest.mark.parametrize("config", ["medium", "full"])
def test_tracks_within_a_body_go_with_it(config: str, tmp_path: Path) -> None:
    """Whose patch of 32 pixels lies on the body; one that reaches over the outline sees the background glide too."""
    poses = tuple(pose(130.0 + 2.2 * k, 120.0 - 0.6 * k, 1.0 * k) for k in range(8))
    shot = Shot(blob([60.0, 48.0, 40.0, 52.0, 64.0, 44.0]), poses, size=(240, 320), drift=(-0.5, 0.3))
    within = [row for row in tracked(shot, config, tmp_path / "a.nk").rows if depth(row, shot) >= 16.0]
    assert len(within) >= 2
    assert max(strayed(row, shot).max() for row in within) < 1.0


@pytest.mark.parametrize("config", ["medium", "full"])
def test_tracks_of_a_small_body_go_with_it_from_frame_to_frame(config: str, tmp_path: Path) -> None:
    """Every patch reaches over this body's outline, and so each creeps; by a pixel a frame at most, or so."""
    poses = tuple(pose(70.0 + 2.2 * k, 60.0 - 0.6 * k, 3.0 * k, 1.0 + 0.01 * k) for k in range(6))
    shot = Shot(blob([30.0, 24.0, 20.0, 26.0, 32.0, 22.0]), poses, drift=(-0.5, 0.3))
    rows = tracked(shot, config, tmp_path / "a.nk").rows
    assert rows
    assert max(np.diff(strayed(row, shot)).max() for row in rows) < 1.25
