"""Test recorded programs: they give the formula's values without redundant steps."""

import operator
import threading
from functools import partial

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from helpers.kinematics import jacobian
from helpers.program import record_program
from tests.laws import ALL_ARMS, arm_id, joint_vectors

OPERATIONS = (operator.add, operator.sub, operator.mul, lambda x, y: -x)
CONSTANTS = (0.0, 1.0, -1.0, -0.0, 0.5, -0.5, 3.0)

lines = st.lists(
    st.tuples(st.sampled_from(OPERATIONS), st.integers(0, 99), st.integers(0, 99)),
    min_size=1,
    max_size=40,
)


def run_lines(lines, *inputs):
    """Run a program line by line and return the value of every line."""
    values = [*inputs, *CONSTANTS]
    for operation, first, second in lines:
        values.append(operation(values[first % len(values)], values[second % len(values)]))
    return values


def rows_of(program, inputs):
    batch = np.shape(inputs)[1]
    return program.run_on_rows(list(inputs), np.full((program.rows, batch), np.nan)).copy()


@settings(max_examples=200)
@given(lines=lines, seed=st.integers(0, 99))
def test_recorded_program_matches_formula(lines, seed):
    inputs = np.random.default_rng(seed).uniform(-1, 1, (3, 5))
    program = record_program(partial(run_lines, lines), 3)
    expected = np.array([run_lines(lines, *column) for column in inputs.T]).T
    np.testing.assert_allclose(rows_of(program, inputs), expected, rtol=1e-12, atol=1e-12)
    one = program.run_on_floats(inputs[:, 0].tolist())
    np.testing.assert_allclose(one, expected[:, 0], rtol=1e-12, atol=1e-12)


@pytest.mark.parametrize(
    ("compute", "steps"),
    [
        (lambda x, y: [0.0 * x + 1.0 * y - 0.0], 0),
        (lambda x, y: [x - x, y * 0.0 + 2.0, y], 0),
        (lambda x, y: [x * y + 1.0, 1.0 + y * x], 2),
        (lambda x, y: [(-x) * y + (-y) * (-x)], 1),
        (lambda x, y: [x * y, -(y * x)], 2),
        (lambda x, y: [0.5 * x * y, -0.5 * x * y], 3),
        (lambda x, y: [x + y, (x * y, y)[1]], 1),
    ],
)
def test_program_has_no_redundant_steps(compute, steps):
    assert len(record_program(compute, 2).row_steps) <= steps
    inputs = np.array([[0.3, -0.7], [2.0, 5.0]])
    expected = [np.broadcast_to(value, 2) for value in compute(*inputs)]
    np.testing.assert_allclose(rows_of(record_program(compute, 2), inputs), expected, rtol=1e-15)


def test_negated_zero_prints_without_sign():
    program = record_program(lambda x: [-x], 1)
    assert str(program.run_on_floats([0.0])[0]) == "0.0"
    assert str(rows_of(program, [[0.0]])[0, 0]) == "0.0"


@pytest.mark.parametrize("arm", ALL_ARMS, ids=arm_id)
def test_threads_do_not_share_memory(arm):
    """Eight threads at once must give the results that each gives alone."""
    batches = [joint_vectors(arm, (3000,), seed) for seed in range(8)]
    found = [None] * 8
    meet = threading.Barrier(8)

    def compute_batch(i):
        meet.wait()
        found[i] = jacobian(arm, batches[i])

    threads = [threading.Thread(target=compute_batch, args=(i,)) for i in range(8)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    for q, J in zip(batches, found, strict=True):
        np.testing.assert_array_equal(J, jacobian(arm, q))
