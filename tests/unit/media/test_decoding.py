"""Decoding in other processes: they give what this one gives, and what ends them is told as a damaged file."""

from __future__ import annotations

import errno
import json
import os
import signal
import subprocess
import sys
import tempfile
import threading
import time
from collections.abc import Callable, Iterator
from pathlib import Path

import numpy as np
import psutil
import pytest

from roam_core.cli import program
from roam_core.cli.performing import perform_on_worker
from roam_core.errors import RoamError
from roam_core.matte import read_mask
from roam_core.media import DamagedFrame, MissingFrame, decoding, open_clip
from roam_core.media.area import Area
from roam_core.media.decoding import pool as pools
from roam_core.media.decoding import process as processes_of
from roam_core.media.decoding.answers import Garbled, NoRoom, packed, unpacked
from roam_core.media.decoding.pool import Pool
from roam_core.translatable import Sentence, sentence
from tests.conftest import ROOT
from tests.unit.media.conftest import picture, write_image, write_movie, write_parts

SENTENCE = r"cannot be decoded: .*It is damaged"
WAITED = 120.0
"""Seconds within which a process has to be gone."""


@pytest.fixture
def mortal(monkeypatch: pytest.MonkeyPatch) -> Iterator[Pool]:
    """Decoding by processes that go wrong for some files."""
    monkeypatch.setattr(processes_of, "WORKER", "tests.unit.media.mortal_decoder")
    pool = Pool()
    monkeypatch.setattr(decoding, "_pool", pool)
    yield pool
    pool.close()


def written(folder: Path, stem: str) -> Path:
    """A small picture."""
    return write_image(folder / f"{stem}.0001.png", picture(1), "uint8")


def is_alive(process_id: int) -> bool:
    """Whether a process runs."""
    try:
        return psutil.Process(process_id).status() != psutil.STATUS_ZOMBIE
    except psutil.NoSuchProcess:
        return False


# ---- the same values ------------------------------------------------------------------------------------------------


def test_layers_areas_and_masks_come_as_they_do_here(tmp_path: Path, apart: Callable[[], None]) -> None:
    parts = write_parts(tmp_path / "p.1001.exr", [("depth", "", ("Z",)), ("beauty", "", ("R", "G", "B", "A"))])
    mask = write_image(tmp_path / "mask.png", picture(3, 4), "uint16", oiio__UnassociatedAlpha=1)
    flat = write_image(tmp_path / "flat.exr", picture(4), "half")

    def all_read() -> list[object]:
        plate = open_clip(parts, "depth.Z")
        areas = open_clip(flat).areas(1)
        assert areas is not None
        arrays = (plate.read(1001), areas.read(Area(3, 9, 2, 11)), read_mask(mask))
        return [plate.layers, plate.layer, *((array.dtype, array.shape, array.tobytes()) for array in arrays)]

    here = all_read()
    apart()
    assert all_read() == here


def test_a_movie_in_any_order(tmp_path: Path, apart: Callable[[], None]) -> None:
    path = write_movie(tmp_path / "m.avi", "MJPG", 12)
    here = open_clip(path)
    apart()
    there = open_clip(path)
    for name in ("frames", "missing", "size", "fps", "pixel_aspect", "colour_space", "depth", "layer", "layers"):
        assert getattr(here, name) == getattr(there, name)
    for frame in (12, 1, 7, 6, 8):
        np.testing.assert_array_equal(there.read(frame), here.read(frame))
    assert there.frame_name(3) == here.frame_name(3)
    assert there.file_of(3) == here.file_of(3)
    with pytest.raises(MissingFrame, match="Frame 13"):
        there.read(13)


def test_refusals_are_word_for_word_the_same(tmp_path: Path, apart: Callable[[], None]) -> None:
    rubbish, cut = tmp_path / "rubbish.png", tmp_path / "b" / "cut.0001.png"
    rubbish.write_bytes(b"no picture")
    cut.parent.mkdir()
    cut.write_bytes(written(tmp_path / "whole", "p").read_bytes()[:200])

    def said(path: Path) -> tuple[type, str]:
        with pytest.raises(RoamError) as refused:
            open_clip(path).read(1)
        return type(refused.value), str(refused.value)

    here = [said(rubbish), said(cut)]
    apart()
    assert [said(rubbish), said(cut)] == here
    assert here[1][0] is DamagedFrame


def test_a_refusal_keeps_its_template_on_its_way(tmp_path: Path, apart: Callable[[], None]) -> None:
    """It came as English text alone, whatever language the window speaks."""
    rubbish = tmp_path / "rubbish.png"
    rubbish.write_bytes(b"no picture")
    apart()
    with pytest.raises(RoamError, match="no image that can be read") as refused:
        open_clip(rubbish).read(1)
    told = refused.value.args[0]
    assert isinstance(told, Sentence)
    assert told.template.startswith("{file} is no image")
    assert told.values["file"] == str(rubbish)


def test_sentences_pass_between_processes_and_what_is_none_is_refused() -> None:
    told = sentence(
        "{file} is {width:.1f} px: {why}.", file=Path("a"), width=2.5, why=sentence("too {much!r}", much="s")
    )
    again = unpacked(json.loads(json.dumps(packed(told))))
    assert again == told == "a is 2.5 px: too 's'."
    assert isinstance(again, Sentence)
    assert isinstance(again.values["why"], Sentence)
    assert unpacked("plain") == "plain"
    deep: object = "x"
    for _ in range(100):
        deep = ["{a}", {"a": deep}]
    for wrong in (
        7, None, ["{a}"], ["{b}", {"a": "x"}], ["{a.__class__}", {"a": "x"}], ["{a:999999999}", {"a": "x"}],
        ["{a:d}", {"a": "x"}], ["{", {}], ["{a:c}", {"a": 1 << 80}], ["{a}", {"a": [1]}], deep,
        ["{0}", {"0": "x"}], ["{a}" * 1000, {"a": "x" * 100000}],
    ):  # fmt: skip
        with pytest.raises(Garbled):
            unpacked(wrong)


def test_names_that_are_no_text(tmp_path: Path, apart: Callable[[], None]) -> None:
    path = Path(os.fsdecode(os.fsencode(tmp_path) + b"/\xff\xfe.1.png"))
    try:
        path.write_bytes(written(tmp_path, "p").read_bytes())
    except OSError:
        pytest.skip("this file system refuses names that are not UTF-8")
    apart()
    assert decoding.read_image(path).shape == (12, 16, 3)


def test_the_configuration_of_colours_is_that_of_the_moment(
    tmp_path: Path, apart: Callable[[], None], monkeypatch: pytest.MonkeyPatch
) -> None:
    path = write_image(tmp_path / "p.1.exr", picture(1), "half", oiio__ColorSpace="lin_ap1_scene")
    apart()
    assert open_clip(path).colour_space == "ACEScg"
    monkeypatch.setenv("OCIO", str(tmp_path / "none.ocio"))
    assert open_clip(path).colour_space == "linear"


# ---- what goes wrong ------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("name", "why"),
    [
        ("crash", "SIGABRT"),
        ("leave", "exit code 3"),
        ("rubbish", "no line of JSON"),
        ("list", "no line of JSON"),
        ("flood", "ended unexpectedly"),
        ("huge", "an impossible picture"),
        ("objects", "an impossible picture"),
        ("short", "fewer pixels than were told"),
    ],
)
def test_what_ends_a_process_is_a_damaged_frame(tmp_path: Path, mortal: Pool, name: str, why: str) -> None:
    plate, good = open_clip(written(tmp_path / name, name)), open_clip(written(tmp_path / "good", "good"))
    with pytest.raises(DamagedFrame, match=SENTENCE) as refused:
        plate.read(1)
    assert why in str(refused.value)
    assert str(plate.file_of(1)) in str(refused.value)
    assert "\n" not in str(refused.value)
    assert good.read(1).shape == (12, 16, 3)


def test_who_takes_too_long_is_ended(tmp_path: Path, mortal: Pool, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(pools, "SECONDS", 0.3)
    plate = open_clip(written(tmp_path, "loop"))
    with pytest.raises(DamagedFrame, match=r"it takes longer than .* seconds. It is damaged"):
        plate.read(1)


def test_who_waits_too_long_is_ended(tmp_path: Path, mortal: Pool, monkeypatch: pytest.MonkeyPatch) -> None:
    plate = open_clip(written(tmp_path, "good"))
    (process_id,) = mortal.process_ids()
    os.kill(process_id, signal.SIGSTOP)  # as one does that waits for a server that is gone
    monkeypatch.setattr(processes_of, "PATIENCE", -19.5)
    with pytest.raises(DamagedFrame, match="it takes longer"):
        plate.read(1)


@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="the memory of a process is bounded on Linux")
def test_who_asks_for_too_much_memory_is_refused_it(tmp_path: Path, mortal: Pool) -> None:
    plate = open_clip(written(tmp_path, "greedy"))
    with pytest.raises(DamagedFrame, match="asks for too much memory"):
        plate.read(1)


def test_who_was_ended_by_somebody_else_is_asked_again(tmp_path: Path, mortal: Pool) -> None:
    assert decoding.read_image(written(tmp_path, "once")).shape == (2, 2, 3)
    plate = open_clip(written(tmp_path / "b", "good"))
    (process_id,) = mortal.process_ids()
    os.kill(process_id, signal.SIGKILL)
    assert plate.read(1).shape == (12, 16, 3)
    assert mortal.process_ids() != (process_id,)


def test_a_defect_is_told_as_one(tmp_path: Path, mortal: Pool) -> None:
    with pytest.raises(RuntimeError, match="a defect of ours"):
        open_clip(written(tmp_path, "defect")).read(1)
    assert len(mortal.process_ids()) == 1


@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="the size of files is bounded on Linux")
def test_where_there_is_no_room_for_pictures_no_frame_is_damaged(tmp_path: Path, apart: Callable[[], None]) -> None:
    path = write_image(tmp_path / "large.0001.png", np.zeros((200, 200, 3)), "uint8")
    script = (
        "import resource, sys; from roam_core.media import decoding, open_clip\n"
        "decoding.isolate(); resource.setrlimit(resource.RLIMIT_FSIZE, (4096, 4096))\n"
        "try:\n    open_clip(sys.argv[1]).read(1)\n"
        "except Exception as error:\n    print(type(error).__name__, error)\n"
    )
    done = subprocess.run([sys.executable, "-c", script, path], capture_output=True, text=True, check=True, cwd=ROOT)
    assert done.stdout.startswith("NoRoom There is no room for decoded pictures")


def test_without_files_in_memory_none_is_left_by_a_program_that_is_killed(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """On macOS each lay in the folder for temporary files until the system cleared it: as large as the largest picture.

    Both processes have it open: the name alone is given up.
    """
    path = written(tmp_path, "p")
    expected = open_clip(path).read(1)
    monkeypatch.delattr(os, "memfd_create", raising=False)
    (tmp_path / "temporary").mkdir()
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path / "temporary"))
    pool = Pool()
    monkeypatch.setattr(decoding, "_pool", pool)
    for _ in range(2):
        np.testing.assert_array_equal(open_clip(path).read(1), expected)
        assert os.name == "nt" or list((tmp_path / "temporary").iterdir()) == []
    pool.close()
    assert list((tmp_path / "temporary").iterdir()) == []


def test_where_no_shared_file_can_be_made_it_is_said(monkeypatch: pytest.MonkeyPatch) -> None:
    def refuse(*_: object, **__: object) -> int:
        raise OSError(errno.EMFILE, "Too many open files")

    monkeypatch.setattr(os, "memfd_create", refuse, raising=False)
    with pytest.raises(NoRoom, match=r"no room for decoded pictures in memory \(Too many open files\)"):
        processes_of.DecoderProcess()


def test_a_picture_that_is_missing_is_refused(tmp_path: Path, mortal: Pool) -> None:
    with pytest.raises(DamagedFrame, match="without a picture"):
        open_clip(written(tmp_path, "nothing")).read(1)


def test_a_movie_goes_on_after_its_process_was_ended(tmp_path: Path, apart: Callable[[], None]) -> None:
    path = write_movie(tmp_path / "m.avi", "MJPG", 6)
    expected = open_clip(path).read(5)
    apart()
    movie = open_clip(path)
    os.kill(movie._process[0].process_id, signal.SIGKILL)  # type: ignore[attr-defined]
    np.testing.assert_array_equal(movie.read(5), expected)


def test_processes_that_cannot_be_started_are_told(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = written(tmp_path, "p")
    pool = Pool()
    monkeypatch.setattr(decoding, "_pool", pool)
    monkeypatch.setattr(processes_of, "WORKER", "roam_core.no_such_module")
    with pytest.raises(RoamError, match=r"cannot be started .*ROAM_DECODER=inside"):
        open_clip(path)
    monkeypatch.setattr(sys, "executable", str(tmp_path / "nothing"))
    with pytest.raises(RoamError, match="cannot be started"):
        open_clip(path)
    assert pool.process_ids() == ()


# ---- processes: how many, and how they end ---------------------------------------------------------------------------


def test_pictures_are_decoded_side_by_side_by_three_at_most(tmp_path: Path, apart: Callable[[], None]) -> None:
    pool = Pool()
    gate = threading.Barrier(pools.MOST_PROCESSES)
    lent = [pool._lend() for _ in range(pools.MOST_PROCESSES)]
    waiting = threading.Thread(target=lambda: pool._give_back(pool._lend()))
    waiting.start()
    assert len({process.process_id for process in lent}) == gate.parties
    assert waiting.is_alive()
    for process in lent:
        pool._give_back(process)
    waiting.join(WAITED)
    assert not waiting.is_alive()
    assert len(pool.process_ids()) == pools.MOST_PROCESSES
    pool.close()


def test_processes_that_do_not_answer_keep_no_other_file_waiting(
    monkeypatch: pytest.MonkeyPatch, apart: Callable[[], None]
) -> None:
    pool = Pool()
    lent = [pool._lend() for _ in range(pools.MOST_PROCESSES)]
    monkeypatch.setattr(pools, "LATE_SECONDS", 0.0)
    further = [pool._lend()]
    asking = threading.Thread(target=lambda: further.append(pool._lend()), daemon=True)
    asking.start()
    asking.join(WAITED)
    assert len({process.process_id for process in (*lent, *further)}) == pools.MOST_PROCESSES + 2
    further.pop().close()
    monkeypatch.undo()
    for process in (*lent, *further):
        pool._give_back(process)
    assert len(pool.process_ids()) <= pools.MOST_PROCESSES
    pool.close()


def test_processes_end_with_the_program_however_it_ends(tmp_path: Path) -> None:
    program_text = (
        "import sys, time\n"
        "from pathlib import Path\n"
        "from roam_core.media import decoding\n"
        "decoding.isolate()\n"
        "decoding.read_header(Path(sys.argv[1]))\n"
        "print(*decoding._pool.process_ids(), flush=True)\n"
        "time.sleep(600)\n"
    )
    command = [sys.executable, "-c", program_text, str(written(tmp_path, "p"))]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as running:
        assert running.stdout is not None
        process_id = int(running.stdout.readline())
        assert is_alive(process_id)
        assert os.getsid(process_id) != os.getsid(running.pid)  # a key press in the terminal does not reach it
        running.kill()
    until = time.monotonic() + WAITED
    while is_alive(process_id) and time.monotonic() < until:
        time.sleep(0.05)
    assert not is_alive(process_id)


def test_a_forked_process_starts_its_own(tmp_path: Path, apart: Callable[[], None], processes: Pool) -> None:
    path = written(tmp_path, "p")
    apart()
    decoding.read_header(path)
    assert processes.process_ids()
    processes._forget()
    assert processes.process_ids() == ()
    assert decoding.read_image(path).shape == (12, 16, 3)
    for process in processes._parents:
        process.close()


@pytest.mark.skipif(os.name == "nt", reason="a script stands in for the program of a bundle")
def test_the_program_of_a_bundle_starts_itself(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = written(tmp_path, "p")
    bundled = tmp_path / "roam"
    bundled.write_text(f'#!/bin/sh\nexec "{sys.executable}" "{ROOT / "bundle" / "entry.py"}" "$@"\n')
    bundled.chmod(0o755)
    pool = Pool()
    monkeypatch.setattr(decoding, "_pool", pool)
    monkeypatch.setattr(sys, "executable", str(bundled))
    assert decoding.read_image(path).shape == (12, 16, 3)
    pool.close()


# ---- who decodes so --------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(("said", "isolated"), [(None, True), ("inside", False)])
def test_the_program_decodes_apart_unless_it_is_told_otherwise(
    monkeypatch: pytest.MonkeyPatch, said: str | None, isolated: bool
) -> None:
    if said:
        monkeypatch.setenv("ROAM_DECODER", said)
    seen: list[bool] = []
    monkeypatch.setattr(program, "command_line", lambda _: seen.append(decoding.is_isolated()) or 0)
    assert program.main(["info", "p.roam"]) == 0
    assert seen == [isolated]
    assert not decoding.is_isolated()


def test_so_does_a_worker_of_a_batch(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    seen: list[bool] = []
    monkeypatch.setattr("roam_core.cli.performing.perform", lambda *_: seen.append(decoding.is_isolated()) or {})
    perform_on_worker("batch", {}, "")
    decoding.trust()
    assert seen == [True]


def test_the_library_decodes_in_its_own_process(tmp_path: Path) -> None:
    assert not decoding.is_isolated()
    assert decoding.read_image(written(tmp_path, "p")).shape == (12, 16, 3)
