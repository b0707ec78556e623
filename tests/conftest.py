"""Prepare all tests: the judge under Node.js, a message in every ArmError, no deadlines."""

import os

from hypothesis import HealthCheck, settings

from helpers.checks import engine
from helpers.inputs import ArmError
from tests.node import NODE, ask_judge_bundle

# No deadline: on a slow machine a single example of a property test may take seconds.
settings.register_profile(
    "no_deadline", settings(), deadline=None, suppress_health_check=[HealthCheck.too_slow]
)
settings.load_profile("no_deadline")


def _require_message(error, *arguments):
    """Initialize an ArmError that must have one non-empty string as its message."""
    assert [type(argument) for argument in arguments] == [str], "raise ArmError with one string"
    assert arguments[0], "the message of this ArmError is empty"
    ValueError.__init__(error, *arguments)


ArmError.__init__ = _require_message  # type: ignore[method-assign]


# Node.js gives the same answers as QuickJS in a tenth of the time. Only `make coverage` lets all
# tests ask QuickJS.
start_quickjs = engine._start_quickjs
if NODE and os.environ.get("JUDGE") != "quickjs":
    engine._start_quickjs = lambda script: ask_judge_bundle


def pytest_collection_modifyitems(items):
    """Move the slowest file to the front; at the end it would run alone on one processor."""
    items.sort(key=lambda item: item.path.name != "test_works.py")
