"""Test the checks of arguments: valid input is converted, invalid input has a full message."""

import numpy as np
import pytest

from helpers.inputs import (
    ArmError,
    broadcast_shape,
    finite_array,
    finite_number,
    float_array,
    parse_plane,
    require_callable,
    require_choice,
    require_type,
    shorten,
    tuple_of_items,
    whole_number,
)

MASKED = np.ma.array([1, 2], mask=[0, 1])


class Orange:
    """A class whose name begins with a vowel, so that the message must say 'an'."""


@pytest.mark.parametrize(
    ("ask", "words"),
    [
        (lambda: require_type(3, Orange, "fruit"), "fruit is 3; expected an Orange"),
        (lambda: require_type(3, str, "name"), "name is 3; expected a str"),
        (lambda: require_callable(3, "path", "a function"), "path is 3; expected a function"),
        (lambda: finite_array([1, 2], "q", "(3,)", (3,)), "q has shape (2,); expected (3,)"),
        (lambda: finite_array(1, "q", "(3,)", (3,)), "q is 1; expected (3,)"),
        (lambda: finite_array([[1, 2, 3]], "q", "(3,)", (3,)), "q has shape (1, 3); expected (3,)"),
        (
            lambda: finite_array([1, np.nan, 3], "q", "x", (3,)),
            "q holds NaN or infinity; expected x",
        ),
        (
            lambda: finite_array([-2e100], "q", "x", (1,)),
            "q holds a number beyond 1e+100; expected x",
        ),
        (lambda: finite_array([1, 2], "T", "4", (None, 4), True), "T has shape (2,); expected 4"),
        (lambda: float_array(None, "q", "numbers"), "q is None; expected numbers"),
        (lambda: float_array("up", "q", "numbers"), "q is 'up'; expected numbers"),
        (lambda: float_array(1j, "q", "numbers"), "q is 1j; expected numbers"),
        (lambda: float_array([True], "q", "numbers"), "q is [True]; expected numbers"),
        (lambda: float_array([[1], [1, 2]], "q", "x"), "q is [[1], [1, 2]]; expected x"),
        (lambda: float_array([10**400], "q", "x"), f"q is [1{'0' * 75}...; expected x"),
        (lambda: float_array(MASKED, "q", "x"), f"q is {shorten(MASKED)}; expected x"),
        (lambda: finite_number("a", "m"), "m is 'a'; expected a finite number"),
        (lambda: finite_number([1], "m"), "m is [1]; expected a finite number"),
        (lambda: finite_number(np.inf, "m"), "m is inf; expected a finite number"),
        (lambda: finite_number(0, "m", "m > 0", above=0), "m is 0; expected m > 0"),
        (lambda: finite_number(-0.1, "m", "m >= 0", least=0), "m is -0.1; expected m >= 0"),
        (lambda: whole_number(-1, "steps"), "steps is -1; expected a whole number of 0 or more"),
        (lambda: whole_number(2, "steps", 3), "steps is 2; expected a whole number of 3 or more"),
        (
            lambda: whole_number(True, "steps"),
            "steps is True; expected a whole number of 0 or more",
        ),
        (lambda: whole_number(1.0, "steps"), "steps is 1.0; expected a whole number of 0 or more"),
        (lambda: require_choice("c", "part", ("a", "b")), "part is 'c'; expected one of a, b"),
        (lambda: require_choice(1, "part", ("a", "b")), "part is 1; expected one of a, b"),
        (lambda: tuple_of_items("ab", "rows", "a list"), "rows are 'ab'; expected a list"),
        (lambda: tuple_of_items(b"ab", "rows", "a list"), "rows are b'ab'; expected a list"),
        (lambda: tuple_of_items(3, "rows", "a list"), "rows are 3; expected a list"),
        *(
            (
                lambda plane=plane: parse_plane(plane),
                f"plane is {plane!r}; expected two different letters of x, y, z, such as 'yz'",
            )
            for plane in ("", "x", "xx", "xyz", "xw", "XY", "y,z", None, ("x", "y"), ["x"])
        ),
        (
            lambda: broadcast_shape("q and T", (2,), (3,)),
            "q and T have shapes (2,) and (3,); expected the same or one of one",
        ),
    ],
)
def test_invalid_input_has_complete_message(ask, words):
    with pytest.raises(ArmError) as error:
        ask()
    assert str(error.value) == words


def test_valid_input_is_converted():
    array = finite_array([[1, 2, 3]], "q", "(..., 3)", (3,), many=True)
    assert (array.shape, array.dtype) == ((1, 3), np.float64)
    assert finite_array([1, 2, 3], "q", "(..., 3)", (3,), many=True).shape == (3,)
    assert finite_array(np.zeros((5, 4)), "T", "(n, 4)", (None, 4)).shape == (5, 4)
    assert float_array(np.array([1, 2], np.uint8), "q", "numbers").tolist() == [1.0, 2.0]
    assert float_array(np.ma.array([1, 2]), "q", "numbers").tolist() == [1.0, 2.0]
    assert finite_number(0, "m", least=0) == 0.0
    assert type(finite_number(np.int64(2), "m", above=1)) is float
    assert (
        whole_number(0, "n"),
        whole_number(3, "n", 3),
        type(whole_number(np.int64(3), "n")),
    ) == (0, 3, int)
    assert require_choice("b", "part", {"a": 1, "b": 2}) == "b"
    assert tuple_of_items((x for x in (1, 2)), "rows", "a list") == (1, 2)
    assert broadcast_shape("q and T", (2, 1), (3,)) == (2, 3)
    require_type(Orange(), Orange, "fruit")
    require_callable(len, "path", "a function")


def test_plane_axes_keep_their_order():
    axes = {"xy": (0, 1), "xz": (0, 2), "yz": (1, 2), "yx": (1, 0), "zx": (2, 0), "zy": (2, 1)}
    assert {plane: parse_plane(plane) for plane in axes} == axes


def test_shown_truncates_after_80_characters():
    assert shorten("x" * 78) == "'" + "x" * 78 + "'"
    assert shorten("x" * 79) == "'" + "x" * 76 + "..."
