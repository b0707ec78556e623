"""Is it right? Comparisons that say what is wrong, in words."""

from helpers.checks.line import check
from helpers.checks.tables import Finding, TableReport, compare_tables

__all__ = ["Finding", "TableReport", "check", "compare_tables"]
