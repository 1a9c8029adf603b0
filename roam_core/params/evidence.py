"""Parameters of what is known of the cells near an object, and of the components of its region."""

from __future__ import annotations

from dataclasses import dataclass

from roam_core.params.stamped import later


@dataclass(frozen=True)
class LabelPropagationParams:
    """Parameters of what a cell brings along from the key (`proposal.cues.label_propagation`). Lengths are pixels of a
    480-line image, differences of colour the mean over the channels of 8 bits.

    Attributes
    ----------
    edge : depth at which a cell is three quarters as sure of its side as it can be.
    reach : depth beyond which it counts no more.
    like : difference of colour at which a cell is hardly taken for the one that it came from.
    returned : distance from itself, after following the flow back and forth, at which the same is so.
    like_enough : difference of colour at which a line is half broken.
    returned_enough : distance from itself at which the same is so.
    contradicted : what is left of the line of a cell that was decided otherwise than it was carried.
    """

    edge: float = 3.0
    reach: float = 20.0
    like: float = 8.0
    returned: float = 1.0
    like_enough: float = 50.0
    returned_enough: float = 8.0
    contradicted: float = 0.3


@dataclass(frozen=True)
class ComponentsParams:
    """Parameters of the components of a region and how they hang together (`proposal.segment.components`,
    `proposal.segment.region`).

    Attributes
    ----------
    least : share of all that a shape has from which a component hangs on to it.
    likely : share of a component that no shape wants most that must lie where the object is likely to be, for a shape
        to have it.
    speck : cells; smaller parts and holes are noise.
    """

    least: float = 0.02
    likely: float = 0.3
    speck: int = 6


@dataclass(frozen=True)
class KeyColoursParams:
    """Parameters of what the colours of both keys say of a frame between them (`proposal.cues.key_colours`).

    Attributes
    ----------
    radius, spread : half side of the window, cells, and the price of a place off its middle, Lab units squared a
        cell squared.
    sigma, clip : Lab units by which a colour changes between key and frame, and the bound on the log-ratio, nats.
    aged : by how much more a difference counts on the key at the far end of a span than on the one where it starts.
    """

    radius: int = 5
    spread: float = 0.1
    sigma: float = 3.0
    clip: float = 3.0
    aged: float = 1.0


@dataclass(frozen=True)
class BackgroundParams:
    """Parameters of what the key's background says of a cell (`proposal.cues.background`). Lengths are cells,
    differences of colour units of Lab in 8 bits.

    Attributes
    ----------
    window, reach : side of the patches that are compared, and how far off a cell may lie from where it is expected.
    alike : correlation from which patches are said to be the same. texture : deviation of a patch's colours under
        which a correlation counts for less. same : nats of one that is the same in full.
    unlike : difference of colour from which a cell is said to show something else; twice that: in full. other : nats of
        that, as far as the background outside of the object is as on the key.
    shade : how far a difference of lightness counts where the picture is the darker one.
    around : side of the window in which it must be.
    agreed : share of the surroundings that must move as one for the key to be drawn to the picture by them.
    new : share of the cells around an object whose background is not known, beyond which a frame is kept as a view of
        it. apart : how far from the object a view is believed. views : how many are kept.
    """

    window: int = 5
    reach: int = 1
    alike: float = 0.6
    texture: float = 2.0
    same: float = 3.0
    unlike: float = 20.0
    shade: float = 0.5
    other: float = 2.0
    around: int = 31
    agreed: float = 0.4
    new: float = later(0.1)
    apart: int = later(8)
    views: int = later(8)


@dataclass(frozen=True)
class LevelsParams:
    """Parameters of how a picture of little contrast is stretched for the engine (`features.levels`).

    Attributes
    ----------
    dark, bright : shares of the pixels that are darker, in luma, than black and than white.
    under : how far white lies above black, of 255, in a picture that is seen as it is. span : how far it shall in one
        where it lies nearer; most : by how much contrast grows at most. floor : where black comes to lie.
    """

    dark: float = 0.01
    bright: float = 0.99
    under: float = 120.0
    span: float = 200.0
    most: float = 4.0
    floor: float = 20.0


@dataclass(frozen=True)
class BarsParams:
    """Parameters of black bars around what a picture shows (`features.active_area`).

    Attributes
    ----------
    black : luma, of 255, up to which a pixel is black. stray : share of a line of a bar that may be brighter.
    lit : share of the first line beyond a bar that is. soft : lines between them that are neither.
    """

    black: int = 24
    stray: float = 0.02
    lit: float = 0.5
    soft: int = 3


@dataclass(frozen=True)
class BlankParams:
    """Parameters of frames that show nothing (`features.blank`).

    Attributes
    ----------
    cell : side, pixels, of the cells whose means are compared: grain does not count.
    span : levels, of 255, by which they differ at least where a picture shows something.
    margin : pixels around the outlines that are looked at first.
    """

    cell: int = 8
    span: float = 8.0
    margin: float = 32.0


@dataclass(frozen=True)
class ShadowParams:
    """Parameters of a light that lies over a part of the picture only, a shadow (`proposal.cues.shadow`). Differences
    of colour are means over the channels of 8 bits.

    Attributes
    ----------
    apart : difference of the logarithm of brightness from which a patch lies in another light than most.
    share : of the patches that must. within, agreed : share of all patches that must lie in one of the lights, and
        within what difference.
    window : side, cells, of the squares in which it is decided in which light they lie. edge : cells (sigma) over which
        one goes over into another.
    unlike : difference of colour that counts no more.
    """

    apart: float = 0.4
    share: float = 0.1
    within: float = 0.15
    agreed: float = 0.65
    window: int = 15
    edge: float = 1.0
    unlike: float = 60.0


@dataclass(frozen=True)
class ExposureParams:
    """Parameters of how the light has changed since the key (`proposal.cues.exposure`).

    Attributes
    ----------
    window : side, cells, of the patches that are compared. alike : correlation from which two are the same. flat :
        deviation of a patch's luma under which a correlation counts for less.
    beside : share of the key's object in a cell up to which it is background.
    darkest, brightest : mean luma between which a patch tells anything.
    least : cells that must be known again. most : so many of them are asked at most.
    within : difference of the logarithm of brightness that two patches of one light may show, and of a channel's
        besides. agreed : share of the cells that must agree on a change within that.
    veiled : share of the cells by which a veil must explain more than a factor to come up.
    shadow : of another light over a part of the picture.
    """

    window: int = 7
    alike: float = 0.6
    flat: float = 2.0
    beside: float = 0.2
    darkest: float = 12.0
    brightest: float = 243.0
    least: int = 200
    most: int = later(4000)
    within: float = 0.06
    agreed: float = 0.5
    veiled: float = later(0.2)
    shadow: ShadowParams = later(ShadowParams())


@dataclass(frozen=True)
class TextureParams:
    """Parameters of what texture tells an object from its surroundings (`appearance.texture_model`).

    Attributes
    ----------
    windows : sides, cells, of the windows that a cell's texture is seen in (`features.texture`).
    trees, levels : how many trees, and questions of each. tests : among how many a level chooses its own.
    samples : cells of each side, at most, that a frame teaches.
    key : how much the key's cells count beside those of later frames.
    unseen : share of a side that a leaf is taken to hold unseen: one that hardly anything fell into says little.
    """

    windows: tuple[int, int, int] = (5, 9, 17)
    trees: int = 20
    levels: int = 10
    tests: int = 12
    samples: int = 8000
    key: float = 1.0
    unseen: float = 1e-4
