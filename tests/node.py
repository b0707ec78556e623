"""Ask scripts under Node.js, one line of JSON at a time.

A started Node.js is kept, since it takes longer to start than to answer. The tests also ask the
judge's bundle there in place of QuickJS, which takes ten times as long for the same answers.
"""

import atexit
import json
import os
import shutil
import subprocess
import threading
from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import Any

import pytest

NODE = shutil.which("node")
needs_node = pytest.mark.skipif(
    NODE is None and not os.environ.get("CI"), reason="Node.js is not installed"
)
PACKAGES = Path(__file__).parents[1] / "node_modules"
_skip_without_packages = pytest.mark.skipif(
    not PACKAGES.exists(), reason="the packages of package.json are not installed: npm ci"
)


def needs_packages(test: Callable) -> Callable:
    """Skip a test if `npm ci` has not run. `make lint` runs `npm ci` and these tests."""
    return pytest.mark.npm(needs_node(_skip_without_packages(test)))


def ask_node(script: str, question: dict) -> Any:
    """Return the answer of a script in tests/ to a question."""
    return json.loads(_exchange_lines(script, json.dumps(question)))


def ask_judge_bundle(question: str) -> str:
    """Return the answer of helpers/checks/judge.js to a question, both as JSON text.

    Raises AssertionError with JavaScript's stack if the bundle crashes.
    """
    answer = _exchange_lines("judge_bundle.mjs", question)
    if answer.startswith('{"crash"'):
        raise AssertionError(f"{json.loads(answer)['crash']}\nThe question: {question[:300]}")
    return answer


def _exchange_lines(script: str, question: str) -> str:
    """Send a script one line and return the line that it answers."""
    process = _start_node(script, os.getpid(), threading.get_ident())
    process.stdin.write(f"{question}\n")
    process.stdin.flush()
    line = process.stdout.readline()
    if not line:
        _start_node.cache_clear()
        raise AssertionError(f"Node.js ended in {script} on the question {question[:300]}")
    return line


@cache
def _start_node(script: str, process_id: int, thread_id: int) -> subprocess.Popen:
    """Start Node.js once per script, process and thread; a shared pipe would mix answers."""
    assert NODE, "Node.js is not installed"
    command = [NODE, str(Path(__file__).with_name(script))]
    pipe = subprocess.PIPE
    process = subprocess.Popen(command, stdin=pipe, stdout=pipe, text=True, encoding="utf-8")
    atexit.register(lambda: (process.kill(), process.wait()))
    return process
