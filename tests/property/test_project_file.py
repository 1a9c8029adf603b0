"""read(write(project)) = project, for whatever an artist may have made."""

from __future__ import annotations

from dataclasses import replace

from hypothesis import given
from hypothesis import strategies as st

from roam_core.roto import Project, file
from tests.property.strategies import FOLDER, projects


@given(projects())
def test_a_project_comes_back_from_its_file(project: Project) -> None:
    text = file.dumps(project, FOLDER)
    again = file.loads(text, FOLDER)
    assert again == project
    assert again.extra == project.extra
    for shape, same in zip(project.shapes, again.shapes, strict=True):
        assert same.extra == shape.extra
    assert file.dumps(again, FOLDER) == text
    assert file.digest(again) == file.digest(project)


@given(projects(), st.text(max_size=6))
def test_a_project_of_another_name_has_another_digest(project: Project, name: str) -> None:
    renamed = project.map_item("root", lambda layer: replace(layer, name=layer.name + "." + name))
    assert file.digest(renamed) != file.digest(project)


@given(projects())
def test_every_file_tells_its_fields_in_the_same_order(project: Project) -> None:
    names = [line for line in file.dumps(project, FOLDER).splitlines() if line.startswith(' "')]
    known = [
        name for name in (' "type"', ' "version"', ' "clip"', ' "root"') for line in names if line.startswith(name)
    ]
    assert [line.partition(":")[0] for line in names][: len(known)] == known
