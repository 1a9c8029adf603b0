"""Why the operating system refused: known reasons can be translated, all others stay in its own words."""

from __future__ import annotations

import errno
import os
import sys
from pathlib import Path

import pytest

from roam_core.atomic_write import make_folder
from roam_core.errors import RoamError
from roam_core.system_errors import REASONS, reason_of
from roam_core.translatable import Sentence


@pytest.mark.skipif(sys.platform != "linux", reason="the words are those of Linux")
@pytest.mark.parametrize("name", REASONS)
def test_english_is_what_the_system_says(name: str) -> None:
    number = getattr(errno, name)
    reason = reason_of(OSError(number, "some other language"))
    assert isinstance(reason, Sentence)
    assert reason == os.strerror(number)


def test_what_is_not_known_stays_as_it_is() -> None:
    assert reason_of(OSError(errno.EPIPE, "Broken pipe")) == "Broken pipe"
    assert reason_of(OSError("no number")) == "no number"
    assert reason_of(OSError(10**6, "of another system")) == "of another system"
    assert reason_of(ValueError("embedded null byte")) == "embedded null byte"


def test_a_refusal_keeps_its_reason_as_a_sentence_of_its_own(tmp_path: Path) -> None:
    (tmp_path / "file").write_bytes(b"")
    with pytest.raises(RoamError) as refusal:
        make_folder(tmp_path / "file" / "deeper")
    (said,) = refusal.value.args
    assert said == f"The folder {tmp_path / 'file' / 'deeper'} cannot be made: Not a directory."
    assert isinstance(said.values["reason"], Sentence)
