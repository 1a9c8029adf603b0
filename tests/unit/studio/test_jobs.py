"""Files of jobs: what is read, what is refused and how, the schema, and folders of shots."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import jsonschema
import pytest

from roam_core.errors import RoamError
from roam_core.studio.fields import VERBS, schema
from roam_core.studio.finding import jobs_from
from roam_core.studio.jobs import Job, Jobs, Step, as_document, jobs_of, read_jobs, steps_named

GOOD = """
type: roam.Jobs
version: 1
out: results
steps:
  - track: {config: best, end: 1050}
  - render: {file: exr, channels: true}
jobs:
  - {name: sh010, clip: plates/sh010, init: masks/sh010.png}
  - name: sh020
    init: /show/sh020.roam
    steps: [fill, {export: {to: nuke}}, {import: {source: mattes}}]
"""


def document(**changes: Any) -> dict[str, Any]:
    job = {"name": "a", "clip": "plate", "init": "m.png", "steps": ["track"]}
    return {"type": "roam.Jobs", "version": 1, "jobs": [{**job, **changes}]}


def read(given: Any) -> Jobs:
    return jobs_of(given, Path("/show"), "jobs.yaml", Path("/show/jobs"))


def test_a_file_of_jobs_is_read(tmp_path: Path) -> None:
    path = tmp_path / "jobs.yaml"
    path.write_text(GOOD)
    steps = Step("track", {"config": "best", "end": 1050}), Step("render", {"file": "exr", "channels": True})
    own = Step("fill"), Step("export", {"to": "nuke"}), Step("import", {"source": str(tmp_path / "mattes")})
    assert read_jobs(path) == Jobs(
        (
            Job("sh010", steps, str(tmp_path / "plates/sh010"), tmp_path / "masks/sh010.png"),
            Job("sh020", own, None, Path("/show/sh020.roam")),
        ),
        tmp_path / "results",
    )


def test_json_says_the_same_and_a_document_gives_its_jobs_back(tmp_path: Path) -> None:
    path = tmp_path / "jobs.yaml"
    path.write_text(GOOD)
    jobs = read_jobs(path)
    again = tmp_path / "other" / "again.json"
    again.parent.mkdir()
    again.write_text(json.dumps(as_document(jobs)))
    assert read_jobs(again) == jobs


def test_the_schema_takes_what_is_read() -> None:
    jsonschema.Draft202012Validator.check_schema(schema())
    jsonschema.validate(document(), schema())
    for verb, each in VERBS.items():
        values = {"TEXT": "x", "WHOLE": 1, "NUMBER": 0.5, "FLAG": True, "TEXTS": ["x"]}
        full = {field.name: field.choices[0] if field.choices else values[field.kind.name] for field in each.fields}
        given = document(steps=["track", {verb: full}])
        jsonschema.validate(given, schema())
        assert read(given).jobs[0].steps[1].verb == verb


REFUSED = [
    ([], "no file of jobs"),
    ({"type": "roam.Jobs", "version": 2, "jobs": [{}]}, "another version"),
    ({"type": "roam.Jobs", "version": 1, "jobs": []}, "no list of jobs"),
    ({"type": "roam.Jobs", "version": 1, "jobs": ["a"]}, r"jobs\[0\] is no mapping"),
    ({**document(), "speed": 1}, "'speed', which means nothing"),
    (document(name=8), r"jobs\[0\].name is 8; it has to be a text"),
    (document(name="../up"), "a folder is named so"),
    (document(name="a."), "a folder is named so"),
    (document(steps=["tracking"]), "'tracking'; the steps are track, fill"),
    (document(steps=[]), "no list of steps"),
    (document(steps=[{"track": {"start": "first"}}]), r"track.start is 'first'; it has to be a whole number"),
    (document(steps=[{"track": {"start": True}}]), "it has to be a whole number"),
    (document(steps=[{"track": {"begin": 1}}]), "'begin', which means nothing"),
    (document(steps=[{"track": 3}]), "has to be a mapping"),
    (document(steps=["track", {"render": {"file": "gif"}}]), "one of png, exr, tiff"),
    (document(steps=["track", "export"]), "has no 'to'"),
    (document(steps=[{"track": {}, "fill": {}}]), "is no step"),
    (document(steps=["render"]), "no shapes to work on"),
    (document(clip="a\nb"), "has to be a text"),
]


@pytest.mark.parametrize(("given", "said"), REFUSED, ids=[said for _, said in REFUSED])
def test_what_is_wrong_is_told_with_its_place(given: Any, said: str) -> None:
    with pytest.raises(RoamError, match=said):
        read(given)


NOT_TOLD_BY_SCHEMA = ("a folder is named so", "no shapes to work on", "has to be a text")


@pytest.mark.parametrize("given", [given for given, said in REFUSED if said not in NOT_TOLD_BY_SCHEMA])
def test_the_schema_refuses_it_too(given: Any) -> None:
    with pytest.raises(jsonschema.ValidationError):
        jsonschema.validate(given, schema())


def test_a_job_without_clip_or_with_the_name_of_another_is_refused() -> None:
    one = document()["jobs"][0]
    with pytest.raises(RoamError, match="has no clip"):
        read({**document(), "jobs": [{key: value for key, value in one.items() if key != "clip"}]})
    with pytest.raises(RoamError, match="two jobs named 'A'"):
        read({**document(), "jobs": [one, {**one, "name": "A"}]})


@pytest.mark.parametrize(
    ("name", "text", "said"),
    [
        ("a.txt", "", "no file of jobs; its name"),
        ("a.yaml", "a: [1", "is no YAML: .* in line"),
        ("a.yaml", "a: &x [1]\nb: *x", r"by reference \(\*x\)"),
        ("a.yaml", "[" * 5000, "nested too deeply"),
        ("a.yaml", "!!python/object/apply:os.system ['true']", "is no YAML: could not determine a constructor"),
        ("a.yaml", "a: 2026-99-99", "cannot be read: month"),
        ("a.json", "[" * 200_000, "nested too deeply"),
        ("a.json", "{", "is no JSON"),
        ("a.json", "\xff", "is no (text|JSON)"),
        ("a.json", "9" * 10_000, "cannot be read"),
    ],
)
def test_a_hostile_file_gives_one_sentence(tmp_path: Path, name: str, text: str, said: str) -> None:
    (tmp_path / name).write_bytes(text.encode("latin-1"))
    with pytest.raises(RoamError, match=said):
        read_jobs(tmp_path / name)


def test_steps_in_short() -> None:
    assert steps_named("track, export:svg") == (Step("track"), Step("export", {"to": "svg"}))
    for wrong, said in (("jump", "is no step"), ("track:best", "is no step"), ("export", "has no 'to'")):
        with pytest.raises(RoamError, match=said):
            steps_named(wrong)


def test_folders_of_shots_are_jobs(tmp_path: Path) -> None:
    show = tmp_path / "show"
    for name in ("masked/plate", "keyed/plate", "matted/plate", "matted/mattes", "notes", ".hidden/plate"):
        (show / name).mkdir(parents=True)
    (show / "masked/init.png").touch()
    (show / "keyed/init.roam").touch()
    (show / ".hidden/init.png").touch()
    jobs = jobs_from(show).jobs
    assert {job.name: [step.verb for step in job.steps] for job in jobs.jobs} == {
        "keyed": ["fill", "render"],
        "masked": ["track", "render"],
        "matted": ["import", "render"],
    }
    assert jobs.out == tmp_path / "show-roam"
    assert jobs_from(show).notes == ()
    chosen = jobs_from(show, steps="track", out=tmp_path / "o")
    assert chosen.jobs.out == tmp_path / "o"
    assert [step.verb for step in chosen.jobs.jobs[0].steps] == ["track"]


def test_a_folder_that_is_half_a_shot_is_told(tmp_path: Path) -> None:
    for name in ("whole/plate", "whole/mattes", "bare/plate", "lost/plates", "matted/mattes", "notes/text"):
        (tmp_path / name).mkdir(parents=True)
    (tmp_path / "lost/init.png").touch()
    found = jobs_from(tmp_path)
    assert [job.name for job in found.jobs.jobs] == ["whole"]
    bare, lost, matted = found.notes
    assert bare == f"{tmp_path / 'bare'} is left out: it has no init.png, init.roam or folder mattes."
    assert lost.startswith(f"{tmp_path / 'lost'} is left out: it has no plate (plate, plate.mov")
    assert matted.startswith(f"{tmp_path / 'matted'} is left out: it has no plate (plate, plate.mov")


def test_a_folder_without_shots_is_refused(tmp_path: Path) -> None:
    with pytest.raises(RoamError, match="holds no shots"):
        jobs_from(tmp_path)


@pytest.mark.parametrize("suffix", [".yaml", ".json"])
def test_what_is_said_twice_of_one_thing_is_refused(tmp_path: Path, suffix: str) -> None:
    """YAML and JSON allow it nowhere; their readers took the last one, and the steps before it were not done."""
    path = tmp_path / f"jobs{suffix}"
    text = json.dumps(document())
    path.write_text(text)
    assert len(read_jobs(path).jobs) == 1
    path.write_text(text.replace('"steps": ["track"]', '"steps": ["track"], "steps": ["render"]'))
    with pytest.raises(RoamError, match=f"jobs{suffix} says 'steps' twice"):
        read_jobs(path)


def test_the_users_folder_may_be_named_as_in_a_shell(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(
        Path, "expanduser", lambda path: tmp_path / Path(*path.parts[1:]) if path.parts[0] == "~" else path
    )
    (job,) = read(document(clip="~/plates/a", init="~/m.png", steps=[{"import": {"source": "~/mattes"}}])).jobs
    assert job.clip == str(tmp_path / "plates/a")
    assert job.init == tmp_path / "m.png"
    assert job.steps[0].options["source"] == str(tmp_path / "mattes")
    assert read({**document(), "out": "~/out"}).out == tmp_path / "out"
    monkeypatch.undo()
    (job,) = read(document(clip="~nobody-of-this-name/plate")).jobs
    assert job.clip == "/show/~nobody-of-this-name/plate"
