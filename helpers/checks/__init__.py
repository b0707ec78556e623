"""Judge a student's answers and explain their mistakes in sentences."""

from helpers.checks.check_line import check
from helpers.checks.compare import (
    compare_branches,
    compare_jacobian,
    compare_pose,
    compare_tables,
    compare_torques,
    compare_trace,
)
from helpers.checks.marked_text import UnreadNumberError
from helpers.checks.verdict import Finding, Verdict

__all__ = [
    "Finding",
    "UnreadNumberError",
    "Verdict",
    "check",
    "compare_branches",
    "compare_jacobian",
    "compare_pose",
    "compare_tables",
    "compare_torques",
    "compare_trace",
]
