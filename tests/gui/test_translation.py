"""The window in another language: what is said, how numbers stand in it, and who decides which language it is."""

from __future__ import annotations

import errno
import re
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest
from PySide6.QtCore import QCoreApplication, QLocale
from PySide6.QtGui import QKeySequence
from PySide6.QtWidgets import QComboBox, QWidget
from pytestqt.qtbot import QtBot

from app.actions.actions import Actions
from app.actions.keymaps import load_keymap
from app.actions.search_words import words_for
from app.canvas.plate.pixel_marks import values_text
from app.jobs.runner import Report, Runner
from app.model.preferences import Preferences, load_preferences, save_preferences
from app.translation import (
    N_,
    SOURCE,
    SYSTEM,
    VARIABLE,
    chosen,
    moment,
    number,
    sentence_of,
    speak,
    tr,
    translated,
)
from app.widgets.fields import BLENDS
from roam_core.atomic_write import write_atomically
from roam_core.errors import RoamError
from roam_core.geometry.bezier import polygon_points
from roam_core.interchange import EXPORTERS, ExportOptions, read_shapes
from roam_core.interchange.clipboard import read_text
from roam_core.interchange.nuke.names import Names
from roam_core.interchange.protocol import LossyExport
from roam_core.media import open_clip
from roam_core.proposal.assist.cut_out import cut_box
from roam_core.roto import BlendMode, Clip, Keyframe, Layer, Project, RotoShape, edit, file
from roam_core.system_errors import reason_of
from roam_core.translatable import listed, sentence
from tests.gui.waiting import WAIT
from tests.gui.windows import dialogs_of, opened_window, write_clip
from tests.house.test_translations import of


@pytest.fixture
def german(monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    """The window speaks German, and afterwards English again."""
    monkeypatch.delenv(VARIABLE, raising=False)
    before = QLocale()
    speak("de")
    yield
    speak(SOURCE)
    QLocale.setDefault(before)


def test_english_is_what_stands_in_the_code() -> None:
    assert tr("Track forward") == "Track forward"
    assert tr("%n frame(s) is/are missing.", "", 1) == "1 frame is missing."
    assert tr("%n frame(s) is/are missing.", "", 3) == "3 frames are missing."
    assert tr("no text of the window") == "no text of the window"


def test_german(german: None) -> None:
    assert tr("Track forward") == "Vorwärts tracken"
    assert tr("%n frame(s) is/are missing.", "", 1) == "1 Frame fehlt."
    assert tr("%n frame(s) is/are missing.", "", 3) == "3 Frames fehlen."
    assert tr(N_("Opening {name} …"), name="a.roam") == "a.roam wird geöffnet …"
    assert tr("Keys") == "Keyframes"
    assert tr("Keys", "of the keyboard") == "Tasten"


def test_numbers_and_keys_go_with_the_language(german: None) -> None:
    assert tr("Confidence is {confidence:.2f} at least.", confidence=0.5) == "Die Konfidenz ist mindestens 0,50."
    assert [number(0.75), number(2), number(2, ".3f")] == ["0,75", "2", "2,000"]
    assert re.fullmatch(r"\d\d\. Okt\.? 2026, \d\d:\d\d", moment(1_791_720_000.0))
    assert values_text(np.array([0.5, 1.25, 1], np.float32)) == ["0,500", "1,250", "1,000"]
    assert QKeySequence("Ctrl+Z").toString(QKeySequence.SequenceFormat.NativeText) == "Strg+Z"
    assert QKeySequence("Ctrl+Z").toString() == "Ctrl+Z"
    assert QCoreApplication.translate("QPlatformTheme", "Cancel") == "Abbrechen"


def test_sentences_of_the_engine_are_translated_with_what_they_hold(german: None) -> None:
    told = sentence("Labels are hard and opaque, without the {left} of {name!r}.", left=listed(
        [sentence("feather"), sentence("opacity")]), name="a")  # fmt: skip
    assert told == "Labels are hard and opaque, without the feather and opacity of 'a'."
    assert translated(told) == "Labels sind hart und deckend, ohne weiche Kante und Deckkraft von 'a'."
    assert translated("put together of several") == "put together of several"


def test_what_an_error_of_the_engine_says_is_translated(german: None) -> None:
    shape = RotoShape("shape-1", "Arm", (Keyframe(1, polygon_points([(0, 0), (9, 0), (9, 9)])),))
    with pytest.raises(RoamError, match="needs at least one key") as raised:
        edit.delete_keys(shape, [1])
    assert sentence_of(raised.value) == "'Arm' braucht mindestens einen Keyframe; stattdessen die Form löschen."
    assert sentence_of(RoamError("Only in English.")) == "Only in English."


def test_what_is_refused_of_an_export_and_of_a_box_is_translated(german: None) -> None:
    """It came in English, in the window of another language."""
    with pytest.raises(RoamError) as raised:
        ExportOptions(frames=range(5, 3)).frames_of(Clip(Path("plate"), 1, 9, (64, 48)))
    assert sentence_of(raised.value).startswith("Der letzte Frame zum Exportieren liegt vor dem ersten")
    with pytest.raises(RoamError, match="at least 6 pixels") as raised:
        cut_box(np.zeros((48, 64, 3), np.uint8), (9.0, 9.0), (11.0, 11.0), 1)
    assert sentence_of(raised.value) == ("Der Rahmen ist zu klein; einen von mindestens 6 Pixeln um das Objekt ziehen.")


def test_what_is_listed_in_a_sentence_is_translated_too(german: None) -> None:
    names = Names(changed={f"Korper{k}": f"Körper{k}" for k in range(8)})
    (told,) = map(translated, names.notes())
    assert "'Körper0' heißt 'Korper0', 'Körper1' heißt 'Korper1', " in told
    assert "'Korper5' und 2 weitere" in told
    assert "is called" not in told


def test_the_modes_of_what_an_export_loses_are_called_as_in_the_window(german: None, tmp_path: Path) -> None:
    """They stayed English: 'Modus 'subtract''."""
    key = Keyframe(1, polygon_points([(0, 0), (9, 0), (9, 9)]))
    shapes = tuple(
        RotoShape(f"shape-{mode.value}", "Arm", (key,), blend=mode) for mode in BLENDS if mode is not BlendMode.ADD
    )
    project = Project(Clip(Path("plate"), 1, 9, (64, 48)), Layer("root", "Root", shapes))
    with pytest.raises(LossyExport) as refused:
        EXPORTERS["cvat"].export(project, tmp_path / "a.xml")
    told = " ".join(map(translated, refused.value.losses))
    words = {mode: tr(title) for mode, title in BLENDS.items()}
    lost = (BlendMode.SUBTRACT, BlendMode.INTERSECT, BlendMode.DIFFERENCE)
    assert [mode for mode in lost if f"'{words[mode]}'" not in told] == []


def test_what_is_wrong_with_a_file_is_told_in_german_with_its_reason(german: None, tmp_path: Path) -> None:
    """It came in English, and so did the reason within a German sentence."""
    damaged, setting, cut = tmp_path / "a.roam", tmp_path / "a.setting", tmp_path / "cut.png"
    damaged.write_text(
        file.dumps(Project(Clip(Path("plate"), 1, 9, (64, 48))), tmp_path).replace('"first": 1', '"first": 1.5')
    )
    setting.write_text("{ Tools = ordered() {")
    cut.write_bytes(b"no picture")
    clip = Clip(tmp_path, 1, 9, (64, 48))
    told = []
    for open_it in (
        lambda: open_clip(tmp_path / "gone.####.png"),
        lambda: open_clip(cut),
        lambda: file.load(damaged),
        lambda: read_shapes(setting, clip),
        lambda: read_text("no shapes", clip),
    ):
        with pytest.raises(RoamError) as refused:
            open_it()
        told.append(sentence_of(refused.value))
    assert told[0].startswith(f"Keine Datei in {tmp_path} passt zum Muster gone.####.png; im Ordner liegen cut.png")
    assert told[1].startswith(f"{cut} ist kein lesbares Bild (")
    assert told[2] == f"{damaged} ist beschädigt: der erste Frame des Clips ist keine ganze Zahl."
    assert told[3].startswith(f"{setting} ist kein Setting von Fusion oder ist abgeschnitten")
    assert told[4] == "Die Zwischenablage enthält keine Formen einer Art, die ROAM liest."


def test_notes_of_an_import_are_german_and_gathered(german: None) -> None:
    drawing = "".join(f'<path id="p{k}" filter="url(#f)" d="M0 0L9 0L9 9Z"/>' for k in range(3))
    text = f'<svg xmlns="http://www.w3.org/2000/svg" width="20" height="10">{drawing}<text>a</text></svg>'
    notes = read_text(text, Clip(Path("plate"), 1, 9, (40, 20))).notes
    assert [translated(note) for note in notes] == [
        "Die Datei spricht von Bildern mit 20 x 10 Pixeln, der Clip hat 40 x 20: Die Formen wurden skaliert.",
        "Der Filter von 'p0' entfällt. Ebenso: 'p1', 'p2'.",
        "Elemente der Art 'text' entfallen: ROAM liest nur Umrisse.",
    ]


def test_english_again(german: None) -> None:
    speak(SOURCE)
    assert tr("Track forward") == "Track forward"
    assert QKeySequence("Ctrl+Z").toString(QKeySequence.SequenceFormat.NativeText) == "Ctrl+Z"


def test_actions_are_called_and_found_in_the_language(german: None, qtbot: object) -> None:
    widget = QWidget()
    actions = Actions(widget, widget, load_keymap())
    assert actions["edit.undo"].text() == "Rückgängig"
    assert "Strg+Z" in actions["edit.undo"].toolTip()
    assert "lesezeichen" in words_for("mark.toggle")
    assert "bookmark" in words_for("mark.toggle")
    widget.deleteLater()


SAYS = ("text", "toolTip", "statusTip", "title", "windowTitle", "placeholderText", "accessibleName", "prefix", "suffix")


def said_by(widget: QWidget) -> Iterator[str]:
    """What a widget says, in any of its places."""
    for name in SAYS:
        text = getattr(widget, name, None)
        if callable(text) and isinstance(said := text(), str):
            yield said
    if isinstance(widget, QComboBox):
        yield from (widget.itemText(index) for index in range(widget.count()))


def test_no_word_of_the_window_stays_english_that_has_a_translation(german: None, qtbot: QtBot, tmp_path: Path) -> None:
    """Tables of words that are marked for translation were shown as they stand in the code."""
    english = {each.source for each in of("de") if each.source not in each.translations}
    german_too = {form for each in of("de") for form in each.translations}
    with opened_window(qtbot, write_clip(tmp_path / "plate"), tmp_path / "state") as window:
        found = {said for root in (window, *dialogs_of(window)) for each in root.findChildren(QWidget)
                 for said in said_by(each)}  # fmt: skip
    assert found & english - german_too == set()


def test_the_environment_wins_over_the_preference_and_both_over_the_desktop(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv(VARIABLE, raising=False)
    assert chosen("de") == "de"
    assert chosen("nowhere's") == chosen(SYSTEM)
    monkeypatch.setenv(VARIABLE, "de")
    assert chosen(SOURCE) == "de"
    monkeypatch.setenv(VARIABLE, "nowhere's")
    assert chosen("de") == "de"


@pytest.mark.parametrize(("desktop", "wanted"), [(["de-AT", "de"], "de"), (["fr-FR", "de"], "de"), (["fr"], SOURCE)])
def test_the_desktop_decides_where_nobody_said(
    desktop: list[str], wanted: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.delenv(VARIABLE, raising=False)
    monkeypatch.setattr(QLocale, "uiLanguages", lambda _self, *_: desktop)
    assert chosen(SYSTEM) == wanted


def test_the_language_is_kept_and_one_that_is_none_is_not_believed(tmp_path: Path) -> None:
    path = tmp_path / "preferences.json"
    save_preferences(Preferences(language="de"), path)
    assert load_preferences(path).language == "de"
    path.write_text(path.read_text().replace('"de"', '"xx"'))
    assert load_preferences(path).language == SYSTEM


def test_how_far_the_engine_is_is_said_in_german(german: None, qtbot: QtBot, runner: Runner) -> None:
    def work(report: Report) -> str:
        report.progress(1.0, sentence("Curves of {name}", name=sentence("part {number} of {count}", number=2, count=3)))
        return ""

    told: list[str] = []
    job = runner.start("test", work)
    job.progress.connect(lambda _, text: told.append(text))
    with qtbot.waitSignal(job.ended, timeout=WAIT):
        pass
    assert told == ["Kurven von Teil 2 von 3"]


def test_what_the_operating_system_refuses_is_told_in_german(german: None, tmp_path: Path) -> None:
    """Its words, as `No such file or directory`, stood in the midst of German sentences, which were English, too."""
    gone = tmp_path / "gone" / "a.nk"
    with pytest.raises(RoamError) as refusal:
        write_atomically(gone, b"")
    told = f"{gone} kann nicht geschrieben werden: Die Datei oder den Ordner gibt es nicht ({gone.parent})."
    assert sentence_of(refusal.value) == told
    assert str(refusal.value) == f"{gone} cannot be written: No such file or directory ({gone.parent})."
    for each in (errno.ENOSPC, errno.EACCES, errno.EROFS):
        assert translated(reason_of(OSError(each, "?"))) not in ("?", reason_of(OSError(each, "?")))
