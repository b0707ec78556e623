"""The judge, which is JavaScript (judge/, here bundled into judge.js), asked from Python.

A question and its answer are JSON text, which keeps every bit of a number. QuickJS runs the script;
in Pyodide, where QuickJS is not to be had, the browser does (that was not run).
"""

import json
import sys
import threading
from collections.abc import Callable
from pathlib import Path
from typing import Any

from helpers.checks.report import advised
from helpers.inputs import ArmError

_SCRIPT = Path(__file__).with_name("judge.js")
_MEMORY = 512 << 20  # bytes
_SECONDS = 120  # of processor time for a question; one that needs more gets no verdict
_engines = threading.local()  # a context belongs to one thread


def asked(topic: str, **question: Any) -> Any:
    """What the judge answers; raises ArmError, in its words, where it refuses."""
    if not hasattr(_engines, "ask"):
        _engines.ask = _started()
    answer = json.loads(_engines.ask(json.dumps({"topic": topic, **question}, allow_nan=False)))
    if "refused" in answer:
        raise ArmError(". ".join([answer["refused"], *map(advised, answer["advice"])]))
    return answer["answer"]


def say(key: str, **fields: object) -> str:
    """A sentence of the judge's with its fields put in."""
    return asked("words", key=key, fields=fields)


def _started() -> Callable[[str], str]:
    script = _SCRIPT.read_text(encoding="utf-8")
    return _in_browser(script) if sys.platform == "emscripten" else _in_quickjs(script)


def _in_quickjs(script: str) -> Callable[[str], str]:
    import quickjs

    context = quickjs.Context()
    context.eval(script)
    ask = context.eval("(text) => ArmJudge.ask(text)")
    context.set_memory_limit(_MEMORY)
    context.set_time_limit(_SECONDS)

    def limited(text: str) -> str:
        try:
            return ask(text)
        except (quickjs.JSException, quickjs.StackOverflow) as problem:
            del _engines.ask  # what broke off half-way is not asked again
            first = str(problem).partition("\n")[0]
            raise ArmError(
                f"the judge gave up ({first}); expected a question that takes it at most"
                f" {_SECONDS} s and {_MEMORY >> 20} MB"
            ) from problem

    return limited


def _in_browser(script: str) -> Callable[[str], str]:
    import js  # type: ignore[import-not-found]

    return js.Function(f"{script}; return (text) => ArmJudge.ask(text);")()
