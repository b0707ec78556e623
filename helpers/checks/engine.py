"""Ask the judge, which is JavaScript (judge/, bundled into judge.js), from Python.

Question and answer are JSON text, which keeps every bit of a number. QuickJS runs the script.
Pyodide has no QuickJS; there the browser runs it (not tested).
"""

import json
import sys
import threading
from collections.abc import Callable
from pathlib import Path
from typing import Any

from helpers.checks.marked_text import UnreadNumberError, make_marked_text
from helpers.checks.verdict import format_advice
from helpers.inputs import ArmError

_SCRIPT = Path(__file__).with_name("judge.js")
_MEMORY = 512 << 20  # bytes
_SECONDS = 120  # processor time for one question
_engines = threading.local()  # each thread needs its own context


def ask_judge(topic: str, **question: Any) -> Any:
    """Return the judge's answer to a question.

    Raises ArmError with the judge's message if it refuses, and RuntimeError if the judge crashes.
    """
    if not hasattr(_engines, "ask"):
        _engines.ask = _start_engine()
    answer = json.loads(_engines.ask(json.dumps({"topic": topic, **question}, allow_nan=False)))
    if "refused" in answer:
        message = ". ".join([answer["refused"], *map(format_advice, answer["advice"])])
        if "marked" in answer:
            raise UnreadNumberError(message, make_marked_text(answer["marked"]))
        raise ArmError(message)
    return answer["answer"]


def _start_engine() -> Callable[[str], str]:
    script = _SCRIPT.read_text(encoding="utf-8")
    return _start_in_browser(script) if sys.platform == "emscripten" else _start_quickjs(script)


def _start_quickjs(script: str) -> Callable[[str], str]:
    """Start QuickJS with limits on memory and time, and return the function that asks it."""
    import quickjs

    context = quickjs.Context()
    context.eval(script)
    ask = context.eval("(text) => ArmJudge.ask(text)")
    context.set_memory_limit(_MEMORY)
    context.set_time_limit(_SECONDS)

    def ask_within_limits(text: str) -> str:
        try:
            return ask(text)
        except quickjs.JSException as problem:
            # An interrupted engine may be inconsistent. The next question starts a new engine.
            del _engines.ask
            first = str(problem).partition("\n")[0]
            # Beyond its limits of time and memory, QuickJS raises InternalError, or null if no
            # memory is left for an error.
            is_limit = first.startswith(("InternalError", "null"))
            if not is_limit and not isinstance(problem, quickjs.StackOverflow):
                raise RuntimeError(f"the judge has a fault ({first}); report it") from problem
            raise ArmError(
                f"the judge gave up ({first}); expected a question that takes it at most"
                f" {_SECONDS} s and {_MEMORY >> 20} MB"
            ) from problem

    return ask_within_limits


def _start_in_browser(script: str) -> Callable[[str], str]:
    import js  # type: ignore[import-not-found]

    return js.Function(f"{script}; return (text) => ArmJudge.ask(text);")()
