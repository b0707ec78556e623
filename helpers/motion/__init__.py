"""Define paths of the tip, follow them by resolved rates, and report how well it went."""

from helpers.motion.joining import join_traces
from helpers.motion.paths import Path, circle, circle_below, line, rest_to_rest
from helpers.motion.rates import (
    Rates,
    SingularError,
    damped,
    levenberg,
    plain_inverse,
    pseudo_inverse,
)
from helpers.motion.report import TraceReport
from helpers.motion.self_motions import self_motion, self_motion_directions
from helpers.motion.tracing import Trace, UnreachableError, trace

__all__ = [
    "Path",
    "Rates",
    "SingularError",
    "Trace",
    "TraceReport",
    "UnreachableError",
    "circle",
    "circle_below",
    "damped",
    "join_traces",
    "levenberg",
    "line",
    "plain_inverse",
    "pseudo_inverse",
    "rest_to_rest",
    "self_motion",
    "self_motion_directions",
    "trace",
]
