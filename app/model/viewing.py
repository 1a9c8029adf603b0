"""Viewing: how the artist looks at the plate: which view, which channel, how exposed, what lies under a cut-out."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import asdict, dataclass, fields, replace
from enum import StrEnum
from functools import partial
from typing import Any

from PySide6.QtCore import QObject, Signal
from PySide6.QtGui import QColor

from roam_core.errors import RoamError
from roam_core.media.colour_spaces import config_name, offered_views
from roam_core.media.looking import Channel, Look
from roam_core.media.proxies import STEPS
from roam_core.system_errors import is_file

from ..translation import N_, tr

EXPOSURES, GAMMAS = (-8.0, 8.0), (0.2, 5.0)
"""How far a look may go."""

MOST_GHOSTS = 12
"""Frames that the onion skin shows at most on either side."""


class ViewMode(StrEnum):
    """What the canvas shows below the tool's marks."""

    SOURCE = "source"
    OVERLAY = "overlay"
    MATTE = "matte"
    CUTOUT = "cutout"
    ONION = "onion"
    CONFIDENCE = "confidence"
    ALPHA = "alpha"


TITLES = {
    ViewMode.SOURCE: N_("Source"),
    ViewMode.OVERLAY: N_("Overlay"),
    ViewMode.MATTE: N_("Matte"),
    ViewMode.CONFIDENCE: N_("Confidence"),
    ViewMode.CUTOUT: N_("Cut-out"),
    ViewMode.ONION: N_("Onion skin"),
    ViewMode.ALPHA: N_("Alpha alone"),
}


def title_of(mode: ViewMode) -> str:
    """What a view is called."""
    return tr(TITLES[mode])


PROXIES = dict(zip(("view.full", "view.half", "view.quarter"), STEPS, strict=True))
"""The actions that choose a proxy, by their ids."""
WITHOUT_SHAPES = frozenset({ViewMode.SOURCE, ViewMode.ALPHA})
OF_MATTE = frozenset({ViewMode.MATTE, ViewMode.ALPHA, ViewMode.CUTOUT})
"""Views that need the matte rendered."""


@dataclass(frozen=True)
class Onion:
    """Which other frames' outlines the onion skin draws.

    Attributes
    ----------
    before, after : how many of them.
    step : frames from one to the next.
    only_keys : the artist's keys before and after, in place of every `step`-th frame.
    all_shapes : of all visible shapes, also while some are selected.
    before_colour, after_colour : `#rrggbb`.
    """

    before: int = 3
    after: int = 3
    step: int = 1
    only_keys: bool = False
    all_shapes: bool = False
    before_colour: str = "#ff8c1a"
    after_colour: str = "#4aa8ff"


class BackgroundKind(StrEnum):
    """What a cut-out lies on."""

    COLOUR = "colour"
    CHECKER = "checker"
    IMAGE = "image"


@dataclass(frozen=True)
class Background:
    """What a cut-out lies on: a `colour` `#rrggbb`, a checkerboard, or the image in the file `image`.

    `choice` counts how often an image was chosen: the same file, chosen again, is read again.
    """

    kind: BackgroundKind = BackgroundKind.CHECKER
    colour: str = "#808080"
    image: str = ""
    choice: int = 0


class Viewing(QObject):
    """The one place that says how the canvas looks at things. Never saved in the project, never undone.

    Signals
    -------
    changed() : something of it is another.
    """

    changed = Signal()

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._mode = self._before_alpha = ViewMode.OVERLAY
        self._are_shapes_hidden = self._shows_joints = self._shows_edges = self._is_stabilised = False
        self._shows_magnifier = False
        self._look, self._onion, self._background = Look(), Onion(), Background()
        self._views: dict[str, tuple[str, str]] = {}
        """The display and view that were chosen last, by the configuration of OpenColorIO; not plain sRGB."""
        self._proxy = STEPS[0]

    @property
    def mode(self) -> ViewMode:
        return self._mode

    def set_mode(self, mode: ViewMode) -> None:
        """Show another view, with its shapes."""
        self._mode, self._are_shapes_hidden = ViewMode(mode), False
        if self._mode is not ViewMode.ALPHA:
            self._before_alpha = self._mode
        self.changed.emit()

    def toggle_alpha(self) -> None:
        """Show the alpha alone, or again what was shown before it."""
        self.set_mode(self._before_alpha if self._mode is ViewMode.ALPHA else ViewMode.ALPHA)

    @property
    def are_shapes_hidden(self) -> bool:
        return self._are_shapes_hidden

    def hide_shapes(self, hidden: bool) -> None:
        """Hide or show the shapes in any view."""
        self._are_shapes_hidden = hidden
        self.changed.emit()

    @property
    def shows_shapes(self) -> bool:
        """True where shapes are drawn, and so can be edited."""
        return self._mode not in WITHOUT_SHAPES and not self._are_shapes_hidden

    @property
    def shows_joints(self) -> bool:
        """True where parts are drawn with what they hang on, over the shapes."""
        return self._shows_joints

    def show_joints(self, shown: bool) -> None:
        """Show or hide where parts hang together."""
        self._set("_shows_joints", shown)

    @property
    def shows_edges(self) -> bool:
        """True where outlines are drawn by what kind of edge they are."""
        return self._shows_edges

    def show_edges(self, shown: bool) -> None:
        """Draw outlines by what kind of edge they are, or as usual."""
        self._set("_shows_edges", shown)

    @property
    def is_stabilised(self) -> bool:
        """True where the view goes along with what is selected, from frame to frame."""
        return self._is_stabilised

    def stabilise(self, on: bool) -> None:
        """Let the view go along with what is selected, or stand."""
        self._set("_is_stabilised", on)

    @property
    def shows_magnifier(self) -> bool:
        """True where a point that is dragged is shown magnified."""
        return self._shows_magnifier

    def show_magnifier(self, shown: bool) -> None:
        """Show a point magnified while it is dragged, or no longer."""
        self._set("_shows_magnifier", shown)

    @property
    def look(self) -> Look:
        return self._look

    def set_look(self, **changes: Any) -> None:
        """Change `exposure`, `gamma`, `channel` or `view`; numbers are kept within their bounds."""
        look = replace(self._look, **changes)
        exposure = min(max(look.exposure, EXPOSURES[0]), EXPOSURES[1])
        gamma = min(max(look.gamma, GAMMAS[0]), GAMMAS[1])
        if "view" in changes:
            self._views.pop(config_name(), None)
            self._views |= {config_name(): look.view} if look.view is not None else {}
        self._set("_look", replace(look, exposure=exposure, gamma=gamma))

    @property
    def proxy(self) -> int:
        """How many of the plate's pixels lie along a side of one of those that are shown: 1, 2 or 4."""
        return self._proxy

    def set_proxy(self, step: int) -> None:
        """Show the plate itself, or a proxy of it."""
        self._set("_proxy", step)

    def toggle_channel(self, channel: Channel) -> None:
        """Show one channel alone, or all of them again."""
        self.set_look(channel=Channel.COLOUR if self._look.channel is channel else channel)

    def reset_look(self) -> None:
        """Show the picture as the display's view has it."""
        self._set("_look", Look(view=self._look.view))

    @property
    def onion(self) -> Onion:
        return self._onion

    def set_onion(self, **changes: Any) -> None:
        """Change what the onion skin draws."""
        onion = replace(self._onion, **changes)
        before, after = (min(max(count, 0), MOST_GHOSTS) for count in (onion.before, onion.after))
        self._set("_onion", replace(onion, before=before, after=after, step=max(onion.step, 1)))

    @property
    def background(self) -> Background:
        return self._background

    def set_background(self, **changes: Any) -> None:
        """Change what cut-outs lie on."""
        self._set("_background", replace(self._background, **changes))

    def handlers(self) -> dict[str, Callable[[], object]]:
        """What the actions of this part call, by id."""
        modes = {f"view.{mode}": (lambda mode=mode: self.set_mode(mode)) for mode in ViewMode}
        channels = {
            f"view.{channel}": (lambda channel=channel: self.toggle_channel(channel))
            for channel in Channel
            if channel is not Channel.COLOUR
        }
        proxies = {name: partial(self.set_proxy, step) for name, step in PROXIES.items()}
        return {
            **modes,
            **channels,
            **proxies,
            "view.alpha": self.toggle_alpha,
            "view.colour": lambda: self.set_look(channel=Channel.COLOUR),
            "view.reset_look": self.reset_look,
            "view.hide_overlays": lambda: self.hide_shapes(not self._are_shapes_hidden),
            "view.joints": lambda: self.show_joints(not self._shows_joints),
            "view.edges": lambda: self.show_edges(not self._shows_edges),
            "view.magnifier": lambda: self.show_magnifier(not self._shows_magnifier),
        }

    def remembered(self) -> dict[str, dict[str, Any]]:
        """What comes back when the window is opened again, as plain values.

        Of the look that is the display's view, for each configuration; channel, exposure and gamma would deceive.
        """
        overlays = {"joints": self._shows_joints, "edges": self._shows_edges, "magnifier": self._shows_magnifier}
        stabilised = {"on": self._is_stabilised}
        views = {config: list(view) for config, view in self._views.items()}
        return {
            "onion": asdict(self._onion),
            "ground": asdict(replace(self._background, choice=0)),
            "overlays": overlays,
            "stabilised": stabilised,
            "views": views,
        }

    def recall(self, remembered: object) -> None:
        """Take back what `remembered` gave; what makes no sense stays as it is."""
        kept = remembered if isinstance(remembered, dict) else {}
        self.set_onion(**_fitting(kept.get("onion"), Onion()))
        overlays = kept.get("overlays")
        overlays = overlays if isinstance(overlays, dict) else {}
        self.show_joints(overlays.get("joints") is True)
        self.show_edges(overlays.get("edges") is True)
        self.show_magnifier(overlays.get("magnifier") is True)
        stabilised = kept.get("stabilised")
        self.stabilise(isinstance(stabilised, dict) and stabilised.get("on") is True)
        background = _fitting(kept.get("ground"), Background())
        if background.get("kind", BackgroundKind.CHECKER) in set(BackgroundKind):
            background["kind"] = BackgroundKind(background.get("kind", BackgroundKind.CHECKER))
            if is_file(background.get("image")) or background["kind"] is not BackgroundKind.IMAGE:
                self.set_background(**background)
        self._recall_views(kept.get("views"))

    def _recall_views(self, remembered: object) -> None:
        """Look through the view that was chosen last with this configuration, where it still has it."""
        kept = remembered.items() if isinstance(remembered, dict) else ()
        self._views |= {
            config: (view[0], view[1])
            for config, view in kept
            if isinstance(view, list) and len(view) == 2 and all(isinstance(name, str) for name in view)
        }
        if (view := self._views.get(config_name())) is not None and view in _views_there():
            self._set("_look", replace(self._look, view=view))

    def _set(self, name: str, value: object) -> None:
        if getattr(self, name) != value:
            setattr(self, name, value)
            self.changed.emit()


def _views_there() -> tuple[tuple[str, str], ...]:
    """The views of the configuration; none where it cannot be read, which is told where a plate is opened."""
    try:
        return offered_views()
    except RoamError:
        return ()


def _fitting(given: object, default: Onion | Background) -> dict[str, Any]:
    """Those of the given values that a field of their name and type can take."""
    if not isinstance(given, dict):
        return {}
    own = {field.name: getattr(default, field.name) for field in fields(default)}
    return {
        name: value
        for name, value in given.items()
        if name in own
        and isinstance(value, str if isinstance(own[name], str) else type(own[name]))
        and ("colour" not in name or QColor.isValidColorName(str(value)))
    }
