"""Keep the old names of renamed objects for one edition, with a DeprecationWarning.

A module of a renamed function ends in
``__getattr__ = deprecated_names(__name__, old="new")``.
"""

import importlib
import warnings
from collections.abc import Callable
from typing import Any


def deprecated_names(module: str, **new_names: str) -> Callable[[str], Any]:
    """Return a module's ``__getattr__`` that finds renamed attributes by their old names.

    Args:
        module: The module's ``__name__``.
        new_names: For each old name, the new one: in the same module, as ``"join_traces"``, or
            with its own module, as ``"answers.page.make_html_sheet"``.
    """

    def get_renamed(name: str) -> Any:
        if name not in new_names:
            raise AttributeError(f"module {module!r} has no attribute {name!r}")
        new_module, _, new_name = new_names[name].rpartition(".")
        warn_renamed(f"{module}.{name}", f"{new_module or module}.{new_name}")
        return getattr(importlib.import_module(new_module or module), new_name)

    return get_renamed


def warn_renamed(old: str, new: str) -> None:
    """Warn the user's code, two calls up, that a name will be removed."""
    warnings.warn(
        f"{old} is now {new}; the old name is removed with the next edition",
        DeprecationWarning,
        stacklevel=3,
    )
