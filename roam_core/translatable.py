"""Texts that the window says in other languages: the engine itself says everything in English, and knows no Qt."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import reduce
from types import MappingProxyType


def N_(text: str) -> str:  # noqa: N802 - gettext's name for it
    """The text itself: `make translations` finds it by this mark, and whoever shows it translates it."""
    return text


class Sentence(str):
    """An English sentence that remembers its template, and what was filled in: another language fills in its own.

    Attributes
    ----------
    template : the sentence with its `{places}`.
    values : what stands in them; sentences among these are translated, too.
    """

    __slots__ = ("template", "values")
    template: str
    values: Mapping[str, object]

    def __reduce__(self) -> tuple[object, ...]:
        """An error with such a sentence comes from a worker of a batch or a fill."""
        return _again, (self.template, dict(self.values))


def sentence(template: str, **values: object) -> Sentence:
    """`template` with its places filled in as by `str.format`. `make translations` finds templates written so."""
    made = Sentence(template.format(**values) if values else template)
    made.template, made.values = template, MappingProxyType(values)
    return made


def _again(template: str, values: Mapping[str, object]) -> Sentence:
    return sentence(template, **values)


def said_by(error: BaseException) -> str:
    """What an error says, to be told within another sentence: its own sentence, where it was raised with one."""
    return error.args[0] if error.args and isinstance(error.args[0], Sentence) else str(error)


def listed(words: Sequence[str]) -> str:
    """`feather and motion blur`: words that are sentences of their own, joined."""
    return reduce(lambda before, after: sentence("{before} and {after}", before=before, after=after), words)


def enumerated(words: Sequence[str], most: int | None = None) -> str:
    """`a, b and 3 more`: words that may be sentences, joined; no more than `most` of them, and how many others."""
    more = 0 if most is None else len(words) - most
    shown = words[:most]
    if any(isinstance(word, Sentence) for word in shown):
        names = reduce(lambda before, after: sentence("{before}, {after}", before=before, after=after), shown)
    else:
        names = ", ".join(shown)
    return sentence("{names} and {count} more", names=names, count=more) if more > 0 else names
