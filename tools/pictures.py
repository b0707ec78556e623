"""A Sphinx extension for the book's drawings: their size is known before they arrive, and on a
narrow screen a drawing of several panels shows one panel a row. Both are read from the SVG that
Matplotlib wrote.
"""

import re
import xml.etree.ElementTree as ET
from collections.abc import Iterator
from functools import cache, reduce
from html import escape
from pathlib import Path

from docutils import nodes
from sphinx.application import Sphinx
from sphinx.environment import BuildEnvironment

SVG = "{http://www.w3.org/2000/svg}"
POINT = {"pt": 4 / 3, "px": 1.0, "": 1.0}
PLACE = re.compile(
    r"translate\(([-\d.]+)[ ,]+([-\d.]+)\)(?: rotate\(([-\d.]+)\))?(?: scale\(([\d.]+))?"
)
DIGEST = re.compile(r"[0-9a-f]{64}\.svg")
NUMBER = re.compile(r"-?\d+(?:\.\d+)?")
Box = tuple[float, float, float, float]  # left, top, right, bottom
# Four panels or more, none wider than this, stand two or three beside each other on a phone, with
# their words at no less than their own size.
SMALL = 170


# The size and the panels of a drawing.


@cache
def drawing(path: Path) -> ET.Element:
    return ET.parse(path).getroot()


def size(root: ET.Element) -> tuple[int, int] | None:
    """The width and height of a drawing in CSS pixels; nothing where it does not say."""
    sides = [re.fullmatch(r"([\d.]+)(pt|px|)", root.get(name, "")) for name in ("width", "height")]
    if None in sides:
        return None
    width, height = (round(float(side[1]) * POINT[side[2]]) for side in sides)
    return width, height


def panels(root: ET.Element) -> list[Box]:
    """The boxes of a figure's panels in the order of reading; nothing where they stand one above
    the other already."""
    figure = next((g for g in root.iter(f"{SVG}g") if g.get("id") == "figure_1"), None)
    if figure is None:
        return []
    parts, clips = figure[1:], _clips(root)
    bars = [box for part in parts if _is_bar(part, clips) and (box := _box(part, clips))]
    found = _with_bars(_united(_axes(parts, clips)), bars)
    rows: list[list[Box]] = []
    for box in sorted(found, key=lambda box: box[1]):
        if rows and box[1] < (rows[-1][0][1] + rows[-1][0][3]) / 2:
            rows[-1].append(box)
        else:
            rows.append([box])
    if all(len(row) == 1 for row in rows):
        return []
    return [box for row in rows for box in sorted(row)]


def _clips(root: ET.Element) -> dict[str, Box]:
    """The rectangles to which a drawing's parts are cut, by the words that ask for it, and the
    boxes of its markers, which are drawn once and put in many places."""
    marks = (path for defs in root.iter(f"{SVG}defs") for path in defs.iter(f"{SVG}path"))
    boxes = {f"#{path.get('id')}": box for path in marks if (box := _box(path, {}))}
    rectangles = ((clip.get("id"), clip.find(f"{SVG}rect")) for clip in root.iter(f"{SVG}clipPath"))
    sides = {
        name: [float(rect.get(side)) for side in ("x", "y", "width", "height")]
        for name, rect in rectangles
        if rect is not None
    }
    cuts = {f"url(#{name})": (x, y, x + w, y + h) for name, (x, y, w, h) in sides.items()}
    return boxes | cuts


def _is_bar(part: ET.Element, clips: dict[str, Box]) -> bool:
    """Whether an axes is a colour bar: what it cuts its content to is far higher than wide."""
    cuts = (clips.get(child.get("clip-path", "")) for child in part.iter())
    return any(cut and cut[2] - cut[0] < 0.15 * (cut[3] - cut[1]) for cut in cuts)


def _axes(parts: list[ET.Element], clips: dict[str, Box]) -> list[Box]:
    """A box for each axes, with the walls that are drawn before those in space, and one for each
    legend or title of all."""
    boxes: list[Box] = []
    walls: list[Box] = []
    for part in parts:
        if box := _box(part, clips):
            walls.append(box)
        if walls and part.get("id", "").startswith("axes_"):
            boxes.append(reduce(_join, walls))
            walls = []
    return boxes + walls


def _united(boxes: list[Box]) -> list[Box]:
    """Boxes joined with those that they mostly cover: the walls, the lines and the labels of one
    panel."""
    for k, one in enumerate(boxes):
        for other in boxes[k + 1 :]:
            if _shared(one, other) > 0.2 * min(_area(one), _area(other)):
                rest = [box for box in boxes if box not in (one, other)]
                return _united([*rest, _join(one, other)])
    return boxes


def _with_bars(boxes: list[Box], bars: list[Box]) -> list[Box]:
    """Colour bars joined with the panel on their left, where they are not yet."""
    for bar in bars:
        alone = next((box for box in boxes if _shared(bar, box) > 0.9 * _area(box)), None)
        left = [box for box in boxes if box[0] < bar[0] and box[1] < bar[3] and bar[1] < box[3]]
        if alone and left:
            panel = max(left, key=lambda box: box[2])
            boxes = [box for box in boxes if box not in (alone, panel)] + [_join(panel, bar)]
    return boxes


def _join(one: Box, other: Box) -> Box:
    return (*map(min, one[:2], other[:2]), *map(max, one[2:], other[2:]))


def _shared(one: Box, other: Box) -> float:
    wide = min(one[2], other[2]) - max(one[0], other[0])
    high = min(one[3], other[3]) - max(one[1], other[1])
    return max(wide, 0) * max(high, 0)


def _area(box: Box) -> float:
    return max((box[2] - box[0]) * (box[3] - box[1]), 1e-6)


def _box(part: ET.Element, clips: dict[str, Box]) -> Box | None:
    points = list(_points(part, clips))
    if not points:
        return None
    x, y = zip(*points, strict=True)
    return min(x), min(y), max(x), max(y)


def _points(part: ET.Element, clips: dict[str, Box]) -> Iterator[tuple[float, float]]:
    """Points that span what a part draws, as far as it is not cut off; what is only defined or
    invisible does not count."""
    if part.tag == f"{SVG}defs" or part.get("style") == "fill: none":
        return
    points = _drawn(part, clips)
    if clip := clips.get(part.get("clip-path", "")):
        left, top, right, bottom = clip
        points = ((min(max(x, left), right), min(max(y, top), bottom)) for x, y in points)
    yield from points


def _drawn(part: ET.Element, clips: dict[str, Box]) -> Iterator[tuple[float, float]]:
    if place := PLACE.match(part.get("transform", "")):
        yield from _text(part, *(float(number or 0) for number in place.groups()))
    elif part.tag == f"{SVG}path":
        numbers = [float(number) for number in NUMBER.findall(part.get("d", ""))]
        yield from zip(numbers[::2], numbers[1::2], strict=False)
    elif part.get("x"):
        x, y = float(part.get("x")), float(part.get("y"))
        left, top, right, bottom = clips.get(part.get("href", ""), (0, 0, 0, 0))
        yield from ((x + left, y + top), (x + right, y + bottom))
    else:
        for child in part:
            yield from _points(child, clips)


def _text(part, x: float, y: float, turn: float, scale: float) -> Iterator[tuple[float, float]]:
    """The corners of a line of letters, which Matplotlib draws 100 units high and places one by
    one."""
    last = [PLACE.match(letter.get("transform", "")) for letter in part.iter(f"{SVG}use")]
    long = scale * (max((float(place[1]) for place in last if place), default=0) + 65)
    high = 80 * scale
    if abs(turn) > 45:
        yield from ((x - high, y - long), (x + 0.3 * high, y))
    else:
        yield from ((x, y - high), (x + long, y + 0.3 * high))


# On the page.


def visit_image(translator, node) -> None:
    """A drawing whole and in panels, with one name for all; what is not shown is not fetched."""
    builder = translator.builder
    name = builder.images.get(node["uri"], "")
    path = Path(builder.srcdir, node["uri"])
    if not name.endswith(".svg"):
        return type(translator).visit_image(translator, node)
    root = drawing(path)
    boxes = panels(root)
    widest = max((box[2] - box[0] for box in boxes), default=0)
    small = len(boxes) > 3 and widest <= SMALL
    kinds = [*(["many"] if boxes else []), *(["small"] if small else [])]
    classes = " ".join(["picture", *kinds, *node["classes"]])
    style = f' style="width: {node["width"]}"' if "width" in node else ""
    words = escape(node.get("alt", ""))
    picture = f'<img src="{builder.imgpath}/{name}" alt="" loading="lazy"'
    windows = "".join(_cut(f"{picture}>", box, root, widest) for box in boxes)
    sides = size(root)
    room = f' width="{sides[0]}" height="{sides[1]}"' if sides else ""
    translator.body.append(
        f'<span class="{classes}"{style} role="img" aria-label="{words}">'
        f"{picture}{room}>{windows}</span>"
    )
    raise nodes.SkipNode


def _cut(picture: str, box: Box, root: ET.Element, widest: float) -> str:
    """The whole drawing in a window that shows one panel of it; how wide it is of the widest keeps
    small ones at one scale."""
    left, top, wide, high = box[0] - 3, box[1] - 3, box[2] - box[0] + 6, box[3] - box[1] + 6
    whole = [float(number) for number in root.get("viewBox").split()][2:]
    share = f"--share: {wide / (widest + 6):.1%}"
    place = f"--wide: {whole[0] / wide:.1%}; --left: {-left / wide:.1%}; --top: {-top / high:.1%}"
    most = f"aspect-ratio: {wide:.0f} / {high:.0f}; max-width: {1.5 * wide * POINT['pt']:.0f}px"
    return f'<span class="panel" style="{most}; {share}; {place}">{picture}</span>'


def short_names(_app: Sphinx, env: BuildEnvironment) -> None:
    """MyST-NB calls a drawing by 64 digits, and a page does so four times or more."""
    for source, (pages, name) in env.images.items():
        if DIGEST.fullmatch(name):
            env.images[source] = pages, name[-12:]


def setup(app: Sphinx) -> dict[str, bool]:
    app.add_node(nodes.image, override=True, html=(visit_image, lambda *_: None))
    app.connect("env-updated", short_names)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
