"""Run notebooks again in this process's setting, and say as JSON where they differ from what is
stored.

Everything is imported once and each notebook runs in a fork: a Jupyter kernel for each would take
three times as long.
"""

import json
import os
import re
import sys
from importlib import import_module
from multiprocessing import get_context
from pathlib import Path
from typing import Any, NamedTuple

import nbformat
import numpy as np
from IPython.core.displayhook import DisplayHook
from IPython.core.interactiveshell import InteractiveShell
from IPython.utils.capture import capture_output
from traitlets.config import Config

from tools.rounding import NOISE, Products, install

WIDGET = "application/vnd.jupyter.widget-view+json"  # names a process's own objects
IDS = re.compile(r"\bf[0-9a-f]{8}-(?=\d)")


class Run(NamedTuple):
    """What became of one notebook: the cells that changed, counted from 0 over all cells, and how
    much of its tolerance each check used, by (cell, number of the call, label)."""

    changed: list[tuple[int, str]]
    used: list[tuple[tuple[int, int, str], float]]


def main() -> None:
    """A seed, 0 for no noise, and notebooks: their runs, by path."""
    seed, *notebooks = sys.argv[1:]
    print(json.dumps(run_all(notebooks, int(seed))))


def run_all(notebooks: list[str], seed: int) -> dict[str, Run]:
    """Each notebook in a fork of this process, so that none sees what another one did."""
    history = Config(HistoryManager={"enabled": False})
    InteractiveShell.instance(config=history, displayhook_class=Shown)  # before Matplotlib's import
    if seed:
        install()
    for module in ("matplotlib.pyplot", "sympy", "helpers.inverse", "helpers.motion"):
        import_module(module)
    sys.modules["matplotlib.pyplot"].uninstall_repl_displayhook()  # draws each figure for a screen
    return {path: _forked(path, seed) for path in notebooks}


def _forked(path: str, seed: int) -> Run:
    fork = get_context("fork")
    end, other_end = fork.Pipe(duplex=False)
    process = fork.Process(target=lambda: other_end.send(run(path, seed)))
    process.start()
    other_end.close()  # so that a process that dies is noticed here
    found = end.recv()
    process.join()
    return found


class Shown(DisplayHook):
    """Publishes a cell's last value as `display` would, without a prompt."""

    def write_output_prompt(self) -> None: ...

    def write_format_data(self, format_dict: dict, md_dict: dict | None = None) -> None:
        self.shell.display_pub.publish(format_dict, md_dict)

    def finish_displayhook(self) -> None: ...


def run(path: str, seed: int) -> Run:
    """One notebook, from top to bottom."""
    shell = InteractiveShell.instance()
    os.chdir(Path(path).parent)
    if seed:
        NOISE.reseed(seed)
        shell.ast_transformers.append(Products())
    used: list = []
    _record_checks(used)
    changed = []
    for number, cell in enumerate(nbformat.read(path, as_version=4).cells):
        if cell.cell_type == "code":
            first = len(used)
            what = difference(_stored(cell), _executed(shell, cell.source))
            used[first:] = [((number, i, w), s) for i, (w, s) in enumerate(used[first:])]
            changed += [(number, what)] if what else []
    return Run(changed, used)


def _record_checks(used: list) -> None:
    """Have every `check` leave the share of the tolerance that it used."""
    import helpers.checks as checks

    check = checks.check

    def recorded(
        label: str, actual: Any, expected: Any, tolerance: float = 0.0, **how: Any
    ) -> None:
        check(label, actual, expected, tolerance, **how)
        if tolerance:
            used.append((label, share(actual, expected, tolerance)))

    checks.check = recorded


def share(actual: Any, expected: Any, tolerance: float) -> float:
    """How much of the tolerance a check uses, from 0 to 1."""
    apart = np.abs(np.subtract(actual, expected, dtype=float))
    return float(apart.max(initial=0.0)) / tolerance


def _executed(shell: Any, source: str) -> list[Any]:
    """A cell's outputs: its text, and the data of each display."""
    with capture_output() as caught:
        result = shell.run_cell(source, store_history=True)
    if error := result.error_before_exec or result.error_in_exec:
        return [f"{error!r}"]
    shown = [words(output.data) for output in caught.outputs]
    return [caught.stdout + caught.stderr, *shown]


def _stored(cell: Any) -> list[Any]:
    text = "".join(output.get("text", "") for output in cell.outputs)
    return [text, *(words(output["data"]) for output in cell.outputs if "data" in output)]


def words(data: dict[str, Any]) -> dict[str, str]:
    """What is said in words, formulas and pictures; a picture's ids are drawn from all of it."""
    texts = {kind: "".join(data[kind]).strip() for kind in sorted(data) if kind != WIDGET}
    return {kind: IDS.sub("", text) for kind, text in texts.items()}


def difference(stored: list[Any], executed: list[Any]) -> str:
    """Nothing if both say the same, else the first words that differ."""
    before, after = (json.dumps(said, ensure_ascii=False) for said in (stored, executed))
    if before == after:
        return ""
    at = next((i for i, pair in enumerate(zip(before, after)) if pair[0] != pair[1]), 0)  # noqa: B905
    return f"…{before[max(at - 30, 0) : at + 30]}… becomes …{after[max(at - 30, 0) : at + 30]}…"
