"""Is it right? Comparisons that say what is wrong, in words."""

from helpers.checks.jacobian import compare_jacobian
