"""An edit's clips become jobs, with handles and transitions, and their mattes go back above them."""

from __future__ import annotations

from pathlib import Path
from typing import Any
from urllib.parse import quote

import pytest

from roam_core.cli import main
from roam_core.cli.performing import perform
from roam_core.errors import RoamError
from roam_core.studio.edits import _without_scheme, read_edit
from roam_core.studio.finding import jobs_from
from roam_core.studio.tasks import tasks_of
from tests.unit.studio.shots import put_mask, put_plate

otio = pytest.importorskip("opentimelineio", reason="OpenTimelineIO is not installed (pip install 'roam-roto[studio]')")
RATE = 24.0


def time(frames: float) -> Any:
    return otio.opentime.RationalTime(frames, RATE)


def span(first: float, length: float) -> Any:
    return otio.opentime.TimeRange(time(first), time(length))


def clip(name: str, plate: Path, first: int, length: int, **reference: Any) -> Any:
    """A clip of the shot's plate, whose media begin at 1001 and are six frames long."""
    media = otio.schema.ImageSequenceReference(
        target_url_base=plate.as_uri(), name_prefix="plate.", name_suffix=".png", start_frame=1001, rate=RATE,
        frame_zero_padding=4, available_range=span(1001, 6), **reference,
    )  # fmt: skip
    return otio.schema.Clip(name=name, media_reference=media, source_range=span(first, length))


@pytest.fixture
def edit(tmp_path: Path) -> Path:
    """An edit of three clips, two of which have masks; the second one is dissolved into."""
    plate = put_plate(tmp_path / "plate")
    (tmp_path / "inits").mkdir()
    for name in ("sh010", "sh_020"):
        put_mask(tmp_path / "inits" / f"{name}.png")
    track = otio.schema.Track(name="V1", kind=otio.schema.TrackKind.Video)
    track.append(clip("sh010", plate, 1002, 2))
    track.append(clip("titles", plate, 1001, 3))
    track.append(otio.schema.Transition(in_offset=time(1), out_offset=time(0)))
    track.append(clip("sh/020", plate, 1004, 2))
    timeline = otio.schema.Timeline(name="edit")
    timeline.tracks.append(track)
    path = tmp_path / "edit.otio"
    path.write_text(otio.core.serialize_json_to_string(timeline))
    return path


def ranges(path: Path, handles: int, **options: Any) -> dict[str, tuple[int, int]]:
    jobs = jobs_from(path, handles=handles, inits=path.parent / "inits", **options).jobs.jobs
    return {job.name: (job.steps[0].options["start"], job.steps[0].options["end"]) for job in jobs}


def test_clips_with_an_init_become_jobs_of_the_frames_that_the_edit_shows(edit: Path) -> None:
    assert ranges(edit, 0) == {"sh010": (1002, 1003), "sh_020": (1003, 1005)}
    assert ranges(edit, 1) == {"sh010": (1001, 1004), "sh_020": (1002, 1006)}
    assert ranges(edit, 50) == {"sh010": (1001, 1006), "sh_020": (1001, 1006)}


@pytest.mark.parametrize("step", [1, 2])
@pytest.mark.parametrize(("counted", "ranged"), [(24, 48), (48, 24), (48, 48), (120, 24), (24, None)])
def test_the_frames_of_a_sequence_go_on_by_its_own_rate(
    edit: Path, counted: int, ranged: int | None, step: int
) -> None:
    """The library says which frame is shown; a clip whose times count 48 a second got twice the frames of the plate."""

    def times(first: float, last: float, rate: float) -> Any:
        return otio.opentime.TimeRange(
            otio.opentime.RationalTime(first / RATE * rate, rate), otio.opentime.RationalTime(last / RATE * rate, rate)
        )

    timeline = read_edit(edit)
    shot = timeline.video_tracks()[0][0]
    media = shot.media_reference
    media.frame_step = step
    media.available_range = None if ranged is None else times(1001, 6, ranged)
    shot.source_range = times(1002, 2, counted)
    edit.write_text(otio.core.serialize_json_to_string(timeline))
    media.available_range = media.available_range or times(1001, 6, RATE)
    begin, end = shot.source_range.start_time, shot.source_range.end_time_inclusive()
    told = media.frame_for_time(begin), media.frame_for_time(end)
    assert told == (1002, 1003)
    assert ranges(edit, 0)["sh010"] == told


@pytest.mark.parametrize("step", [0, 1, 2])
def test_mattes_show_at_the_times_of_their_pictures_whatever_the_rates(edit: Path, tmp_path: Path, step: int) -> None:
    timeline = read_edit(edit)
    shot = timeline.video_tracks()[0][0]
    media, half = shot.media_reference, 2 * RATE
    media.frame_step = step
    media.available_range = otio.opentime.TimeRange(
        otio.opentime.RationalTime(100, half), otio.opentime.RationalTime(12, half)
    )
    shot.source_range = otio.opentime.TimeRange(
        otio.opentime.RationalTime(104, half), otio.opentime.RationalTime(4, half)
    )
    edit.write_text(otio.core.serialize_json_to_string(timeline))
    found = jobs_from(edit, handles=1, inits=tmp_path / "inits", out=tmp_path / "out")
    folder = tmp_path / "out" / "sh010" / "mattes"
    folder.mkdir(parents=True)
    for frame in range(1002, 1006):
        put_mask(folder / f"plate.{frame}.png")
    found.write_timeline(tmp_path / "with.otio")
    mattes = read_edit(tmp_path / "with.otio").video_tracks()[1][0]
    made, time = mattes.media_reference, mattes.trimmed_range().start_time
    assert media.frame_for_time(time) == made.frame_for_time(time) == 1003
    number = (1003 - made.start_frame) // made.frame_step
    assert made.target_url_for_image_number(number).endswith("plate.1003.png")
    assert made.presentation_time_for_image_number(number) == time
    assert made.available_range.start_time <= time
    assert made.available_range.end_time_exclusive() >= mattes.trimmed_range().end_time_exclusive()


def test_the_edit_comes_back_with_a_track_of_mattes(edit: Path, tmp_path: Path) -> None:
    found = jobs_from(edit, handles=1, inits=tmp_path / "inits", out=tmp_path / "out")
    line = tasks_of(found.jobs)[0]
    line[0] = type(line[0])(**{**line[0].plain(), "words": (*line[0].words, "--config", "baseline")})
    assert [perform("b", task.plain())["status"] for task in line] == ["done", "done"]
    found.write_timeline(tmp_path / "with.otio")
    made = read_edit(tmp_path / "with.otio")
    plain, mattes = made.video_tracks()
    assert [type(item).__name__ for item in mattes] == ["Clip", "Gap", "Gap"]
    assert [item.duration().value for item in mattes] == [2, 3, 2]
    media = mattes[0].media_reference
    shown = mattes[0].trimmed_range().start_time
    place = otio.url_utils.filepath_from_url(media.target_url_for_image_number(media.frame_for_time(shown) - 1001))
    assert Path(place) == tmp_path / "out" / "sh010" / "mattes" / "plate.1002.png"
    assert Path(place).exists()
    assert media.available_range == span(1001, 4)
    assert plain.is_equivalent_to(read_edit(edit).video_tracks()[0])


def test_what_is_no_edit_or_has_no_init_is_told(edit: Path, tmp_path: Path) -> None:
    with pytest.raises(RoamError, match="--inits"):
        jobs_from(edit)
    (tmp_path / "empty").mkdir()
    with pytest.raises(RoamError, match=r"None of the 3 clip\(s\)"):
        jobs_from(edit, inits=tmp_path / "empty")
    for text, said in (
        ("{", "is no edit"),
        ("[" * 100_000, "nested too deeply"),
        ('{"OTIO_SCHEMA": "Gap.1"}', "timeline"),
    ):
        edit.write_text(text)
        with pytest.raises(RoamError, match=said):
            jobs_from(edit, inits=tmp_path / "inits")


@pytest.mark.parametrize(("url", "said"), [("http://show/plate.mov", "only files"), ("gone.mov", "gone.mov")])
def test_media_that_cannot_be_opened_are_told(edit: Path, tmp_path: Path, url: str, said: str) -> None:
    timeline = read_edit(edit)
    media = otio.schema.ExternalReference(target_url=url, available_range=span(0, 10))
    timeline.video_tracks()[0][0].media_reference = media
    edit.write_text(otio.core.serialize_json_to_string(timeline))
    with pytest.raises(RoamError, match=said):
        jobs_from(edit, inits=tmp_path / "inits")


@pytest.mark.parametrize("folder", ["shot", "two words", "sh #3", "50%41", "é"])
@pytest.mark.parametrize("written", ["standard", "library", "path", "relative", "relative_standard"])
def test_media_are_found_however_their_urls_are_written(edit: Path, tmp_path: Path, folder: str, written: str) -> None:
    """By the standard, as OpenTimelineIO's own tools write them (which escape nothing), and as plain paths."""
    plate = put_plate(tmp_path / "media" / folder)
    url = {
        "standard": plate.as_uri(),
        "library": otio.url_utils.url_from_filepath(str(plate)),
        "path": str(plate),
        "relative": f"media/{folder}",
        "relative_standard": f"media/{quote(folder)}",
    }[written]
    media = otio.schema.ExternalReference(target_url=url, available_range=span(1001, 6))
    assert _plate_of(edit, media) == plate
    media = otio.schema.ImageSequenceReference(
        f"{url}/", "plate.", ".png", 1001, 1, RATE, 4, available_range=span(1001, 6)
    )
    assert _plate_of(edit, media) == plate / "plate.%04d.png"


@pytest.mark.parametrize("number", ["%04d", "####", "%d"])
@pytest.mark.parametrize("before", ["file://", "file://localhost", ""])
def test_media_may_be_patterns_of_pictures(edit: Path, tmp_path: Path, number: str, before: str) -> None:
    """`%04d` was taken for the character of the number 4, and what follows `#` for a part of a document."""
    url = f"{before}{tmp_path.as_posix()}/plate/plate.{number}.png"
    media = otio.schema.ExternalReference(target_url=url, available_range=span(1001, 6))
    assert _plate_of(edit, media).parent == tmp_path / "plate"


def _plate_of(edit: Path, media: Any) -> Path:
    """The plate of the job of the first clip with these media."""
    timeline = read_edit(edit)
    timeline.video_tracks()[0][0].media_reference = media
    edit.write_text(otio.core.serialize_json_to_string(timeline))
    return Path(jobs_from(edit, inits=edit.parent / "inits").jobs.jobs[0].clip or "")


@pytest.mark.parametrize(
    ("url", "place"),
    [
        ("file:///C:/show/plate.mov", "C:/show/plate.mov"),
        ("file://C:/show/plate.mov", "C:/show/plate.mov"),
        ("file://localhost/C%3a/show/plate.mov", "C%3a/show/plate.mov"),  # as Premiere writes it
        ("file:///C%3A/show/plate.mov", "C%3A/show/plate.mov"),
        ("file://server/show/plate.mov", "//server/show/plate.mov"),
        ("file:/show/plate.mov", "/show/plate.mov"),
        ("file:plate.mov", "plate.mov"),
    ],
)
def test_urls_of_drives_and_of_other_machines(url: str, place: str) -> None:
    assert _without_scheme(url) == place


def test_an_edit_is_written_over_nothing_that_is_read_or_of_others(
    edit: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    """It is told before any work begins; the edit itself was replaced at the end."""
    monkeypatch.setattr("roam_core.cli.batch.jobs_from", lambda *_, **__: pytest.fail("work began"))
    other = tmp_path / "other.otio"
    other.write_bytes(edit.read_bytes())
    for target, words, said in (
        (edit, [], "is read for this and is never written over"),
        (edit, ["--overwrite"], "is read for this and is never written over"),
        (other, [], "say --overwrite"),
        (tmp_path / "new.xml", [], "does not end in .otio"),
    ):
        inits = ["--inits", str(tmp_path / "inits")]
        assert main(["batch", str(edit), *inits, "--timeline", str(target), *words]) == 1
        assert said in capsys.readouterr().err
    assert other.read_bytes() == edit.read_bytes()


def test_mattes_are_referred_to_by_the_digits_that_count(edit: Path, tmp_path: Path) -> None:
    """`shot_0001_v002.png` is frame 1 of version 2; its mattes were taken for one picture, number 2."""
    plate = tmp_path / "plate"
    for path in sorted(plate.iterdir()):
        path.rename(plate / f"shot_{path.suffixes[0][1:]}_v002.png")
    timeline = read_edit(edit)
    for item in timeline.find_clips():
        item.media_reference.name_prefix, item.media_reference.name_suffix = "shot_", "_v002.png"
    edit.write_text(otio.core.serialize_json_to_string(timeline))
    found = jobs_from(edit, handles=1, inits=tmp_path / "inits", out=tmp_path / "out")
    job = next(job for job in found.jobs.jobs if job.name == "sh010")
    mattes = tmp_path / "out" / "sh010" / "mattes"
    mattes.mkdir(parents=True)
    for frame in range(job.steps[0].options["start"], job.steps[0].options["end"] + 1):
        (mattes / f"shot_{frame}_v002.png").touch()
    found.write_timeline(tmp_path / "with.otio")
    media = read_edit(tmp_path / "with.otio").video_tracks()[1][0].media_reference
    assert (media.name_prefix, media.start_frame, media.frame_zero_padding) == ("shot_", 1001, 4)
    assert media.number_of_images_in_sequence() == 4
    places = [Path(otio.url_utils.filepath_from_url(media.target_url_for_image_number(k))) for k in range(4)]
    assert places == sorted(mattes.iterdir())


def changed(edit: Path, change: Any) -> None:
    """The edit, saved anew with a change to it."""
    timeline = read_edit(edit)
    change(timeline)
    edit.write_text(otio.core.serialize_json_to_string(timeline))


def without_ranges(timeline: Any) -> None:
    for item in timeline.find_clips():
        item.media_reference.available_range = None


def test_media_need_not_say_how_long_they_are(edit: Path, tmp_path: Path) -> None:
    """`available_range` is optional in OpenTimelineIO, and many leave it out: that ended in an error of Python's."""
    changed(edit, without_ranges)
    assert ranges(edit, 0) == {"sh010": (1002, 1003), "sh_020": (1003, 1005)}

    def from_zero(timeline: Any) -> None:
        timeline.video_tracks()[0][0].source_range = span(1, 2)
        timeline.video_tracks()[0][3].source_range = None

    changed(edit, from_zero)
    assert ranges(edit, 0) == {"sh010": (1002, 1003), "sh_020": (1001, 1006)}


@pytest.mark.parametrize("first", [500, -3])
def test_media_that_leave_their_time_open_are_told(edit: Path, tmp_path: Path, first: int) -> None:
    changed(edit, without_ranges)
    changed(edit, lambda timeline: setattr(timeline.video_tracks()[0][0], "source_range", span(first, 2)))
    with pytest.raises(RoamError, match=r"sh010 does not say at which time its media begin \(available_range\)"):
        jobs_from(edit, inits=tmp_path / "inits")


def test_mattes_go_above_clips_in_nested_tracks_and_clips_without_a_length(edit: Path, tmp_path: Path) -> None:
    def nested(timeline: Any) -> None:
        track = timeline.video_tracks()[0]
        track[0].enabled = False
        track[1].media_reference.available_range = track[1].source_range = None
        inner, stack = track.deepcopy(), otio.schema.Stack(name="nest")
        del track[:]
        stack.append(inner)
        track.append(stack)

    changed(edit, nested)
    found = jobs_from(edit, inits=tmp_path / "inits", out=tmp_path / "out")
    mattes = tmp_path / "out" / "sh010" / "mattes"
    mattes.mkdir(parents=True)
    for frame in (1002, 1003):
        (mattes / f"plate.{frame}.png").touch()
    found.write_timeline(tmp_path / "with.otio")
    (stack,) = read_edit(tmp_path / "with.otio").video_tracks()[0]
    _, above = stack
    assert [(type(item).__name__, item.duration().value) for item in above] == [("Clip", 2), ("Gap", 6), ("Gap", 2)]
    assert not above[0].enabled


def test_a_clip_that_lies_in_a_stack_has_no_neighbours(edit: Path) -> None:
    def stacked(timeline: Any) -> None:
        track, stack = timeline.video_tracks()[0], otio.schema.Stack(name="nest")
        stack.append(track[0].deepcopy())
        track[0] = stack

    changed(edit, stacked)
    assert ranges(edit, 0) == {"sh010": (1002, 1003), "sh_020": (1003, 1005)}


def test_a_clip_of_no_length_whose_media_are_gone_is_told(edit: Path, tmp_path: Path) -> None:
    def gone(timeline: Any) -> None:
        titles = timeline.video_tracks()[0][1]
        titles.media_reference, titles.source_range = otio.schema.MissingReference(), None

    changed(edit, gone)
    found = jobs_from(edit, inits=tmp_path / "inits", out=tmp_path / "out")
    with pytest.raises(RoamError, match="How long titles lasts is not said"):
        found.write_timeline(tmp_path / "with.otio")
