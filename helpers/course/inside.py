"""Run a notebook with nbclient and print what its names hold at the end; in the sandbox only."""

import json
import resource
import sys
from pathlib import Path
from typing import Any

_LAST = "from helpers.course.answers import collected\nprint({mark!r} + collected(globals()))"
_MARK = "the answers of this homework:"  # before the JSON in the last cell's output


def main(path: str, seconds: int, cell_seconds: int, memory: int) -> None:
    """Print the answers and the number of cells that failed as JSON."""
    import nbformat  # with nbclient an extra, which no other part of the kit needs
    from nbclient import NotebookClient
    from nbclient.exceptions import DeadKernelError

    limits = {"CPU": seconds, "AS": memory, "FSIZE": 2 * 10**7, "NOFILE": 256, "NPROC": 256}
    for name, most in {**limits, "CORE": 0}.items():
        resource.setrlimit(getattr(resource, f"RLIMIT_{name}"), (most, most))
    sources = json.loads(Path(path).read_bytes())
    cells = [nbformat.v4.new_code_cell(s) for s in (*sources, _LAST.format(mark=_MARK))]
    book = nbformat.v4.new_notebook(cells=cells)
    client = NotebookClient(
        book, timeout=cell_seconds, interrupt_on_timeout=True, allow_errors=True,
        kernel_name="python3",
    )  # fmt: skip
    try:
        client.execute()
    except DeadKernelError:
        print(json.dumps({"trouble": "its kernel stopped before the end"}))
    else:
        print(json.dumps(_result(book)))


def _result(book: Any) -> dict[str, Any]:
    printed = "".join(o.text for o in book.cells[-1].outputs if o.get("name") == "stdout")
    failed = sum(any(o.output_type == "error" for o in cell.outputs) for cell in book.cells)
    trouble = f"{failed} of its cells raised an error" if failed else ""
    return {"answers": json.loads(printed.split(_MARK)[-1]), "trouble": trouble}


if __name__ == "__main__":
    main(sys.argv[1], *map(int, sys.argv[2:]))
