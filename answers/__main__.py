"""Write the answer sheet of any arm into one HTML file."""

import argparse
import re
import sys
from pathlib import Path

from answers import document
from answers.command_line import read_arm
from helpers.inputs import ArmError


def main(arguments: list[str] | None = None) -> None:
    """Read the command line, write the file, say where it is; what is wrong is told in words."""
    parser = argparse.ArgumentParser(prog="python -m answers", description=__doc__)
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
    except ModuleNotFoundError as error:
        sys.exit(f"{error}; pip install -e '.[course]' in the book's folder brings it")
    sys.stdout.write(f"{out}\n")


def slug(name: str) -> str:
    """A name as it may stand in a file's name."""
    return re.sub(r"\W+", "_", name).strip("_").lower() or "arm"


if __name__ == "__main__":
    main()
