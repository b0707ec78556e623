"""Test that ablation lists the decisions of the judge that change no answer."""

import json

from tests.ablate import switch_decisions
from tests.node import needs_packages


@needs_packages
def test_ablation_lists_only_decisions_without_effect(tmp_path):
    question = {"topic": "numbers", "mine": "1 2\n3 4", "what": "J"}
    line = {"script": "judge_bundle.mjs", "question": json.dumps(question)}
    questions = tmp_path / "questions.jsonl"
    questions.write_text(json.dumps(line), encoding="utf-8")
    output = switch_decisions(questions, "judge/reading/spans.js")
    assert "span.from >= last.from is true: not reached" in output
    assert "!parts.length is true" not in output  # without it the tests of the explorer fail
