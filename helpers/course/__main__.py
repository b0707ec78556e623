"""Run the course commands."""

import sys

from helpers.course.commands import main

if __name__ == "__main__":
    sys.exit(main())
