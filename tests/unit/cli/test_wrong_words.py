"""Some fifty ways to ask `export`, `render`, `import` for what cannot be: one sentence each, nothing is written."""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path

import pytest

from roam_core.cli import main
from roam_core.roto import Clip, Keyframe, Layer, Project, RotoShape, file
from tests.unit.cli.conftest import Plate, Roam
from tests.unit.matte.conftest import rectangle


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """`p.roam` (frames 7-9), `newer.roam`, `empty` and bad files of every kind."""
    shape = rectangle(2.0, 2.0, 10.0, 10.0, frame=7)
    moved = RotoShape("shape-1", "Arm", (*shape.keys, Keyframe(9, shape.keys[0].points + 10.0)))
    file.save(Project(Clip(Path("/plates/gone"), 7, 9, (64, 48)), Layer("root", "Root", (moved,))), tmp_path / "p.roam")
    (tmp_path / "newer.roam").write_text(
        re.sub(r'"version": \d+', '"version": 99', (tmp_path / "p.roam").read_text(encoding="utf-8"), count=1)
    )
    (tmp_path / "empty").mkdir()
    noise = bytes(range(256)) * 64
    for name in ("noise.nk", "noise.fxs", "noise.svg", "noise.json", "noise.png"):
        (tmp_path / name).write_bytes(noise)
    (tmp_path / "void.nk").touch()
    bomb = '<!DOCTYPE x [<!ENTITY a "aaaa"><!ENTITY b "&a;&a;">]>'
    (tmp_path / "bomb.fxs").write_text(f"{bomb}<Silhouette>&b;</Silhouette>")
    (tmp_path / "bomb.svg").write_text(f'{bomb}<svg xmlns="http://www.w3.org/2000/svg">&b;</svg>')
    (tmp_path / "deep.nk").write_text("Roto {\n curves " + "{" * 5000 + "}" * 5000 + "\n}\n")
    (tmp_path / "deep.json").write_text("[" * 100_000)
    return tmp_path


def tree(folder: Path) -> dict[str, bytes]:
    return {str(path): path.read_bytes() for path in sorted(folder.rglob("*")) if path.is_file()}


EXPORTS: list[tuple[str, str]] = [
    ("{f}/none.roam --to nuke {f}/x.nk", "does not exist"),
    ("{f} --to nuke {f}/x.nk", "is a folder"),
    ("{f}/noise.nk --to nuke {f}/x.nk", "not a ROAM project"),
    ("{f}/newer.roam --to nuke {f}/x.nk", "version"),
    ("{f}/p.roam --to flame {f}/x.nk", "no export format 'flame'; there are"),
    ("{f}/p.roam --to nuke {f}/none/x.nk", "cannot be written"),
    ("{f}/p.roam --to nuke {f}/empty", "cannot be written"),
    ("{f}/p.roam --to nuke {f}/x.nk --frames 9 7", "lies before the first; name the earlier one first"),
    ("{f}/p.roam --to nuke {f}/x.nk --frames 1 2", "must lie between 7 and 9"),
    ("{f}/p.roam --to nuke {f}/x.nk --keys reduced --tolerance 0", "positive number of pixels"),
    ("{f}/p.roam --to nuke {f}/x.nk --keys reduced --tolerance nan", "positive number of pixels"),
    ("{f}/p.roam --to nuke {f}/x.nk --smooth -3", "positive number of pixels"),
    ("{f}/p.roam --to silhouette {f}/x.fxs --frame-offset 99999999999999999999", "number frames beyond 16777216"),
    ("{f}/p.roam --to svg {f}/x.svg --frame 500", "Frame 500 lies outside of the clip's, which are 7 to 9"),
    ("{f}/p.roam --to mattes {f}/x.jpg", "PNG, EXR or TIFF"),
    ("{f}/p.roam --to silhouette {f}/x.nk", "another format's files; those of silhouette end in .fxs"),
    ("{f}/p.roam --to nuke {f}/x.PY", "those of nuke end in .nk"),
    ("{f}/p.roam --to mattes {f}/x.svg", "those of mattes end in .exr or .png or .tif or .tiff"),
    ("{f}/p.roam --to mattes {f}/x.png --file exr", "the name of PNG files, but EXR is asked for"),
    ("{f}/p.roam --to mattes {f}/x.png --depth float", "8 or 16 deep, not float"),
    ("{f}/p.roam --to mattes {f}/out --file png --channels", "no channels with names"),
    ("{f}/p.roam --to mattes {f}/out --file png --compression piz", "compressed by zip, not 'piz'"),
    ("{f}/p.roam --to mattes {f}/noise.nk/out", "cannot be made"),
]
RENDERS = [
    ("{f}/p.roam --out {f}/noise.nk", "is a file; name a folder"),
    ("{f}/p.roam --out {f}/out --start 9 --end 7", "--end 7 comes before --start 9"),
    ("{f}/p.roam --out {f}/out --start 100 --end 200", "--start 100 lies outside the clip's frames 7-9"),
    ("{f}/p.roam --out {f}/out --end 12", "--end 12 lies outside the clip's frames 7-9"),
    ("{f}/p.roam --out {f}/out --name a/b.####.png", "is no file name"),
    ("{f}/p.roam --out {f}/out --name x.exr --file tiff", "the name of EXR files, but TIFF is asked for"),
    ("{f}/p.roam --out {f}/out --file png --tight", "hold all pixels"),
    ("{f}/p.roam --out {f}/out --file tiff --depth half", "not half"),
    ("{f}/none.roam --out {f}/out", "does not exist"),
]
IMPORTS = [
    ("{f}/none.nk", "does not exist"),
    ("{f}/p.roam", "is a project; export its shapes (--to json) and import those"),
    ("{f}/empty", "holds no image"),
    ("{f}/void.nk", "no Roto or RotoPaint node"),
    ("{f}/noise.nk", "no Roto or RotoPaint node"),
    ("{f}/noise.fxs", "no valid XML"),
    ("{f}/noise.svg", "no valid XML"),
    ("{f}/noise.json", "no valid JSON"),
    ("{f}/deep.json", "no valid JSON"),
    ("{f}/deep.nk", "deep"),
    ("{f}/bomb.fxs", "document type"),
    ("{f}/bomb.svg", "entity"),
    ("{f}/noise.png", "no image that can be read"),
    ("{f}/void.nk --frame-offset 99999999999", "smaller offset"),
]


@pytest.mark.parametrize(
    ("command", "words", "reason"),
    [
        *(("export", words, reason) for words, reason in EXPORTS),
        *(("render", words, reason) for words, reason in RENDERS),
        *(("import", f"{words} --into {{f}}/p.roam", reason) for words, reason in IMPORTS),
        ("import", "{f}/void.nk --into {f}/none.roam", "does not exist"),
        ("import", "{f}/void.nk --into {f}/p.roam --save {f}/none/q.roam", "does not exist"),
    ],
)
def test_it_is_refused_in_one_sentence(roam: Roam, folder: Path, command: str, words: str, reason: str) -> None:
    before = tree(folder)
    done = roam(command, *(word.format(f=folder) for word in words.split()))
    assert (done.status, done.out) == (1, "")
    assert done.err.startswith("roam: ")
    assert done.err.count("\n") == 1
    assert done.err.endswith(".\n")
    assert len(done.err) < 400 + 2 * len(str(folder))
    assert reason in done.err
    assert tree(folder) == before


@pytest.mark.parametrize(
    ("words", "choices"),
    [
        ("review p --view x", "'overlay', 'cutout'"),
        ("review p --ground x", "'grey', 'checker', 'black'"),
        ("render p --out o --file x", "'png', 'exr', 'tiff'"),
        ("render p --out o --depth x", "'8', '16', 'half', 'float'"),
        ("render p --out o --per x", "'all', 'layer', 'shape'"),
        ("export p o --to mattes --keys x", "'every', 'artist', 'reduced'"),
    ],
)
def test_the_choices_are_told_as_they_are_typed(capsys: pytest.CaptureFixture[str], words: str, choices: str) -> None:
    with pytest.raises(SystemExit, match="2"):
        main(words.split())
    told = f"invalid choice: 'x' (choose from {choices})\n"
    assert capsys.readouterr().err.endswith(
        (told, told.replace(choices, choices.replace("'", "")))
    )  # newer Pythons quote none


def test_what_mlt_cannot_hold_and_workers_that_are_none_are_refused(roam: Roam, folder: Path) -> None:
    file.save(Project(file.load(folder / "p.roam").clip), folder / "bare.roam")
    for words, reason in (
        (("export", folder / "bare.roam", folder / "x.json", "--to", "mlt"), "holds no closed shape"),
        (("fill", folder / "p.roam", "--workers", "0"), "--workers has to be 1 or more"),
        (("fill", folder / "p.roam", "--workers", "-2"), "--workers has to be 1 or more"),
    ):
        done = roam(*words)
        assert (done.status, done.out) == (1, "")
        assert reason in done.err


def test_a_pattern_of_mattes_without_a_suffix_gets_that_of_the_style(roam: Roam, folder: Path) -> None:
    for words, names in (((), ["go.0007.png"]), (("--file", "exr"), ["go.0007.exr", "go.0007.png"])):
        export = roam(
            "export", folder / "p.roam", folder / "out" / "go.####", "--to", "mattes", "--frames", 7, 7, *words
        )
        assert export.status == 0
        assert sorted(path.name for path in (folder / "out").iterdir()) == names


def test_a_pattern_says_what_kind_of_file_is_rendered(roam: Roam, folder: Path) -> None:
    magic: dict[str, Callable[[bytes], bool]] = {
        "m.%d.exr": lambda content: content[:4] == b"v/1\x01",
        "m.####.tif": lambda content: content[:2] in (b"II", b"MM"),
        "plain": lambda content: content[1:4] == b"PNG",
    }
    for pattern, fits in magic.items():
        out = folder / pattern.partition(".")[2].lstrip("%d#.") / "out"
        assert roam("render", folder / "p.roam", "--out", out, "--name", pattern).status == 0
        written = sorted(out.iterdir())
        assert len(written) == 3
        assert all(fits(path.read_bytes()) for path in written)
        assert all(path.suffix in (".exr", ".tif", ".png") for path in written)


def test_a_file_whose_name_begins_with_a_dash(
    roam: Roam, plate: Plate, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """`--` was passed over, for options may stand between what is not optional."""
    monkeypatch.chdir(plate.folder.parent)
    plate.folder.rename("-shot")
    assert "-shot" in roam("info", "--", "-shot").out
    assert roam("track", "--init", plate.mask, "--end", 1002, "--save", "p.roam", "--", "-shot").status == 0
    assert roam("export", "--to", "svg", "--", "p.roam", "-out.svg").status == 0
    assert (plate.folder.parent / "-out.svg").is_file()
    with pytest.raises(SystemExit):
        roam("info", "-shot")
    assert "give the file -shot as ./-shot" in capsys.readouterr().err
