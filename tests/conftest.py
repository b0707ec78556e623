"""Check in every test that an ArmError has a message, and let Hypothesis run without deadlines."""

from hypothesis import HealthCheck, settings

from helpers.inputs import ArmError

# A slow machine must not make a property test fail.
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
