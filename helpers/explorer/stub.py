"""What stands in a page that has no kernel: a live part as data, which the page's script brings to
life. When the book is built the same script draws it beforehand (tools/stills.py)."""

import json
from html import escape

import numpy as np
from numpy.typing import ArrayLike

from helpers.arm import Arm
from helpers.explorer.data import Data

RUN_HINT = " Run the cell to move it."  # seen where a notebook is only read


def stub(words: str, spec: Data, name: str = "arm-explorer", figure: str = "") -> str:
    """A live part in HTML, `words` for what reads no more; `figure` is the kind of a small one. The
    same bytes each time."""
    data = json.dumps(spec, separators=(",", ":"), ensure_ascii=False).replace("</", "<\\/")
    kind = f' data-figure="{figure}"' if figure else ""
    script = f'<script type="application/json">{data}</script>'
    return f'<div class="{name}"{kind}><p>{escape(words)}</p>{script}</div>'


def standing(arm: Arm, q: ArrayLike) -> str:
    """Describe the pose of an arm at q, shape (dof,), in a sentence."""
    pairs = zip(arm.variables, np.round(arm.joint_vector(q), 3) + 0.0, strict=True)
    return f"{arm.name} at {', '.join(f'{name} = {value:g}' for name, value in pairs)}."
