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


def listed(words: Sequence[str]) -> str:
    """`feather and motion blur`: words that are sentences of their own, joined."""
    return reduce(lambda before, after: sentence("{before} and {after}", before=before, after=after), words)
