"""Read the arm that a command of `answers` or `course` names."""

import runpy
from pathlib import Path

from helpers.arm import Arm
from helpers.inputs import ArmError
from helpers.robots import find_arm
from helpers.urdf import from_urdf


def read_arm(
    text: str, base: str | None = None, tip: str | None = None, tolerance: float = 1e-9
) -> Arm:
    """Read the arm that a command line names.

    Args:
        text: A name of the catalogue, a robot description (``arm.urdf``), or ``file.py:NAME``; the
            Python file is the caller's own and is run.
        base: First link of a robot description.
        tip: Last link of a robot description.
        tolerance: Tolerance with which a robot description is read.

    Raises:
        ArmError: There is no such arm.
    """
    file, colon, name = text.rpartition(":")
    if colon and file.endswith(".py"):
        if not Path(file).is_file():
            raise ArmError(f"{file} is not there; expected a Python file, as in my_arm.py:ARM")
        arm = runpy.run_path(file).get(name)
        if not isinstance(arm, Arm):
            raise ArmError(f"{name} of {file} is {arm!r}; expected an Arm")
        return arm
    if text.lower().endswith((".urdf", ".xml", ".xacro", ".sdf")):
        return from_urdf(text, base, tip, tolerance=tolerance)
    return find_arm(text)
