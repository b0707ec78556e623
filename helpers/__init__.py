"""Compute with robot arms from DH tables, for all notebooks of the book.

``from helpers import Arm, PANDA`` takes an arm's class or an arm of the catalogue, and
``from helpers import kinematics`` a module. The book's page *The same numbers in other programs*
lists the names that other libraries have for the functions.
"""

import importlib
from typing import Any

__version__ = "6.0.0"  # test_tools.py compares it with CITATION.cff and CHANGELOG.md

_PUBLIC = {
    "helpers.arm": ("Arm", "ArmError", "Body", "Joint", "Row", "fixed", "prismatic", "revolute"),
    "helpers.robots": (
        "ARMS", "ELBOW", "PANDA", "PANDA_HOMEWORK", "STANFORD", "THREE_LINK", "TWO_LINK", "UR10E",
        "UR10E_HOMEWORK", "find_arm",
    ),
}  # fmt: skip

__all__ = [name for names in _PUBLIC.values() for name in names]


def __getattr__(name: str) -> Any:
    """Import a name of `_PUBLIC` at its first use, so that `import helpers` is fast."""
    for module, names in _PUBLIC.items():
        if name in names:
            return getattr(importlib.import_module(module), name)
    raise AttributeError(f"module 'helpers' has no attribute {name!r}")


def __dir__() -> list[str]:
    return sorted([*globals(), *__all__])
