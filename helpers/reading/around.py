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
_COMMENT = re.compile(r"((?<![^\n])|[;,\]]|\.\.\.|\\\\)[ \t]*(?:%|#(?![A-Z]+[/!?]))[^\n\r]*")
_REMARK = re.compile(r"(?<=[0-9.)])[ \t]+[#%][ \t]*[A-Za-z][^\n\r]*")  # 50 % 20 % is none
_CURLED = str.maketrans("“”„‟", '""""', "\ufeff")
_CURLED_ONCE = re.compile(r"‘([^‘’\n]*)’")
_LABEL = re.compile(r"^[ \t\r\n]*[A-Za-z_][A-Za-z0-9_]*[ \t]*:[ \t\r\n]*(?=[\[({])")
_SIGN = re.compile(r"^[ \t\r\n]*=[ \t]*(?=[\[({])")

_INNER = r"\{(?:[A-Za-z]*matrix\*?|array|tabular)\}"
_BEGIN, _END = re.compile(r"\\begin" + _INNER), re.compile(r"\\end" + _INNER)
_SET_BEFORE = re.compile(
    r"\\begin\{[a-z]+\*?\}|\\label\{[^{}]*\}"
    r"|\\(?:displaystyle|scriptsize|footnotesize|small|tiny|boxed)"
    r"|\\(?:(?:left|[bB]igg?l?)[ \t]*[\[(|.]|\[|\()"
    r"|[$&{ \t\r\n]"
)
_SET_AFTER = re.compile(
    r"\\end\{[a-z]+\*?\}|\\(?:label|tag)\{[^{}]*\}|\\(?:q?quad|nonumber|notag)(?![A-Za-z])"
    r"|\\(?:(?:right|[bB]igg?r?)[ \t]*[\])|.]|\]|\))|[$}.,; \t\r\n]"
)
_NAME = re.compile(  # J =, or dx/dq = J =
    r"(?:(?!\\[dt]?frac[0-9])[^-=0-9](?:(?!\\approx)[^=])*(?:=|\\approx))+"
)
_FACTOR = re.compile(
    r"(?:\\(?:[dt]?frac|cdot|times|ast|sqrt|pi|circ|degree)|[-+*/^0-9.,(){}°]"
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
    text = _COMMENT.sub(r"\1", _FENCE.sub("", straight(text)))
    text = _PROMPTED.sub("", _ASKED.sub("", _REMARK.sub("", text)))
    return _SIGN.sub("", _LABEL.sub("", text))


def straight(text: str) -> str:
    """A text with the quotes that programs know, and without byte order marks."""
    return _CURLED_ONCE.sub(r"'\1'", text.translate(_CURLED))


def bare_latex(text: str) -> str:
    """LaTeX without a name and what else is set beside its one matrix, and with its numbers as they
    are elsewhere; raises ArmError for a factor beside it.
    """
    begins, ends = list(_BEGIN.finditer(text)), list(_END.finditer(text))
    if len(begins) == len(ends) == 1:
        start, end = begins[0].start(), ends[0].end()
        before, after = _SET_BEFORE.sub("", text[:start]), _SET_AFTER.sub("", text[end:])
        if before[-1:] + after[:1] in ("()", "[]"):
            before, after = before[:-1], after[1:]
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
        raise beside(stands)


def beside(stands: str) -> ArmError:
    """What is said where something that matters stands beside a matrix."""
    given = shown(stands.strip())
    return ArmError(f"beside the matrix stands {given}; expected entries that hold it")
