"""Translations are whole: every text of the code has one, with the same places to fill in, and is compiled."""

from __future__ import annotations

import re
import shutil
import xml.etree.ElementTree as ET
from collections import Counter
from dataclasses import dataclass
from pathlib import Path

import pytest

from app.actions.menus import MENUS
from app.actions.specs import SPECS
from app.translation import LANGUAGES, SOURCE
from scripts.translations import TRANSLATIONS, extract, release

FOREIGN = [code for code in LANGUAGES if code != SOURCE]
PLACES = re.compile(r"\{\w+[^}]*\}|<[a-z_]+\.[a-z_]+>|%n|\(\*[^)]*\)|;;")
"""What must stand in a translation as in the text: places, keys of actions, numbers, kinds of files."""
ENDS = re.compile(r"(…|[.:?!])?\s*$")
MNEMONIC = re.compile(r"&(\w)")


@dataclass(frozen=True)
class Message:
    """A text and its translations: one, or of what is counted one for each plural of the language."""

    source: str
    comment: str
    translations: tuple[str, ...]
    is_finished: bool
    has_plurals: bool


def messages(ts: Path) -> list[Message]:
    """All texts of a file of Qt Linguist."""
    found = []
    for message in ET.parse(ts).getroot().iter("message"):
        translation = message.find("translation")
        assert translation is not None
        forms = [form.text or "" for form in translation.iter("numerusform")] or [translation.text or ""]
        is_finished = translation.get("type") is None and all(forms)
        comment = message.findtext("comment") or ""
        found.append(
            Message(
                message.findtext("source") or "", comment, tuple(forms), is_finished, message.get("numerus") == "yes"
            )
        )
    return found


def of(language: str) -> list[Message]:
    return messages(TRANSLATIONS / f"roam_{language}.ts")


@pytest.mark.parametrize("language", FOREIGN)
def test_every_text_is_translated(language: str) -> None:
    assert len(of(language)) > 900
    assert [message.source for message in of(language) if not message.is_finished] == []


@pytest.mark.parametrize("language", FOREIGN)
def test_what_is_counted_has_plurals(language: str) -> None:
    """Qt's tools see the count where `tr` has the text itself: one that `N_` marks has a singular alone."""
    assert [message.source for message in of(language) if ("%n" in message.source) != message.has_plurals] == []


@pytest.mark.parametrize("language", FOREIGN)
def test_a_translation_has_the_places_of_its_text(language: str) -> None:
    wrong = [
        (message.source, translation)
        for message in of(language)
        for translation in message.translations
        if Counter(PLACES.findall(translation)) != Counter(PLACES.findall(message.source))
    ]
    assert wrong == []


@pytest.mark.parametrize("language", FOREIGN)
def test_a_translation_begins_and_ends_as_its_text(language: str) -> None:
    """The same spaces on both sides and the same dots at the end: texts are put together, and dots ask a question."""

    def frame(text: str) -> tuple[str, str]:
        return text[: len(text) - len(text.lstrip())], ENDS.search(text)[0]  # type: ignore[index]

    wrong = [
        (message.source, translation)
        for message in of(language)
        for translation in message.translations
        if frame(translation) != frame(message.source)
    ]
    assert wrong == []


@pytest.mark.parametrize("language", FOREIGN)
def test_keys_of_menus_are_those_of_the_texts_and_no_menu_has_one_twice(language: str) -> None:
    said = {message.source: message.translations[0] for message in of(language) if not message.comment}
    assert [
        source for source, text in said.items() if bool(MNEMONIC.search(source)) != bool(MNEMONIC.search(text))
    ] == []
    titles = {spec.id: said[spec.title] for spec in SPECS}
    for entries in [
        [said[title] for title in MENUS],
        *([titles.get(name, "") for name in each] for each in MENUS.values()),
    ]:
        keys = [key[1].casefold() for entry in entries if (key := MNEMONIC.search(entry))]
        assert len(keys) == len(set(keys)), entries


@pytest.mark.parametrize("language", FOREIGN)
def test_no_two_actions_have_one_title(language: str) -> None:
    """Beyond those that are alike in English: the palette tells actions apart by their titles."""
    said = {message.source: message.translations[0] for message in of(language) if not message.comment}
    counted = Counter(said[title] for title in {spec.title for spec in SPECS})
    assert [title for title, times in counted.items() if times > 1] == []


@pytest.mark.parametrize("language", FOREIGN)
def test_the_texts_are_those_of_the_code(language: str, tmp_path: Path) -> None:
    ts = tmp_path / f"roam_{language}.ts"
    shutil.copy(TRANSLATIONS / ts.name, ts)
    extract(ts, language)
    assert messages(ts) == of(language), "run `make translations`"


@pytest.mark.parametrize("language", FOREIGN)
def test_what_is_compiled_is_what_is_translated(language: str, tmp_path: Path) -> None:
    qm = tmp_path / f"roam_{language}.qm"
    release(TRANSLATIONS / f"roam_{language}.ts", qm)
    assert qm.read_bytes() == (TRANSLATIONS / qm.name).read_bytes(), "run `make translations`"
