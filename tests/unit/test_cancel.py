"""A token to cancel by: its copies are the same flag, and another process gets none."""

from __future__ import annotations

import pickle
from collections.abc import Callable
from copy import copy, deepcopy

import pytest

from roam_core.cancel import Cancelled, CancelToken


@pytest.mark.parametrize("copied", [copy, deepcopy])
def test_a_copy_is_the_same_flag(copied: Callable[[CancelToken], CancelToken]) -> None:
    token = CancelToken()
    other = copied(token)
    other.check()
    token.cancel()
    assert other.is_cancelled
    with pytest.raises(Cancelled):
        other.check()


def test_another_process_gets_none() -> None:
    with pytest.raises(TypeError, match=r"a CancelToken is not pickled: .*make one there"):
        pickle.dumps(CancelToken())
