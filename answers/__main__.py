"""Write the answer sheet of any arm into an HTML file."""

import argparse
import re
import sys
from pathlib import Path

from answers import make_html_sheet
from answers.command_line import read_arm
from helpers.inputs import ArmError


def main(arguments: list[str] | None = None) -> None:
    """Write the sheet that the command line asks for and print its path."""
    parser = argparse.ArgumentParser(prog="python -m answers", description=__doc__)
    parser.add_argument(
        "arm", help="a name of the catalogue, a robot description (arm.urdf), or my_arm.py:NAME"
    )
    parser.add_argument("--base", help="a robot description's first link")
    parser.add_argument("--tip", help="a robot description's last link")
    parser.add_argument(
        "--tolerance",
        type=float,
        default=1e-9,
        help="axes of a robot description closer than this (m, or sine of an angle) meet or are"
        " parallel; a warning says where it must be larger",
    )
    pose = "as x,y,z,roll,pitch,yaw in m and rad, angles such as pi/2 too"
    parser.add_argument("--base-pose", help=f"pose of the arm's base in the world, {pose}")
    parser.add_argument("--tool-pose", help=f"pose of the tool's tip in the last frame, {pose}")
    parser.add_argument(
        "--out", type=Path, help="the file to write; named after the arm unless given"
    )
    options = parser.parse_args(arguments)
    try:
        arm = read_arm(options.arm, options.base, options.tip, options.tolerance)
        if options.base_pose:
            arm = arm.with_base(options.base_pose.split(","))
        if options.tool_pose:
            arm = arm.with_tool(options.tool_pose.split(","))
        out = options.out or Path(f"{make_file_stem(arm.name)}_answers.html")
        out.write_text(make_html_sheet(arm), encoding="utf-8")
    except (ArmError, OSError) as error:
        sys.exit(str(error))
    except ModuleNotFoundError as error:
        sys.exit(f"{error}; pip install -e '.[course]' in the book's folder brings it")
    sys.stdout.write(f"{out}\n")


def make_file_stem(name: str) -> str:
    """Return a name in lower case with underscores, fit for the name of a file."""
    return re.sub(r"\W+", "_", name).strip("_").lower() or "arm"


if __name__ == "__main__":
    main()
