"""Write the form in which a page checks an answer, with the data of the arms to choose from."""

import json
from collections.abc import Mapping

from helpers import motion, robots
from helpers.arm import Arm
from helpers.checks.arms import Data, judge_data
from helpers.inputs import ArmError

# Calls that create the arms of the form's list: names in helpers.robots, and locked joints.
_NAMES = (name for name, arm in vars(robots).items() if arm in robots.ARMS)
CALLS = ("PANDA.lock(3)", "PANDA_HOMEWORK.lock(3)", *_NAMES)
# For each question an answer with a known mistake, which is in the form before a reader types.
EXAMPLES = (
    {
        "ask": "jacobian",
        "arm": "PANDA.lock(3)",
        "q": "0.4, -0.6, -1.9, 0.3, 1.8, 0.7",
        "answer": """ 0.0390  -0.4054   0.2081  -0.0808  -0.1771   0.0000
-0.2300  -0.1714   0.0880   0.1542  -0.1175   0.0000
 0.0000  -0.2270   0.4736  -0.0517  -0.0736   0.0000
 0.3894   0.5201  -0.8875   0.4448   0.0845   0.0845
-0.9211   0.2199  -0.3752  -0.8491  -0.2767  -0.2767
 0.0000   0.8253   0.2675   0.2848  -0.9572  -0.9572""",
    },
    {
        "ask": "torques",
        "arm": "UR10E",
        "q": "0.3, -1.1, 1.4, -0.8, 0.9, 0.2",
        "wrench": "0, 0, -20, 0, 0, 0",
        "answer": "[0.00, -56.32, -24.69, 1.94, -1.02, 0.00]",
    },
    {
        "ask": "table",
        "arm": "PANDA",
        "answer": """joint  a        d      alpha  theta
1      0        0.333  0      q1
2      0        0      -pi/2  q2
3      0        0.316  pi/2   q3
4      0.0825   0      pi/2   q4
5      -0.0825  0.384  -pi/2  q5
6      0        0      pi/2   q6
7      0.088    0      pi/2   q7
tool   0        0.207  0      0""",
    },
    {
        "ask": "branches",
        "arm": "ELBOW",
        "target": "0.52, 0.2841, 0.8463",
        "answer": """ 0.5000  0.7000 -0.4002
 0.5000  0.3578 -0.4002
-2.6416  2.4416  0.4002
-2.6416  2.7838 -0.4002""",
    },
    {
        "ask": "pose",
        "arm": "UR10E",
        "target": """ 0.8286  0.2994 -0.4730 -0.8930
-0.5473  0.2555 -0.7970 -0.5994
-0.1177  0.9193  0.3755  0.5340""",
        "answer": "[0.3, -1.1, 1.4, -2.3708, 0.9, 0.2]",
    },
)


def trace_example() -> dict[str, str]:
    """Return the example of a trajectory: a circle traced in the wrong direction."""
    q = (0.3, -0.6, 1.4, -0.8, 0.9, 0.2)
    path = motion.circle_below(robots.UR10E_HOMEWORK, q, 0.1, "yz", 5.0, 24)
    trajectory = motion.trace(robots.UR10E_HOMEWORK, q, path, method="exact")
    rows = ["  ".join(f"{x:7.4f}" for x in row) for row in trajectory.q]
    question = {"ask": "trace", "arm": "UR10E_HOMEWORK", "q": ", ".join(map(str, q))}
    return {**question, "answer": "\n".join(rows)}


def catalogue_arm(call: str) -> Arm:
    """Return the arm that a call such as ``PANDA.lock(3)`` makes."""
    name, _, locked = call.removesuffix(")").partition(".lock(")
    arm = getattr(robots, name, None)
    if not isinstance(arm, Arm):
        raise ArmError(f"no arm is called {call!r}; expected one of {', '.join(CALLS)}")
    return arm.lock(int(locked)) if locked else arm


def form_html(question: Mapping[str, str] | None = None) -> tuple[str, str]:
    """Return the HTML before and after the text that readers without scripts see.

    Args:
        question: The question of a chapter's form: `ask`, `arm` (a call such as ``PANDA.lock(3)``,
            or several with commas) or the `table` of another arm, `q` and more fields of
            page/src/check/question.js. Without it the form takes any question.

    Raises:
        ArmError: An arm is not in the catalogue.
    """
    fields = dict(question or {})
    calls = [call.strip() for call in fields.pop("arm", ",".join(CALLS)).split(",")]
    if "table" in fields:
        calls, fields["arm"] = [], "own"
    data: Data = {"arms": [list_entry(call) for call in calls]}
    data |= {"given": fields} if fields else {"examples": [*EXAMPLES, trace_example()]}
    script = json.dumps(data, separators=(",", ":")).replace("</", "<\\/")
    class_name = "arm-judge small" if fields else "arm-judge"
    end = f'<script type="application/json">{script}</script></div>'
    return f'<div class="{class_name}">', end


def list_entry(call: str) -> Data:
    """Return the data of an arm in the page's list."""
    arm = catalogue_arm(call)
    data = {**judge_data(arm), "key": call, "title": arm.name, "explorer": arm.name}
    for joint in arm.locked:  # locked at 0; the explorer's arm can move this joint
        data |= {"locked": joint, "title": f"{arm.name}, joint {joint} locked"}
    return data
