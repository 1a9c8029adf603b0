"""What the window says, in the artist's language: `tr` for every text that is shown, English where none is found."""

from __future__ import annotations

import os
import re
import string
from typing import Any

from PySide6.QtCore import QCoreApplication, QDateTime, QLibraryInfo, QLocale, QTranslator

from roam_core.errors import RoamError
from roam_core.installation import resource
from roam_core.translatable import N_, Sentence

__all__ = [
    "LANGUAGES",
    "N_",
    "SYSTEM",
    "chosen",
    "moment",
    "number",
    "sentence_of",
    "speak",
    "tr",
    "translated",
]

SOURCE = "en"
"""The language in which the texts stand in the code."""
SYSTEM = ""
"""The choice of the language that the desktop asks for, where there is a translation; English elsewhere."""
LANGUAGES = {SOURCE: "English", "de": "Deutsch"}
"""What can be chosen, each by its own name; all but the first have their `resources/translations/roam_<code>.qm`."""
DAY = N_("dd MMM yyyy")
"""How days are written, in Qt's letters for their parts."""
VARIABLE = "ROAM_LANGUAGE"
"""The environment's word for the language, which wins over the preference."""


def tr(text: str, disambiguation: str = "", n: int = -1, /, **values: object) -> str:
    """A text in the window's language, its `{places}` filled in. `make translations` finds what is written so.

    Parameters
    ----------
    text : the English text: a literal, or one that `N_` marked. Of what is counted it has `%n shape(s) is/are`.
    disambiguation : tells texts apart that are alike in English and not in other languages.
    n : how many things the text tells of: it stands in place of `%n`, and chooses between singular and plural.
    values : what stands in the places, in words of the window's language.
    """
    if not text:
        return text
    found = _catalogue.translate("", text, disambiguation, n) or (_counted(text, n) if n >= 0 else text)
    if n >= 0:
        found = found.replace("%n", str(n))
    return _FILLING.vformat(found, (), values) if values else found


def number(value: float, how: str = "g") -> str:
    """A number with the decimal point of the window's language: as short as it goes, or formatted as `how` says."""
    return _FILLING.vformat(f"{{:{how}}}", (float(value),), {})


def moment(when: float, clock: str = "HH:mm") -> str:
    """Day and time of `when`, in seconds since 1970, with the months of the window's language."""
    then = QDateTime.fromSecsSinceEpoch(int(when))
    return ", ".join(QLocale().toString(then, part) for part in (tr(DAY), clock))


def translated(text: str) -> str:
    """A sentence of the engine in the window's language; what is none, or was put together of several, as it is."""
    if not isinstance(text, Sentence):
        return text
    values = {name: translated(value) if isinstance(value, str) else value for name, value in text.values.items()}
    return tr(text.template, **values)


def sentence_of(error: RoamError) -> str:
    """What an error says, in the window's language: in English where the engine has no sentence of it."""
    return translated(error.args[0]) if error.args and isinstance(error.args[0], str) else str(error)


def speak(language: str) -> None:
    """From now on the window speaks `language`: a code of `LANGUAGES`, or `SYSTEM`.

    Called at the start, when there is an application and no window yet: what is shown already stays as it is. Numbers,
    Qt's own words and the names of keys go with it. Raises `RoamError` where the translation is not installed.
    """
    code = chosen(language)
    for translator in (_catalogue, _qt):
        QCoreApplication.removeTranslator(translator)
        translator.load("")
    _shown[:] = [code]
    QLocale.setDefault(QLocale(code) if is_asked_for(language) else QLocale.system())
    if code == SOURCE:
        return
    if not _catalogue.load(str(resource("translations", f"roam_{code}.qm"))):
        raise RoamError(
            tr("The translation {code!r} is not installed; choose another language in the settings.", code=code)
        )
    if _qt.load(f"qtbase_{code}", QLibraryInfo.path(QLibraryInfo.LibraryPath.TranslationsPath)):
        QCoreApplication.installTranslator(_qt)


def chosen(language: str) -> str:
    """The code of the language that is meant: the environment's, else `language`, else the desktop's."""
    for wanted in (os.environ.get(VARIABLE, ""), language):
        if wanted in LANGUAGES:
            return wanted
    names = (name.partition("-")[0] for name in QLocale.system().uiLanguages())
    return next((name for name in names if name in LANGUAGES), SOURCE)


def is_asked_for(language: str) -> bool:
    """True where the artist chose a language, and does not leave it to the desktop."""
    return os.environ.get(VARIABLE, "") in LANGUAGES or language in LANGUAGES


def _counted(text: str, n: int) -> str:
    """English singular or plural: of `(s)` what is left for `n`, of `is/are` the one or the other."""
    text = re.sub(r"\b(\w+)/(\w+)\b", r"\1" if n == 1 else r"\2", text)
    return text.replace("(s)", "" if n == 1 else "s")


class _Filling(string.Formatter):
    """Fills places in as `str.format` does, with the language's decimal point in fractions."""

    def format_field(self, value: Any, format_spec: str) -> Any:
        filled = super().format_field(value, format_spec)
        return filled.replace(".", QLocale().decimalPoint()) if isinstance(value, float) else filled


_FILLING = _Filling()
_catalogue, _qt = QTranslator(), QTranslator()
_shown = [SOURCE]
