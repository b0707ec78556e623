"""A Sphinx extension for the book's drawings: their size is known before they arrive, and on a
narrow screen a drawing of several panels shows one panel a row. The drawing itself says both:
`helpers/plotting/style.py` writes each panel into it as a view.
"""

import re
import xml.etree.ElementTree as ET
from html import escape
from pathlib import Path

from docutils import nodes
from sphinx.application import Sphinx
from sphinx.environment import BuildEnvironment

POINT = {"pt": 4 / 3, "px": 1.0, "": 1.0}
DIGEST = re.compile(r"[0-9a-f]{64}\.svg")
# Four panels or more, none wider than this, stand two or three beside each other on a phone, with
# their words at no less than their own size.
SMALL = 170


def size(root: ET.Element) -> tuple[int, int] | None:
    """The width and height of a drawing in CSS pixels; nothing where it does not say."""
    sides = [re.fullmatch(r"([\d.]+)(pt|px|)", root.get(name, "")) for name in ("width", "height")]
    if None in sides:
        return None
    width, height = (round(float(side[1]) * POINT[side[2]]) for side in sides)
    return width, height


def views(root: ET.Element) -> dict[str, tuple[int, int]]:
    """The panels of a drawing by name, with their widths and heights in its points."""
    found = {view.get("id"): view.get("viewBox").split() for view in root.iterfind("{*}view")}
    return {name: (int(wide), int(high)) for name, (_, _, wide, high) in found.items()}


def visit_image(translator, node) -> None:
    """A drawing whole and in panels, with one name for all; what is not shown is not fetched."""
    builder = translator.builder
    name = builder.images.get(node["uri"], "")
    if not name.endswith(".svg"):
        return type(translator).visit_image(translator, node)
    root = ET.parse(Path(builder.srcdir, node["uri"])).getroot()
    panels = views(root)
    widest = max((wide for wide, _ in panels.values()), default=0)
    kinds = ["many"] * (len(panels) > 1) + ["small"] * (len(panels) > 3 and widest <= SMALL)
    classes = " ".join(["picture", *kinds, *node["classes"]])
    style = f' style="width: {node["width"]}"' if "width" in node else ""
    source = f'<img alt="" loading="lazy" src="{builder.imgpath}/{name}'
    sides = size(root)
    room = f' width="{sides[0]}" height="{sides[1]}"' if sides else ""
    alone = "".join(_panel(source, panel, *panels[panel], widest) for panel in panels)
    translator.body.append(
        f'<span class="{classes}"{style} role="img" aria-label="{escape(node.get("alt", ""))}">'
        f'{source}"{room}>{alone}</span>'
    )
    raise nodes.SkipNode


def _panel(source: str, panel: str, wide: int, high: int, widest: int) -> str:
    """One panel alone; how wide it is of the widest keeps small ones at one scale."""
    most = f"max-width: {1.5 * wide * POINT['pt']:.0f}px; --share: {wide / widest:.1%}"
    return f'{source}#{panel}" class="panel" style="aspect-ratio: {wide} / {high}; {most}">'


def short_names(_app: Sphinx, env: BuildEnvironment) -> None:
    """MyST-NB calls a drawing by 64 digits, and a page does so four times or more."""
    for source, (pages, name) in env.images.items():
        if DIGEST.fullmatch(name):
            env.images[source] = pages, name[-12:]


def setup(app: Sphinx) -> dict[str, bool]:
    app.add_node(nodes.image, override=True, html=(visit_image, lambda *_: None))
    app.connect("env-updated", short_names)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
