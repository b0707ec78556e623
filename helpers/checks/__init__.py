"""Is it right? Comparisons that say what is wrong, in words."""

from helpers.checks.branches import compare_branches
from helpers.checks.jacobian import compare_jacobian
from helpers.checks.line import check
from helpers.checks.pose import compare_pose
from helpers.checks.tables import compare_tables
from helpers.checks.torques import compare_torques
from helpers.checks.traces import compare_trace
from helpers.checks.verdict import Finding, Report

__all__ = [
    "Finding",
    "Report",
    "check",
    "compare_branches",
    "compare_jacobian",
    "compare_pose",
    "compare_tables",
    "compare_torques",
    "compare_trace",
]
