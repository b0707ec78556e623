"""Ask scripts under Node.js, one line of JSON at a time.

A started Node.js is kept, since it takes longer to start than to answer.
"""

import atexit
import json
import os
import shutil
import subprocess
from functools import cache
from pathlib import Path
from typing import Any

import pytest

NODE = shutil.which("node")
needs_node = pytest.mark.skipif(
    NODE is None and not os.environ.get("CI"), reason="Node.js is not installed"
)


def ask_node(script: str, question: dict) -> Any:
    """Return the answer of a script in tests/ to a question."""
    process = _start_node(script, os.getpid())
    process.stdin.write(json.dumps(question) + "\n")
    process.stdin.flush()
    line = process.stdout.readline()
    if not line:
        _start_node.cache_clear()
        raise AssertionError(f"Node.js ended in {script} on the question {str(question)[:300]}")
    return json.loads(line)


@cache
def _start_node(script: str, pid: int) -> subprocess.Popen:
    """Start Node.js once per script and process.

    `pid` is part of the cache's key: two processes on one pipe would take each other's answers.
    """
    assert NODE, "Node.js is not installed"
    command = [NODE, str(Path(__file__).with_name(script))]
    pipe = subprocess.PIPE
    process = subprocess.Popen(command, stdin=pipe, stdout=pipe, text=True, encoding="utf-8")
    atexit.register(lambda: (process.kill(), process.wait()))
    return process
