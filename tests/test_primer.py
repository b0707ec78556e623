"""Test that the code on the page before chapter 1 prints what stands below it."""

import re
from pathlib import Path

PAGE = Path(__file__).parents[1] / "book/primer.md"


def test_code_of_the_primer_prints_the_matrix_below_it(capsys):
    text = PAGE.read_text(encoding="utf-8")
    ((code, printed),) = re.findall(r"(?s)```python\n(.*?)```\n\n```text\n(.*?)```", text)
    exec(code, {})
    assert capsys.readouterr().out == printed
