"""`roam batch` as a whole: on a scheduler by its address and on a cluster of its own, with its report."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
from pathlib import Path

import pytest

from roam_core.cli import batch, main
from roam_core.studio.pictures import doubtful
from roam_core.studio.report import page
from tests.conftest import ROOT
from tests.unit.studio.shots import put_gaps, put_plate, put_shot

CONFIG = "baseline"


def put_jobs(folder: Path) -> Path:
    """Two shots to track, one to fill, and one that cannot be carried out."""
    for name in ("a", "b"):
        put_shot(folder / "show" / name)
    put_gaps(folder / "c.roam", put_plate(folder / "show" / "c"))
    (folder / "none.png").write_bytes(b"no picture")
    steps = [{"track": {"config": CONFIG}}, "render"]
    jobs = [
        {"name": name, "clip": f"show/{name}/plate", "init": f"show/{name}/init.png", "steps": steps} for name in "ab"
    ]
    jobs.append({"name": "c", "init": "c.roam", "steps": [{"fill": {"config": CONFIG}}, "render"]})
    jobs.append({"name": "d", "clip": "show/a/plate", "init": "none.png", "steps": steps})
    path = folder / "jobs.json"
    path.write_text(json.dumps({"type": "roam.Jobs", "version": 1, "jobs": jobs}))
    return path


def results(folder: Path) -> dict[str, bytes]:
    """What a batch made, by path: projects and mattes."""
    found = (path for path in folder.rglob("*") if path.suffix in (".roam", ".png") and "steps" not in path.parts)
    return {str(path.relative_to(folder)): path.read_bytes() for path in found}


def test_a_batch_by_address_is_bit_by_bit_what_single_runs_give(
    scheduler: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    jobs, out = put_jobs(tmp_path), tmp_path / "out"
    words = ["batch", str(jobs), "--out", str(out), "--scheduler", scheduler, "--json"]
    assert main(words) == 1
    lines = [json.loads(line) for line in capsys.readouterr().out.splitlines()]
    assert {(line["job"], line["status"]) for line in lines} == {
        *((job, "done") for job in "abc"),
        ("d", "failed"),
        ("d", "skipped"),
    }
    assert {line["step"] for line in lines if line["job"] == "c" and "/" in line["step"]}  # it was divided
    alone = tmp_path / "alone" / "in"
    alone.mkdir(parents=True)
    for name in "ab":
        shot, project = tmp_path / "show" / name, alone / f"{name}.roam"
        init = str(shot / "init.png")
        assert main(["track", str(shot / "plate"), "--init", init, "--config", CONFIG, "--save", str(project)]) == 0
    assert main(["fill", str(tmp_path / "c.roam"), "--config", CONFIG, "--save", str(alone / "c.roam")]) == 0
    made = results(out)
    for name in "abc":
        assert main(["render", str(alone / f"{name}.roam"), "--out", str(alone / name)]) == 0
        assert made[f"{name}/{name}.roam"] == (alone / f"{name}.roam").read_bytes()
        for matte in (alone / name).iterdir():
            assert made[f"{name}/mattes/{matte.name}"] == matte.read_bytes()
    report = json.loads((out / "report.json").read_text())
    assert report["counts"] == {"done": 3, "failed": 1}
    shown = (out / "report.html").read_text()
    assert shown.index("<td>d</td>") < shown.index("<td>a</td>")
    assert "none.png" in shown
    capsys.readouterr()
    assert main(words) == 1  # again: what is done is kept
    lines = [json.loads(line) for line in capsys.readouterr().out.splitlines()]
    assert {line["status"] for line in lines if line["job"] in "abc"} == {"kept"}
    assert results(out) == made


@pytest.mark.usefixtures("heard")
def test_a_cluster_of_its_own_is_stopped_by_a_signal_and_resumed(tmp_path: Path) -> None:
    put_shot(tmp_path / "show" / "a")
    frames = 6
    job = {"clip": "show/a/plate", "init": "show/a/init.png", "steps": [{"track": {"config": CONFIG}}, "render"]}
    jobs = [{"name": f"j{k}", **job} for k in range(40)]
    (tmp_path / "jobs.json").write_text(json.dumps({"type": "roam.Jobs", "version": 1, "jobs": jobs}))
    words = [sys.executable, "-m", "roam_core", "batch", "jobs.json", "--workers", "1", "--no-dashboard", "--json"]
    environment = os.environ | {"PYTHONPATH": str(ROOT)}
    running = subprocess.Popen(
        words, cwd=tmp_path, env=environment, stdout=subprocess.PIPE, stderr=subprocess.PIPE, start_new_session=True
    )
    assert running.stdout is not None
    first = json.loads(running.stdout.readline())
    os.killpg(running.pid, signal.SIGINT)  # as a terminal does: to all processes
    _, said = running.communicate(timeout=120)
    assert running.returncode == 130, said
    assert b"stopped; what was finished is kept" in said
    report = json.loads((tmp_path / "jobs" / "report.json").read_text())
    done = {job["name"] for job in report["jobs"] if job["steps"][0]["status"] == "done"}
    assert first["job"] in done
    assert len(done) < 40
    left = sorted(each["name"] for each in jobs if each["name"] not in done)
    for name in left[1:]:
        jobs = [each for each in jobs if each["name"] != name]
    (tmp_path / "jobs.json").write_text(json.dumps({"type": "roam.Jobs", "version": 1, "jobs": jobs}))
    again = subprocess.run(words, cwd=tmp_path, env=environment, capture_output=True, timeout=120, check=False)
    assert again.returncode == 0, again.stderr
    ended = [json.loads(line) for line in again.stdout.splitlines()]
    assert {each["job"] for each in ended if each["step"] == "1-track" and each["status"] == "kept"} >= done
    assert len(list((tmp_path / "jobs" / left[0] / "mattes").iterdir())) == frames


@pytest.mark.parametrize(
    ("words", "said"),
    [
        ([], "Name a file of jobs"),
        (["j.json", "--tls-ca", "x"], "go together"),
        (["j.json", "--tls-ca", "x", "--tls-cert", "y", "--tls-key", "z"], "name it with --scheduler"),
        (["j.json", "--scheduler", "h:1", "--workers", "2"], "a scheduler has its own"),
        (["j.json", "--workers", "0"], "1 or more"),
        (["j.json", "--timeline", "o.otio"], "for an edit"),
        (["j.json"], "does not exist"),
        (["shotz"], "shotz does not exist; give a file of jobs, a folder of shots or an edit"),
    ],
)
def test_what_makes_no_sense_is_refused(words: list[str], said: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["batch", *words]) == 1
    assert said in capsys.readouterr().err


def test_the_jobs_that_were_found_and_the_schema_are_written(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    put_shot(tmp_path / "show" / "a")
    assert main(["batch", str(tmp_path / "show"), "--write", str(tmp_path / "jobs.json")]) == 0
    assert json.loads((tmp_path / "jobs.json").read_text())["jobs"][0]["name"] == "a"
    assert not (tmp_path / "show-roam").exists()
    capsys.readouterr()
    assert main(["batch", "--schema"]) == 0
    assert json.loads(capsys.readouterr().out)["title"] == "Jobs of roam batch"


def test_a_page_shows_what_a_program_said_as_text() -> None:
    step = {"step": "1-track", "status": "failed", "said": "<script>", "seconds": 0.0, "frames": {}}
    job = {"name": "<b>", "folder": "", "status": "failed", "seconds": 0.0, "steps": [step]}
    shown = page({"jobs": [job], "counts": {"failed": 1}, "seconds": 1.0, "workers": 1, "program": "0"})
    assert "&lt;script&gt;" in shown
    assert "<script>" not in shown
    assert "<b>" not in shown


def test_a_frame_without_a_picture_is_not_doubted() -> None:
    """A gap in the plate made a sure job the least sure one, and took the places of pictures of doubtful frames."""
    missing = {str(frame): [0.0, 0.0, "missing_frame"] for frame in range(1003, 1007)}
    frames = {"1001": [1.0, 0.0, "artist_key"], "1002": [0.8, 0.1, "converged"], **missing}
    assert doubtful(frames) == [1002]
    step = {"step": "1-track", "status": "done", "said": "", "seconds": 0.0, "frames": frames}
    job = {"name": "a", "folder": "", "status": "done", "seconds": 0.0, "steps": [step]}
    told = {"counts": {"done": 1}, "seconds": 1.0, "workers": 1, "program": "0"}
    assert '<td class="number">0.80</td>' in page({"jobs": [job], **told})
    assert "<polyline" not in page({"jobs": [job | {"steps": [step | {"frames": missing}]}], **told})


def test_without_the_extra_one_sentence_says_what_to_install(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr("roam_core.installation.find_spec", lambda name: None)
    put_shot(tmp_path / "show" / "a")
    assert main(["batch", str(tmp_path / "show")]) == 1
    (line,) = capsys.readouterr().err.splitlines()
    assert "roam-roto[studio]" in line


def test_a_fill_on_several_processes_is_the_fill_of_one(tmp_path: Path) -> None:
    given = put_gaps(tmp_path / "c.roam", put_plate(tmp_path / "plate"))
    words = ["fill", str(given), "--config", CONFIG, "--save"]
    command = [sys.executable, "-m", "roam_core", *words, str(tmp_path / "two.roam"), "--workers", "2", "--json"]
    environment = os.environ | {"PYTHONPATH": str(ROOT)}
    done = subprocess.run(command, env=environment, capture_output=True, text=True, timeout=120, check=False)
    assert done.returncode == 0, done.stderr
    lines = [json.loads(line) for line in done.stdout.splitlines()]
    # The frames between keys share the time of the processes: nothing was left to be filled by this one.
    assert len({line["seconds"] for line in lines if line["termination"] != "artist_key"}) == 1
    assert {line["seconds"] for line in lines if line["termination"] == "artist_key"} == {0.0}
    assert main([*words, str(tmp_path / "one.roam")]) == 0
    assert (tmp_path / "two.roam").read_bytes() == (tmp_path / "one.roam").read_bytes()


def test_the_terminal_says_why_a_step_had_nothing_to_do(capsys: pytest.CaptureFixture[str]) -> None:
    outcome = {"job": "sh010", "step": "1-fill", "status": "done", "said": "P.roam has no gap to fill.", "seconds": 0.0}
    with batch._Terminal(as_json=False) as terminal:
        terminal.ended(outcome | {"idle": True})
        terminal.ended(outcome)
    told = ["sh010  1-fill  done  0.0 s  P.roam has no gap to fill.", "sh010  1-fill  done  0.0 s"]
    assert capsys.readouterr().err.splitlines() == told


def test_jobs_are_written_over_nothing_of_others_and_never_over_what_is_read(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    jobs, notes = put_jobs(tmp_path), tmp_path / "notes.json"
    notes.write_text('{"mine": 1}')
    before = jobs.read_bytes()
    assert main(["batch", str(jobs), "--write", str(notes)]) == 1
    assert f"{notes} is there already" in capsys.readouterr().err
    assert notes.read_text() == '{"mine": 1}'
    (tmp_path / "link.json").symlink_to(jobs)
    for target in (jobs, tmp_path / "link.json"):
        assert main(["batch", str(jobs), "--write", str(target), "--overwrite"]) == 1
        assert "is read for this and is never written over" in capsys.readouterr().err
    assert jobs.read_bytes() == before
    picture = min((tmp_path / "show" / "a" / "plate").iterdir())
    assert main(["batch", str(jobs), "--write", str(picture), "--overwrite"]) == 1
    assert "its name has to end in .yaml, .yml, .json" in capsys.readouterr().err
    assert main(["batch", str(jobs), "--write", str(notes), "--overwrite"]) == 0
    assert len(json.loads(notes.read_text())["jobs"]) == 4
