"""Run the examples in the docstrings of the helpers and compare their outputs."""

import doctest
import importlib
import pkgutil

import pytest

import helpers

MODULES = sorted(
    module.name
    for module in pkgutil.walk_packages(helpers.__path__, "helpers.")
    if not module.name.endswith("__main__")
)


@pytest.mark.parametrize("name", MODULES)
def test_docstring_examples_give_their_output(name):
    module = importlib.import_module(name)
    failed, _ = doctest.testmod(module)
    assert not failed, f"run python -m doctest on {module.__file__}"
