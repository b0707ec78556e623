"""Live figures of arms, for running notebooks and for the pages of the built book."""

try:
    from helpers.explorer.figure import ArmFigure
    from helpers.explorer.widget import ArmExplorer
except ModuleNotFoundError as error:
    if error.name not in ("anywidget", "traitlets"):
        raise
    raise ModuleNotFoundError("the explorer needs anywidget; say: pip install anywidget") from None

__all__ = ["ArmExplorer", "ArmFigure"]
