"""Write a single number in the formats of people and tools."""

from dataclasses import dataclass
from fractions import Fraction
from math import isclose, pi, sqrt
from random import Random

SUPERSCRIPTS = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")

#: Weights of the kinds. Most answers are copied from a rounded print (fixed decimals); a tenth are
#: full prints of Python; powers of ten, fractions of pi and surds stand in hand-typed answers.
KIND_WEIGHTS = {
    "fixed": 50,
    "trimmed": 12,
    "general": 9,
    "repr": 10,
    "scientific": 5,
    "power": 5,
    "float64": 3,
    "pi": 5,
    "exact": 6,
}


@dataclass(frozen=True)
class NumberFormat:
    """Format of every number of an answer.

    Attributes:
        kind: one of KIND_WEIGHTS.
        digits: decimals, or significant digits for "general".
        minus: character of the minus.
        comma: whether the decimal mark is a comma.
        plus, bare_point, thousands: "+0.5", ".5", "1,234.5".
        plain_zero: whether an exact zero is typed "0".
        power, pi: spelling of a power of ten and of pi.
    """

    kind: str
    digits: int
    minus: str = "-"
    comma: bool = False
    plus: bool = False
    bare_point: bool = False
    thousands: bool = False
    plain_zero: bool = True
    power: str = " × 10^{0}"
    pi: str = "π"


#: Spellings of a power of ten and of pi, by class of layout.
POWERS = {
    "code": ("*10^{0}", "*10**({0})"),
    "print": (" × 10^{0}",),
    "latex": (r" \times 10^{{{0}}}", r"\cdot 10^{{{0}}}"),
    "markdown": (" × 10^{0}", "×10^{0}", " * 10^{0}", " x 10^{0}", " × 10{s}", "·10{s}"),
    "html": (" × 10<sup>{0}</sup>", " × 10^{0}", "·10{s}"),
    "text": (" × 10^{0}", "×10^{0}", "*10^{0}", " x 10^{0}", " × 10{s}", "·10{s}", " × 10^({0})"),
}
PIS = {
    "code": ("*pi",),
    "print": ("*pi",),
    "latex": (r"\pi", r"\,\pi"),
    "markdown": ("π", " π", "*pi"),
    "html": ("π", "&pi;"),
    "text": ("π", " π", "*pi", "pi"),
}


def draw_format(rng: Random, family: str, *, angles: bool, commas: bool) -> NumberFormat:
    """Draw a number format.

    Args:
        family: class of the layout, which says what it can hold.
        angles: whether all numbers are angles in rad, so that multiples of pi can be typed.
        commas: whether the layout leaves a decimal comma readable.
    """
    weights = dict(KIND_WEIGHTS)
    if family != "code":
        del weights["float64"]
    if family in ("print", "code"):
        del weights["power"]
    if not angles:
        del weights["pi"]
    kind = rng.choices(list(weights), list(weights.values()))[0]
    # Teachers and programs mostly use three to six decimals; eight are rare.
    digits = rng.choices((3, 4, 5, 6, 8), (22, 38, 12, 22, 6))[0]
    handwritten = family in ("latex", "markdown", "html", "text")
    return NumberFormat(
        kind,
        digits + (1 if kind == "general" else 0),
        minus="−" if handwritten and family != "latex" and rng.random() < 0.10 else "-",
        comma=commas and kind != "repr" and rng.random() < 0.09,
        plus=handwritten and rng.random() < 0.04,
        bare_point=family != "code" and rng.random() < 0.03,
        thousands=handwritten and rng.random() < 0.5,
        plain_zero=rng.random() < 0.6,
        power=rng.choice(POWERS[family]),
        pi=rng.choice(PIS[family]),
    )


def write_number(value: float, style: NumberFormat, family: str) -> tuple[str, float]:
    """Write a number; return its text and the unit of its last typed digit."""
    if style.kind in ("repr", "float64"):
        text = repr(float(value))
        text = f"np.float64({text})" if style.kind == "float64" else text
        return text, 1e-12
    value = 0.0 if abs(value) < 1e-12 else float(value)
    if value == 0 and style.plain_zero:
        return "0", 0.0
    if style.kind == "exact":
        text = _exact_text(value, style, family)
        if text:
            return text.replace("-", style.minus), 0.0
    text, unit = _decimal_text(value, style)
    if style.kind == "pi":
        text, unit = text + style.pi, unit * pi
    if style.bare_point:
        text = text.replace("-0.", "-.") if text.startswith("-0.") else text.removeprefix("0")
        text = text if text and text[0] != "p" else "0" + text
    if style.plus and value > 0:
        text = "+" + text
    if style.comma:
        text = text.replace(",", " ").replace(".", ",")
    return text.replace("-", style.minus), unit


def _decimal_text(value: float, style: NumberFormat) -> tuple[str, float]:
    digits, unit = style.digits, 10.0**-style.digits
    if style.kind == "general":
        text = f"{value:.{digits}g}"
        return text, unit_of_last_digit(text)
    if style.kind in ("scientific", "power") and value:
        mantissa, power = f"{value:.{digits}e}".split("e")
        unit *= 10.0 ** int(power)
        if style.kind == "scientific":
            return f"{value:.{digits}e}", unit
        exponent = int(power)
        if exponent == 0:
            return mantissa, unit
        spelled = style.power.format(exponent, s=str(exponent).translate(SUPERSCRIPTS))
        return mantissa + spelled, unit
    if style.kind == "pi":
        return f"{value / pi:.{digits}f}", unit
    text = f"{value:,.{digits}f}" if style.thousands else f"{value:.{digits}f}"
    if style.kind == "trimmed":
        text = text.rstrip("0").rstrip(".")
        text = "0" if text in ("-0", "") else text
        unit = unit if text == "0" else unit_of_last_digit(text.replace(",", ""))
    return text, unit


def unit_of_last_digit(text: str) -> float:
    """Return the unit of the last typed digit, 0.1 for "0.2"."""
    mantissa, _, power = text.partition("e")
    return 10.0 ** (int(power or 0) - len(mantissa.partition(".")[2]))


def _exact_text(value: float, style: NumberFormat, family: str) -> str:
    """Write a multiple of pi/24, a simple fraction or a square root; "" for other numbers."""
    pi_text, root = ("pi", "sqrt({})") if family in ("code", "print") else ("π", "√{}")
    if family == "latex":
        pi_text, root = r"\pi", r"\sqrt{{{}}}"
    for unit, name in ((pi, pi_text), (sqrt(2), root.format(2)), (sqrt(3), root.format(3))):
        share = Fraction(value / unit).limit_denominator(24)
        if share and isclose(float(share) * unit, value, rel_tol=0, abs_tol=1e-12):
            return _share_text(share, name, family)
    return ""


def _share_text(share: Fraction, name: str, family: str) -> str:
    mark = "*" if family in ("code", "print") else ""
    sign, top = ("-" if share < 0 else ""), abs(share.numerator)
    numerator = name if top == 1 else f"{top}{mark}{name}"
    if share.denominator == 1:
        return sign + numerator
    if family == "latex":
        return rf"{sign}\frac{{{numerator}}}{{{share.denominator}}}"
    return f"{sign}{numerator}/{share.denominator}"
