"""What is true of many shapes is one sentence."""

from __future__ import annotations

from pathlib import Path

from roam_core.interchange import read_shapes
from roam_core.interchange.telling import MOST_NAMES, gathered
from roam_core.roto import Clip
from roam_core.translatable import Sentence, sentence


def test_sentences_that_differ_in_a_name_are_one_and_keep_their_order() -> None:
    lost = [sentence("The feather of {name!r} is lost.", name=name) for name in ("A", "B", "B", "C")]
    told = gathered([lost[0], "Else.", *lost[1:], sentence("{name!r} is open.", name="A")])
    assert told == ("The feather of 'A' is lost. So it is with 'B', 'C'.", "Else.", "'A' is open.")
    assert isinstance(told[0], Sentence), "the window says it in its own language"


def test_other_differences_keep_sentences_apart() -> None:
    notes = [sentence("{name!r} is {px} px off.", name="A", px=1), sentence("{name!r} is {px} px off.", name="B", px=2)]
    assert gathered(notes) == tuple(notes)


def test_the_name_may_stand_in_the_subject() -> None:
    subjects = [sentence("layer {name}", name="'A'"), *(sentence("shape {name}", name=name) for name in ("'B'", "'C'"))]
    told = gathered(sentence("The {subject}: {lost} was left out.", subject=each, lost="its blur") for each in subjects)
    assert told == (
        "The layer 'A': its blur was left out.", "The shape 'B': its blur was left out. So it is with 'C'."
    )  # fmt: skip


def test_names_that_are_sentences_stay_those() -> None:
    names = [sentence("mask {k}", k=k) for k in range(3)]
    (told,) = gathered(sentence("{name} is lost.", name=name) for name in names)
    assert told == "mask 0 is lost. So it is with mask 1, mask 2."
    assert isinstance(told, Sentence)
    assert isinstance(told.values["names"], Sentence)


def test_many_names_are_counted() -> None:
    (told,) = gathered(sentence("The blur of {name} was left out.", name=f"'S{k}'") for k in range(300))
    assert told.startswith("The blur of 'S0' was left out. So it is with 'S1', ")
    assert told.endswith(f"and {299 - MOST_NAMES} more.")


def test_a_file_of_many_shapes_with_one_trouble_tells_it_once(tmp_path: Path) -> None:
    path = tmp_path / "s.fxs"
    shape = (
        '<Shape type="Shape" label="S{k}"><Properties><Property id="feather"><Value>4</Value></Property>'
        '<Property id="path"><Key frame="0"><Path closed="True" type="Bezier">'
        "<Point>(0,0),(0,0),(0,0)</Point><Point>(.1,0),(.1,0),(.1,0)</Point><Point>(0,.1),(0,.1),(0,.1)</Point>"
        "</Path></Key></Property></Properties></Shape>"
    )
    shapes = "".join(shape.format(k=k) for k in range(50))
    path.write_text(f'<Silhouette width="100" height="100">{shapes}</Silhouette>')
    read = read_shapes(path, Clip(tmp_path, 1, 9, (100, 100)))
    assert len(list(read.layer.shapes())) == 50
    assert len(read.notes) == 1
    assert read.notes[0].startswith("The shape 'S0': its feather was left out. So it is with 'S1', ")
