"""Exports as jobs: the file appears, what cannot be exported is one sentence."""

from __future__ import annotations

import threading
from collections.abc import Sequence
from pathlib import Path

import pytest
from pytestqt.qtbot import QtBot

from app.jobs.export import Export
from app.jobs.runner import Ending, Runner
from app.model.document import Document
from roam_core.geometry.bezier import polygon_points
from roam_core.media import open_clip
from roam_core.roto import Clip, Project, edit, file
from tests.gui.waiting import WAIT
from tests.gui.windows import write_clip

CLIP = Clip(Path("/plates/shot"), 1001, 1003, (64, 48))


@pytest.fixture
def drawn(document: Document) -> Document:
    square = polygon_points([(10, 10), (30, 10), (30, 30), (10, 30)])
    document.open(edit.new_shape(Project(CLIP), square, 1001)[0], None)
    return document


@pytest.mark.parametrize(("name", "target"), [("nuke", "a.nk"), ("silhouette", "a.fxs"), ("mattes", "mattes")])
def test_an_export_is_written_on_the_worker(
    qtbot: QtBot, drawn: Document, runner: Runner, tmp_path: Path, name: str, target: str
) -> None:
    export = Export(drawn, runner)
    with qtbot.waitSignal(export.finished, timeout=WAIT) as finished:
        export.start(name, tmp_path / target)
    assert finished.args[0] is Ending.DONE
    assert str(tmp_path / target) in finished.args[1]
    written = tmp_path / target
    assert len(list(written.iterdir())) == 3 if name == "mattes" else written.stat().st_size > 100


def test_a_project_without_a_clip_is_refused_in_a_sentence(
    qtbot: QtBot, document: Document, runner: Runner, tmp_path: Path
) -> None:
    export = Export(document, runner)
    with qtbot.waitSignal(export.finished, timeout=WAIT) as finished:
        export.start("nuke", tmp_path / "a.nk")
    assert finished.args[0] is Ending.FAILED
    assert "clip" in finished.args[1]
    assert list(tmp_path.iterdir()) == []


@pytest.fixture
def on_a_plate(document: Document, tmp_path: Path) -> Document:
    """A saved project on the frames 1001 to 1003 of `plate`."""
    clip = Clip.of(open_clip(write_clip(tmp_path / "plate", 3) / "plate.%04d.png"))
    square = polygon_points([(10, 10), (30, 10), (30, 30), (10, 30)])
    project = edit.new_shape(Project(clip), square, 1001)[0]
    document.open(project, tmp_path / "p.roam")
    file.save(project, tmp_path / "p.roam")
    return document


@pytest.mark.parametrize(
    ("name", "target"),
    [("mattes", "plate/plate.####.png"), ("nuke", "plate/plate.1002.png"), ("json", "p.roam"), ("json", "link.json")],
)
def test_what_the_project_is_made_of_is_never_written_over(
    qtbot: QtBot, on_a_plate: Document, runner: Runner, tmp_path: Path, name: str, target: str
) -> None:
    (tmp_path / "link.json").symlink_to(tmp_path / "plate" / "plate.1001.png")
    before = {path: path.read_bytes() for path in tmp_path.rglob("*") if path.is_file()}
    export = Export(on_a_plate, runner, may_overwrite=lambda _: True)
    with qtbot.waitSignal(export.finished, timeout=WAIT) as finished:
        export.start(name, tmp_path / target)
    assert finished.args[0] is Ending.FAILED
    assert "is read for this and is never written over" in finished.args[1]
    assert {path: path.read_bytes() for path in tmp_path.rglob("*") if path.is_file()} == before


@pytest.mark.parametrize("answer", [True, False])
def test_the_artist_is_asked_about_what_roam_did_not_make(
    qtbot: QtBot, drawn: Document, runner: Runner, tmp_path: Path, answer: bool
) -> None:
    theirs = [tmp_path / "mattes" / f"matte.{frame}.png" for frame in (1001, 1003)]
    theirs[0].parent.mkdir()
    for path in theirs:
        path.write_text("my own work")
    asked: list[Sequence[Path]] = []

    def may_overwrite(paths: Sequence[Path]) -> bool:
        asked.append(list(paths))
        return answer

    export = Export(drawn, runner, may_overwrite=may_overwrite)
    for _ in range(2):
        with qtbot.waitSignal(export.finished, timeout=WAIT) as finished:
            export.start("mattes", tmp_path / "mattes")
        assert finished.args[0] is (Ending.DONE if answer else Ending.CANCELLED)
    assert asked == ([theirs] if answer else [theirs, theirs])
    assert [path.read_bytes()[:4] == b"\x89PNG" for path in theirs] == [answer] * 2


def test_an_export_goes_on_while_another_is_asked_for(
    qtbot: QtBot, drawn: Document, runner: Runner, tmp_path: Path
) -> None:
    export, told = Export(drawn, runner), list[tuple[int, Ending]]()
    export.finished.connect(lambda ending, _: told.append((export.current, ending)))
    mattes = export.start("mattes", tmp_path / "mattes")
    script = export.start("nuke", tmp_path / "a.nk")
    assert export.is_writing
    qtbot.waitUntil(lambda: not export.is_writing, timeout=WAIT)
    assert told == [(mattes, Ending.DONE), (script, Ending.DONE)]
    assert len(list((tmp_path / "mattes").iterdir())) == 3
    assert (tmp_path / "a.nk").exists()


def test_stopping_stops_what_waits_too(qtbot: QtBot, drawn: Document, runner: Runner, tmp_path: Path) -> None:
    export, told = Export(drawn, runner), list[tuple[int, Ending]]()
    export.finished.connect(lambda ending, _: told.append((export.current, ending)))
    gate = threading.Event()
    runner.start("other", lambda report: str(gate.wait()))
    numbers = [export.start("mattes", tmp_path / "mattes"), export.start("nuke", tmp_path / "a.nk")]
    export.stop()
    gate.set()
    qtbot.waitUntil(lambda: not export.is_writing, timeout=WAIT)
    assert told == [(number, Ending.CANCELLED) for number in numbers]
    assert list(tmp_path.iterdir()) == []


def test_files_beside_the_one_that_was_named_are_told(
    qtbot: QtBot, drawn: Document, runner: Runner, tmp_path: Path
) -> None:
    square = polygon_points([(40, 10), (50, 10), (50, 30), (40, 30)])
    drawn.apply("Draw", edit.new_shape(drawn.project, square, 1001)[0])
    export, noted = Export(drawn, runner), list[tuple[str, ...]]()
    export.noted.connect(noted.append)
    with qtbot.waitSignal(export.finished, timeout=WAIT) as finished:
        export.start("mlt", tmp_path / "a.json")
    first, second = sorted(tmp_path.iterdir())
    told = f"Exported to {first} and 1 other file beside it."
    assert finished.args[1].startswith(told)
    assert noted[0][0] == told
    assert second.exists()
