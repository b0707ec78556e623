"""A Sphinx extension that writes the book's drawings as HTML with a known size.

On a narrow screen a drawing of several panels shows one panel a row: `helpers/plotting/style.py`
stores each panel's box in the SVG as a `<view>`.
"""

import re
import xml.etree.ElementTree as ET
from html import escape
from pathlib import Path

from docutils import nodes
from sphinx.application import Sphinx
from sphinx.environment import BuildEnvironment

PIXELS_PER_UNIT = {"pt": 4 / 3, "px": 1.0, "": 1.0}
HASHED_NAME = re.compile(r"[0-9a-f]{64}\.svg")
# On a phone, four or more panels are arranged in rows of two or three if none is wider than this
# (pt), so that their text is at least as large as the page's.
SMALL_PANEL_WIDTH = 170


def svg_size(svg: ET.Element) -> tuple[int, int] | None:
    """Return an SVG's width and height in CSS pixels, or None if it does not give them."""
    sides = [re.fullmatch(r"([\d.]+)(pt|px|)", svg.get(name, "")) for name in ("width", "height")]
    if None in sides:
        return None
    width, height = (round(float(side[1]) * PIXELS_PER_UNIT[side[2]]) for side in sides)
    return width, height


def panel_sizes(svg: ET.Element) -> dict[str, tuple[int, int]]:
    """Return the width and height of each panel in points, by the name of its view."""
    boxes = {view.get("id"): view.get("viewBox").split() for view in svg.iterfind("{*}view")}
    return {name: (int(width), int(height)) for name, (_, _, width, height) in boxes.items()}


def visit_image(translator, node) -> None:
    """Write a drawing as a whole and panel by panel, with a single text alternative.

    The style sheet hides one of the two forms, and browsers do not load hidden lazy images.
    """
    builder = translator.builder
    name = builder.images.get(node["uri"], "")
    if not name.endswith(".svg"):
        return type(translator).visit_image(translator, node)
    svg = ET.parse(Path(builder.srcdir, node["uri"])).getroot()
    panels = panel_sizes(svg)
    max_width = max((width for width, _ in panels.values()), default=0)
    are_small = len(panels) > 3 and max_width <= SMALL_PANEL_WIDTH
    layout_classes = ["many"] * (len(panels) > 1) + ["small"] * are_small
    classes = " ".join(["picture", *layout_classes, *node["classes"]])
    style = f' style="width: {node["width"]}"' if "width" in node else ""
    image_start = f'<img alt="" loading="lazy" src="{builder.imgpath}/{name}'
    size = svg_size(svg)
    size_attributes = f' width="{size[0]}" height="{size[1]}"' if size else ""
    panel_images = "".join(
        _panel_image(image_start, panel, *panels[panel], max_width) for panel in panels
    )
    translator.body.append(
        f'<span class="{classes}"{style} role="img" aria-label="{escape(node.get("alt", ""))}">'
        f'{image_start}"{size_attributes}>{panel_images}</span>'
    )
    raise nodes.SkipNode


def _panel_image(image_start: str, panel: str, width: int, height: int, max_width: int) -> str:
    """Return an image of a panel, scaled by its width relative to the widest panel."""
    limit = 1.5 * width * PIXELS_PER_UNIT["pt"]
    style = f"aspect-ratio: {width} / {height}; max-width: {limit:.0f}px; "
    return f'{image_start}#{panel}" class="panel" style="{style}--share: {width / max_width:.1%}">'


def shorten_names(_app: Sphinx, env: BuildEnvironment) -> None:
    """Cut MyST-NB's 64-digit names of drawings to 8 digits, since pages repeat them often."""
    for source, (pages, name) in env.images.items():
        if HASHED_NAME.fullmatch(name):
            env.images[source] = pages, name[-12:]


def setup(app: Sphinx) -> dict[str, bool]:
    app.add_node(nodes.image, override=True, html=(visit_image, lambda *_: None))
    app.connect("env-updated", shorten_names)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
