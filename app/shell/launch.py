"""Opens the window, on a clip, a project or the demo: what `roam_core.cli.program` calls where it is installed."""

from __future__ import annotations

import logging
import os
import sys
from collections.abc import Callable
from logging.handlers import RotatingFileHandler
from pathlib import Path
from typing import TYPE_CHECKING

from ..translation import N_, tr

if TYPE_CHECKING:
    from ..jobs.runner import Runner
    from ..jobs.under_way import UnderWay
    from ..model.view_state import ViewState
    from .main_window import MainWindow

PATIENCE = 3000
"""Milliseconds after which the artist is told that the engine is being prepared."""
FIRST_SIZE = 1500, 940
"""Width and height of the window at the very first start."""
JOURNALS = "journal"
"""Of the state folder: where the journals lie."""
BAD_USAGE = 2
NO_DISPLAY = N_(
    "There is no display to open a window on; use the command line (roam --help), "
    "or log in with a display or X forwarding."
)


def has_display() -> bool:
    """True where a window can be opened: always but on a Unix without X, Wayland or a chosen Qt platform."""
    if sys.platform in ("win32", "darwin"):
        return True
    return any(os.environ.get(name) for name in ("DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"))


def open_window(path: str | None) -> int:
    """Open the window, on a clip or project if one was named. Returns the exit code when it was closed.

    Raises
    ------
    RoamError
        when the clip or project cannot be opened.
    """
    if path is not None:
        _require_readable(path)
    if not has_display():
        sys.stderr.write(f"roam: {tr(NO_DISPLAY)}\n")
        return BAD_USAGE
    return _run(lambda window: _open_first(window, path))


def _require_readable(path: str) -> None:
    """Raise `RoamError` when a clip or project cannot be opened: a wrong name is told before any window opens."""
    from roam_core.roto import file
    from roam_core.roto.backups import is_named_as_backup

    from ..files.reading import clip_project
    from ..model.document import PROJECT_SUFFIX

    if path.lower().endswith(PROJECT_SUFFIX) or is_named_as_backup(Path(path)):
        file.load(Path(path))
    else:
        clip_project(Path(path))


def _open_first(window: MainWindow, path: str | None) -> None:
    if path is not None:
        window.files.open(Path(path).absolute())
    else:
        window.reopening.page.begin()
        window.recovering.offer()


def open_demo() -> int:
    """Open the window on the demo. Returns the exit code when it was closed."""
    return _run(lambda window: window.files.open_demo())


def _run(begin: Callable[[MainWindow], object]) -> int:
    from PySide6.QtCore import QTimer
    from PySide6.QtWidgets import QApplication

    from roam_core.media import decoding

    from .. import style, translation
    from ..folders import cache_folder, other_state_folders, state_folder, state_trouble
    from ..jobs import warm_up
    from ..model.personal import Personal
    from ..widgets.floating import resize_on_screen
    from .crash_report import NativeLog, native_crashes
    from .leaving import leave_on_signals
    from .main_window import MainWindow

    decoding.prepare()  # the first picture is not to wait for it
    _keep_log(state_folder() / "roam.log")
    personal = Personal(state_folder(), cache_folder())
    personal.trouble = " ".join(filter(None, (state_trouble(), personal.trouble)))
    _scale(personal.preferences.scale)
    application = QApplication.instance() or QApplication(sys.argv[:1])
    assert isinstance(application, QApplication)
    application.setApplicationName("ROAM")
    application.setDesktopFileName("roam")
    style.apply(application)
    translation.speak(personal.preferences.language)
    crashes = native_crashes(state_folder() / "crashes")
    window = MainWindow(state_folder() / JOURNALS, personal)
    window.recovering.elsewhere = tuple(folder / JOURNALS for folder in other_state_folders())
    window.defects.install()
    native_log = NativeLog(state_folder() / "crashes")
    leave_on_signals(window.leave_unasked, window)
    resize_on_screen(window, *FIRST_SIZE)
    settings_path = state_folder() / "window.ini"
    window.restore_settings(settings_path)
    application.aboutToQuit.connect(lambda: window.keep_settings(settings_path))
    window.show()
    QTimer.singleShot(0, window, lambda: begin(window))
    QTimer.singleShot(0, window, lambda: window.defects.tell_of(crashes))
    QTimer.singleShot(0, window, lambda: warm_up.load_dialogs(window.writer))
    view_state, under_way = window.view_state, window.under_way
    QTimer.singleShot(0, window, lambda: _prepare(window.solver, window.tracking.config, view_state, under_way))
    try:
        return application.exec()
    finally:
        window.defects.remove()
        native_log.close()


def _prepare(solver: Runner, config: str, view_state: ViewState, under_way: UnderWay) -> None:
    """Compile what the engine needs, and say so where it takes its time: at the very first start."""
    from PySide6.QtCore import QTimer

    from ..jobs import warm_up

    preparation = warm_up.start(solver, config)
    said: list[bool] = []

    def tell() -> None:
        if not preparation.is_over and not under_way.is_any:
            said.append(True)
            view_state.say(tr("The engine is being prepared, once on this machine; you can draw meanwhile."))

    QTimer.singleShot(PATIENCE, preparation, tell)
    preparation.ended.connect(lambda *_: view_state.say(tr("The engine is ready.")) if said else None)


def _scale(scale: float) -> None:
    """Have Qt draw everything larger; only before the application is made. What the desktop already asks for wins."""
    if scale != 1.0:
        os.environ.setdefault("QT_SCALE_FACTOR", f"{scale:g}")


def _keep_log(path: Path) -> None:
    handler = RotatingFileHandler(path, maxBytes=1 << 20, backupCount=2, encoding="utf-8", delay=True)
    handler.setFormatter(logging.Formatter("%(asctime)s %(levelname)s %(name)s: %(message)s"))
    logging.getLogger().addHandler(handler)
