"""Write the catalogue's arms where the page's small figures read them: `python -m tools.arms`."""

import json
from pathlib import Path

from helpers.checks.arms import arm_data
from helpers.robots import ARMS

PLACE = Path(__file__).parents[1] / "page/src/more/arms.json"


def text() -> str:
    return json.dumps([arm_data(arm) for arm in ARMS], indent=2) + "\n"


if __name__ == "__main__":
    PLACE.write_text(text(), "utf-8")
