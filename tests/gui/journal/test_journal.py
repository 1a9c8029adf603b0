"""The journal: every edit is on the disk, a crash is found whatever it left, and reading changes nothing."""

from __future__ import annotations

import errno
import os
import random
import re
import shutil
import zlib
from collections.abc import Iterator
from contextlib import suppress
from dataclasses import replace
from pathlib import Path
from typing import IO

import numpy as np
import pytest
from pytestqt.qtbot import QtBot

from app.journal import recovery, writer
from app.journal.journal import Journal
from app.journal.record import Damaged, Entry, append, encoded, entries
from app.journal.recovery import KEPT_SESSIONS, Recovery
from app.journal.session import KEPT_SAVED, Session
from app.journal.writer import BASES
from app.model.document import Document
from roam_core.errors import RoamError
from roam_core.geometry.bezier import polygon_points
from roam_core.roto import Clip, Keyframe, Origin, Project, backups, edit, file, timing
from roam_core.roto.following import followed, with_moving_layer
from tests.gui.journal.test_delta import random_edit
from tests.gui.waiting import WAIT
from tests.unit.roto.faults import refusing

SQUARE = polygon_points([(0, 0), (10, 0), (10, 10), (0, 10)])


@pytest.fixture
def root(tmp_path: Path) -> Path:
    return tmp_path / "journal"


@pytest.fixture
def journal(document: Document, root: Path) -> Iterator[Journal]:
    journal = Journal(document, root)
    yield journal
    journal.close()


def draw(document: Document) -> None:
    document.apply("Draw", edit.new_shape(document.project, SQUARE, 1)[0])


def crashed(journal: Journal, root: Path) -> list[Recovery]:
    """What would be found if the program ended here: the lock is let go as by a process that is killed."""
    assert journal.flush()
    journal._session.let_go()
    found = recovery.recoveries(root)
    journal._session.hold()
    return found


def test_every_edit_of_an_untitled_project_comes_back(document: Document, journal: Journal, root: Path) -> None:
    for number in range(1, 6):
        draw(document)
        (found,) = crashed(journal, root)
        assert (found.edits, found.original, found.settled) == (number, None, "")
        assert recovery.load(found) == (document.project, "")
    assert recovery.offered([found]) == [found]


def test_undo_and_redo_come_back_and_nothing_is_offered_where_nothing_is_left(
    document: Document, journal: Journal, root: Path
) -> None:
    draw(document)
    draw(document)
    document.undo_stack.undo()
    (found,) = crashed(journal, root)
    assert recovery.load(found)[0] == document.project
    document.undo_stack.undo()
    assert recovery.offered(crashed(journal, root)) == []
    document.undo_stack.redo()
    assert len(recovery.offered(crashed(journal, root))) == 1


def test_edits_build_on_the_artists_file_which_stays_as_it_is(
    document: Document, journal: Journal, root: Path, tmp_path: Path
) -> None:
    mine = tmp_path / "mine.roam"
    document.apply("Clip", replace(document.project, clip=Clip(tmp_path / "plate", 1, 9, (20, 10))))
    draw(document)
    document.save(mine)
    before = mine.read_bytes()
    draw(document)
    draw(document)
    found = recovery.offered(crashed(journal, root))
    assert [(each.original, each.edits, each.shapes) for each in found] == [(mine, 2, 2)]
    assert found[0].sentence == "2 edits in 2 shapes since the last save"
    assert mine.read_bytes() == before
    assert recovery.load(found[0]) == (document.project, "")
    journal._writer._open._copying.join()
    assert journal.flush()
    mine.write_text("another program was here", encoding="utf-8")
    assert recovery.load(found[0]) == (document.project, "")
    mine.unlink()
    assert recovery.load(found[0]) == (document.project, "")


def test_without_its_base_a_journal_is_refused_in_a_sentence(
    document: Document, journal: Journal, root: Path, tmp_path: Path
) -> None:
    document.save(tmp_path / "mine.roam")
    draw(document)
    (found,) = crashed(journal, root)
    journal._writer._open._copying.join()
    for base in root.glob("*/*.roam"):
        base.write_text("{", encoding="utf-8")
    assert recovery.load(found) == (document.project, "")
    (tmp_path / "mine.roam").write_text("{", encoding="utf-8")
    with pytest.raises(RoamError, match=r"builds on mine\.roam"):
        recovery.load(found)


def test_a_save_on_the_way_leaves_what_a_journal_builds_on_among_the_backups(
    document: Document, journal: Journal, root: Path, tmp_path: Path
) -> None:
    mine = tmp_path / "mine.roam"
    document.save(mine)
    draw(document)
    (found,) = crashed(journal, root)
    journal._writer._open._copying.join()
    for base in root.glob("*/*.roam"):
        base.unlink()
    backups.rotate(mine, 2)
    file.save(Project(), mine)
    assert recovery.load(found) == (document.project, "")


def test_saving_and_closing_in_good_order_leave_nothing_to_offer(
    document: Document, journal: Journal, root: Path, tmp_path: Path
) -> None:
    draw(document)
    document.save(tmp_path / "mine.roam")
    assert recovery.offered(crashed(journal, root)) == []
    draw(document)
    document.open(Project(), None)  # what was there was thrown away
    assert [each.settled for each in crashed(journal, root)] == ["discarded", "saved"]


def test_a_file_that_cannot_be_looked_at_settles_nothing(
    document: Document, journal: Journal, root: Path, tmp_path: Path
) -> None:
    """Such as one on a share that is away: what cannot be found there is offered still."""
    draw(document)
    journal.note_saving(tmp_path / f"{'a' * 300}.roam")
    assert len(recovery.offered(crashed(journal, root))) == 1


def test_a_journal_takes_no_number_that_is_taken(root: Path) -> None:
    """One before it may have been deleted meanwhile."""
    session = Session(root)
    paths = []
    for _ in range(2):
        paths.append(session.new_path())
        paths[-1].touch()
    paths[0].unlink()
    assert not session.new_path().exists()
    session.let_go()


def test_what_the_file_holds_already_is_not_offered_though_the_journal_did_not_end(
    document: Document, journal: Journal, root: Path, tmp_path: Path
) -> None:
    (tmp_path / "plate").mkdir()
    mine = tmp_path / "mine.roam"
    document.apply("Clip", replace(document.project, clip=Clip(tmp_path / "plate", 1, 9, (20, 10))))
    document.save(mine)
    draw(document)
    file.save(document.project, mine)  # and the program is killed before it knows
    assert recovery.offered(crashed(journal, root)) == []
    file.save(Project(), mine)  # the artist goes on: what was found out once holds
    assert [each.settled for each in crashed(journal, root)] == ["saved", "saved"]


@pytest.mark.parametrize("is_titled", [False, True])
def test_what_a_save_under_another_name_wrote_is_not_offered_though_the_journal_did_not_end(
    document: Document, journal: Journal, root: Path, tmp_path: Path, is_titled: bool
) -> None:
    (tmp_path / "plate").mkdir()
    other = tmp_path / "other ü.roam"
    document.apply("Clip", replace(document.project, clip=Clip(tmp_path / "plate", 1, 9, (20, 10))))
    if is_titled:
        document.save(tmp_path / "mine.roam")
    draw(document)
    journal.note_saving(other)
    (found,) = recovery.offered(crashed(journal, root))  # killed before the file is in its place
    assert recovery.load(found)[0] == document.project
    file.save(document.project, other)  # and now, before the program knows
    assert recovery.offered(crashed(journal, root)) == []


def test_edits_after_what_a_killed_save_under_another_name_wrote_are_offered(
    document: Document, journal: Journal, root: Path, tmp_path: Path
) -> None:
    draw(document)
    journal.note_saving(tmp_path / "mine.roam")
    file.save(document.project, tmp_path / "mine.roam")
    draw(document)
    (found,) = recovery.offered(crashed(journal, root))
    assert recovery.load(found)[0] == document.project


def test_edits_after_what_a_killed_save_wrote_are_offered(
    document: Document, journal: Journal, root: Path, tmp_path: Path
) -> None:
    document.save(tmp_path / "mine.roam")
    draw(document)
    file.save(document.project, tmp_path / "mine.roam")
    draw(document)
    (found,) = recovery.offered(crashed(journal, root))
    assert recovery.load(found) == (document.project, "")


def test_edits_made_while_a_save_was_under_way_are_in_the_next_journal(
    document: Document, journal: Journal, root: Path, tmp_path: Path
) -> None:
    draw(document)
    saved = document.project
    file.save(saved, tmp_path / "mine.roam")
    draw(document)
    document.mark_saved(saved, tmp_path / "mine.roam", writer.Fingerprint.of(tmp_path / "mine.roam"))
    (found,) = recovery.offered(crashed(journal, root))
    assert recovery.load(found)[0] == document.project


def test_until_they_are_in_the_next_journal_the_last_one_offers_edits_that_a_save_did_not_see(
    qtbot: QtBot, document: Document, journal: Journal, root: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The next journal cannot be made for a while: a kill meanwhile loses nothing that was said to be on the disk."""
    mine = tmp_path / "mine.roam"
    document.save(mine)
    draw(document)
    saved = document.project
    draw(document)
    assert journal.flush()
    with monkeypatch.context() as failing, qtbot.waitSignal(journal.refused, timeout=WAIT):
        failing.setattr(journal._session, "new_path", lambda: root / "nowhere" / "0002.journal")
        file.save(saved, mine)
        document.mark_saved(saved, mine, writer.Fingerprint.of(mine))
        assert not journal.flush()
    journal._session.let_go()
    assert [recovery.load(each)[0] for each in recovery.offered(recovery.recoveries(root))] == [document.project]
    journal._session.hold()
    draw(document)
    found = crashed(journal, root)
    assert [each.settled for each in found] == ["", "saved"]
    assert recovery.load(found[0])[0] == document.project


def test_an_open_session_is_no_crash(document: Document, journal: Journal, root: Path) -> None:
    draw(document)
    assert journal.flush()
    assert recovery.recoveries(root) == []


def test_a_crash_is_offered_though_that_cannot_be_remembered(
    qtbot: QtBot, document: Document, root: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Taken from a folder that cannot be written to, it is kept all the same, and nothing is told that went wrong."""
    crash(tmp_path / "before")
    monkeypatch.setattr(Path, "touch", refusing(errno.EROFS))
    (found,) = recovery.offered(recovery.recoveries(root, elsewhere=[tmp_path / "before", tmp_path / "nowhere"]))
    journal = Journal(document, root)
    told: list[str] = []
    journal.refused.connect(told.append)
    document.recover(recovery.load(found)[0], None, found.fingerprint, found.journal)
    assert journal.flush()
    qtbot.wait(0)
    assert told == []
    assert [recovery.load(each)[0] for each in crashed(journal, root)] == [document.project]
    journal.close()


@pytest.mark.parametrize("number", [errno.EINVAL, errno.ENOTSUP])
def test_a_disk_that_flushes_nothing_holds_the_journal_all_the_same(
    document: Document, journal: Journal, root: Path, monkeypatch: pytest.MonkeyPatch, number: int
) -> None:
    monkeypatch.setattr(os, "fsync", refusing(number))
    draw(document)
    (found,) = crashed(journal, root)
    assert recovery.load(found) == (document.project, "")


def test_work_that_nobody_could_be_asked_about_is_offered(document: Document, root: Path) -> None:
    journal = Journal(document, root)
    draw(document)
    journal.leave_for_recovery()
    journal.close()
    (found,) = recovery.offered(recovery.recoveries(root))
    assert recovery.load(found)[0] == document.project


def test_a_recovered_project_is_in_the_new_journal_before_the_old_one_is_settled(
    document: Document, root: Path
) -> None:
    first = Journal(document, root)
    draw(document)
    first.leave_for_recovery()
    first.close()
    (old,) = recovery.recoveries(root)
    other = Document()
    second = Journal(other, root)
    assert [each.settled for each in recovery.recoveries(root)] == [""]
    other.recover(recovery.load(old)[0], None, follows=old.journal)
    assert second.flush()
    assert [each.settled for each in recovery.recoveries(root)] == ["recovered"]
    (new,) = recovery.offered(crashed(second, root))
    assert recovery.load(new)[0] == document.project
    assert new.sentence == "Recovered work in 1 shape"
    draw(other)
    draw(other)
    (new,) = recovery.offered(crashed(second, root))
    assert re.fullmatch("Recovered work and [12] edits? in 3 shapes", new.sentence)  # two may share an entry
    second.close()


def crash(root: Path, edits: int = 1) -> Recovery:
    """A session that ended without closing."""
    document = Document()
    journal = Journal(document, root)
    for _ in range(edits):
        draw(document)
        assert journal.flush()  # edits that come faster than the disk takes them may share an entry
    journal.leave_for_recovery()
    journal.close()
    return recovery.recoveries(root)[0]


def test_every_crash_is_offered_and_a_damaged_one_hides_none(root: Path, qapp: object) -> None:
    first, second, third = (crash(root, edits) for edits in (1, 3, 2))
    content = bytearray(second.journal.read_bytes())
    content[-20] ^= 1
    second.journal.write_bytes(content)
    third.journal.write_bytes(b"no journal")
    found = recovery.offered(recovery.recoveries(root))
    assert [(each.journal, each.edits, each.is_damaged) for each in found] == [
        (second.journal, 2, True),
        (first.journal, 1, False),
    ]
    assert found[0].sentence == "2 edits in 2 shapes; what came after them is damaged"
    project, sentence = recovery.load(found[0])
    assert len(project.shapes) == 2
    assert "damaged" in sentence
    with pytest.raises(RoamError, match="nothing of it"):
        recovery.load(third)


def test_the_writer_outlives_any_error(
    qtbot: QtBot, document: Document, journal: Journal, root: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    with monkeypatch.context() as failing, qtbot.waitSignal(journal.refused, timeout=WAIT):
        failing.setattr(journal._writer, "_do", lambda _: 1 / 0)
        draw(document)
        while not journal._writer._is_refused:
            qtbot.wait(1)
    draw(document)
    (found,) = crashed(journal, root)
    assert recovery.load(found) == (document.project, "")


BEGIN = {"kind": "begin", "version": 1, "time": 1e9, "is_on_file": False, "original": None, "digest": None}
EDIT = {"kind": "edit", "time": 1e9, "is_modified": True, "edits": 1, "tracked": 0, "ids": [], "clip": None}


@pytest.mark.parametrize(
    "row",
    [
        [BEGIN | {"version": 99}],
        [BEGIN | {"time": 1e300}],
        [EDIT],
        [BEGIN, EDIT, EDIT | {"time": "soon"}],
        [BEGIN, EDIT, EDIT | {"ids": 7}],
        [BEGIN, EDIT, EDIT | {"edits": None}],
        [BEGIN, EDIT, {"kind": "end"}],
        [BEGIN, EDIT, {"kind": "base", "name": "../../x", "after": "y"}],
        [BEGIN, EDIT | {"tree": 3, "dropped": {}}],
        [BEGIN, EDIT | {"tree": ["nobody"], "dropped": {}}],
    ],
)
def test_entries_that_make_no_sense_end_in_a_sentence(root: Path, row: list[dict[str, object]]) -> None:
    (root / "20260101-000000-1-1").mkdir(parents=True)
    text = file.dumps(Project(), Path("/"))
    content = b"".join(encoded(Entry(header, text if header["kind"] == "edit" else "")) for header in row)
    (root / "20260101-000000-1-1" / "0001.journal").write_bytes(content)
    for found in recovery.recoveries(root):
        assert found.day
        assert found.sentence
        with suppress(RoamError):
            assert recovery.load(found)[0] == Project()


def test_a_header_nested_without_end_is_damage(tmp_path: Path) -> None:
    payload = b"[" * 200_000 + b"\n"
    (tmp_path / "x.journal").write_bytes(b"%d %08x\n%b\n" % (len(payload), zlib.crc32(payload), payload))
    with pytest.raises(Damaged):
        list(entries(tmp_path / "x.journal"))


def test_declining_is_remembered_and_drops_nothing(root: Path, qapp: object) -> None:
    found = crash(root)
    before = found.journal.read_bytes()
    recovery.decline(found)
    (again,) = recovery.recoveries(root)
    assert recovery.offered([again]) == []
    assert again.settled == "declined"
    assert again.journal.read_bytes() == before
    assert len(recovery.load(again)[0].shapes) == 1


def test_of_a_day_of_saves_the_newest_journals_stay_and_all_that_nobody_saved(
    document: Document, journal: Journal, root: Path, tmp_path: Path
) -> None:
    """Each save began another journal with a copy of the project: a day of them filled the disk."""
    draw(document)
    lost = document.project
    document.open(Project(), None)  # the drawing is thrown away
    for _ in range(KEPT_SAVED + 5):
        draw(document)
        document.save(tmp_path / "mine.roam")
    draw(document)
    found = crashed(journal, root)
    assert [each.settled for each in found] == ["", *["saved"] * KEPT_SAVED, "discarded"]
    assert [each.journal.name for each in found] == sorted((each.journal.name for each in found), reverse=True)
    assert recovery.load(found[0]) == (document.project, "")
    assert recovery.load(found[-1]) == (lost, "")
    folder = found[0].journal.parent
    beside = {path.stem.partition("-")[0] for path in folder.glob("*.roam")}
    assert beside <= {each.journal.stem for each in found}
    assert len(beside) == KEPT_SAVED + 1


def test_settled_sessions_are_pruned_by_count_and_others_never(document: Document, root: Path, tmp_path: Path) -> None:
    lost, declined = crash(root), crash(root)
    recovery.decline(declined)
    for number in range(KEPT_SESSIONS + 3):
        journal = Journal(document, root)
        draw(document)
        document.save(tmp_path / f"{number}.roam")
        journal.close()
    (root / "20000101-000000-1-1").mkdir()  # killed before the first edit, long ago and just now
    os.utime(root / "20000101-000000-1-1", (0, 0))
    (root / "20990101-000000-1-1").mkdir()
    recovery.prune(root)
    assert [path.name[:4] for path in sorted(root.iterdir()) if not list(path.glob("*.journal"))] == ["2099"]
    folders = {path.parent for path in root.glob("*/*.journal")}
    assert {lost.journal.parent, declined.journal.parent} <= folders
    assert len(folders) == KEPT_SESSIONS + 2


def test_a_folder_that_cannot_be_made_is_told_and_tried_again(qtbot: QtBot, document: Document, tmp_path: Path) -> None:
    root = tmp_path / "taken"
    root.touch()
    journal = Journal(document, root)
    with qtbot.waitSignal(journal.refused, timeout=WAIT):
        draw(document)
    root.unlink()
    draw(document)
    (found,) = crashed(journal, root)
    assert recovery.load(found) == (document.project, "")
    journal.close()


@pytest.mark.parametrize("failing", range(1, 9))
def test_a_write_that_fails_half_way_costs_nothing_once_it_succeeds(
    document: Document, journal: Journal, root: Path, monkeypatch: pytest.MonkeyPatch, failing: int
) -> None:
    calls = 0

    def half(stream: IO[bytes], entry: Entry) -> int:
        nonlocal calls
        calls += 1
        if calls == failing:
            stream.write(encoded(entry)[: 7 * failing])
            raise OSError(5, "Input/output error")
        return append(stream, entry)

    monkeypatch.setattr(writer, "append", half)
    for number in range(6):
        draw(document)
        if number == 3:
            document.open(document.project, None)  # another journal
        journal.flush()
    found = recovery.offered(crashed(journal, root))[0]  # one whose end could not be told is offered, too
    assert calls > failing
    assert recovery.load(found)[0].shapes[-2:] == document.project.shapes[-2:]
    assert not found.is_damaged


@pytest.mark.parametrize("seed", range(3))
def test_after_any_row_of_edits_undos_saves_and_openings_the_journal_holds_what_is_shown(
    document: Document, journal: Journal, root: Path, tmp_path: Path, seed: int
) -> None:
    choose = random.Random(seed)
    document.open(Project(Clip(Path("/plate"), 1, 50, (200, 100))), None)
    document.undo_bytes = 1 << 16
    doing = (
        *(lambda: document.apply("Edit", random_edit(document.project, choose)),) * 12,
        *(document.undo_stack.undo,) * 4,
        *(document.undo_stack.redo,) * 2,
        lambda: document.amend("Run", lambda project: timing.set_mark(project, choose.randrange(99)), "run"),
        lambda: document.save(tmp_path / f"{choose.randrange(3)}.roam"),
        lambda: document.recover(document.project, document.path),
    )
    for step in range(200):
        choose.choice(doing)()
        if step % 10 == 0:
            found = recovery.offered(crashed(journal, root))
            assert len(found) == document.is_modified
            if found:
                assert recovery.load(found[0]) == (document.project, "")


def test_a_long_row_of_edits_gets_whole_projects_in_between(
    document: Document, journal: Journal, root: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(writer, "MOST_DELTAS", 2000)
    for _ in range(12):
        draw(document)
        assert journal.flush()
        if journal._writer._open._copying is not None:
            journal._writer._open._copying.join()
    (found,) = crashed(journal, root)
    bases = sorted(root.glob("*/*.roam"))
    assert len(bases) == BASES  # older ones are gone
    assert recovery.load(found) == (document.project, "")
    assert 1 < len(file.load(bases[0]).shapes) < len(file.load(bases[1]).shapes)
    for base in reversed(bases):  # the one before serves as well; with neither there is no way
        assert recovery.load(found) == (document.project, "")
        base.write_text("{", encoding="utf-8")
    assert recovery.load(found) == (document.project, "")  # from the beginning: no file lay under it


def test_tracked_frames_are_counted_apart(document: Document, journal: Journal, root: Path) -> None:
    draw(document)
    assert journal.flush()
    (shape,) = document.project.shapes
    for frame in (2, 3, 4):
        key = Keyframe(frame, SQUARE, origin=Origin.ENGINE, confidence=0.5)
        document.amend(
            "Track", lambda p, key=key: p.with_shape(edit.set_engine_keys(p.shape(shape.id), [key])), "run-1"
        )
        assert journal.flush()
    (found,) = crashed(journal, root)
    assert found.sentence == "1 edit and 3 tracked frames in 1 shape"
    assert recovery.load(found)[0] == document.project


def test_frames_of_a_planar_track_are_counted_apart(document: Document, journal: Journal, root: Path) -> None:
    draw(document)
    project, layer_id = with_moving_layer(document.project, [document.project.shapes[0].id], 1)
    document.apply("Planar track", project)
    assert journal.flush()
    motion = np.array([[1.0, 0.0, 2.0], [0.0, 1.0, 1.0], [0.0, 0.0, 1.0]])
    for frame in range(1, 5):
        document.amend("Planar track", lambda p, f=frame: followed(p, layer_id, 1, f, motion, 0.9), "run-1")
        assert journal.flush()
    (found,) = crashed(journal, root)
    assert found.sentence.startswith("2 edits and 4 tracked frames in 2 shapes")
    assert recovery.load(found)[0] == document.project


def test_a_fill_is_one_edit_of_many_frames(document: Document, journal: Journal, root: Path) -> None:
    draw(document)
    assert journal.flush()
    (shape,) = document.project.shapes
    keys = [Keyframe(frame, SQUARE, origin=Origin.ENGINE, confidence=0.5) for frame in range(2, 9)]
    document.apply("Fill", document.project.with_shape(edit.set_engine_keys(shape, keys)))
    assert journal.flush()
    (found,) = crashed(journal, root)
    assert found.sentence == "1 edit and 7 tracked frames in 1 shape"


def test_a_full_disk_is_told_once_and_nothing_is_lost_when_there_is_room_again(
    qtbot: QtBot, document: Document, journal: Journal, root: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    draw(document)
    assert journal.flush()

    def refuse(*_: object) -> None:
        raise OSError(28, "No space left on device")

    told: list[str] = []
    journal.refused.connect(told.append)
    journal.restored.connect(told.append)
    with monkeypatch.context() as full:
        full.setattr(os, "fsync", refuse)
        with qtbot.waitSignal(journal.refused, timeout=WAIT):
            draw(document)
        draw(document)
        assert not journal.flush()
    with qtbot.waitSignal(journal.restored, timeout=WAIT):
        draw(document)
    assert journal.flush()
    assert told == [
        "Your edits cannot be written to the journal (No space left on device); save the project yourself.",
        "The journal is written again; it holds all your edits.",
    ]
    (found,) = crashed(journal, root)
    assert recovery.load(found) == (document.project, "")
    assert found.edits == 4


def test_a_disk_that_is_full_still_after_a_save_is_told_again(
    qtbot: QtBot, document: Document, journal: Journal, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The sentence of the save took the place of the first one, and edits went on unkept without a word."""

    def refuse(*_: object) -> None:
        raise OSError(28, "No space left on device")

    with monkeypatch.context() as full:
        full.setattr(os, "fsync", refuse)
        with qtbot.waitSignal(journal.refused, timeout=WAIT):
            draw(document)
        document.mark_saved(document.project, Path("elsewhere.roam"))
        with qtbot.waitSignal(journal.refused, timeout=WAIT):
            draw(document)
    with qtbot.waitSignal(journal.restored, timeout=WAIT):
        draw(document)


class Share:
    """A file on a share that tells as it is closed that the disk failed."""

    def __init__(self, stream: IO[bytes]) -> None:
        self._stream = stream

    def __getattr__(self, name: str) -> object:
        return getattr(self._stream, name)

    def close(self) -> None:
        self._stream.close()
        raise OSError(errno.EIO, os.strerror(errno.EIO))


def test_a_share_that_fails_as_a_journal_is_closed_ends_no_other(
    document: Document, journal: Journal, root: Path, tmp_path: Path
) -> None:
    """Every edit after that save was refused until the window was closed."""
    draw(document)
    assert journal.flush()
    held = journal._writer._open
    assert held is not None
    held._stream = Share(held._stream)  # type: ignore[assignment]
    file.save(document.project, tmp_path / "a.roam")
    document.mark_saved(document.project, tmp_path / "a.roam")
    draw(document)
    assert journal.flush()
    (found,) = recovery.offered(crashed(journal, root))
    assert recovery.load(found) == (document.project, "")


@pytest.mark.parametrize("is_saved", [False, True])
def test_where_half_a_write_cannot_be_taken_back_another_file_begins_and_is_offered_alone(
    qtbot: QtBot,
    document: Document,
    journal: Journal,
    root: Path,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    is_saved: bool,
) -> None:
    draw(document)
    assert journal.flush()
    opened = journal._writer._open
    assert opened is not None

    def refuse(*_: object) -> None:
        raise OSError(5, "Input/output error")

    with monkeypatch.context() as failing:
        failing.setattr(writer, "append", refuse)
        failing.setattr(opened, "_length", -1)  # no file can be cut there
        with qtbot.waitSignal(journal.refused, timeout=WAIT):
            draw(document)
        if is_saved:
            document.save(tmp_path / "a.roam")
            journal.flush()
            assert recovery.offered(recovery.recoveries(root)) == []
    with qtbot.waitSignal(journal.restored, timeout=WAIT):
        draw(document)
    (found,) = recovery.offered(crashed(journal, root))
    assert recovery.load(found) == (document.project, "")


@pytest.mark.skipif(os.name != "posix", reason="a file that is open cannot be deleted here")
@pytest.mark.parametrize("is_saved", [False, True])
def test_a_journal_that_is_deleted_is_begun_again(
    qtbot: QtBot, document: Document, journal: Journal, root: Path, tmp_path: Path, is_saved: bool
) -> None:
    """What tidies temporary folders up took it away, and edits went on into nothing."""
    if is_saved:
        draw(document)
        document.save(tmp_path / "a.roam")
    draw(document)
    assert journal.flush()
    shutil.rmtree(root)
    with qtbot.waitSignal(journal.restored, timeout=WAIT):
        draw(document)
    (found,) = recovery.offered(crashed(journal, root))
    assert recovery.load(found) == (document.project, "")
