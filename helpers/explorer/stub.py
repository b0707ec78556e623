"""Write live figures as HTML with their data, from which the page's script builds them.

When the book is built, the same script writes their still form into this HTML (tools/stills.py).
"""

from __future__ import annotations

import json
from html import escape

import numpy as np
from numpy.typing import ArrayLike

from helpers.arm import Arm
from helpers.explorer.data import Data

RUN_HINT = " Run the cell to move it."  # shown if no kernel runs


def live_html(text: str, spec: Data, class_name: str = "arm-explorer", figure: str = "") -> str:
    """Return a live figure as HTML.

    Equal arguments give equal bytes.

    Args:
        text: The sentence shown where no script runs.
        spec: The data that the page's script needs.
        class_name: Class of the element; the script looks for "arm-explorer".
        figure: The kind of a small figure, or "" for an explorer.
    """
    data = json.dumps(spec, separators=(",", ":"), ensure_ascii=False).replace("</", "<\\/")
    kind = f' data-figure="{figure}"' if figure else ""
    script = f'<script type="application/json">{data}</script>'
    return f'<div class="{class_name}"{kind}><p>{escape(text)}</p>{script}</div>'


def describe_configuration(arm: Arm, q: ArrayLike) -> str:
    """Describe an arm and its configuration q, shape (dof,), in a sentence."""
    pairs = zip(arm.variables, np.round(arm.joint_vector(q), 3) + 0.0, strict=True)
    return f"{arm.name} at {', '.join(f'{name} = {value:g}' for name, value in pairs)}."
