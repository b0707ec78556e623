"""Read the arm that a command of `answers` or `course` names."""

import runpy
from pathlib import Path

from helpers.arm import Arm
from helpers.inputs import ArmError
from helpers.robots import find_arm
from helpers.urdf import from_urdf


def read_arm(text: str, base: str | None = None, tip: str | None = None) -> Arm:
    """Return the arm that an argument of a command names.

    Args:
        text: a name of the catalogue, a robot description (.urdf, .xml) or ``file.py:NAME``. The
            Python file is run.
        base, tip: first and last link in a robot description.

    Raises ArmError if there is no such arm.
    """
    file, colon, name = text.rpartition(":")
    if colon and file.endswith(".py"):
        if not Path(file).is_file():
            raise ArmError(f"{file} is not there; expected a Python file, as in my_arm.py:ARM")
        arm = runpy.run_path(file).get(name)
        if not isinstance(arm, Arm):
            raise ArmError(f"{name} of {file} is {arm!r}; expected an Arm")
        return arm
    if text.endswith((".urdf", ".xml")):
        return from_urdf(text, base, tip)
    return find_arm(text)
