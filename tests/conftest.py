"""An ArmError without words helps nobody: in every test, each one that is raised has some."""

from helpers.inputs import ArmError


def _with_words(error, *words):
    assert [type(word) for word in words] == [str]
    assert words[0]
    ValueError.__init__(error, *words)


ArmError.__init__ = _with_words  # type: ignore[method-assign]
