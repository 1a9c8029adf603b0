"""Decoding off the window's thread: the viewer keeps its last picture until the one it wants is there."""

from __future__ import annotations

import time
from collections import OrderedDict
from collections.abc import Callable
from typing import TYPE_CHECKING, Any, NamedTuple

from PySide6.QtCore import QObject, QTimer, Signal

from roam_core.errors import RoamError

from ..model.viewing import Viewing
from ..translation import tr
from .runner import Ending, Report, Runner

if TYPE_CHECKING:
    from roam_core.arrays import Image, UInt8
    from roam_core.media import FrameCache, PlateSource
    from roam_core.media.looking import Plate
    from roam_core.media.partial import PartialPicture

READ_AHEAD = 120
"""Frames decoded ahead of the playhead in the direction in which it moves: five seconds; fewer where memory ends."""
DEFAULT_CACHE_BYTES = 1 << 30
"""Bound on the plate's decoded frames, where the artist set no other."""
DISPLAY_BYTES = 512 << 20
"""Bound on pictures kept ready for the screen; plates that are shown as they lie in their files need none."""
PATIENCE = 1000
"""Milliseconds after which it is told that a picture is waited for."""


class Ready(NamedTuple):
    """What the screen shows of a frame: display values, and what views and exposure are made of, where one is wanted.

    Of a proxy both have fewer pixels than the plate.
    """

    pixels: UInt8
    scalable: Image | None

    @property
    def nbytes(self) -> int:
        return int(self.pixels.nbytes) + (0 if self.scalable is None else int(self.scalable.nbytes))


class PlateReader(QObject):
    """The plate that is open: its source, its cache, and the picture of the frame that the window looks at.

    Signals
    -------
    plate_changed() : another plate was opened, or none is.
    picture(frame, image) : `image (h, w, 3)` uint8 for the screen, or None where the frame cannot be shown. A proxy has
        fewer pixels than the plate.
    refused(sentence) : why a frame cannot be shown.
    cache_changed() : other frames are cached, or known to be damaged, than before; at most ten times a second.
    progress(fraction, text), finished(ending, sentence) : a picture takes long, as from a server that does not answer;
        it is there, or waited for no more.
    """

    plate_changed = Signal()
    picture = Signal(int, object)
    refused = Signal(str)
    cache_changed = Signal()
    progress = Signal(float, str)
    finished = Signal(object, str)
    _cache_touched = Signal()

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._runner = Runner("decode", self)
        self._source: PlateSource | None = None
        self._cache: FrameCache[Image] | None = None
        self._ready: OrderedDict[int, Ready] = OrderedDict()
        self._viewings: list[Viewing] = []
        self._baked: frozenset[tuple[str, tuple[str, str]]] = frozenset()
        self._step = 1
        self._limit = DEFAULT_CACHE_BYTES
        self._wanted: int | None = None
        self._previous = 0
        self._cache_touched.connect(self._touch)
        self._settle = QTimer(self, interval=100, singleShot=True)
        self._settle.timeout.connect(self.cache_changed)
        self._patience = QTimer(self, interval=PATIENCE, singleShot=True)
        self._patience.timeout.connect(self._tell_wait)
        self._is_told = False
        """That a picture is waited for."""
        self._reading: list[FrameCache[Image] | Runner] = []
        """What reads a frame of a plate that was let go, to its end."""

    @property
    def source(self) -> PlateSource | None:
        return self._source

    def open(self, source: PlateSource | None) -> None:
        """Show another plate; the frames of the old one are let go."""
        from roam_core.media import FrameCache

        self._let_go()
        if source is not None:
            self._source, self._cache = source, FrameCache(source, self._limit)
            self._cache.on_change(self._cache_touched.emit)
        self.plate_changed.emit()
        self.cache_changed.emit()

    def close(self, wait: float = 10.0) -> bool:
        """Let the plate go and end the threads; False where one still reads a frame after `wait` seconds."""
        self._let_go()
        self._settle.stop()
        until = time.monotonic() + wait
        ended = [each.close(max(0.0, until - time.monotonic())) for each in (self._runner, *self._reading)]
        return all(ended)

    def stop(self) -> None:
        """Wait no more for a picture that was told to take long; the one before stays."""
        if self._is_told:
            self._drop_job()
            self._end_wait(
                Ending.CANCELLED, tr("Frame {frame} is not read; go to it again to try.", frame=self._wanted)
            )

    def set_cache_limit(self, limit: int) -> None:
        """Hold no more than so many bytes of decoded frames; what is above goes when the next frame is read."""
        self._limit = limit
        if self._cache is not None:
            self._cache.limit_bytes = limit
            self.cache_changed.emit()

    def cached_frames(self) -> frozenset[int]:
        return frozenset(self._cache.cached_frames()) if self._cache is not None else frozenset()

    def frames_without_picture(self) -> tuple[int, ...]:
        """The frames that the plate lacks, and those that turned out to be damaged, sorted."""
        if self._source is None or self._cache is None:
            return ()
        return tuple(sorted({*self._source.missing, *self._cache.damaged_frames()}))

    def look_through(self, viewing: Viewing) -> None:
        """What a viewer's look is made of is made on the worker; the first viewer chooses the size of pictures too."""
        self._viewings.append(viewing)
        viewing.changed.connect(self._look_again)

    def _look_again(self) -> None:
        """A look has changed, or pictures have another size from now on."""
        step = self._viewings[0].proxy
        if step != self._step:
            self._step, self._ready = step, OrderedDict()
        elif self._wanted is None or (plate := self.plate(self._wanted)) is None or not self._lacks(plate):
            return
        if self._wanted is not None:
            self.show(self._wanted)

    def plate(self, frame: int) -> Plate | None:
        """The plate's own values of a frame, where it is held; never waits for decoding."""
        if self._cache is None or self._source is None:
            return None
        from roam_core.media.looking import Plate

        values = self._cache.get(frame)
        if values is None:
            return None
        ready = self._ready.get(frame)
        scalable = None if ready is None else ready.scalable
        if scalable is None and self._step == 1 and values.dtype != "float16":
            scalable = values
        if not self._views() <= self._baked:
            scalable = None
        return Plate(values, self._source.colour_space, scalable)

    def full_picture(self, frame: int, pixels: UInt8) -> UInt8 | None:
        """The display values of a frame in the plate's own size: the `pixels` on the screen where they have that.

        None where the plate is not held; never waits for decoding.
        """
        from roam_core.media.colour import to_display

        if self._source is None or pixels.shape[1::-1] == self._source.size:
            return pixels
        plate = self.plate(frame)
        return None if plate is None else to_display(plate.values, plate.colour_space)

    def memory(self) -> tuple[int, int]:
        """Bytes held by the cache, and its bound."""
        return (0, 0) if self._cache is None else (self._cache.used_bytes, self._cache.limit_bytes)

    def engine_frame(self, frame: int) -> Any:
        """The frame `(h, w, 3)` in the engine's colours; called by the engine on its own thread."""
        return self.engine_parts(frame).whole

    def engine_parts(self, frame: int) -> PartialPicture:
        """As `engine_frame`; of it is converted what is looked at."""
        return _engine_parts(self._source, self._cache, frame)

    def frames_of_this_plate(self) -> Callable[[int], Any]:
        """What reads frames as `engine_frame` of the plate that is open now, and goes on to when another one is."""
        source, cache = self._source, self._cache
        return lambda frame: _engine_parts(source, cache, frame).whole

    def show(self, frame: int) -> None:
        """Ask for the picture of `frame`. While one is being decoded only the last wish counts.

        What is at hand is told at once: in playback a way over the other thread would cost more than the painting.
        """
        self._wanted = frame
        if self._cache is None:
            return
        if self._runner.running("decode") is not None:
            if self._is_told:
                self._tell_wait()
        elif (picture := self._at_hand(frame)) is None:
            self._decode(frame)
        else:
            self._end_wait()
            self._cache.read_ahead(self._ahead(frame))
            self.picture.emit(frame, picture)

    # ---- the rest is private

    def _at_hand(self, frame: int) -> UInt8 | None:
        """The picture of a frame that needs neither decoding nor conversion, or None."""
        from roam_core.media.colour import is_displayed_as_it_is

        plate = self.plate(frame)
        if plate is not None and self._lacks(plate):
            return None
        if (ready := self._ready.get(frame)) is not None:
            return ready.pixels
        is_itself = plate is not None and self._step == 1 and is_displayed_as_it_is(plate.values, plate.colour_space)
        return plate.values if plate is not None and is_itself else None

    def _lacks(self, plate: Plate) -> bool:
        """Whether one of the looks is made of what is not there yet."""
        from roam_core.media.looking import is_seen_anew

        return plate.scalable is None and any(is_seen_anew(plate, viewing.look) for viewing in self._viewings)

    def _views(self) -> frozenset[tuple[str, tuple[str, str]]]:
        """The views that are looked through, with the space of the plate that they are for."""
        space = "" if self._source is None else self._source.colour_space
        return frozenset((space, view) for viewing in self._viewings if (view := viewing.look.view))

    def _bake(self, values: Image) -> None:
        """On the worker: have the views made that are looked through, which takes long for some of ACES."""
        from roam_core.media.looking import Look, seen_plate

        for space, view in self._views() - self._baked:
            seen_plate(values[:1, :1], space, Look(view=view))
            self._baked = self._baked | {(space, view)}

    def _decode(self, frame: int) -> None:
        cache, source, ready, step, lacks = self._cache, self._source, self._ready, self._step, self._lacks
        assert cache is not None
        assert source is not None
        ahead = self._ahead(frame)

        def work(report: Report) -> str:
            from roam_core.media.colour import to_display
            from roam_core.media.looking import Plate, scalable
            from roam_core.media.proxies import reduced

            values = cache.read(frame)
            wants = lacks(Plate(values, source.colour_space))
            self._bake(values)
            if (seen := ready.get(frame)) is None or (wants and seen.scalable is None):
                pixels = to_display(values, source.colour_space) if seen is None else seen.pixels
                seen = Ready(
                    reduced(pixels, step) if seen is None else pixels, scalable(values, step) if wants else None
                )
                if seen.pixels is not values:
                    seen.pixels.setflags(write=False)
                if seen.pixels is not values or wants:
                    _keep(ready, frame, seen)
            report.partial(seen.pixels)
            cache.read_ahead(ahead)
            return ""

        if self._is_told:
            self._tell_wait()
        else:
            self._patience.start()
        job = self._runner.start("decode", work)
        job.partial.connect(lambda picture: self.picture.emit(frame, picture))
        job.ended.connect(lambda ending, sentence: self._decoded(frame, step, ending, sentence))

    def _decoded(self, frame: int, step: int, ending: Ending, sentence: str) -> None:
        if ending is Ending.FAILED:
            self.picture.emit(frame, None)
            self.refused.emit(sentence)
        if ending is not Ending.CANCELLED and self._wanted is not None:
            plate = self.plate(frame)
            is_late = step != self._step or (plate is not None and self._lacks(plate))  # it is looked at otherwise now
            is_late &= ending is Ending.DONE
            if self._wanted != frame or is_late:
                self.show(self._wanted)
                return
        if ending is not Ending.CANCELLED:
            self._end_wait()

    def _tell_wait(self) -> None:
        self._is_told = True
        self.progress.emit(0.0, tr("Waiting for the picture of frame {frame} …", frame=self._wanted))

    def _end_wait(self, ending: Ending = Ending.DONE, sentence: str = "") -> None:
        self._patience.stop()
        if self._is_told:
            self._is_told = False
            self.finished.emit(ending, sentence)

    def _ahead(self, frame: int) -> list[int]:
        assert self._source is not None
        step = 1 if frame >= self._previous else -1
        self._previous = frame
        frames = self._source.frames
        wanted = range(frame + step, frame + step * (READ_AHEAD + 1), step)
        return [other for other in wanted if frames[0] <= other <= frames[-1]]

    def _touch(self) -> None:
        # News of a cache that was let go meanwhile are late: nobody waits for them any more.
        if self._cache is not None and not self._settle.isActive():
            self._settle.start()

    def _let_go(self) -> None:
        self._drop_job()
        if self._cache is not None:
            self._reading.append(self._cache)
        self._reading = [each for each in self._reading if not _has_ended(each)]
        self._source = self._cache = self._wanted = None
        self._ready = OrderedDict()
        self._end_wait()

    def _drop_job(self) -> None:
        """Let the picture that is being decoded not arrive; what is decoded next does not wait for it."""
        if (job := self._runner.running("decode")) is not None:
            job.drop()
            self._reading.append(self._runner)
            self._runner.close(0.0)
            self._runner = Runner("decode", self)


def _has_ended(reading: FrameCache[Image] | Runner) -> bool:
    """Whether nothing reads any more for a plate that was let go; a worker that has ended goes with it."""
    if not reading.close(0.0):
        return False
    if isinstance(reading, Runner):
        reading.deleteLater()
    return True


def _engine_parts(source: PlateSource | None, cache: FrameCache[Image] | None, frame: int) -> PartialPicture:
    from roam_core.media.partial import PartialPicture

    if cache is None or source is None:
        raise RoamError(tr("There is no plate to track in; open a clip first."))
    width, height = source.size
    return PartialPicture((height, width), source.colour_space, None, (0, 0), cache.read(frame))


def _keep(ready: OrderedDict[int, Ready], frame: int, seen: Ready) -> None:
    """Remember a picture converted now; those converted longest ago go first when they are too many."""
    ready[frame] = seen
    ready.move_to_end(frame)
    held = sum(each.nbytes for each in tuple(ready.values()))
    while held > DISPLAY_BYTES and len(ready) > 1:
        held -= ready.popitem(last=False)[1].nbytes
