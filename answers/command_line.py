"""An arm from the words of a command line, as the commands of `sheets` and `course` take it."""

import runpy
from pathlib import Path

from helpers.arm import Arm
from helpers.inputs import ArmError
from helpers.robots import find_arm
from helpers.urdf import from_urdf


def read_arm(text: str, base: str | None = None, tip: str | None = None) -> Arm:
    """The arm that a name of the catalogue, a robot description or ``file.py:NAME`` stands for.

    The Python file is the caller's own and is run. Raises ArmError where there is no such arm.
    """
    file, colon, name = text.rpartition(":")
    if colon and file.endswith(".py"):
        if not Path(file).is_file():
            raise ArmError(f"{file} is not there; expected a Python file, as in my_arm.py:ARM")
        found = runpy.run_path(file).get(name)
        if not isinstance(found, Arm):
            raise ArmError(f"{name} of {file} is {found!r}; expected an Arm")
        return found
    if text.endswith((".urdf", ".xml")):
        return from_urdf(text, base, tip)
    return find_arm(text)
