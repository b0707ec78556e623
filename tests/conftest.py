"""An ArmError without words helps nobody: in every test, each one that is raised has some. And no
law is broken by a slow machine.
"""

from hypothesis import HealthCheck, settings

from helpers.inputs import ArmError

settings.register_profile(
    "unhurried", settings(), deadline=None, suppress_health_check=[HealthCheck.too_slow]
)
settings.load_profile("unhurried")


def _with_words(error, *words):
    assert [type(word) for word in words] == [str]
    assert words[0]
    ValueError.__init__(error, *words)


ArmError.__init__ = _with_words  # type: ignore[method-assign]
