"""Work shared between two threads: everything once, in order, the same bits."""

from __future__ import annotations

import os
from collections.abc import Iterator
from threading import Event, get_ident

import cv2
import numpy as np
import pytest

from roam_core import threads
from roam_core.kernels.local_match import nearest_colours
from roam_core.threads import WORTH_A_THREAD, beside, each, in_halves


@pytest.fixture
def two_threads() -> Iterator[None]:
    before = cv2.getNumThreads()
    cv2.setNumThreads(2)
    yield
    cv2.setNumThreads(before)


@pytest.mark.parametrize("rows", [0, 1, 2, 7, 200])
@pytest.mark.parametrize("full", ["top", "bottom", "all"])
def test_every_row_is_worked_on_once(two_threads: object, rows: int, full: str) -> None:
    wanted = np.zeros((rows, WORTH_A_THREAD), dtype=bool)
    wanted[{"top": slice(0, 1), "bottom": slice(-1, None), "all": slice(None)}[full]] = True
    visits = np.zeros(rows, dtype=int)

    def visit(first: int, stop: int) -> None:
        visits[first:stop] += 1

    in_halves(visit, wanted)
    assert (visits == 1).all()


def test_two_threads_give_the_bits_of_one(two_threads: object) -> None:
    rng = np.random.default_rng(3)
    colours, memory = rng.integers(0, 60, (2, 90, 80, 3)).astype(np.float32)
    labels = rng.integers(0, 3, (90, 80)).astype(np.uint8)
    shift = rng.normal(0, 3, (90, 80, 2)).astype(np.float32)
    wanted = rng.random((90, 80)) < 0.7
    assert wanted.sum() > WORTH_A_THREAD
    arguments = (colours, memory, labels, wanted, shift, 4, 0.3)
    both = nearest_colours(*arguments)
    cv2.setNumThreads(1)
    np.testing.assert_array_equal(nearest_colours(*arguments), both)


def test_results_come_in_the_order_of_the_items(two_threads: object) -> None:
    assert each(lambda item: -item, range(20)) == [-item for item in range(20)]
    assert each(str, []) == []


def test_two_who_have_work_share_no_more(two_threads: object) -> None:
    def inner(item: int) -> bool:
        outer = get_ident()
        return {outer} == set(each(lambda _: get_ident(), range(2)))

    assert each(inner, range(4)) == [True] * 4
    assert not inner(0)


def test_what_is_begun_beside_is_done_by_another_while_one_goes_on(two_threads: object) -> None:
    may_end = Event()

    def work() -> int:
        assert may_end.wait(120)
        return get_ident()

    begun = beside(work)
    may_end.set()
    assert begun() != get_ident()
    assert begun() == begun()


def test_who_is_alone_does_at_once_what_is_to_be_done_beside(two_threads: object) -> None:
    cv2.setNumThreads(1)
    done: list[int] = []
    begun = beside(lambda: done.append(get_ident()))
    assert done == [get_ident()]
    begun()
    assert len(done) == 1


def test_what_is_done_beside_shares_no_more(two_threads: object) -> None:
    def outer() -> bool:
        return beside(get_ident)() == get_ident()

    assert beside(outer)()
    assert not outer()


def test_what_fails_beside_is_heard_where_its_result_is_asked(two_threads: object) -> None:
    def fail() -> None:
        raise ValueError("beside")

    begun = beside(fail)
    with pytest.raises(ValueError, match="beside"):
        begun()


def test_the_first_exception_comes_out(two_threads: object) -> None:
    def refuse(item: int) -> int:
        raise ValueError(f"item {item}")

    with pytest.raises(ValueError, match="item 0"):
        each(refuse, range(4))


def test_what_fails_in_the_other_half_is_heard(two_threads: object) -> None:
    def work(first: int, stop: int) -> None:
        if first > 0:
            raise ValueError("the other half")

    with pytest.raises(ValueError, match="the other half"):
        in_halves(work, np.ones((2, WORTH_A_THREAD), dtype=bool))


@pytest.mark.skipif(not hasattr(os, "fork"), reason="Windows begins processes afresh")
def test_a_forked_process_has_threads_of_its_own() -> None:
    """Those of its parent are not there: it would wait for them for ever."""
    assert threads._others(os.getpid()).submit(int, 7).result() == 7
    child = os.fork()
    if child == 0:
        answer = 1
        try:
            answer = threads._others(os.getpid()).submit(int, 7).result(timeout=120)
        finally:
            os._exit(answer)  # whatever happens: the tests go on in the parent alone
    assert os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]) == 7
