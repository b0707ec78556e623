"""Write the answer sheet of any arm into one HTML file."""

import argparse
import re
import runpy
import sys
from pathlib import Path

from helpers.arm import Arm
from helpers.inputs import ArmError
from helpers.robots import named
from helpers.sheets import document
from helpers.urdf import from_urdf


def main(arguments: list[str] | None = None) -> None:
    """Read the command line, write the file, say where it is; what is wrong is told in words."""
    parser = argparse.ArgumentParser(prog="python -m helpers.sheets", description=__doc__)
    parser.add_argument(
        "arm", help="a name of the catalogue, a robot description (arm.urdf), or my_arm.py:NAME"
    )
    parser.add_argument("--base", help="a robot description's first link")
    parser.add_argument("--tip", help="a robot description's last link")
    parser.add_argument(
        "--out", type=Path, help="the file to write; named after the arm unless given"
    )
    given = parser.parse_args(arguments)
    try:
        arm = read_arm(given.arm, given.base, given.tip)
        out = given.out or Path(f"{slug(arm.name)}_answers.html")
        out.write_text(document(arm), encoding="utf-8")
    except (ArmError, OSError) as error:
        sys.exit(str(error))
    sys.stdout.write(f"{out}\n")


def read_arm(text: str, base: str | None = None, tip: str | None = None) -> Arm:
    """The arm that a name, a file or ``file.py:NAME`` stands for. Raises ArmError where there is
    none.
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
    return named(text)


def slug(name: str) -> str:
    """A name as it may stand in a file's name."""
    return re.sub(r"\W+", "_", name).strip("_").lower() or "arm"


if __name__ == "__main__":
    main()
