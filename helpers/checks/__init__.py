"""Is it right? Comparisons that say what is wrong, in words."""

from helpers.checks.branches import BranchReport, compare_branches
from helpers.checks.differences import Finding
from helpers.checks.jacobian import JacobianReport, compare_jacobian
from helpers.checks.line import check
from helpers.checks.tables import TableReport, compare_tables
from helpers.checks.torques import TorqueReport, compare_torques
from helpers.checks.traces import TraceReport, compare_trace

__all__ = [
    "BranchReport",
    "Finding",
    "JacobianReport",
    "TableReport",
    "TorqueReport",
    "TraceReport",
    "check",
    "compare_branches",
    "compare_jacobian",
    "compare_tables",
    "compare_torques",
    "compare_trace",
]
