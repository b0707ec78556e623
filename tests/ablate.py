"""Switch each decision of the judge's reading and list those that change no answer.

`python -m tests.ablate` records the questions of the tests that judge texts. In a copy of the
judge it then forces each condition, drops each pattern, and drops each alternative of patterns and
lists. `--only PATHS` takes modules whose paths begin so, separated by commas, as
judge/reading/lines.js. `--questions FILE` takes questions that were recorded before, or records
them there. `--seconds N` is the processor time for each decision, after which it counts as not
decided. A decision that nothing feels is not proved superfluous: read it, then delete it or write
its case.
"""

import argparse
import json
import subprocess
from pathlib import Path
from tempfile import TemporaryDirectory

import pytest

from tests import node

HERE = Path(__file__).parent
MODULES = ("works", "judge", "reading", "expressions", "unfinished")
TESTS = [str(HERE / f"test_{name}.py") for name in MODULES]


def main() -> None:
    """Read the command line, record the questions and switch the decisions."""
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--only", default="judge/reading/")
    parser.add_argument("--questions", type=Path)
    parser.add_argument("--seconds", default="3")
    options = parser.parse_args()
    with TemporaryDirectory() as folder:
        questions = options.questions or Path(folder, "questions.jsonl")
        if not questions.exists():
            record_questions(questions)
        print(switch_decisions(questions, options.only, options.seconds))


def switch_decisions(questions: Path, paths: str, seconds: str = "3") -> str:
    """Return a line for each decision that changes no answer, and the counts."""
    command = [node.NODE, str(HERE / "ablate.mjs"), str(questions), paths, seconds]
    return subprocess.run(command, check=True, text=True, stdout=subprocess.PIPE).stdout


def record_questions(file: Path) -> None:
    """Run the tests that judge texts and write each question that they put to the judge."""
    recorded = {}
    exchange_lines = node._exchange_lines

    def record(script: str, question: str) -> str:
        if script in ("judge_bundle.mjs", "judge_reading.mjs"):
            recorded[script, question] = None
        return exchange_lines(script, question)

    node._exchange_lines = record
    pytest.main(["-q", "-k", "not linearly", *TESTS])  # without tests of the reading time
    lines = [json.dumps({"script": script, "question": text}) for script, text in recorded]
    file.write_text("\n".join(lines), encoding="utf-8")


if __name__ == "__main__":
    main()
