"""Measure a judge on generated answers: ``python -m tests.measure.random_answers --seed 1``."""

import argparse
import sys
from collections import Counter, defaultdict
from math import sqrt
from multiprocessing import Pool
from pathlib import Path

OUTCOMES = ("right", "so far", "rounded", "refused", "wrong", "crashed")
# A table with a mistake may be the same arm with other zeros of its joints: "right by map".
TWIN_OUTCOMES = (
    *("named", "located", "called wrong", "so far", "right by map", "refused", "passed", "crashed"),
)


def _measure_index(task: tuple[int, int]) -> tuple:
    """Judge one right answer and its twin."""
    from tests.measure.random_answers.draws import draw_answer, draw_twin

    seed, index = task
    answer, twin = draw_answer(seed, index), draw_twin(seed, index)
    right, report = _outcome(answer)
    wrong, twin_report = _outcome(twin)
    if wrong == "wrong":
        places = any(f.where for f in twin_report.findings)
        wrong = "named" if twin_report.causes else "located" if places else "called wrong"
    elif wrong in ("right", "rounded"):
        wrong = "passed"
    message = str(report).split("\n")[0]
    return index, right, message, wrong, twin.mistake, answer.features


def _outcome(draw) -> tuple[str, object]:
    from helpers.inputs import ArmError
    from tests.measure.random_answers.questions import ask_judge

    try:
        report = ask_judge(draw.question, draw.text, draw.angles)
    except ArmError as error:
        return "refused", error
    except Exception as error:  # a crash of the judge is counted as a result
        return "crashed", error
    return report.grade, report


def _print_features(results: list[tuple]) -> None:
    """Print features whose answers fail more often than average by two standard errors."""
    groups = defaultdict(list)
    for _, outcome, _, _, _, features in results:
        failed = outcome in ("refused", "wrong", "crashed")
        for name, value in features.items():
            groups[name, value].append((failed, outcome == "wrong"))
    count = len(results)
    average = sum(r[1] in ("refused", "wrong", "crashed") for r in results) / count
    print(f"\nFeatures with more failures than the average of {average:.1%} (two standard errors):")
    print(f"{'feature':<46} {'draws':>6} {'fails':>7} {'wrong':>7}")
    rows = []
    for (name, value), pairs in groups.items():
        size = len(pairs)
        share = sum(failed for failed, _ in pairs) / size
        if size >= 5 and share > average + 2 * sqrt(average * (1 - average) / size):
            rows.append((share, name, value, size, sum(wrong for _, wrong in pairs) / size))
    for share, name, value, size, wrong in sorted(rows, reverse=True):
        print(f"{name + ' = ' + value!r:<46} {size:>6} {share:>7.1%} {wrong:>7.1%}")


def _print_draws(seed: int, indices: range) -> None:
    """Print draws as Markdown."""
    from tests.measure.random_answers.draws import draw_answer

    for index in indices:
        draw = draw_answer(seed, index)
        features = ", ".join(f"{name}: {value}" for name, value in draw.features.items())
        print(f"## Draw {index}\n\n{features}; setting: {draw.angles}\n")
        print(f"````text\n{draw.text}\n````\n")


def main() -> None:
    """Read the command line and print counts."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--draws", type=int, default=2000)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--judge-root", help="worktree whose helpers judge")
    parser.add_argument("--print", type=int, default=0, metavar="N", help="print N draws")
    parser.add_argument("--failures", help="file that receives each failed draw")
    options = parser.parse_args()
    if options.judge_root:
        sys.path.insert(0, str(Path(options.judge_root).resolve()))
    import helpers

    if options.print:
        _print_draws(options.seed, range(options.print))
        return
    tasks = [(options.seed, index) for index in range(options.draws)]
    with Pool(2) as pool:
        results = pool.map(_measure_index, tasks, chunksize=20)
    print(f"Judge: {Path(helpers.__file__).parent}; seed {options.seed}, {len(results)} draws")
    rights, twins = Counter(r[1] for r in results), Counter(r[3] for r in results)
    print(
        "Right:", ", ".join(f"{x} {rights[x]} ({rights[x] / len(results):.1%})" for x in OUTCOMES)
    )
    print(
        "Twins:",
        ", ".join(f"{x} {twins[x]} ({twins[x] / len(results):.1%})" for x in TWIN_OUTCOMES),
    )
    passed = Counter(r[4] for r in results if r[3] == "passed")
    print("Passed twins by mistake:", dict(passed))
    _print_features(results)
    if options.failures:
        _write_failures(options.failures, options.seed, results)


def _write_failures(path: str, seed: int, results: list[tuple]) -> None:
    from tests.measure.random_answers.draws import draw_answer, draw_twin

    parts = []
    for index, outcome, message, twin, mistake, _ in results:
        if outcome in ("wrong", "refused", "crashed"):
            text = draw_answer(seed, index).text
            parts.append(f"=== {index} {outcome}: {message}\n{text}\n")
        if twin in ("passed", "crashed"):
            parts.append(f"=== twin {index} {twin}, {mistake}\n{draw_twin(seed, index).text}\n")
    Path(path).write_text("\n".join(parts), encoding="utf-8")


if __name__ == "__main__":
    main()
