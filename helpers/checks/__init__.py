"""Is it right? Comparisons that say what is wrong, in words."""

from helpers.checks.check_line import check
from helpers.checks.compare import (
    compare_branches,
    compare_jacobian,
    compare_pose,
    compare_tables,
    compare_torques,
    compare_trace,
)
from helpers.checks.report import Finding, Report

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
