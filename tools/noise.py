"""Do the notebooks say the same on every processor? `python -m tools.noise book/*.ipynb`.

Each notebook is run under every kernel of OpenBLAS that this processor can run, with one and two
threads and with NumPy's newer instructions switched off. All but the first of these runs have
seeded noise in the last places too, each its own (`tools.rounding`): what a kernel or a seed alone
would move, both together move as well, in half the runs. No stored text, formula or figure may
change, no check fail, and no noise use up half of a check's tolerance.
"""

import argparse
import json
import os
import subprocess
import sys
from collections import defaultdict
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from itertools import cycle
from pathlib import Path
from typing import NamedTuple

from tools.rerun import Run

ROOT = Path(__file__).parents[1]
SEEDS = range(6)  # 0 is no noise
OLD = "X86_V3 X86_V4 AVX2 FMA3 AVX512F AVX512_SKX AVX512_ICL AVX512_SPR"  # instructions
KERNELS = {  # of OpenBLAS: what the processor must have, the threads, what NumPy may not use
    "Prescott": ("SSE3", 1, ""),
    "Nehalem": ("SSE42", 2, OLD),
    "Sandybridge": ("AVX", 1, ""),
    "Haswell": ("AVX2", 2, ""),
    "Zen": ("AVX2", 1, ""),
    "SkylakeX": ("AVX512_SKX", 2, ""),
}
OWN = "this processor's kernel"


class Setting(NamedTuple):
    """A machine to imitate: its environment, and the seed of its noise, or 0 for none."""

    name: str
    environment: dict[str, str]
    seed: int = 0


def settings() -> list[Setting]:
    """All that this processor can imitate; where its kernels are fewer than the seeds, they come
    again."""
    from numpy._core._multiarray_umath import __cpu_features__ as has

    kernels = [name for name, (needs, *_) in KERNELS.items() if has.get(needs)] or [OWN]
    return [
        _setting(kernel, seed)
        for seed, kernel in zip(range(max(len(SEEDS), len(kernels))), cycle(kernels), strict=False)
    ]


def _setting(kernel: str, seed: int) -> Setting:
    noise = f", noise {seed}" if seed else ""
    if kernel == OWN:
        return Setting(kernel + noise, {}, seed)
    _, threads, off = KERNELS[kernel]
    environment = {
        "OPENBLAS_CORETYPE": kernel,
        "OPENBLAS_NUM_THREADS": str(threads),
        "NPY_DISABLE_CPU_FEATURES": off,
    }
    name = f"{kernel}, threads: {threads}{', old NumPy' if off else ''}{noise}"
    return Setting(name, environment, seed)


def main() -> None:
    options = _parser().parse_args()
    chosen = [setting for setting in settings() if options.only in setting.name]
    with ThreadPoolExecutor(options.jobs) as pool:
        found = list(pool.map(lambda s: outside(s, options.notebooks), chosen))
    complaints = [
        *(
            line
            for setting, runs in zip(chosen, found, strict=True)
            for line in said(setting, runs)
        ),
        *tight(found),
    ]
    print("\n".join(complaints))
    print(f"{len(options.notebooks)} notebooks, {len(chosen)} settings: {len(complaints)} findings")
    sys.exit(bool(complaints))


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("notebooks", nargs="+", help="notebooks whose stored outputs are the right")
    parser.add_argument("--only", default="", help="settings with this in their name")
    parser.add_argument("--jobs", type=int, default=os.cpu_count(), help="settings at a time")
    return parser


def outside(setting: Setting, notebooks: list[str]) -> dict[str, Run]:
    """Run the notebooks in a process of that setting."""
    command = [sys.executable, "-c", "from tools.rerun import main; main()", str(setting.seed)]
    own = {"MPLBACKEND": "module://matplotlib_inline.backend_inline", "PYTHONPATH": str(ROOT)}
    done = subprocess.run(
        [*command, *map(os.path.abspath, notebooks)],
        env=os.environ | own | setting.environment,
        stdout=subprocess.PIPE,
        check=True,
    )
    found = json.loads(done.stdout)
    return {name: Run(changed, used) for name, (changed, used) in found.items()}


def said(setting: Setting, runs: dict[str, Run]) -> Iterator[str]:
    """A line for each cell that says something else, or fails."""
    for name, run in runs.items():
        for cell, what in run.changed:
            yield f"{Path(name).name} [{cell}], {setting.name}: {what}"


def tight(found: list[dict[str, Run]]) -> Iterator[str]:
    """A line for each check whose tolerance rounding uses to more than half.

    A number quoted to its digits is off by a steady share of its tolerance, which is no matter.
    What counts is a share that moves: by a hundredth and beyond a half, or by half of what is left.
    """
    shares = defaultdict(list)
    for runs in found:
        for name, run in runs.items():
            for key, share in run.used:
                shares[Path(name).name, *key].append(share)
    for (name, cell, _, label), seen in shares.items():
        least, most = min(seen), max(seen)
        if (most > 0.5 and most - least > 0.01) or most - least > 0.5 * (1 - least):
            yield f"{name} [{cell}] {label!r}: uses {least:.3g} to {most:.3g} of its tolerance"


if __name__ == "__main__":
    main()
