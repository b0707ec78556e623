"""Print the answers of a sheet, write them to answers.json, and find them in a saved notebook.

Nobody runs a student's notebook again. Its last cell prints one marked line of JSON when the
student runs it, and that line, or answers.json, is marked.
"""

import inspect
import json
from collections.abc import Mapping
from typing import Any

ANSWERS_FILE = "answers.json"
NOTEBOOK_FILE = "homework.ipynb"
ANSWER_PREFIX = "answer_"  # prefix of variables that contain answers
SHEET_ANSWER = "sheet"  # the answer that names the sheet, as "course/student"
MARKED_LINE = "Answers of this sheet: "


def to_json_value(value: Any) -> Any:
    """Convert a value to numbers, texts and lists; other objects become their text."""
    if hasattr(value, "tolist"):
        value = value.tolist()  # arrays of NumPy and matrices of SymPy
    if isinstance(value, dict):
        return {str(key): to_json_value(entry) for key, entry in value.items()}
    if isinstance(value, (list, tuple)):
        return [to_json_value(entry) for entry in value]
    return value if isinstance(value, (str, bool, int, float)) else str(value)


def collect_answers(variables: Mapping[str, Any]) -> dict[str, Any]:
    """Collect the answers among a notebook's variables, except those without a value."""
    return {
        name[len("answer_") :]: to_json_value(value)
        for name, value in variables.items()
        if name.startswith("answer_") and value is not None and value is not ...
    }


def write_last_cell() -> str:
    """Return the code of a sheet's last cell, which needs only Python."""
    functions = (to_json_value, collect_answers)
    sources = "\n\n\n".join(inspect.getsource(function).rstrip() for function in functions)
    return f"""import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any


{sources}


text = json.dumps(collect_answers(globals()))
_ = Path("{ANSWERS_FILE}").write_text(text + "\\n", encoding="utf-8")
print("{MARKED_LINE}" + text)"""


def find_printed_answers(notebook: Mapping[str, Any]) -> dict[str, Any] | None:
    """Return the answers in the last marked line of a notebook's outputs, or None.

    A line counts only in the output of a cell that itself contains the marker.
    """
    for cell in reversed(list_code_cells(notebook)):
        if MARKED_LINE not in read_source(cell):
            continue
        printed = "".join(map(_read_printed_text, cell.get("outputs") or ()))
        for line in reversed(printed.splitlines()):
            if line.startswith(MARKED_LINE):
                return parse_answers(line.removeprefix(MARKED_LINE))
    return None


def parse_answers(text: str | bytes) -> dict[str, Any] | None:
    """Return the answers in a JSON text without prefixes, or None if it is no JSON object."""
    try:
        data = json.loads(text)
    except (ValueError, RecursionError):
        return None
    if not isinstance(data, dict):
        return None
    return {name.removeprefix(ANSWER_PREFIX): answer for name, answer in data.items()}


def list_code_cells(notebook: Any) -> list[Mapping[str, Any]]:
    """List the code cells of a notebook, or none if the data are no notebook."""
    cells = notebook.get("cells") if isinstance(notebook, Mapping) else None
    cells = cells if isinstance(cells, list) else []
    return [c for c in cells if isinstance(c, Mapping) and c.get("cell_type") == "code"]


def read_source(cell: Mapping[str, Any]) -> str:
    """Return the source of a cell, which notebooks store as a text or as a list of lines."""
    return _join_lines(cell.get("source"))


def _read_printed_text(output: Any) -> str:
    is_printed = isinstance(output, Mapping) and output.get("name") == "stdout"
    return _join_lines(output.get("text")) if is_printed else ""


def _join_lines(text: Any) -> str:
    if isinstance(text, list):
        text = "".join(filter(lambda line: isinstance(line, str), text))
    return text if isinstance(text, str) else ""
