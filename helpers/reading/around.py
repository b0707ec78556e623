"""What stands around the numbers of a paste and says nothing about them: prompts, comments, fences,
names, and what LaTeX sets beside a matrix. Written so that JavaScript has the same expressions.
"""

import re

from helpers.inputs import ArmError, shown

_FENCE = re.compile(r"(?<![^\n])[ \t]*```[^\n\r]*")
_PROMPT = r"(?<![^\n])[ \t]*(?:>>>?|(?:In|Out) ?\[[0-9]*\]:)[ \t]*"
_ASKED = re.compile(
    _PROMPT + r"(?:[A-Za-z_][A-Za-z0-9_]*|(?:print|disp|display)\([A-Za-z0-9_]*\))[ \t]*(?![^\n\r])"
)
_PROMPTED = re.compile(_PROMPT)
_COMMENT = re.compile(r"((?<![^\n])|[;,\]]|\.\.\.|\\\\)[ \t]*[#%][^\n\r]*")
_LABEL = re.compile(r"^[ \t\r\n]*[A-Za-z_][A-Za-z0-9_]*[ \t]*:[ \t\r\n]*(?=[\[({])")
_SIGN = re.compile(r"^[ \t\r\n]*=[ \t]*(?=[\[({])")

_INNER = r"\{(?:[A-Za-z]*matrix\*?|array|tabular)\}"
_BEGIN, _END = re.compile(r"\\begin" + _INNER), re.compile(r"\\end" + _INNER)
_SET_BEFORE = re.compile(
    r"\\begin\{[a-z]+\*?\}|\\label\{[^{}]*\}"
    r"|\\(?:displaystyle|scriptsize|footnotesize|small|tiny|boxed|left[ \t]*[\[(|.]|\[|\()"
    r"|[$&{ \t\r\n]"
)
_SET_AFTER = re.compile(
    r"\\end\{[a-z]+\*?\}|\\label\{[^{}]*\}|\\(?:right[ \t]*[\])|.]|\]|\))|[$}.,; \t\r\n]"
)
_NAME = re.compile(r"(?:(?!\\[dt]?frac[0-9])[^-=0-9][^=]*=)+")  # J =, or dx/dq = J =
_FACTOR = re.compile(
    r"(?:\\(?:[dt]?frac|cdot|times|ast|sqrt|pi)|[-+*/^0-9.,(){}]"
    r"|(?<![A-Za-z])[A-Za-z](?:_[0-9A-Za-z])?(?![A-Za-z]))+"
)
_LATEX = (
    (re.compile(r"\\[hv]?phantom\{[^{}]*\}"), " "),
    (re.compile(r"\\num\{([^{}]*)\}"), r"\1"),
    (re.compile(r"\{([-+])\}"), r"\1"),
    (re.compile(r"(?<=[0-9])\{,\}(?=[0-9])"), "."),
)


def bare(text: str) -> str:
    """A paste without what only stands around it."""
    text = _COMMENT.sub(r"\1", _FENCE.sub("", text.replace("\ufeff", "")))
    text = _PROMPTED.sub("", _ASKED.sub("", text))
    return _SIGN.sub("", _LABEL.sub("", text))


def bare_latex(text: str) -> str:
    """LaTeX without a name and what else is set beside its one matrix, and with its numbers as they
    are elsewhere; raises ArmError for a factor beside it.
    """
    begins, ends = list(_BEGIN.finditer(text)), list(_END.finditer(text))
    if len(begins) == len(ends) == 1:
        start, end = begins[0].start(), ends[0].end()
        before, after = _SET_BEFORE.sub("", text[:start]), _SET_AFTER.sub("", text[end:])
        alone(text[:start], _NAME.sub("", before))
        alone(text[end:], after)
        named = not before or _NAME.fullmatch(before)
        text = text[start if named else 0 : len(text) if after else end]
    for pattern, instead in _LATEX:
        text = pattern.sub(instead, text)
    return text


def alone(stands: str, factor: str) -> None:
    """Raise ArmError where a factor stands beside a matrix: it is meant for every entry."""
    if _FACTOR.fullmatch(factor):
        beside = shown(stands.strip())
        raise ArmError(f"beside the matrix stands {beside}; expected entries that hold it")
