"""Runs one after the other, as one run."""

from collections.abc import Iterable
from itertools import accumulate, pairwise

import numpy as np
from numpy.typing import ArrayLike, NDArray

from helpers.inputs import ArmError, listed, must_be
from helpers.motion.paths import Path
from helpers.motion.tracing import Trace

Array = NDArray[np.floating]


def joined(runs: Iterable[Trace]) -> Trace:
    """Runs of one arm as one run, each beginning where and when the one before ends; the wall is
    that of the first.

    Raises ArmError for no runs, for runs of several arms, and where a run does not begin at the
    joints, to 1e-6, at which the one before ended.
    """
    runs = listed(runs, "runs", "one or more runs")
    if not runs:
        raise ArmError("runs are none; expected one or more")
    for run in runs:
        must_be(run, Trace, "run")
    for number, (one, next_one) in enumerate(pairwise(runs), 1):
        if one.arm != next_one.arm:
            raise ArmError(
                f"run {number} is {one.arm.name}'s, the next {next_one.arm.name}'s; expected one"
                " arm"
            )
        if not np.allclose(one.q[-1], next_one.q[0], rtol=0, atol=1e-6):
            raise ArmError(
                f"run {number} ends at {one.q[-1]}, the next begins at {next_one.q[0]}; expected"
                " the same"
            )
    return Trace(
        runs[0].arm,
        _path([run.path for run in runs]),
        np.concatenate([runs[0].q, *(run.q[1:] for run in runs[1:])]),
        np.concatenate([*(run.q_dot[:-1] for run in runs), runs[-1].q_dot[-1:]]),
        np.concatenate([runs[0].poses, *(run.poses[1:] for run in runs[1:])]),
    )


def _path(paths: list[Path]) -> Path:
    ends = list(accumulate(path.times[-1] - path.times[0] for path in paths))
    begins = [0.0, *ends[:-1]]

    def pieced(what: str):
        def value(t: ArrayLike) -> Array:
            t = np.asarray(t)
            which, out = np.searchsorted(ends[:-1], t), np.empty((*t.shape, 3))
            for k, path in enumerate(paths):
                out[which == k] = getattr(path, what)(t[which == k] - begins[k] + path.times[0])
            return out

        return value

    later = [path.times[1:] - path.times[0] + begins[k] for k, path in enumerate(paths)]
    times = np.concatenate([[0.0], *later])
    return Path(times, pieced("position"), pieced("velocity"), paths[0].normal)
