"""Test QuickJS, which runs the judge for a student: its answers, threads, late start and limits."""

import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest

from helpers import checks
from helpers.checks import engine
from helpers.inputs import ArmError
from helpers.kinematics import jacobian
from helpers.robots import ELBOW
from tests.cases import QUESTIONS, typed_fields
from tests.conftest import start_quickjs
from tests.node import needs_node
from tests.test_judge import judge_in_python

Q = [0.5, 0.7, -0.4]
J = jacobian(ELBOW, Q).round(4)


@pytest.fixture(autouse=True)
def quickjs(monkeypatch):
    """Ask QuickJS during a test of this file."""
    monkeypatch.setattr(engine, "_start_quickjs", start_quickjs)
    monkeypatch.setattr(engine, "_engines", engine.threading.local())


@needs_node
@pytest.mark.parametrize(
    "case", QUESTIONS[::12], ids=lambda case: f"{case['ask']}, {case['about']}"
)
def test_quickjs_gives_the_verdict_of_node(case, monkeypatch):
    """Almost all other tests ask the judge under Node.js (tests/conftest.py)."""
    in_quickjs = judge_or_refuse(typed_fields(case))
    monkeypatch.undo()
    assert judge_or_refuse(typed_fields(case)) == in_quickjs


def judge_or_refuse(fields):
    try:
        return str(judge_in_python(fields))
    except ArmError as refusal:
        return str(refusal)


def test_import_loads_neither_engine_nor_sympy():
    code = "import sys, helpers.checks; print({'quickjs', 'sympy'} & set(sys.modules))"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout == "set()\n"


def test_threads_use_separate_engines():
    def list_causes(k):
        return checks.compare_jacobian(J if k % 2 else -J, ELBOW, Q).causes

    with ThreadPoolExecutor(4) as pool:
        assert list(pool.map(list_causes, range(8))) == [("J.all signs",), ()] * 4


@pytest.mark.parametrize("limits", [{"_SECONDS": 0.001}, {"_MEMORY": 1_000_000}], ids=str)
def test_engine_recovers_after_exceeding_a_limit(monkeypatch, limits):
    def compare_wrong_jacobian():
        return checks.compare_jacobian(J * [1.7, 0.3, -2] + 1, ELBOW, Q)

    headline = compare_wrong_jacobian().headline
    with monkeypatch.context() as limited:
        limited.setattr(engine, "_engines", engine.threading.local())
        for name, value in limits.items():
            limited.setattr(engine, name, value)
        with pytest.raises(ArmError, match="the judge gave up"):
            compare_wrong_jacobian()
    assert compare_wrong_jacobian().headline == headline


def test_numbers_reach_the_engine_unchanged():
    numbers = np.random.default_rng(3).uniform(-1, 1, 200) * 10.0 ** np.arange(-100, 100)
    found = engine.ask_judge("numbers", mine=numbers.tolist(), what="mine", wanted="numbers")
    assert list(map(float, found["values"])) == numbers.tolist()


def test_nan_is_rejected_before_the_engine():
    with pytest.raises(ValueError, match="Out of range"):
        engine.ask_judge("numbers", mine=[float("nan")], what="mine", wanted="numbers")


def test_crash_of_the_judge_is_not_reported_as_refusal(tmp_path, monkeypatch):
    script = tmp_path / "judge.js"
    script.write_text("const ArmJudge = { ask: (text) => null.length };", "utf-8")
    monkeypatch.setattr(engine, "_SCRIPT", script)
    with pytest.raises(RuntimeError, match=r"the judge has a fault \(TypeError: cannot read"):
        checks.compare_jacobian(J, ELBOW, Q)
