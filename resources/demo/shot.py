"""Puts a frame together: ground, shadow, manta and passers-by at several moments of the open shutter."""

from __future__ import annotations

import cv2
import numpy as np
from numpy.typing import NDArray

from . import body, camera, film, foreground, ground, light, skin
from .coverage import coverage
from .foreground import Layer
from .noise import Image
from .outline import polyline, true_points
from .timing import SIZE, Array, check_frame, shutter_times

WATER = np.array([0.006, 0.033, 0.048], dtype=np.float32)
"""Light that the water itself sends to the lens."""

RETURNED = np.array([0.56, 0.91, 1.09], dtype=np.float32)
"""Colour of the sunlight that comes back from the ground through the water: red goes first."""

SHALLOW = np.array([1.10, 1.30, 1.34], dtype=np.float32)
"""The light that reaches the manta, which swims higher than the ground."""

AMBIENT = 0.22
"""Share of the light on the manta that comes from everywhere."""


def render_frame(frame: int) -> NDArray[np.uint8]:
    """The frame of the shot `(540, 960, 3)`, RGB.

    Raises
    ------
    ValueError
        when the shot has no such frame.
    """
    frame = check_frame(frame)
    sky = light.cloud(frame)
    on_ground = ground_light(frame, sky)
    on_manta = light.caustics(frame, body.surface(np.zeros(2), frame)[:2], 0.55) * sky
    times = shutter_times(frame)
    exposed = np.zeros((SIZE[1], SIZE[0], 3), dtype=np.float32)
    for moment in times:
        plate = _ground(moment, on_ground)
        for layer in (_manta(moment, on_manta), *foreground.school(moment), *foreground.specks(moment)):
            _lay_over(plate, layer)
        exposed += plate
    return film.develop(exposed / np.float32(len(times)), light.exposure(frame), frame)


def true_mask(frame: int) -> NDArray[np.uint8]:
    """Where the true outline covers more than half of a pixel: `(540, 960)` 0 or 255, as if nothing passed in front."""
    line = polyline(true_points(check_frame(frame)))
    inside = coverage(line, 0, 0, *SIZE) > 0.5
    return np.where(inside, np.uint8(255), np.uint8(0))


def occlusion(frame: int) -> float:
    """Share of the manta, in [0, 1], that the fish cover in the middle of the frame's shutter."""
    matte = coverage(polyline(true_points(check_frame(frame))), 0, 0, *SIZE)
    seen = np.ones_like(matte)
    for layer in foreground.school(frame):
        seen[layer.window] *= 1.0 - layer.alpha
    return float(1.0 - (matte * seen).sum() / matte.sum())


def ground_light(frame: float, sky: Image) -> Image:
    """Light on the sea bed as it reaches the lens, `(540, 960, 3)`: the sky's, the waves', and the manta's shadow."""
    origin = camera.view(frame, camera.SAND, ground.GROUND_SIZE) @ (0.0, 0.0, 1.0)
    grey = light.caustics(frame, origin, 0.50) * sky * _shadow(frame)
    return np.asarray(cv2.merge([grey * share for share in RETURNED]))


def _shadow(frame: float) -> Image:
    """Factor `(540, 960)` of the manta's shadow on the ground: thrown away from the sun, soft as the water is deep."""
    step = 4
    throw = -ground.SUN[:2] / ground.SUN[2] * body.height_above_ground(frame)
    line = (polyline(true_points(frame)) + throw) / step
    width, height = SIZE[0] // step, SIZE[1] // step
    blocked = cv2.GaussianBlur(coverage(line, 0, 0, width, height), (0, 0), 2.4)
    return np.asarray(1.0 - 0.74 * cv2.resize(blocked, SIZE, interpolation=cv2.INTER_LINEAR), dtype=np.float32)


def _ground(moment: float, on_ground: Image) -> Image:
    """Sand and boulders as the camera sees them through the water, `(540, 960, 3)`."""
    sand = _seen(ground.sand(), moment, camera.SAND)
    reef = _seen(ground.reef(), moment, camera.REEF)
    seen_through = np.float32(1.0) - cv2.extractChannel(reef, 3)
    sand *= _grey(seen_through)
    sand += cv2.cvtColor(reef, cv2.COLOR_RGBA2RGB)
    sand *= on_ground
    return np.asarray(cv2.add(sand, (*WATER.tolist(), 0.0)))


def _grey(values: Image) -> Image:
    """`values (H, W)` in three channels: whole arrays multiply much faster than numpy spreads a last axis of one."""
    return np.asarray(cv2.merge([values, values, values]))


def _seen(texture: Image, moment: float, nearness: float) -> Image:
    matrix = camera.view(moment, nearness, ground.GROUND_SIZE)
    return np.asarray(cv2.warpAffine(texture, matrix, SIZE, flags=cv2.INTER_LINEAR, borderMode=cv2.BORDER_REFLECT))


def _manta(moment: float, on_manta: Image) -> Layer:
    """The manta, cut by its true outline; its back is lit on the bent surface."""
    line = polyline(true_points(moment))
    low = np.maximum(np.floor(line.min(axis=0)).astype(int) - 1, 0)
    high = np.minimum(np.ceil(line.max(axis=0)).astype(int) + 1, SIZE)
    left, top = int(low[0]), int(low[1])
    width, height = (int(extent) for extent in high - low)

    rest = body.rest_positions(left, top, width, height, moment)
    at = body.spread(skin.texture_positions(rest), width, height)
    albedo = cv2.remap(skin.colour(), at, None, cv2.INTER_LINEAR, borderMode=cv2.BORDER_REPLICATE)
    slope = cv2.remap(skin.relief(), at, None, cv2.INTER_LINEAR, borderMode=cv2.BORDER_REPLICATE)

    facing = body.spread(_sun_in_skin(rest, moment), width, height)
    diffuse = facing[..., 0] - slope[..., 0] * facing[..., 1] - slope[..., 1] * facing[..., 2]
    diffuse /= np.sqrt(1.0 + slope[..., 0] ** 2 + slope[..., 1] ** 2)
    sunlight = (1.0 - AMBIENT) * np.maximum(diffuse, 0.0) * on_manta[top : top + height, left : left + width]
    colour = albedo * (AMBIENT + sunlight)[..., None] * SHALLOW + np.float32(0.55) * WATER
    return Layer(colour.astype(np.float32), coverage(line, left, top, width, height), left, top)


def _sun_in_skin(rest: Array, moment: float) -> Array:
    """The sun `(..., 3)` along the surface's unit normal and its unit tangents of u and v, relative to level ground."""
    tangents = body.jacobian(rest, moment)
    along, across = tangents[..., 0], tangents[..., 1]
    normal = np.cross(along, across)
    axes = np.stack([normal, along, across], axis=-2)
    length = np.linalg.norm(axes, axis=-1)
    return np.asarray((axes @ ground.SUN) / np.maximum(length, 1e-9) / ground.SUN[2])


def _lay_over(plate: Image, layer: Layer) -> None:
    below = plate[layer.window]
    below += layer.alpha[..., None] * (layer.colour - below)
