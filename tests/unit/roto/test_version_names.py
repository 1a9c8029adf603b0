"""Version numbers in the names of files: counted up as studios write them, and never onto what is there."""

from __future__ import annotations

import pytest

from roam_core.roto.version_names import next_version


@pytest.mark.parametrize(
    ("name", "expected"),
    [
        ("shot010_roto_v003.roam", "shot010_roto_v004.roam"),
        ("shot010_roto_V003.roam", "shot010_roto_V004.roam"),
        ("shot_v9.roam", "shot_v10.roam"),
        ("shot_v099.roam", "shot_v100.roam"),
        ("shot_v999.roam", "shot_v1000.roam"),
        ("shot_v002_roto_v010.roam", "shot_v002_roto_v011.roam"),
        ("shot_v003_final.roam", "shot_v004_final.roam"),
        ("v1.roam", "v2.roam"),
        ("sh010v003.roam", "sh010v004.roam"),
        ("shot.v003.ROAM", "shot.v004.ROAM"),
        ("shot.roam", "shot_v002.roam"),
        ("shot.010.roam", "shot.010_v002.roam"),
        ("hdv1080_rev2.roam", "hdv1080_rev2_v002.roam"),  # these are words
        ("über_v3 links.roam", "über_v4 links.roam"),
        ("shot_v٣.roam", "shot_v٣_v002.roam"),  # no digits of a file name
    ],
)
def test_the_last_number_after_a_v_counts_up(name: str, expected: str) -> None:
    assert next_version(name, [name]) == (expected, "")


@pytest.mark.parametrize(
    ("there", "expected"),
    [
        (["shot_v004.roam"], ("shot_v005.roam", "shot_v004.roam")),
        (["shot_v004.roam", "shot_v012.roam", "shot_v007.roam"], ("shot_v013.roam", "shot_v004.roam")),
        (["shot_v4.roam"], ("shot_v005.roam", "shot_v4.roam")),
        (["SHOT_V004.Roam"], ("shot_v005.roam", "SHOT_V004.Roam")),
        (["shot_v007.roam"], ("shot_v004.roam", "")),
        (["shot_v004.nk", "shot_v004.roam.1", "xshot_v004.roam", "shot_v004_b.roam", ".shot_v004.roam.lock"],
         ("shot_v004.roam", "")),
    ],
)  # fmt: skip
def test_a_number_that_is_there_gives_the_first_above_all(there: list[str], expected: tuple[str, str]) -> None:
    assert next_version("shot_v003.roam", ["shot_v003.roam", *there]) == expected


def test_a_name_without_a_number_counts_on_after_those_that_have_one() -> None:
    assert next_version("shot.roam", ["shot.roam", "shot_v002.roam"]) == ("shot_v003.roam", "shot_v002.roam")


def test_accents_may_be_written_in_two_ways() -> None:
    assert next_version("\u00fc_v1.roam", ["u\u0308_v2.roam"]) == ("\u00fc_v3.roam", "u\u0308_v2.roam")
