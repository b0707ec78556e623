"""What the reports of all comparisons share."""


class Verdict:
    """A report that is content if it holds no findings, and reads as text in a terminal and as
    Markdown in a notebook.

    A subclass is a dataclass with `findings` and says itself in words by `__str__`, its verdict in
    the first line.
    """

    findings: tuple[object, ...]

    @property
    def agrees(self) -> bool:
        """Whether all is right: nothing was found."""
        return not self.findings

    def __repr__(self) -> str:
        return str(self)

    def _repr_markdown_(self) -> str:
        head, *lines = str(self).split("\n")
        return "\n".join([f"{'✔' if self.agrees else '✘'} **{head}**", "", *lines])
