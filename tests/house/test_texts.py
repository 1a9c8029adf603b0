"""What the window says is said through `tr`, so that it can be said in other languages: no text beside it."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from functools import cache
from pathlib import Path

import pytest

from tests.conftest import ROOT

REPORTS = "app/shell/crash_report.py"
"""What is read by those who mend stays English."""

WORDS = re.compile(r"[a-z,.:;] [a-zA-Z(]|0 [a-z]{3,}|(?:^|[ (])[A-Z][a-z]|…")
"""What reads as words of a language: two words, or one that begins with a capital."""
KEYS = re.compile(r"(?:(?:Ctrl|Alt|Shift)\+?)*(?:\w|Left|Right|Up|Down|Backspace|Esc)?")
"""Keys as keymaps write them: Qt tells them to the artist in the artist's language."""
MACHINES = {
    "getLogger", "debug", "info", "warning", "error", "exception",  # logs are read by those who mend
    "setObjectName", "setProperty", "property", "icon", "resource", "setStyle", "QSettings", "value", "setValue",
    "compile", "critical", "setStyleSheet", "strftime", "start", "startswith", "TypeVar", "get_all", "Path",
}  # fmt: skip
"""Functions whose texts nobody sees: names of objects, jobs, keys of settings, patterns."""
SHOWN = {
    "setText", "setToolTip", "setPrefix", "setSuffix", "setPlaceholderText", "setWindowTitle", "setAccessibleName",
    "say", "apply", "QLabel", "QPushButton", "QCheckBox", "addAction", "addMenu", "form_label", "weak_label",
    "drawText",
}  # fmt: skip
"""Functions whose texts are seen, a single small word, too."""
PROGRAM_ERRORS = {"TypeError", "ValueError", "KeyError", "AssertionError", "NotImplementedError"}
NAMES = {
    "Nuke", "Fusion", "English", "Deutsch", "Planar", "Root", "Manta", "My keys", "OpenImageIO", "OpenEXR",
    "PySide6-Essentials", "License-Expression",
}  # fmt: skip
"""Names, the same in all languages: programs, libraries, what stands in files under a name."""
ON_THE_COMMAND_LINE = {"cli", "studio", "params", "installation"}
"""Rooms of the engine whose refusals and notes no window shows."""
SAID_ELSEWHERE = {"LossyExport"}
"""Errors whose parts are shown, each a sentence, and not their own text."""
NOTED_THERE = {"interchange/nuke/landmarks.py"}
"""Modules of other rooms whose notes are the command line's."""


@cache
def trees() -> dict[str, ast.Module]:
    """The syntax trees of the window, each node knowing its parent."""
    found = {}
    for path in sorted((ROOT / "app").rglob("*.py")):
        tree = ast.parse(path.read_text(encoding="utf-8"))
        for node in ast.walk(tree):
            for child in ast.iter_child_nodes(node):
                child.parent = node  # type: ignore[attr-defined]
        found[str(path.relative_to(ROOT))] = tree
    return found


def above(node: ast.AST) -> Iterator[ast.AST]:
    """The nodes around a node, the nearest first."""
    while (node := getattr(node, "parent", None)) is not None:
        yield node


def name_of(node: ast.AST | None) -> str:
    """The name of the function that a call calls; "" for anything else."""
    function = node.func if isinstance(node, ast.Call) else None
    return getattr(function, "attr", getattr(function, "id", ""))


def literals(tree: ast.Module) -> Iterator[tuple[ast.expr, str]]:
    """Every text of a module, with what stands in it instead of values; not the docstrings."""
    for node in ast.walk(tree):
        parent = getattr(node, "parent", None)
        if isinstance(node, ast.JoinedStr):
            yield node, "".join(str(part.value) if isinstance(part, ast.Constant) else "0" for part in node.values)
        elif isinstance(parent, ast.Expr | ast.JoinedStr | ast.FormattedValue):
            continue
        elif isinstance(node, ast.Constant) and isinstance(node.value, str):
            yield node, node.value


def is_shown(node: ast.expr, text: str) -> bool:
    """True for a text that an artist may read, as far as its place in the code tells."""
    text = text.replace("ROAM", "")
    if name_of(getattr(node, "parent", None)) in SHOWN and re.search(r"[^\W\d_]{2}", text) and text not in NAMES:
        return True
    if not WORDS.search(text) or not re.search(r"[^\W\d]", text) or text in NAMES or KEYS.fullmatch(text):
        return False
    parent = getattr(node, "parent", None)
    if isinstance(parent, ast.List) and "__all__" in ast.unparse(next(iter(above(parent)))):
        return False
    if isinstance(parent, ast.Compare | ast.Set | ast.Subscript) or name_of(parent) in MACHINES | PROGRAM_ERRORS:
        return False
    return not any(isinstance(each, ast.ClassDef) and is_enum(each) for each in list(above(node))[:3])


def is_enum(node: ast.ClassDef) -> bool:
    return any("Enum" in ast.unparse(base) for base in node.bases)


def is_said(node: ast.expr) -> bool:
    """True for a text that goes through the translation, or is logged."""
    return any(name_of(each) in {"tr", "N_", "exception", "debug", "warning"} for each in above(node))


def beside() -> dict[str, list[str]]:
    """The texts of each module that go past the translation."""
    found: dict[str, list[str]] = {}
    for path, tree in trees().items():
        for node, text in literals(tree):
            if is_shown(node, text) and not is_said(node):
                found.setdefault(path, []).append(f"{node.lineno}: {text}")
    return found


def test_every_text_of_the_window_can_be_translated() -> None:
    assert {path: texts for path, texts in beside().items() if path != REPORTS} == {}


def test_the_text_of_a_translation_is_a_literal_or_a_marked_name() -> None:
    """Pieces cannot be translated: what is filled in stands in `{places}`."""
    pieced = [
        f"{path}:{node.lineno}"
        for path, tree in trees().items()
        for node in ast.walk(tree)
        if name_of(node) in {"tr", "N_"}
        and isinstance(node, ast.Call)
        and isinstance(node.args[0], ast.JoinedStr | ast.BinOp)
    ]
    assert pieced == []


def test_nothing_is_translated_when_a_module_is_loaded() -> None:
    """The language is chosen later: tables hold texts that `N_` marks."""
    early = [
        f"{path}:{node.lineno}"
        for path, tree in trees().items()
        for node in ast.walk(tree)
        if name_of(node) == "tr" and isinstance(node, ast.Call)
        if not any(isinstance(each, ast.FunctionDef | ast.Lambda) for each in above(node))
    ]
    assert early == []


@pytest.mark.parametrize("line", ['label.setText("Two words")', 'say(f"{name} is open")', 'QLabel("Word")'])
def test_a_text_beside_the_translation_is_found(line: str) -> None:
    tree = ast.parse(line)
    for node in ast.walk(tree):
        for child in ast.iter_child_nodes(node):
            child.parent = node  # type: ignore[attr-defined]
    assert any(is_shown(node, text) and not is_said(node) for node, text in literals(tree))


def test_files_of_translations_are_there_for_every_language() -> None:
    from app.translation import LANGUAGES, SOURCE

    folder = Path(ROOT / "resources" / "translations")
    wanted = {f"roam_{code}.{kind}" for code in LANGUAGES if code != SOURCE for kind in ("ts", "qm")}
    assert {path.name for path in folder.iterdir()} == wanted


def progress_words(path: Path) -> Iterator[tuple[int, ast.expr]]:
    """What a module of the engine tells to `progress` and `advance`: the lines and the texts."""
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if name_of(node) in {"progress", "_progress", "advance"} and isinstance(node, ast.Call) and len(node.args) == 2:
            yield node.lineno, node.args[1]


def test_what_the_engine_tells_of_its_progress_can_be_translated() -> None:
    """The window shows it: "Matte of frame 1003" stood in the middle of German."""
    engine = [path for path in (ROOT / "roam_core").rglob("*.py") if path.parent.name not in {"cli", "studio"}]
    plain = [
        f"{path.relative_to(ROOT)}:{line}"
        for path in sorted(engine)
        for line, words in progress_words(path)
        if isinstance(words, ast.JoinedStr | ast.Constant)
    ]
    assert not plain, "write these by roam_core.translatable.sentence"


@cache
def engine() -> dict[str, ast.Module]:
    """The syntax trees of the engine."""
    root = ROOT / "roam_core"
    return {str(path.relative_to(root)): ast.parse(path.read_text("utf-8")) for path in sorted(root.rglob("*.py"))}


def engine_for_the_window() -> Iterator[tuple[str, ast.Module]]:
    """The modules of the engine whose sentences a window may show, and their trees."""
    for name, tree in engine().items():
        if name.split("/")[0].removesuffix(".py") not in ON_THE_COMMAND_LINE:
            yield name, tree


def kinds_of_refusals() -> set[str]:
    """The names of `RoamError` and of all that derive from it, in the engine."""
    kinds = {"RoamError"}
    bases = {
        node.name: {ast.unparse(base) for base in node.bases}
        for tree in engine().values()
        for node in ast.walk(tree)
        if isinstance(node, ast.ClassDef)
    }
    while more := {name for name, of in bases.items() if of & kinds} - kinds:
        kinds |= more
    return kinds


def is_plain(node: ast.expr) -> bool:
    """True for a text that is put together of pieces, or stands as it is: no window can say it otherwise."""
    if isinstance(node, ast.IfExp):
        return is_plain(node.body) or is_plain(node.orelse)
    if isinstance(node, ast.BinOp):
        return is_plain(node.left) or is_plain(node.right)
    if isinstance(node, ast.Constant):
        return isinstance(node.value, str)
    return isinstance(node, ast.JoinedStr) or name_of(node) in {"str", "format", "join"}


def plain_refusals(tree: ast.Module, kinds: set[str]) -> Iterator[int]:
    """The lines on which an error of one of these kinds is made of a plain text."""
    for node in ast.walk(tree):
        if isinstance(node, ast.Call) and name_of(node) in kinds and node.args and is_plain(node.args[0]):
            yield node.lineno


def test_what_the_engine_refuses_can_be_said_in_other_languages() -> None:
    """A dialog told in English what is wrong with a file, in the midst of German."""
    kinds = kinds_of_refusals() - SAID_ELSEWHERE
    assert {"DamagedProject", "DamagedFrame", "LostPlane", "NoRoom"} < kinds
    plain = [
        f"roam_core/{name}:{line}" for name, tree in engine_for_the_window() for line in plain_refusals(tree, kinds)
    ]
    assert plain == [], "write these by roam_core.translatable.sentence"


NOTES = {"note", "_tell", "_refusal", "FormError"}
"""What readers and writers say of a file, and why something of it is left out."""
LISTS_OF_NOTES = {"notes", "losses"}


def plain_notes(tree: ast.Module) -> Iterator[int]:
    """The lines on which a note, or a reason within one, is a plain text."""
    for node in ast.walk(tree):
        if not isinstance(node, ast.Call):
            continue
        of = getattr(node.func, "value", None)
        is_listed = name_of(node) == "append" and getattr(of, "attr", getattr(of, "id", "")) in LISTS_OF_NOTES
        if (name_of(node) in NOTES or is_listed) and any(map(is_plain, node.args)):
            yield node.lineno


def test_what_the_engine_notes_can_be_said_in_other_languages() -> None:
    plain = [
        f"roam_core/{name}:{line}"
        for name, tree in engine_for_the_window()
        if name not in NOTED_THERE
        for line in plain_notes(tree)
    ]
    assert plain == [], "write these by roam_core.translatable.sentence"


@pytest.mark.parametrize(
    "line",
    ['raise RoamError(f"{path} is none.")', 'raise LostPlane("Lost.")', "RoamError(str(error))", 'RoamError("a" + b)'],
)
def test_a_refusal_in_plain_english_is_found(line: str) -> None:
    assert list(plain_refusals(ast.parse(line), {"RoamError", "LostPlane"})) == [1]
    assert list(plain_refusals(ast.parse('raise RoamError(sentence("{a}.", a=a))'), {"RoamError"})) == []
    assert list(plain_notes(ast.parse('reader.note(f"{name} was left out.")\nnotes.append("Left out.")'))) == [1, 2]
