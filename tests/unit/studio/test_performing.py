"""A step carried out: the same bits as the command gives, known again, cancelled, and told of."""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from roam_core import edit, load_project
from roam_core.cancel import CancelToken
from roam_core.cli import main, performing
from roam_core.cli.main import INTERRUPTED
from roam_core.cli.performing import perform
from roam_core.cli.stopping import cancelled_by
from roam_core.propagate import FrameResult, track
from roam_core.roto import file
from roam_core.studio.finding import jobs_from
from roam_core.studio.pictures import doubtful
from roam_core.studio.tasks import Task, pieces, tasks_of
from tests.unit.studio.shots import put_gaps, put_plate, put_shot

CONFIG = "baseline"


def carried_out(path: Path, out: Path, pictures: str = "", **options: Any) -> list[dict[str, Any]]:
    """All steps of the jobs at `path`, one after the other, in this process."""
    jobs = jobs_from(path, out=out, **options).jobs
    return [perform("b", json.loads(json.dumps(task.plain())), pictures) for line in tasks_of(jobs) for task in line]


@pytest.fixture
def show(tmp_path: Path) -> Path:
    put_shot(tmp_path / "show" / "sh010")
    steps = [{"track": {"config": CONFIG}}, "render", {"export": {"to": "nuke", "keys": "artist"}}]
    job = {"name": "sh010", "clip": "show/sh010/plate", "init": "show/sh010/init.png", "steps": steps}
    (tmp_path / "jobs.json").write_text(json.dumps({"type": "roam.Jobs", "version": 1, "jobs": [job]}))
    return tmp_path / "jobs.json"


def test_steps_give_what_the_commands_give(show: Path, tmp_path: Path) -> None:
    outcomes = carried_out(show, tmp_path / "out")
    assert [outcome["status"] for outcome in outcomes] == ["done"] * 3
    assert sorted(outcomes[0]["frames"]) == [str(frame) for frame in range(1001, 1007)]
    shot, alone = show.parent / "show" / "sh010", tmp_path / "alone"
    (alone / "deep").mkdir(parents=True)
    project = alone / "deep" / "sh010.roam"
    init = str(shot / "init.png")
    assert main(["track", str(shot / "plate"), "--init", init, "--config", CONFIG, "--save", str(project)]) == 0
    assert main(["render", str(project), "--out", str(alone / "deep" / "mattes")]) == 0
    assert main(["export", str(project), str(alone / "deep" / "sh010.nk"), "--to", "nuke", "--keys", "artist"]) == 0
    made = tmp_path / "out" / "sh010"
    for path in sorted((alone / "deep").rglob("*")):
        if path.is_file():
            assert (made / path.relative_to(alone / "deep")).read_bytes() == path.read_bytes(), path


def test_what_is_done_is_kept_until_something_changes(show: Path, tmp_path: Path) -> None:
    out = tmp_path / "out"
    first = carried_out(show, out)
    again = carried_out(show, out)
    assert [outcome["status"] for outcome in again] == ["kept"] * 3
    assert again[0]["frames"] == first[0]["frames"]
    (out / "sh010" / "mattes" / "plate.1003.png").write_bytes(b"")
    assert [outcome["status"] for outcome in carried_out(show, out)] == ["kept", "done", "kept"]
    frame = show.parent / "show" / "sh010" / "plate" / "plate.1004.png"
    frame.write_bytes((frame.parent / "plate.1003.png").read_bytes())
    assert [outcome["status"] for outcome in carried_out(show, out)] == ["done"] * 3
    assert not list(out.rglob("*.roam.1"))  # what was made is no one else's work


def test_a_step_whose_plate_was_away_for_a_while_is_not_taken_for_done(
    show: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """What it read is what it was, so that the frames it had passed over were never tracked."""
    plate = show.parent / "show" / "sh010" / "plate"
    away = plate.with_name("away")
    acts = {1003: lambda: plate.rename(away), 1005: lambda: away.rename(plate)}

    def watched(*arguments: Any, **options: Any) -> Iterator[FrameResult]:
        for result in track(*arguments, **options):
            yield result
            acts.get(result.frame, Path)()

    with monkeypatch.context() as out:
        out.setattr("roam_core.propagate.track", watched)
        out.setattr("roam_core.cli.plate.AHEAD", 0)
        first = carried_out(show, tmp_path / "out")[0]
    assert first["status"] == "failed"
    assert "was away for a while" in first["said"]
    assert [outcome["status"] for outcome in carried_out(show, tmp_path / "out")] == ["done"] * 3
    (shape,) = load_project(tmp_path / "out" / "sh010" / "sh010.roam").shapes
    assert shape.frames == tuple(range(1001, 1007))


@pytest.mark.parametrize("options", [{}, {"by": -1000}])
def test_a_project_goes_along_with_its_plates_new_numbers(tmp_path: Path, options: dict[str, int]) -> None:
    plate = put_plate(tmp_path / "plate")
    project = load_project(put_gaps(tmp_path / "init.roam", plate))
    for path in sorted(plate.iterdir()):
        path.rename(plate / path.name.replace("plate.1", "plate.0"))
    steps = [{"shift": options}, {"export": {"to": "json"}}]
    job = {"name": "sh010", "init": "init.roam", "steps": steps}
    (tmp_path / "jobs.json").write_text(json.dumps({"type": "roam.Jobs", "version": 1, "jobs": [job]}))
    outcomes = carried_out(tmp_path / "jobs.json", tmp_path / "out")
    assert [outcome["status"] for outcome in outcomes] == ["done", "done"], outcomes
    shifted = load_project(tmp_path / "out" / "sh010" / "sh010.roam")
    frames = [tuple(frame - 1000 for frame in shape.frames) for shape in project.shapes]
    assert [shape.frames for shape in shifted.shapes] == frames
    assert [outcome["status"] for outcome in carried_out(tmp_path / "jobs.json", tmp_path / "out")] == ["kept"] * 2


def test_a_result_that_the_artist_went_on_with_is_kept_aside(show: Path, tmp_path: Path) -> None:
    out = tmp_path / "out"
    carried_out(show, out)
    result = out / "sh010" / "sh010.roam"
    mine = result.read_bytes().replace(b"Shape 1", b"My work")
    assert mine != result.read_bytes()
    result.write_bytes(mine)
    assert carried_out(show, out)[0]["status"] == "kept"
    assert result.read_bytes() == mine
    (out / "sh010" / "sh010.1-track.roam").unlink()
    assert carried_out(show, out)[0]["status"] == "done"
    assert (out / "sh010" / "sh010.roam.1").read_bytes() == mine


def test_a_fill_in_pieces_is_the_fill_of_one_run(tmp_path: Path) -> None:
    plate = put_plate(tmp_path / "plate")
    given = put_gaps(tmp_path / "sh010.roam", plate)
    job = {"name": "sh010", "init": str(given), "steps": [{"fill": {"config": CONFIG}}]}
    (tmp_path / "jobs.json").write_text(json.dumps({"type": "roam.Jobs", "version": 1, "jobs": [job]}))
    ((task,),) = tasks_of(jobs_from(tmp_path / "jobs.json", out=tmp_path / "out").jobs)
    split = perform("b", task.plain())
    assert split["status"] == "split"
    assert [piece[0] for piece in split["pieces"]] == [(1001, 1003)] * 2 + [(1003, 1006)] * 2
    parts, whole = pieces(task, split["pieces"])
    assert [perform("b", part.plain())["status"] for part in reversed(parts)] == ["done"] * 4
    joined = perform("b", whole.plain())
    assert joined["status"] == "done"
    assert "already filled" not in joined["said"]
    assert {frame: values[1] for frame, values in joined["frames"].items()} == dict.fromkeys(joined["frames"], 0.0)
    (tmp_path / "deep" / "in").mkdir(parents=True)
    alone = tmp_path / "deep" / "in" / "one.roam"
    assert main(["fill", str(given), "--config", CONFIG, "--save", str(alone)]) == 0
    assert Path(task.result).read_bytes() == alone.read_bytes()
    assert perform("b", task.plain())["status"] == "kept"


def test_keys_of_other_settings_are_not_taken(tmp_path: Path) -> None:
    given = put_gaps(tmp_path / "a.roam", put_plate(tmp_path / "plate"))
    other, made = tmp_path / "other.roam", tmp_path / "made.roam"
    assert main(["fill", str(given), "--config", "lean", "--save", str(other)]) == 0
    words = ["fill", str(given), "--config", CONFIG, "--save"]
    assert main([*words, str(made), "--take", str(other)]) == 0
    assert main([*words, str(tmp_path / "alone.roam")]) == 0
    assert made.read_bytes() == (tmp_path / "alone.roam").read_bytes()


def test_mattes_become_a_project_and_mattes_again(show: Path, tmp_path: Path) -> None:
    carried_out(show, tmp_path / "out")
    shot = tmp_path / "matted" / "sh010"
    shot.mkdir(parents=True)
    (tmp_path / "out/sh010/mattes").rename(shot / "mattes")
    (show.parent / "show/sh010/plate").rename(shot / "plate")
    outcomes = carried_out(tmp_path / "matted", tmp_path / "again")
    assert [outcome["status"] for outcome in outcomes] == ["done", "done"]
    assert load_project(tmp_path / "again/sh010/sh010.roam").shapes
    assert len(list((tmp_path / "again/sh010/mattes").iterdir())) == 6


@pytest.mark.parametrize(
    ("verb", "reason"),
    [
        ("fill", "no gap to fill"),
        ("track", "no closed, unlocked shape"),
        ("steady", "no tracked or filled key to steady"),
        ("soften", "no closed, unlocked shape to soften"),
    ],
)
def test_what_leaves_a_step_nothing_to_do_goes_on_to_its_render(tmp_path: Path, verb: str, reason: str) -> None:
    """The step failed, and the mattes and exports of a finished shot were left out."""
    show = tmp_path / "show"
    plate, init = put_plate(show / "sh010" / "plate"), show / "sh010" / "init.roam"
    project = load_project(put_gaps(init, plate))
    for shape in project.shapes:
        finished = {"keys": shape.keys[:1]} if verb in ("fill", "steady") else {"locked": True}
        project = edit.set_properties(project, shape.id, **finished)
    file.save(project, init)
    outcomes = carried_out(show, tmp_path / "out", steps=f"{verb},render,export:json")
    assert [outcome["status"] for outcome in outcomes] == ["done"] * 3, outcomes
    assert outcomes[0]["idle"]
    assert reason in outcomes[0]["said"]
    made = tmp_path / "out" / "sh010"
    assert load_project(made / "sh010.roam").shapes == project.shapes
    assert load_project(made / "sh010.roam").require_clip().path == plate
    assert len(list((made / "mattes").iterdir())) == 6
    again = carried_out(show, tmp_path / "out", steps=f"{verb},render,export:json")
    assert [outcome["status"] for outcome in again] == ["kept"] * 3
    assert again[0]["idle"]


def test_a_line_of_steps_none_of_which_has_anything_to_do_ends_with_its_mattes(tmp_path: Path) -> None:
    given = put_gaps(tmp_path / "sh010.roam", put_plate(tmp_path / "plate"))
    project = load_project(given)
    for shape in project.shapes:
        project = edit.set_properties(project, shape.id, locked=True)
    file.save(project, given)
    steps = ["fill", "steady", "soften", "render"]
    (tmp_path / "jobs.json").write_text(
        json.dumps({"type": "roam.Jobs", "version": 1, "jobs": [{"name": "sh010", "init": str(given), "steps": steps}]})
    )
    outcomes = carried_out(tmp_path / "jobs.json", tmp_path / "out")
    assert [(outcome["status"], outcome.get("idle", False)) for outcome in outcomes] == [
        ("done", True),
        ("done", True),
        ("done", True),
        ("done", False),
    ]


@pytest.mark.parametrize("verb", ["fill", "steady", "soften"])
def test_a_shape_that_is_not_there_is_no_reason_to_go_on(tmp_path: Path, verb: str) -> None:
    given = put_gaps(tmp_path / "sh010.roam", put_plate(tmp_path / "plate"))
    job = {"name": "sh010", "init": str(given), "steps": [{verb: {"shape": ["Nobody"]}}]}
    (tmp_path / "jobs.json").write_text(json.dumps({"type": "roam.Jobs", "version": 1, "jobs": [job]}))
    (outcome,) = carried_out(tmp_path / "jobs.json", tmp_path / "out")
    assert outcome["status"] == "failed"
    assert "Nobody" in outcome["said"]


def test_a_refusal_is_told_and_nothing_recorded(show: Path, tmp_path: Path) -> None:
    ((track, *_),) = tasks_of(jobs_from(show, out=tmp_path / "out").jobs)
    (show.parent / "show/sh010/init.png").write_bytes(b"no picture")
    outcome = perform("b", track.plain())
    assert outcome["status"] == "failed"
    assert "init.png" in outcome["said"]
    assert not Path(track.record).exists()


@pytest.mark.parametrize(
    "words",
    [
        ("import", "mattes", "--into", "p.roam", "--save", "out.roam"),
        ("render", "p.roam", "--out", "out"),
        ("export", "p.roam", "out", "--to", "nuke"),
    ],
    ids=lambda words: words[0],
)
def test_steps_that_solve_nothing_hear_that_their_batch_ends_too(
    show: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, words: tuple[str, ...]
) -> None:
    """Ctrl-C waited for the last matte of the longest of them."""
    carried_out(show, tmp_path / "made")
    (tmp_path / "made/sh010/mattes").rename(tmp_path / "mattes")
    (tmp_path / "made/sh010/sh010.roam").rename(tmp_path / "p.roam")
    monkeypatch.chdir(tmp_path)
    token = CancelToken()
    token.cancel()
    with cancelled_by(token):
        assert main(list(words)) == INTERRUPTED
    assert not Path("out.roam").exists()
    assert not Path("out").is_file()
    assert not Path("out").exists() or not list(Path("out").iterdir())


def test_a_cancelled_step_stops_and_is_not_taken_for_done(
    show: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    ((track, *_),) = tasks_of(jobs_from(show, out=tmp_path / "out").jobs)
    solved: list[Any] = []

    def told(message: Any) -> None:
        solved.append(message["frame"])
        assert performing.cancel("other") == 0
        assert performing.cancel("b") == 1

    monkeypatch.setattr(performing, "PAUSE", 0.0)
    outcome = perform("b", track.plain(), tell=told)
    assert outcome["status"] == "cancelled"
    assert solved == [1001]
    assert not Path(track.made).exists()
    assert file.load(track.part).shapes  # what was finished is kept
    assert performing.cancel("b") == 0
    assert perform("b", track.plain())["status"] == "done"
    assert not Path(track.part).exists()


def test_doubtful_frames_have_pictures(show: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("roam_core.studio.pictures.DOUBTED", 2.0)
    outcome = carried_out(show, tmp_path / "out", str(tmp_path / "p"))[0]
    assert len(outcome["pictures"]) == 3
    assert sorted(outcome["pictures"].values()) == sorted(path.name for path in (tmp_path / "p").iterdir())


def test_the_least_sure_frames_are_doubted_first() -> None:
    frames = {"3": [0.5, 0, ""], "10": [0.2, 0, ""], "4": [0.95, 0, ""], "5": [0.8, 0, ""]}
    assert doubtful(frames, 2) == [10, 3]
    assert doubtful({"4": [0.95, 0, ""]}) == []


def test_a_task_travels_as_json(show: Path, tmp_path: Path) -> None:
    for task in tasks_of(jobs_from(show, out=tmp_path / "out").jobs)[0]:
        assert Task.of(json.loads(json.dumps(task.plain()))).plain() == json.loads(json.dumps(task.plain())) | {
            "words": task.words,
            "reads": task.reads,
        }


def test_an_import_is_done_again_when_its_clip_changed(tmp_path: Path) -> None:
    """It was kept, with the clip of before: its frames and its size."""
    shot = put_shot(tmp_path / "sh010")
    steps = [{"import": {"source": "sh010/init.png"}}, "render"]
    job = {"name": "a", "clip": "sh010/plate", "steps": steps}
    path = tmp_path / "jobs.json"
    path.write_text(json.dumps({"type": "roam.Jobs", "version": 1, "jobs": [job]}))
    assert [outcome["status"] for outcome in carried_out(path, tmp_path / "out")] == ["done"] * 2
    assert [outcome["status"] for outcome in carried_out(path, tmp_path / "out")] == ["kept"] * 2
    (shot / "plate" / "plate.1006.png").rename(shot / "plate" / "plate.1007.png")
    assert [outcome["status"] for outcome in carried_out(path, tmp_path / "out")] == ["done"] * 2
    assert load_project(tmp_path / "out/a/a.roam").require_clip().last == 1007


def test_a_step_that_is_kept_renews_the_result_of_its_job(tmp_path: Path) -> None:
    """Where it is gone, or was made by a step that the job has no longer; not where an artist went on with it."""
    put_gaps(tmp_path / "init.roam", put_plate(tmp_path / "plate"))
    path, out = tmp_path / "jobs.json", tmp_path / "out"

    def performed(*by: int) -> list[str]:
        steps = [{"shift": {"by": each}} for each in by]
        job = {"name": "a", "init": "init.roam", "steps": steps}
        path.write_text(json.dumps({"type": "roam.Jobs", "version": 1, "jobs": [job]}))
        return [outcome["status"] for outcome in carried_out(path, out)]

    folder = out / "a"
    result, first, second = folder / "a.roam", folder / "a.1-shift.roam", folder / "a.2-shift.roam"
    assert performed(10, 100) == ["done", "done"]
    assert result.read_bytes() == second.read_bytes() != first.read_bytes()
    result.unlink()
    assert performed(10, 100) == ["kept", "kept"]
    assert result.read_bytes() == second.read_bytes()
    assert performed(10) == ["kept"]
    assert result.read_bytes() == first.read_bytes()
    assert performed(10, 100) == ["kept", "kept"]
    assert result.read_bytes() == second.read_bytes()
    mine = result.read_bytes().replace(b"Small", b"My work")
    result.write_bytes(mine)
    for by in ((10, 100), (10,)):
        assert set(performed(*by)) == {"kept"}
        assert result.read_bytes() == mine
    assert not list(out.rglob("*.roam.1"))
