"""Stage: what lies below the shapes in each view: the plate's picture, the matte of the project, the cut-out."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtCore import QObject, QSizeF, Signal

from roam_core.arrays import UInt8
from roam_core.media.looking import Plate
from roam_core.roto import Project

from ...model.viewing import OF_MATTE, Viewing, ViewMode
from ...paint import marks
from ...translation import N_, tr
from .backdrop import Below
from .background import BackgroundLayer
from .matte_layer import MatteLayer
from .picture import NEUTRAL, Picture

LOST = N_("The plate is not where it was: choose it again with File > Relink clip")


class Stage(QObject):
    """Holds the pictures of the present frame. Mattes and backgrounds are made beside the window's thread.

    Signals
    -------
    changed() : what can be shown is another than before.
    matte_ready() : the matte or cut-out that was asked for last has been rendered.
    """

    changed = Signal()
    matte_ready = Signal()

    def __init__(self, viewing: Viewing, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._viewing = viewing
        self.matte, self.background = MatteLayer(), BackgroundLayer(self)
        self.plate_of: Callable[[int], Plate | None] = lambda frame: None
        """Gives the plate's own values of a frame, where they are at hand."""
        self.picture: Picture | None = None
        self.frame: int | None = None
        """The frame that `picture` is of."""
        self.missing: int | None = None
        self._mattes: dict[bool, Picture] = {}
        """The newest matte and cut-out, the latter under True."""
        self._has_failed = False
        self.matte.ready.connect(self._take_matte)
        self.background.ready.connect(self.changed)

    def set_image(self, frame: int, image: UInt8 | None) -> None:
        """The plate's picture of `frame`: (h, w, 3) uint8 display values, or None where the plate has none."""
        self.picture = None if image is None else Picture(image, self.plate_of(frame))
        self.frame, self.missing = frame, (frame if image is None else None)
        self.changed.emit()

    def clear(self) -> None:
        """Another project was opened."""
        self.picture = self.frame = self.missing = None
        self._has_failed = False
        self._mattes.clear()
        self.matte.forget()
        self.changed.emit()

    def close(self) -> None:
        """Wait for what is being made."""
        self.matte.close()
        self.background.close()

    def below(self, project: Project, frame: int, size: QSizeF | None) -> Below:
        """What lies below the shapes; a matte that is not there yet is asked for.

        The newest matte stays until the next one is rendered; a cut-out stays one of a picture with its own matte.
        `size` is the plate's in full-resolution pixels.
        """
        mode = self._viewing.mode
        if mode not in OF_MATTE:
            return Below(self.picture or marks.EMPTY_PLATE, self._viewing.look if self.picture else NEUTRAL)
        cuts_out = mode is ViewMode.CUTOUT
        if cuts_out and self.missing is not None:
            return Below(marks.EMPTY_PLATE)
        background = self.background.of(self._viewing.background) if cuts_out else None
        if size is not None:
            self._ask(project, frame, (round(size.height()), round(size.width())), cuts_out)
        nothing = marks.EMPTY_PLATE if cuts_out else marks.EMPTY_MATTE
        return Below(self._mattes.get(cuts_out, nothing), self._viewing.look, background)

    def is_whole(self, project: Project, frame: int) -> bool:
        """Whether what lies below the shapes is of this frame, and nothing of before in its place."""
        mode = self._viewing.mode
        cuts_out = mode is ViewMode.CUTOUT
        if mode in OF_MATTE and not (cuts_out and self.missing == frame):
            return self.matte.holds(project, frame, self.picture if cuts_out else None)
        return self.frame in (None, frame)

    def shown_picture(self) -> Picture | None:
        """The picture whose pixels the view shows, or None while there is none."""
        mode = self._viewing.mode
        if mode is ViewMode.CUTOUT and self.missing is not None:
            return None
        return self._mattes.get(mode is ViewMode.CUTOUT) if mode in OF_MATTE else self.picture

    def emptiness(self, lacks_plate: bool = False) -> str:
        """Why the plate's area is empty, or nothing where it is not."""
        mode = self._viewing.mode
        if mode not in (ViewMode.MATTE, ViewMode.ALPHA):
            if lacks_plate:
                return tr(LOST)
            if self.missing is not None:
                return tr("frame {frame} is missing or damaged", frame=self.missing)
        if mode in OF_MATTE and self.shown_picture() is None:
            if self._has_failed and not self.matte.is_busy:
                return tr("The matte could not be rendered")
            return tr("Cutting out …") if mode is ViewMode.CUTOUT else tr("Rendering the matte …")
        return ""

    def _ask(self, project: Project, frame: int, size: tuple[int, int], cuts_out: bool) -> None:
        if not cuts_out:
            self.matte.request(project, frame, size)
        elif self.picture is not None and self.frame == frame:
            self.matte.request(project, frame, size, self.picture)

    def _take_matte(self) -> None:
        self._has_failed = self.matte.pixels is None
        if (pixels := self.matte.pixels) is not None:
            plate = self.matte.plate
            self._mattes[plate is not None] = Picture(pixels) if plate is None else plate.cut_out(pixels)
        else:
            self._mattes.clear()  # those of before would pass for what could not be rendered
        self.changed.emit()
        self.matte_ready.emit()
