"""Run a notebook with nbclient and print what its names hold at the end; in the sandbox only."""

import json
import resource
import sys
from typing import Any

_LAST = """import json
from course.answers import collected
print({mark!r} + json.dumps(collected(globals())))"""
_MARK = "the answers of this homework:"  # before the JSON in the last cell's output
_TOLD, _WORDS = 3, 60  # cells that failed, and letters of each and of what it raised
_MEMORY = 4 * 2**30  # bytes of each process


def main(seconds: int) -> None:
    """Read the cells as JSON; print the answers, and which cells raised what, as JSON."""
    import nbformat  # with nbclient an extra, which no other part of the kit needs
    from nbclient import NotebookClient
    from nbclient.exceptions import DeadKernelError

    limits = {"CPU": seconds, "AS": _MEMORY, "FSIZE": 2 * 10**7, "NOFILE": 256, "NPROC": 256}
    for name, most in {**limits, "CORE": 0}.items():
        resource.setrlimit(getattr(resource, f"RLIMIT_{name}"), (most, most))
    sources = [*json.load(sys.stdin), _LAST.format(mark=_MARK)]
    book = nbformat.v4.new_notebook(cells=list(map(nbformat.v4.new_code_cell, sources)))
    client = NotebookClient(
        book, timeout=max(1, seconds // 4), interrupt_on_timeout=True, allow_errors=True,
        kernel_name="python3",
    )  # fmt: skip
    try:
        client.execute()
    except DeadKernelError:
        print(json.dumps({"answers": {}, "trouble": "its kernel stopped before the end"}))
    else:
        print(json.dumps(_result(book)))


def _result(book: Any) -> dict[str, Any]:
    printed = "".join(o.text for o in book.cells[-1].outputs if o.get("name") == "stdout")
    failed = [
        f"the cell `{_begins(cell.source)}` {_raised(output)}"
        for cell in book.cells
        for output in cell.outputs
        if output.output_type == "error"
    ]
    return {"answers": json.loads(printed.split(_MARK)[-1]), "trouble": "; ".join(failed[:_TOLD])}


def _begins(source: str) -> str:
    """The first line that is no comment."""
    lines = [line.strip() for line in source.splitlines()]
    return next((s for s in lines if s and not s.startswith("#")), "")[:_WORDS]


def _raised(output: Any) -> str:
    if output.ename == "KeyboardInterrupt":
        return "was stopped, since it took too long"
    return f"raised {output.ename}: {output.evalue[:_WORDS]}"


if __name__ == "__main__":
    main(int(sys.argv[1]))
