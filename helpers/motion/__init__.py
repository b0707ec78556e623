"""Paths for the tip, resolved-rate tracing, and its report."""

from helpers.motion.joining import joined
from helpers.motion.paths import Path, circle, circle_below, rest_to_rest
from helpers.motion.rates import (
    Rates,
    SingularError,
    damped,
    levenberg,
    plain_inverse,
    pseudo_inverse,
)
from helpers.motion.report import Report
from helpers.motion.self_motions import self_motion, self_motion_directions
from helpers.motion.tracing import METHODS, Trace, UnreachableError, trace

__all__ = [
    "METHODS",
    "Path",
    "Rates",
    "Report",
    "SingularError",
    "Trace",
    "UnreachableError",
    "circle",
    "circle_below",
    "damped",
    "joined",
    "levenberg",
    "plain_inverse",
    "pseudo_inverse",
    "rest_to_rest",
    "self_motion",
    "self_motion_directions",
    "trace",
]
