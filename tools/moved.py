"""A Sphinx extension that links old addresses to the new places of their sections.

`book/old_anchors.json` lists the anchors of each page of the fifth edition. A part that now stands
on a page in `exercises` or `further` is found there by its anchor. What has another anchor today is
in `book/moved_anchors.json`: "page" or "page#anchor" of before, and where it leads.

A page ends in a line for each part that left it, which shows only if the address names that part;
`book.js` then goes to the new place. A page that has gone is written as a page of such lines.
"""

import json
from collections.abc import Iterator
from html import escape
from pathlib import Path
from typing import Any

from docutils import nodes
from sphinx.application import Sphinx
from sphinx.environment import BuildEnvironment
from sphinx.util import logging
from sphinx.util.osutil import relative_uri

from tools.numbering import FOLDERS

LOGGER = logging.getLogger(__name__)
Targets = dict[str, str]  # new "page#anchor" by old anchor


def record_ids(app: Sphinx, doctree: nodes.document) -> None:
    """Store the ids of a page, which links and old addresses may name."""
    ids = {name for node in doctree.findall(nodes.Element) for name in node.get("ids", ())}
    app.env.metadata[app.env.docname]["ids"] = ids


def find_targets(
    old_anchors: dict[str, list[str]], moved: Targets, ids: dict[str, set[str]]
) -> dict[str, Targets]:
    """Find the new place of each anchor that is missing on its page.

    Args:
        old_anchors: the anchors of before by page.
        moved: the table of `book/moved_anchors.json`.
        ids: the ids of today by page.

    Returns:
        The targets by page and anchor; the target is empty if nothing says where the part is.
    """
    beside = [page for page in ids if page.partition("/")[0] in FOLDERS]
    targets: dict[str, Targets] = {}
    for page, anchors in old_anchors.items():
        for anchor in anchors:
            if anchor in ids.get(page, ()):
                continue
            pages = [name for name in beside if anchor in ids[name]]
            own = f"exercises/{page.partition('_')[2]}"  # of chapter 05_inverse_kinematics
            pages = [own] if own in pages else pages
            found = f"{pages[0]}#{anchor}" if len(pages) == 1 else ""
            target = moved.get(f"{page}#{anchor}") or found or moved.get(page, "")
            targets.setdefault(page, {})[anchor] = target
    return targets


def read_json(app: Sphinx, name: str) -> Any:
    return json.loads(Path(app.srcdir, name).read_text(encoding="utf-8"))


def update_targets(app: Sphinx, env: BuildEnvironment) -> list[str]:
    """Find all targets, and return the pages whose links have changed since the last build."""
    ids = {page: env.metadata[page].get("ids", set()) for page in env.found_docs}
    # Leave out pages whose ids are generated from docstrings, works and arms.
    old = {
        page: anchors
        for page, anchors in read_json(app, "old_anchors.json").items()
        if page not in ("api", "references") and not page.startswith("answers/")
    }
    targets = find_targets(old, read_json(app, "moved_anchors.json"), ids)
    for page, by_anchor in targets.items():
        for anchor, target in by_anchor.items():
            name, _, part = target.partition("#")
            if name not in ids or (part and part not in ids[name]):
                hint = "give the place of today in book/moved_anchors.json"
                LOGGER.warning("%s#%s leads nowhere (%r): %s", page, anchor, target, hint)
    before = getattr(env, "moved_targets", {})
    env.moved_targets = targets
    return [page for page in env.found_docs if targets.get(page) != before.get(page)]


def format_lines(env: BuildEnvironment, page: str, targets: Targets) -> str:
    """Return links to the sections that have left a page, as HTML."""
    items = []
    for anchor, target in targets.items():
        if not target:  # the build has already warned
            continue
        name, _, part = target.partition("#")
        address = relative_uri(f"{page}.html", f"{name}.html") + (part and f"#{part}")
        title = escape(env.titles[name].astext())
        items.append(
            f'<li id="{escape(anchor)}">This part now stands in '
            f'<a href="{escape(address)}">{title}</a>.</li>'
        )
    return f'<ul class="moved">{"".join(items)}</ul>'


def add_lines(app: Sphinx, doctree: nodes.document, page: str) -> None:
    """Add links to the sections that have left a page at its end."""
    if targets := app.env.moved_targets.get(page):
        doctree += nodes.raw("", format_lines(app.env, page, targets), format="html")


def write_gone_pages(app: Sphinx) -> Iterator[tuple[str, dict[str, str], str]]:
    """Yield a page for each removed page."""
    moved = read_json(app, "moved_anchors.json")
    for page in (name for name in moved if "#" not in name):
        home = relative_uri(f"{page}.html", f"{moved[page].partition('#')[0]}.html")
        title = escape(app.env.titles[moved[page].partition("#")[0]].astext())
        lines = format_lines(app.env, page, app.env.moved_targets.get(page, {}))
        body = (
            f'<h1>This page has moved</h1><p><a class="moved" href="{home}">{title}</a></p>{lines}'
        )
        description = f'<meta name="description" content="This page of the book now is {title}.">'
        context = {"title": "This page has moved", "body": body, "metatags": description}
        yield page, context, "layout.html"


def setup(app: Sphinx) -> dict[str, bool]:
    app.connect("doctree-read", record_ids, priority=950)
    app.connect("env-updated", update_targets)
    app.connect("doctree-resolved", add_lines, priority=950)
    app.connect("html-collect-pages", write_gone_pages)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
