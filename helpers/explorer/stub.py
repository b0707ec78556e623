"""What stands in a page that has no kernel: the arm as data, and a still picture until a script
brings it to life."""

import json
from html import escape

import numpy as np
from numpy.typing import ArrayLike

from helpers.arm import Arm
from helpers.explorer.data import Data
from helpers.kinematics import link_frames, skeleton

_WIDTH, _HEIGHT, _MARGIN = 480, 320, 36
# Where the live view's camera stands, too.
_RIGHT = np.array([0.6816, 0.7317, 0.0])
_UP = np.array([-0.2514, 0.2342, 0.9391])
_COLOURS = {"x": "#D55E00", "y": "#009E73", "z": "#0072B2"}


def stub(arm: Arm, q: ArrayLike, spec: Data) -> str:
    """A figure in HTML that any browser shows and the explorer's script brings to life; the same
    bytes each time."""
    data = json.dumps(spec, separators=(",", ":"), ensure_ascii=False).replace("</", "<\\/")
    pairs = zip(arm.variables, np.round(arm.joint_vector(q), 3) + 0.0, strict=True)
    text = f"{arm.name} at {', '.join(f'{name} = {value:g}' for name, value in pairs)}."
    name = "arm-explorer whole" if spec.get("link") else "arm-explorer"
    return (
        f'<div class="{name}">{still(arm, q, "Still picture of the " + text)}'
        f'<p class="arm-explorer-caption">{escape(text)}</p>'
        f'<script type="application/json">{data}</script></div>'
    )


def still(arm: Arm, q: ArrayLike, words: str) -> str:
    """The arm at q, shape (dof,), as a small SVG in the ink of the page around it, described by
    `words`."""
    frames = link_frames(arm, q)
    corners, spots = skeleton(arm, frames), frames[:-1, :3, 3]
    size = 0.12 * np.ptp(corners, axis=0).max()
    axes = [
        (name, frame[:3, 3], frame[:3, 3] + size * frame[:3, i])
        for frame in frames[[0, -1]]
        for i, name in enumerate("xyz")
    ]
    place = _view(np.vstack([corners, corners * [1, 1, 0], *(tip[None] for _, _, tip in axes)]))
    shadow = _line(place(corners * [1, 1, 0]), 8, 0.12)
    link = _line(place(corners), 8, 0.5)
    joints = "".join(
        f'<circle cx="{x}" cy="{y}" r="7" fill="currentColor"/>' for x, y in place(spots)
    )
    arrows = "".join(_arrow(place(np.array([o, tip])), _COLOURS[n]) for n, o, tip in axes)
    return (
        f'<svg viewBox="0 0 {_WIDTH} {_HEIGHT}" width="{_WIDTH}"'
        f' style="max-width:100%;height:auto" role="img" aria-label="{escape(words, quote=True)}">'
        f"{shadow}{link}{joints}{arrows}</svg>"
    )


def _view(held: np.ndarray):
    """The projection that fits points into the picture: from (..., 3) metres to (..., 2) tenths of
    a pixel."""
    flat = held @ np.stack([_RIGHT, -_UP]).T
    low, high = flat.min(axis=0), flat.max(axis=0)
    room = np.array([_WIDTH, _HEIGHT]) - 2 * _MARGIN
    scale = (room / np.maximum(high - low, 1e-9)).min()
    shift = np.array([_WIDTH, _HEIGHT]) / 2 - scale * (low + high) / 2
    return lambda points: np.round(scale * (points @ np.stack([_RIGHT, -_UP]).T) + shift, 1) + 0.0


def _line(points: np.ndarray, width: int, opacity: float) -> str:
    path = " ".join(f"{x},{y}" for x, y in points)
    return (
        f'<polyline points="{path}" fill="none" stroke="currentColor" stroke-width="{width}"'
        f' stroke-linejoin="round" stroke-linecap="round" stroke-opacity="{opacity}"/>'
    )


def _arrow(points: np.ndarray, colour: str) -> str:
    (x1, y1), (x2, y2) = points
    return f'<line x1="{x1}" y1="{y1}" x2="{x2}" y2="{y2}" stroke="{colour}" stroke-width="3"/>'
