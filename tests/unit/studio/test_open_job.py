"""A project's work as a job for a farm: what the specification's own library and runner say of it."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path
from shlex import quote
from typing import Any

import pytest

from roam_core.cli import main
from roam_core.errors import RoamError
from roam_core.studio import open_job
from roam_core.studio.jobs import Job, steps_named
from roam_core.studio.open_job import Shares, _replaced, checked, template_of, written
from tests.conftest import ROOT
from tests.unit.studio.shots import put_gaps, put_plate

SHARES = Shares([(1001, 1003), (1003, 1006)], range(1001, 1007), 4)


def template(steps: str = "fill,render,export:nuke", shares: Shares = SHARES, **changes: Any) -> dict[str, Any]:
    job = Job("sh010", steps_named(steps), "/show/plate", Path("/show/sh010.roam"))
    return template_of(job, Path("/show/out"), shares, **({"folder": Path("/show")} | changes))


def ranges(step: dict[str, Any]) -> list[list[int]]:
    return [each["range"] for each in step["parameterSpace"]["taskParameterDefinitions"]]


def test_a_fill_is_spread_over_spans_and_joined_and_rendering_comes_in_chunks() -> None:
    made = checked(template())
    assert [step["name"] for step in made["steps"]] == ["1-fill spans", "1-fill join", "2-render", "3-export"]
    assert ranges(made["steps"][0]) == [[1001, 1003], [1003, 1006]]
    assert ranges(made["steps"][2]) == [[1001, 1005], [1004, 1006]]
    assert [step.get("dependencies") for step in made["steps"][:2]] == [None, [{"dependsOn": "1-fill spans"}]]
    defaults = {each["name"]: each.get("default") for each in made["parameterDefinitions"]}
    assert defaults == {"Project": "sh010.roam", "Out": "out", "Roam": "roam"}
    assert "/show" not in json.dumps([step["script"] for step in made["steps"]])


def test_tracking_names_the_clip_and_one_gap_needs_no_join() -> None:
    made = checked(template("track,fill", Shares([(1, 9)], range(1, 10), 4)))
    assert [step["name"] for step in made["steps"]] == ["1-track", "2-fill"]
    assert made["steps"][0]["script"]["actions"]["onRun"]["args"][:4] == [
        "track", "{{Param.Clip}}", "--init", "{{Param.Project}}",
    ]  # fmt: skip


def test_a_long_clip_has_no_more_tasks_than_the_specification_allows() -> None:
    made = checked(template("render", Shares([], range(100_000), 4)))
    starts, ends = ranges(made["steps"][0])
    assert len(starts) <= 1024
    assert (starts[0], ends[-1]) == (0, 99_999)
    assert starts[1:] == [end + 1 for end in ends[:-1]]


def test_what_cannot_stand_in_a_job_is_refused() -> None:
    with pytest.raises(RoamError, match="double braces"):
        template(command="{{Param.Out}}")
    with pytest.raises(RoamError, match="at most 1024"):
        template(shares=Shares([(k, k + 2) for k in range(2000)], range(10), 4))
    with pytest.raises(RoamError, match="as Open Job Description wants it"):
        checked({**template(), "steps": []})
    with pytest.raises(RoamError, match=r"a\.txt is none"):
        written(template(), Path("a.txt"))


def test_a_shift_is_refused_for_tasks_are_by_frames(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    project = put_gaps(tmp_path / "sh010.roam", put_plate(tmp_path / "plate"))
    assert main(["farm", str(project), "--steps", "shift,render"]) == 1
    assert f"roam shift {project}" in capsys.readouterr().err
    assert not (tmp_path / "sh010.openjd.json").exists()


def test_mattes_are_rendered_as_asked_for(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    project = put_gaps(tmp_path / "sh010.roam", put_plate(tmp_path / "plate"))
    job = tmp_path / "sh010.openjd.json"
    for words, reason in (
        (["--steps", "fill", "--cryptomatte"], "--cryptomatte is for the step render; name it, too."),
        (["--file", "png", "--cryptomatte"], "PNG files hold no Cryptomatte"),
    ):
        assert main(["farm", str(project), *words]) == 1
        assert reason in capsys.readouterr().err
        assert not job.exists()
    assert main(["farm", str(project), "--cryptomatte", "--compression", "zips"]) == 0
    step = json.loads(job.read_text())["steps"][-1]
    command = step["script"]["actions"]["onRun"]
    assert "--cryptomatte" in json.dumps(command)
    assert "--compression=zips" in json.dumps(command)


def test_a_job_that_cannot_be_written_leaves_no_folder(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    project = put_gaps(tmp_path / "sh010.roam", put_plate(tmp_path / "plate"))
    out = tmp_path / "sh010-farm"
    for own in (False, True):
        if own:
            out.mkdir()
        assert main(["farm", str(project), "--job", str(tmp_path / "nowhere" / "job.json")]) == 1
        assert "nowhere" in capsys.readouterr().err
        assert out.exists() is own
    out.rmdir()
    assert main(["farm", str(project), "--job", str(out / "job.json")]) == 0, "the job may lie in it"


def test_paths_elsewhere_are_to_be_given(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    project = put_gaps(tmp_path / "sh010.roam", put_plate(tmp_path / "plate"))
    (tmp_path / "jobs").mkdir()
    target = tmp_path / "jobs" / "sh010.yaml"
    assert main(["farm", str(project), "--job", str(target), "--json"]) == 0
    told = json.loads(capsys.readouterr().out)
    assert told["parameters"] == {"Project": str(project), "Out": str(tmp_path / "sh010-farm")}
    assert target.read_text().startswith("specificationVersion: jobtemplate-2023-09")


def test_the_runner_of_the_specification_carries_the_job_out(tmp_path: Path) -> None:
    pytest.importorskip("openjd.cli", reason="openjd-cli is not installed (pip install 'roam-roto[dev]')")
    project = put_gaps(tmp_path / "sh010.roam", put_plate(tmp_path / "plate"))
    roam = tmp_path / "roam"  # what a farm calls; here this very checkout
    roam.write_text(f'#!/bin/sh\nPYTHONPATH={quote(str(ROOT))} exec {quote(sys.executable)} -m roam_core "$@"\n')
    roam.chmod(0o755)
    assert main(["farm", str(project), "--chunk", "6", "--roam", str(roam)]) == 0
    command = [sys.executable, "-c", "from openjd.cli import main; main()", "run", str(tmp_path / "sh010.openjd.json")]
    # The runner works in a folder of one name for all users of a machine, which may be another's.
    environment = os.environ | {"TMPDIR": str(tmp_path)}
    done = subprocess.run(command, cwd=tmp_path, env=environment, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    out = tmp_path / "sh010-farm"
    alone = tmp_path / "alone" / "sh010.roam"
    alone.parent.mkdir()
    assert main(["fill", str(project), "--save", str(alone)]) == 0
    assert (out / "sh010.roam").read_bytes() == alone.read_bytes()
    assert len(list((out / "mattes").iterdir())) == 6


@pytest.mark.parametrize(
    ("plate", "project", "out"),
    [
        ("/show/sh010", "/show/sh010.roam", "/show/out"),
        ("/show", "/show/sh010.roam", "/show/out"),
        ("/show/sh010", "/show/sh010/sh010.roam", "/show/sh010/sh010-farm"),
        ("/show/out/plate", "/show/sh010.roam", "/show/out"),
    ],
)
def test_results_go_to_their_place_wherever_the_plate_lies(plate: str, project: str, out: str) -> None:
    """Beside the project its plate's folder has its name, or holds both: mattes were written among the frames."""
    job = Job("sh010", steps_named("render,export:nuke"), plate, Path(project))
    made = checked(template_of(job, Path(out), SHARES, Path("/show")))
    render, export = (step["script"]["actions"]["onRun"]["args"] for step in made["steps"])
    assert render[:4] == ["render", "{{Param.Project}}", "--out", "{{Param.Out}}/mattes"]
    assert export[:3] == ["export", "{{Param.Project}}", "{{Param.Out}}/sh010.nk"]
    assert "Param.Clip" not in json.dumps(made)
    assert "Clip" not in [each["name"] for each in made["parameterDefinitions"]]


@pytest.mark.parametrize("separator", ["/", "\\"])
def test_a_job_names_no_place_of_the_machine_that_wrote_it(separator: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """On Windows, whose paths have other strokes, results kept the drive of the artist's machine."""
    monkeypatch.setattr(open_job.os, "sep", separator)
    place = separator.join(("D:", "show", "out"))
    words = [
        _replaced(place + separator.join(("", *more)), [(place, "{{Param.Out}}")]) for more in ((), ("a", "b.png"))
    ]
    assert words == ["{{Param.Out}}", "{{Param.Out}}/a/b.png"]
    assert _replaced(f"{place}put", [(place, "{{Param.Out}}")]) == f"{place}put"


def test_results_in_a_folder_above_are_to_be_given(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """A default with `..` in it is refused when the job is submitted."""
    (tmp_path / "in").mkdir()
    project = put_gaps(tmp_path / "in" / "sh010.roam", put_plate(tmp_path / "in" / "plate"))
    out = tmp_path / "in" / ".." / "x"
    assert main(["farm", str(project), "--out", str(out), "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["parameters"] == {"Out": str(out)}
    made = json.loads((tmp_path / "in" / "sh010.openjd.json").read_text())
    assert [each["default"] for each in made["parameterDefinitions"] if "default" in each] == ["sh010.roam", "roam"]


@pytest.mark.parametrize("suffix", [".json", ".yaml"])
def test_a_job_takes_the_place_of_none_but_its_own_kind(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], suffix: str
) -> None:
    project = put_gaps(tmp_path / "sh010.roam", put_plate(tmp_path / "plate"))
    target = tmp_path / f"job{suffix}"
    words = ["farm", str(project), "--job", str(target)]
    target.write_text('{"name": "my own notes"}')
    assert main(words) == 1
    assert "job" in (said := capsys.readouterr().err)
    assert "--overwrite" in said
    assert target.read_text() == '{"name": "my own notes"}'
    assert not (tmp_path / "sh010-farm").exists()
    assert main([*words, "--overwrite"]) == 0
    ours = target.read_bytes()
    assert main([*words, "--steps", "render"]) == 0, "ours is written again"
    assert target.read_bytes() != ours
