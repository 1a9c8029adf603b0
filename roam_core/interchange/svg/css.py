"""The part of CSS that drawings are styled with: rules for elements, classes and ids, and what is inherited.

Selectors are compounds of an element's name (or `*`), `#id` and `.class`, joined by blanks (anywhere within) or `>`
(directly within). Other selectors and rules with `@` are named and left out. Nothing is fetched.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from xml.etree.ElementTree import Element

from roam_core.interchange.reading import brief
from roam_core.interchange.xml import local_name
from roam_core.translatable import sentence

Count = Callable[[int], None]

INHERITED = ("fill", "fill-rule", "fill-opacity", "clip-rule", "stroke", "visibility", "color")
OWN = ("opacity", "display", "clip-path", "mask", "mask-type", "filter", "transform", "transform-origin")
PROPERTIES = frozenset((*INHERITED, *OWN))
"""What is asked for; all others are not kept."""


@dataclass(frozen=True)
class Line:
    """An element and those that it lies in, the nearest first: what a selector is matched against."""

    element: Element
    above: Line | None = None


@dataclass(frozen=True)
class _Compound:
    """One part of a selector; `directly` where it must lie directly in the part before it."""

    name: str
    key: str
    classes: frozenset[str]
    directly: bool

    def matches(self, element: Element) -> bool:
        if self.name not in ("", "*") and self.name != local_name(element):
            return False
        if self.key and self.key != element.get("id"):
            return False
        return not self.classes or self.classes <= set(element.get("class", "").split())


@dataclass(frozen=True)
class _Rule:
    compounds: tuple[_Compound, ...]
    weight: tuple[int, int, int]
    number: int
    values: Mapping[str, str]

    def matches(self, line: Line, count: Count) -> bool:
        """Whether the rule is for the element; every step up is counted."""
        if not self.compounds[-1].matches(line.element):
            return False
        return self._matches_above(len(self.compounds) - 2, self.compounds[-1].directly, line.above, count)

    def _matches_above(self, index: int, directly: bool, line: Line | None, count: Count) -> bool:
        """Match the parts up to `index`, with no going back to try others: the nearest fitting ancestor counts.

        That is exact for selectors with blanks only, and for those with `>` whose left parts fit nowhere else above.
        """
        while index >= 0:
            if line is None:
                return False
            count(1)
            if self.compounds[index].matches(line.element):
                directly = self.compounds[index].directly
                index -= 1
            elif directly:
                return False
            line = line.above
        return True


@dataclass
class StyleSheet:
    """The rules of all `<style>` elements of a drawing, found by what their last part asks for."""

    count: Count
    note: Callable[[str], None]
    _rules: dict[str, list[_Rule]] = field(default_factory=dict)
    _number: int = 0

    def add(self, text: str) -> None:
        """Take up the rules of one sheet."""
        text, position = _without_comments(text).replace("<!--", "").replace("-->", ""), 0
        while (start := text.find("{", position)) >= 0:
            self.count(1)
            head = text[position:start]
            if "@" in head or ";" in head:
                head, position = self._at_rule(text, head, start)
                if position < 0:
                    return
                if not head:
                    continue
                start = position - 1
            stop = text.find("}", start)
            stop = len(text) if stop < 0 else stop
            self._add_rules(head, declarations(text[start + 1 : stop], self.count))
            position = stop + 1

    def _at_rule(self, text: str, head: str, start: int) -> tuple[str, int]:
        """What stands before a block with `@` in it: the selector after statements, and where to go on."""
        statements, _, head = head.rpartition(";")
        self.count(1 + statements.count(";"))
        for statement in statements.split(";"):
            self._refuse_at(statement)
        if "@" not in head:
            return head, start + 1
        self._refuse_at(head)
        depth, place = 1, start + 1
        while depth:
            self.count(1)
            opens, closes = text.find("{", place), text.find("}", place)
            if closes < 0:
                return "", -1
            depth, place = (depth + 1, opens + 1) if 0 <= opens < closes else (depth - 1, closes + 1)
        return "", place

    def _refuse_at(self, statement: str) -> None:
        if (word := re.search(r"@[\w-]{1,40}", statement)) and word.group() not in ("@charset", "@font-face"):
            self.note(sentence("Style rules with {rule} were left out.", rule=brief(word.group())))

    def _add_rules(self, heads: str, values: dict[str, str]) -> None:
        self.count(1 + heads.count(","))
        for head in heads.split(","):
            compounds = tuple(_compounds(head, self.count))
            if not values or not head.strip():
                continue
            if not compounds:
                self.note(
                    sentence(
                        "The style rule for {rule} was not understood and left out.",
                        rule=brief(" ".join(head[:200].split())),
                    )
                )
                continue
            last, self._number = compounds[-1], self._number + 1
            weight = (
                sum(1 for part in compounds if part.key),
                sum(len(part.classes) for part in compounds),
                sum(1 for part in compounds if part.name not in ("", "*")),
            )
            key = f"#{last.key}" if last.key else next((f".{word}" for word in sorted(last.classes)), last.name or "*")
            self._rules.setdefault(key, []).append(_Rule(compounds, weight, self._number, values))

    def values(self, line: Line) -> dict[str, str]:
        """The properties that the rules, then its own `style`, give an element; its attributes are not in here."""
        element = line.element
        found: list[_Rule] = []
        words = element.get("class", "").split()
        self.count(len(words))
        keys = [f"#{element.get('id')}", local_name(element), "*", *(f".{word}" for word in dict.fromkeys(words))]
        for key in keys if self._rules else ():
            for rule in self._rules.get(key, ()):
                self.count(1)
                if rule.matches(line, self.count):
                    found.append(rule)
        found.sort(key=lambda rule: (rule.weight, rule.number))
        layers = [rule.values for rule in found]
        layers.append(declarations(element.get("style", ""), self.count))
        plain: dict[str, str] = {}
        urgent: dict[str, str] = {}
        for layer in layers:
            for word, value in layer.items():
                if "!" in value:
                    urgent[word] = value.partition("!")[0].strip()
                else:
                    plain[word] = value
        return plain | urgent


def computed(line: Line, sheet: StyleSheet, above: Mapping[str, str]) -> dict[str, str]:
    """All properties of an element, by its attributes, the sheet, its `style`, and what it inherits from `above`."""
    own = {word: value for word in PROPERTIES if (value := line.element.get(word)) is not None}
    own |= sheet.values(line)
    inherited = {word: above[word] for word in INHERITED if word in above}
    for word, value in own.items():
        if value.strip() == "inherit":
            if word in above:
                inherited[word] = above[word]
        else:
            inherited[word] = value.strip()
    return inherited


def declarations(text: str, count: Count) -> dict[str, str]:
    """The properties of a block or of a `style` attribute; of several alike the last counts."""
    if not text:
        return {}
    count(1 + text.count(";"))
    found = {}
    for word in text.split(";"):
        name, _, value = word.partition(":")
        if (name := name.strip().lower()) in PROPERTIES and value.strip():
            found[name] = value.strip()
    return found


_COMPOUND = re.compile(r"\s*(>?)\s*(\*|[A-Za-z_][\w-]*)?((?:[.#][\w-]+)*)")


def _compounds(head: str, count: Count) -> Iterator[_Compound]:
    """The parts of a selector; none where it is not understood."""
    head, position = head.strip(), 0
    found: list[_Compound] = []
    while position < len(head):
        match = _COMPOUND.match(head, position)
        count(1)
        if match is None or not (match.group(2) or match.group(3)) or (match.group(1) and not found):
            return
        words = re.findall(r"[.#][\w-]+", match.group(3))
        keys = [word[1:] for word in words if word[0] == "#"]
        if len(keys) > 1:
            return
        classes = frozenset(word[1:] for word in words if word[0] == ".")
        found.append(_Compound(match.group(2) or "", keys[0] if keys else "", classes, bool(match.group(1))))
        position = match.end()
        if position < len(head) and not head[position].isspace() and head[position] != ">":
            return
    yield from found


def _without_comments(text: str) -> str:
    parts, position = [], 0
    while (start := text.find("/*", position)) >= 0:
        parts.append(text[position:start])
        stop = text.find("*/", start + 2)
        if stop < 0:
            return "".join(parts)
        position = stop + 2
    return "".join([*parts, text[position:]])
