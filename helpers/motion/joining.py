"""Join traces into one."""

from __future__ import annotations

from collections.abc import Iterable
from itertools import accumulate, pairwise

import numpy as np
from numpy.typing import ArrayLike, NDArray

from helpers.inputs import ArmError, require_type, tuple_of_items
from helpers.motion.paths import Path
from helpers.motion.tracing import Trace

Array = NDArray[np.floating]


def join_traces(runs: Iterable[Trace]) -> Trace:
    """Join traces of one arm, each beginning where and when the one before ends.

    The wall of the joined path is that of the first.

    Args:
        runs: One trace or more.

    Raises:
        ArmError: There is no trace, the arms differ, or a trace does not begin at the joint values,
            to 1e-6, at which the one before ended.
    """
    traces = tuple_of_items(runs, "runs", "one or more runs")
    if not traces:
        raise ArmError("runs are none; expected one or more")
    for trace in traces:
        require_type(trace, Trace, "run")
    for number, (first, second) in enumerate(pairwise(traces), 1):
        if first.arm != second.arm:
            raise ArmError(
                f"run {number} is {first.arm.name}'s, the next {second.arm.name}'s; expected one"
                " arm"
            )
        if not np.allclose(first.q[-1], second.q[0], rtol=0, atol=1e-6):
            raise ArmError(
                f"run {number} ends at {first.q[-1]}, the next begins at {second.q[0]}; expected"
                " the same"
            )
    # The joined path begins at 0 s.
    paths = [trace.path for trace in traces]
    ends = list(accumulate(path.times[-1] - path.times[0] for path in paths))
    begins = [0.0, *ends[:-1]]

    def join_functions(name: str):
        """Return the paths' functions "position" or "velocity" as one function of time."""

        def value(t: ArrayLike) -> Array:
            t = np.asarray(t)
            index, values = np.searchsorted(ends[:-1], t), np.empty((*t.shape, 3))
            for k, path in enumerate(paths):
                function = getattr(path, name)
                values[index == k] = function(t[index == k] - begins[k] + path.times[0])
            return values

        return value

    later = [path.times[1:] - path.times[0] + begins[k] for k, path in enumerate(paths)]
    times, normal = np.concatenate([[0.0], *later]), paths[0].normal
    return Trace(
        traces[0].arm,
        Path(times, join_functions("position"), join_functions("velocity"), normal),
        np.concatenate([traces[0].q, *(trace.q[1:] for trace in traces[1:])]),
        np.concatenate([*(trace.q_dot[:-1] for trace in traces), traces[-1].q_dot[-1:]]),
        np.concatenate([traces[0].poses, *(trace.poses[1:] for trace in traces[1:])]),
    )
