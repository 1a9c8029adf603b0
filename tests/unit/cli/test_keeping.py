"""What is finished is kept: written as a run goes, and on every way out of it."""

from __future__ import annotations

import errno
import io
import json
import os
import signal
import subprocess
import sys
import threading
from collections.abc import Callable, Iterator
from itertools import pairwise
from pathlib import Path
from typing import IO, Any

import pytest

from roam_core.cancel import Cancelled
from roam_core.cli import lines, main
from roam_core.cli.keeping import PAUSE, SHARE, Keeper, kept
from roam_core.cli.overwriting import project_writer
from roam_core.cli.stopping import STOPPING, Stopped, cancelling, raising
from roam_core.errors import RoamError
from roam_core.propagate import FrameResult, track
from roam_core.propagate.between.span import fill_span
from roam_core.roto import Mark, Project, file
from roam_core.roto.backups import backup_path
from tests.unit.cli.conftest import SHOT, Plate, Roam, write_picture
from tests.unit.cli.test_fill import CONFIG
from tests.unit.cli.test_fill import keyed as keyed

STATES = [Project(marks=(Mark(n, "state"),)) for n in range(5)]
ROAM = (sys.executable, "-c", "import sys; from roam_core.cli import main; sys.exit(main())")
LONG = 400
"""Frames: some seconds of work, so that a test can come in between."""


class Clock:
    """Seconds that pass when a test says so."""

    def __init__(self) -> None:
        self.now = 100.0

    def __call__(self) -> float:
        return self.now


# ---- writing as it goes ----------------------------------------------------------------------------------------------


def test_it_is_written_at_most_every_second_and_once_at_the_end() -> None:
    clock, written = Clock(), list[Project]()
    keeper = Keeper(written.append, clock)
    for state, pause in zip(STATES, (0.5 * PAUSE, 0.6 * PAUSE, 0.3 * PAUSE, 0.8 * PAUSE, 0.1 * PAUSE), strict=True):
        clock.now += pause
        keeper.offer(state)
    assert written == [STATES[1], STATES[3]]
    keeper.flush()
    keeper.flush()
    assert written == [STATES[1], STATES[3], STATES[4]]


def test_the_pause_grows_with_the_time_that_a_write_takes() -> None:
    clock, began = Clock(), list[float]()

    def slow(_project: Project) -> None:
        began.append(clock.now)
        clock.now += 3.0

    keeper = Keeper(slow, clock)
    for _ in range(400):
        clock.now += 0.25
        keeper.offer(STATES[0])
    assert len(began) > 2
    assert all(later - before >= 3.0 + 3.0 / SHARE for before, later in pairwise(began))


def test_two_runs_that_write_to_one_file_leave_its_earlier_versions_their_places(tmp_path: Path) -> None:
    path, clock = tmp_path / "p.roam", Clock()
    drawn = Project(marks=(Mark(1, "drawn by hand"),))
    file.save(drawn, path)
    runs = [Keeper(project_writer(path), clock) for _ in range(2)]
    for second in range(1, 600):
        clock.now += PAUSE
        for number, run in enumerate(runs):
            run.offer(Project(marks=(Mark(second, f"run {number}"),)))
    for run in runs:
        run.flush()
    kept_there = [file.load(backup_path(path, number)) for number in range(1, 9) if backup_path(path, number).exists()]
    assert drawn in kept_there
    assert Project(marks=(Mark(599, "run 0"),)) in kept_there
    assert file.load(path) == Project(marks=(Mark(599, "run 1"),))


def broken_off(write: Callable[[Project], None] | None, way_out: BaseException) -> None:
    """A run that is not finished."""
    with kept(write) as keeper:
        keeper.offer(STATES[0])
        raise way_out


@pytest.mark.parametrize("way_out", [KeyboardInterrupt(), BrokenPipeError(), Stopped(15), Cancelled(), ValueError()])
def test_whatever_ends_the_run_what_was_offered_is_written(way_out: BaseException) -> None:
    written: list[Project] = []
    with pytest.raises(type(way_out)):
        broken_off(written.append, way_out)
    assert written == STATES[:1]


def test_an_error_says_what_has_become_of_the_rest() -> None:
    def full(_project: Project) -> None:
        raise RoamError("The disk is full.")

    for write, words in (
        (list[Project]().append, "It broke. What was finished is kept."),
        (full, "It broke. What was finished last is not kept: The disk is full."),
        (None, "It broke."),
    ):
        with pytest.raises(RoamError) as caught:
            broken_off(write, RoamError("It broke."))
        assert str(caught.value) == words


# ---- signals ---------------------------------------------------------------------------------------------------------


@pytest.fixture
def on_frame(monkeypatch: pytest.MonkeyPatch) -> Callable[[int, Callable[[], object]], None]:
    """`on_frame(1003, act)`: something happens when tracking has come to that frame."""

    def arrange(frame: int, act: Callable[[], object]) -> None:
        def watched(*arguments: Any, **options: Any) -> Iterator[FrameResult]:
            for result in track(*arguments, **options):
                yield result
                if result.frame == frame:
                    act()

        monkeypatch.setattr("roam_core.propagate.track", watched)

    return arrange


@pytest.mark.usefixtures("heard")
@pytest.mark.parametrize("number", STOPPING)
def test_a_signal_keeps_what_is_tracked(
    roam: Roam, plate: Plate, on_frame: Callable[[int, Callable[[], object]], None], number: signal.Signals
) -> None:
    before = signal.getsignal(number)
    on_frame(1003, lambda: signal.raise_signal(number))
    path = plate.folder.parent / "p.roam"
    done = roam("track", plate.folder, "--init", plate.mask, *CONFIG, "--save", path)
    assert (done.status, done.err) == (128 + number, "roam: stopped; what was finished is kept.\n")
    assert file.load(path).shapes[0].frames == (1001, 1002, 1003)
    assert signal.getsignal(number) == before


@pytest.mark.usefixtures("heard")
@pytest.mark.parametrize("number", STOPPING)
def test_a_signal_keeps_what_is_filled(
    roam: Roam, keyed: Path, monkeypatch: pytest.MonkeyPatch, number: signal.Signals
) -> None:
    def stopped(images: Any, shapes: Any, start: int, *rest: Any, **options: Any) -> Any:
        if start == 1004:
            signal.raise_signal(number)
        return fill_span(images, shapes, start, *rest, **options)

    monkeypatch.setattr("roam_core.propagate.fill_span", stopped)
    assert roam("fill", keyed, *CONFIG).status == 128 + number
    assert file.load(keyed).shapes[0].frames == (1001, 1002, 1003, 1004, 1006)


@pytest.mark.usefixtures("heard")
def test_a_second_ctrl_c_does_not_wait_and_other_signals_come_in_pairs() -> None:
    came_to: list[str] = []

    def interrupted(*numbers: int) -> None:
        with cancelling() as token:
            for number in numbers:
                signal.raise_signal(number)
            came_to.append("a safe point")
            token.check()

    with pytest.raises(Stopped):
        interrupted(signal.SIGINT, signal.SIGINT)
    assert came_to == []
    with pytest.raises(Stopped) as caught:
        interrupted(*STOPPING[:0:-1])
    assert (caught.value.number, came_to) == (STOPPING[-1], ["a safe point"])


class Finalized:
    """Something that a signal comes to while it is let go of."""

    def __del__(self) -> None:
        signal.raise_signal(signal.SIGINT)


@pytest.mark.usefixtures("heard")
def test_ctrl_c_in_a_finalizer_is_heard_and_no_traceback(capsys: pytest.CaptureFixture[str]) -> None:
    def interrupted() -> None:
        with raising():
            Finalized()
            threading.Event().wait(60.0)

    with pytest.raises(Stopped):
        interrupted()
    assert capsys.readouterr().err == ""


@pytest.mark.usefixtures("heard")
@pytest.mark.parametrize("ends", [None, Cancelled()])
def test_a_signal_while_the_last_is_written_waits_until_it_is(ends: Cancelled | None) -> None:
    written: list[Project] = []

    def write(project: Project) -> None:
        signal.raise_signal(signal.SIGINT)
        written.append(project)

    def interrupted() -> None:
        with cancelling() as token, kept(write) as keeper:
            keeper.offer(STATES[0])
            token.cancel()
            if ends is not None:
                raise ends

    with pytest.raises(Stopped):
        interrupted()
    assert written == STATES[:1]


@pytest.mark.usefixtures("heard")
def test_a_signal_that_is_ignored_stays_so() -> None:
    before = signal.signal(signal.SIGTERM, signal.SIG_IGN)
    try:
        with cancelling() as token:
            signal.raise_signal(signal.SIGTERM)
            assert not token.is_cancelled
    finally:
        signal.signal(signal.SIGTERM, before)


@pytest.fixture
def long_run(plate: Plate) -> Callable[[], subprocess.Popen[bytes]]:
    """A process that tracks a long clip into `p.roam` and tells each frame."""
    for n in range(len(SHOT.frames), LONG):
        os.link(plate.folder / f"plate.{1001 + n % 6}.png", plate.folder / f"plate.{1001 + n}.png")
    words = ["track", plate.folder, "--init", plate.mask, *CONFIG, "--save", plate.folder.parent / "p.roam", "--json"]
    command = [*ROAM, *map(str, words)]
    return lambda: subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE)


def frames_told(stream: IO[bytes]) -> Iterator[int]:
    return (json.loads(line)["frame"] for line in stream)


@pytest.mark.skipif(os.name == "nt", reason="POSIX signals")
def test_a_killed_run_leaves_a_project_that_opens(
    plate: Plate, long_run: Callable[[], subprocess.Popen[bytes]]
) -> None:
    path = plate.folder.parent / "p.roam"
    with long_run() as process:
        assert process.stdout is not None
        last = next(frame for frame in frames_told(process.stdout) if path.exists())
        process.kill()
        process.stdout.read()
    assert process.returncode == -signal.SIGKILL
    frames = file.load(path).shapes[0].frames
    assert frames == tuple(range(1001, frames[-1] + 1))
    assert last - 2 <= frames[-1] < 1000 + LONG


@pytest.mark.skipif(os.name == "nt", reason="POSIX pipes")
def test_a_reader_that_went_away(plate: Plate, long_run: Callable[[], subprocess.Popen[bytes]]) -> None:
    with long_run() as process:
        assert process.stdout is not None
        assert process.stderr is not None
        assert next(frames_told(process.stdout)) == 1001
        process.stdout.close()
        said = process.stderr.read()
    assert (process.returncode, said) == (141, b"")
    frames = file.load(plate.folder.parent / "p.roam").shapes[0].frames
    assert 1 < len(frames) < LONG


# ---- full disks ------------------------------------------------------------------------------------------------------


def test_a_full_disk_while_mattes_are_written(roam: Roam, plate: Plate, monkeypatch: pytest.MonkeyPatch) -> None:
    flushed = iter(range(100))
    really = os.fsync

    def full(handle: int) -> None:
        if next(flushed) == 6:  # a file, not its folder
            raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))
        really(handle)

    monkeypatch.setattr(os, "fsync", full)
    path, out = plate.folder.parent / "p.roam", plate.folder.parent / "mattes"
    done = roam("track", plate.folder, "--init", plate.mask, *CONFIG, "--save", path, "--matte", out)
    assert (done.status, done.out) == (1, "")
    assert "cannot be written: No space left on device" in done.err
    assert done.err.endswith(" What was finished is kept.\n")
    assert done.err.count("\n") == 1
    assert len(file.load(path).shapes[0].frames) >= len(list(out.iterdir())) >= 2
    assert not list(out.glob(".*"))


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="the system has no device that is always full")
def test_a_full_disk_under_the_output_is_told(tmp_path: Path) -> None:
    path = tmp_path / "p.roam"
    file.save(Project(), path)
    with Path("/dev/full").open("w") as full:
        done = subprocess.run([*ROAM, "info", str(path)], stdout=full, stderr=subprocess.PIPE, check=False)
    assert done.returncode == 1
    assert done.stderr == b"roam: The standard output cannot be written: No space left on device.\n"


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="the system has no device that is always full")
@pytest.mark.parametrize("words", [["--version"], ["--help"], ["info", "--help"]])
@pytest.mark.parametrize("buffered", [True, False])
def test_help_that_does_not_arrive_is_told(words: list[str], buffered: bool) -> None:
    environment = os.environ | {"PYTHONUNBUFFERED": "" if buffered else "1"}
    entry = [sys.executable, "-c", "import sys; from roam_core.cli.program import main; sys.exit(main())"]
    for command in (ROAM, entry):
        with Path("/dev/full").open("w") as full:
            given = {"stdout": full, "stderr": subprocess.PIPE, "check": False, "env": environment}
            done = subprocess.run([*command, *words], **given)
        assert done.returncode == 1
        assert done.stderr == b"roam: The standard output cannot be written: No space left on device.\n"


@pytest.mark.parametrize(("system", "status"), [("win32", 141), ("linux", 1)])
@pytest.mark.parametrize("printing", [lambda: lines.print_text("frames"), lambda: print("frames")])
def test_a_reader_of_windows_that_went_away_is_told_nothing(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], system: str, status: int, printing: Any
) -> None:
    """A pipe that is closed refuses what is written with "invalid argument" there, as `roam info P | more` found."""

    class Closed(io.StringIO):
        def write(self, _text: str) -> int:
            raise OSError(errno.EINVAL, "Invalid argument")

    monkeypatch.setattr(sys, "platform", system)
    monkeypatch.setattr(sys, "stdout", Closed())
    monkeypatch.setattr(sys.modules["roam_core.cli.main"], "_run", lambda _: (printing(), 0)[1])
    assert main(["info"]) == status
    assert ("Invalid argument" in capsys.readouterr().err) is (status == 1)


# ---- frames that cannot be read --------------------------------------------------------------------------------------


def test_a_fill_goes_on_past_a_damaged_frame_and_is_not_done_again(roam: Roam, plate: Plate, keyed: Path) -> None:
    (plate.folder / "plate.1002.png").write_bytes(b"no picture")
    done = roam("fill", keyed, *CONFIG, "--json")
    assert done.status == 0
    assert done.err.count("\n") == done.err.count("plate.1002.png") == done.err.count("bridged") == 1
    ends = {line["frame"]: line["termination"] for line in map(json.loads, done.out.splitlines())}
    assert [frame for frame, end in ends.items() if end == "missing_frame"] == [1002]
    assert file.load(keyed).shapes[0].frames == (1001, 1003, 1004, 1005, 1006)
    assert roam("fill", keyed, *CONFIG).err == "Filled 0 gap(s); 2 already filled.\n"
    write_picture(plate.folder / "plate.1002.png", SHOT.read(1002))
    assert roam("fill", keyed, *CONFIG).err == "Filled 1 gap(s); 1 already filled.\n"


def test_a_gap_that_cannot_be_filled_does_not_lose_the_others(roam: Roam, plate: Plate, keyed: Path) -> None:
    for frame in (1001, 1004):
        (plate.folder / f"plate.{frame}.png").write_bytes(b"no picture")
    out = plate.folder.parent / "mattes"
    done = roam("fill", keyed, *CONFIG, "--matte", out)
    assert done.status == 1
    assert "The gap from frame 1001 to 1004 is not filled" in done.err
    assert done.err.endswith("Filled 1 gap(s).\n")
    assert file.load(keyed).shapes[0].frames == (1001, 1004, 1005, 1006)
    assert [path.name for path in sorted(out.iterdir())] == [f"plate.{frame}.png" for frame in (1001, 1004, 1005, 1006)]


@pytest.mark.parametrize("back_on", [1005, None])
def test_a_run_whose_plate_was_away_for_a_while_does_not_pass_for_done(
    roam: Roam, plate: Plate, monkeypatch: pytest.MonkeyPatch, back_on: int | None
) -> None:
    """A server that was out cost every frame meanwhile, and the run ended as if it had tracked them."""
    away, path = plate.folder.with_name("away"), plate.folder.parent / "p.roam"
    acts = {1003: lambda: plate.folder.rename(away), back_on: lambda: away.rename(plate.folder)}

    def watched(*arguments: Any, **options: Any) -> Iterator[FrameResult]:
        for result in track(*arguments, **options):
            yield result
            acts.get(result.frame, Path)()

    monkeypatch.setattr("roam_core.propagate.track", watched)
    monkeypatch.setattr("roam_core.cli.plate.AHEAD", 0)
    done = roam("track", plate.folder, "--init", plate.mask, *CONFIG, "--save", path)
    last, found = (1006, (1001, 1002, 1003)) if back_on is None else (1005, (1001, 1002, 1003, 1006))
    assert done.status == 1
    assert done.err.splitlines()[-1] == (
        f"roam: The plate {plate.folder} was away for a while, and {last - 1003} frames from 1004 to {last} had to be "
        "passed over; run it again when it is back. What was finished is kept."
    )
    assert file.load(path).shapes[0].frames == found


def test_the_last_frame_may_be_cut_short(roam: Roam, plate: Plate) -> None:
    last = plate.folder / "plate.1006.png"
    last.write_bytes(last.read_bytes()[:200])
    path, out = plate.folder.parent / "p.roam", plate.folder.parent / "mattes"
    done = roam("track", plate.folder, "--init", plate.mask, *CONFIG, "--save", path, "--matte", out)
    assert done.status == 0
    assert "plate.1006.png" in done.err
    assert file.load(path).shapes[0].frames == (1001, 1002, 1003, 1004, 1005)
    assert len(list(out.iterdir())) == len(SHOT.frames)
