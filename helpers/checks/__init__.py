"""Is it right? Comparisons that say what is wrong, in words."""

from helpers.checks.line import check

__all__ = ["check"]
