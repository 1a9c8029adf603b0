"""The user guide keeps its word: the keys in its tables are in the keymaps, its pictures are taken by the script."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator

import pytest

from tests.conftest import ROOT

GUIDE = (ROOT / "docs" / "USER-GUIDE.md").read_text(encoding="utf-8")
KEYMAPS = ROOT / "resources" / "keymaps"
PRESETS = {"Nuke": "nuke", "Silhouette": "silhouette", "Mocha": "mocha"}
PRESETS |= {"After Effects": "after-effects", "Blender": "blender"}
OURS = "default"


def keys_of(preset: str) -> dict[str, list[str]]:
    """The keys of a preset by action; what it leaves out keeps the key of the default."""
    default, own = (json.loads((KEYMAPS / f"{name}.json").read_text())["keys"] for name in (OURS, preset))
    return {**default, **own}


def rows_of(title: str) -> Iterator[tuple[list[str], list[str]]]:
    """Of each row of the table for those who come from a program: our keys, and those of its preset."""
    section = GUIDE.partition(f"### Coming from {title}\n")[2].partition("\n### ")[0]
    for line in section.splitlines():
        cells = [cell.strip() for cell in line.strip("|").split(" | ")]
        if line.startswith("| ") and len(cells) == 4 and cells[0] != "there":
            yield keys_in(cells[2]), keys_in(cells[3])


def keys_in(cell: str) -> list[str]:
    """The keys in code type, without the way in which a backquote is written there."""
    return [key.strip() or "`" for key in re.findall(r"`` (`) ``|`([^`]+)`", cell) for key in key if key]


@pytest.mark.parametrize("title", PRESETS)
def test_keys_in_the_tables_are_those_of_one_action(title: str) -> None:
    ours, theirs = keys_of(OURS), keys_of(PRESETS[title])
    rows = list(rows_of(title))
    assert len(rows) >= 10
    for our_keys, their_keys in rows:
        actions = [[name for name, keys in ours.items() if key in keys] for key in our_keys]
        assert all(actions), f"{our_keys}: no action has one of these keys"
        wanted = {name for names in actions for name in names}
        for key in their_keys:
            held = {name for name in wanted if key in theirs[name]}
            assert held, f"{key} is in the preset no key of {sorted(wanted)}"


def test_every_tool_stands_in_the_guide_with_its_keys() -> None:
    tour = GUIDE.partition("## Coming from other programs")[0]
    tools = {name: keys for name, keys in keys_of(OURS).items() if name.startswith("tool.")}
    assert len(tools) >= 12
    assert [name for name, keys in tools.items() if not any(f"`{key}`" in tour for key in keys)] == []


def test_keys_of_the_tour_exist() -> None:
    """Every key that stands alone in the second column of a table with actions."""
    known = {key for keys in keys_of(OURS).values() for key in keys}
    tour = GUIDE.partition("## Coming from other programs")[0]
    cells = re.findall(r"^\| [^|]+ \| (`[^|]+`) \| [^|]*\|$", tour, flags=re.MULTILINE)
    assert len(cells) >= 12
    assert [key for cell in cells for key in keys_in(cell) if key not in known] == []


def test_every_section_stands_in_the_contents_in_its_order() -> None:
    contents, _, tour = GUIDE.partition("\n## ")
    tour = f"## {tour.partition('## Coming from other programs')[0]}"
    listed = [title for title in re.findall(r"^\d+\. \[(.+?)\]", contents, flags=re.MULTILINE) if "Coming" not in title]
    assert listed == re.findall(r"^## (.+)$", tour, flags=re.MULTILINE)


def test_pictures_are_taken_by_the_script() -> None:
    files = ROOT / "scripts" / "screenshots.py", *(ROOT / "scripts").glob("*_scenes.py")
    script = "".join(path.read_text(encoding="utf-8") for path in files)
    shown = re.findall(r"\(images/([\w.-]+)\)", GUIDE)
    assert len(shown) >= 15
    assert [name for name in shown if not re.search(rf"\"{name.rpartition('.')[0]}[.\"]", script)] == []
