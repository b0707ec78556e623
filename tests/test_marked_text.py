"""Test the marks that a verdict shows on a typed answer in a notebook."""

import numpy as np
import pytest

from helpers import kinematics, statics
from helpers.checks import UnreadNumberError, compare_jacobian, compare_tables, compare_torques
from helpers.checks.marked_text import _ELEMENTS, MarkedText, TextPiece
from helpers.inputs import ArmError
from helpers.robots import ELBOW, PANDA

Q = (0.1, 0.5, 0.2, -1.0, 0.3, 0.4, 0.2)
JACOBIAN = kinematics.jacobian(PANDA, Q)
TORQUES = statics.static_torque(PANDA, Q, np.zeros(6))


def print_torques(torques):
    return "\n".join(f"{joint} | {torque:.3f}" for joint, torque in enumerate(torques, 1))


def list_pieces(marked_text, kind):
    return [piece.text for piece in marked_text.pieces if piece.kind == kind]


def test_wrong_jacobian_shows_wrong_entry_with_position():
    wrong = JACOBIAN.copy()
    wrong[2, 3] *= -1
    verdict = compare_jacobian(str(wrong.round(4)), PANDA, Q)
    assert list_pieces(verdict.marked_text, "wrong") == [f"{wrong[2, 3]:.4f}"]
    shown = verdict._repr_markdown_()
    assert shown.count("<pre") == 1
    typed = f"{wrong[2, 3]:.4f}".replace("-", "−")
    assert f'title="entry of vz, joint 4, read as {typed}, wrong"' in shown


def test_omega_rows_first_are_named_as_typed():
    rows = np.vstack([JACOBIAN[3:], -JACOBIAN[:3]])
    verdict = compare_jacobian(str(rows.round(4)), PANDA, Q, angular_first=True)
    assert 'title="entry of ωx, joint 1' in verdict._repr_markdown_()


def test_decimal_comma_is_marked_as_one_number():
    numbers = [f"{torque:.3f}".replace(".", ",") for torque in 2 * TORQUES]
    verdict = compare_torques("\n".join(numbers), PANDA, Q)
    marked = [piece.text for piece in verdict.marked_text.pieces if piece.kind]
    assert marked == numbers


def test_decimal_comma_in_table_is_marked_as_one_number():
    text = "i;a;alpha;d;theta\n1;0;pi/2;0,5;q1\n2;0,4;0;0;q2\n3;0,35;0;0;q3"
    verdict = compare_tables(text, ELBOW)
    assert list_pieces(verdict.marked_text, "wrong") == ["0,35"]


def test_right_text_is_not_shown_again():
    verdict = compare_torques(print_torques(TORQUES), PANDA, Q)
    assert verdict.agrees
    assert list_pieces(verdict.marked_text, "label") == list("1234567")
    assert "<pre" not in verdict._repr_markdown_()


def test_right_verdict_marks_a_number_outside_the_answer():
    verdict = compare_torques(f"run 3 of my script\n{print_torques(TORQUES)}", PANDA, Q)
    assert verdict.agrees
    assert list_pieces(verdict.marked_text, "context") == ["3"]
    assert ">3</s>" in verdict._repr_markdown_()


def test_wrong_table_shows_wrong_entry():
    text = "i|a|alpha|d|theta\n1|0|pi/2|0.5|q1\n2|0.4|0|0|q2\n3|0.35|0|0|q3"
    verdict = compare_tables(text, ELBOW)
    assert list_pieces(verdict.marked_text, "wrong") == ["0.35"]
    assert 'title="entry of row 3, a, read as 0.35 m, wrong"' in verdict._repr_markdown_()


def test_extra_column_headers_leave_entries_unchanged():
    rows = "0 90 0.5 q1\n0.4 0 0 q2\n0.35 0 0 q3"
    verdict = compare_tables(f"a alpha d theta offset\n{rows}", ELBOW)
    assert 'title="entry of row 3, a, read as 0.35 m, wrong"' in verdict._repr_markdown_()


@pytest.mark.parametrize(
    "verdict",
    [
        compare_jacobian(2 * JACOBIAN, PANDA, Q),
        compare_tables([[0, 90, 0.5, 0], [0.4, 0, 0, 0], [0.35, 0, 0, 0]], ELBOW),
        compare_tables(ELBOW.with_values(a_2=0.5), ELBOW),
    ],
    ids=["array", "lists", "arm"],
)
def test_answer_in_numbers_has_no_marked_text(verdict):
    assert not verdict.agrees
    assert verdict.marked_text is None
    assert "<pre" not in verdict._repr_markdown_()


def test_markup_of_text_is_escaped():
    text = f'{print_torques(TORQUES)}\n# 7 <b> & $x$ \\(y\\) "𝜃" 9'
    marked_text = compare_torques(text, PANDA, Q).marked_text
    assert "".join(piece.text for piece in marked_text.pieces) == text
    assert list_pieces(marked_text, "context") == ["7", "9"]
    end = marked_text.format_html().partition(">7</s>")[2]
    assert end.startswith(" &lt;b&gt; &amp; &#36;x&#36; &#92;(y&#92;) &quot;𝜃&quot; <s ")


def test_unread_number_stops_verdict_and_is_quoted():
    text = print_torques(TORQUES).replace("2 | -", "2 | -1l2")
    with pytest.raises(UnreadNumberError, match=r"^I cannot read '-1l2") as caught:
        compare_torques(text, PANDA, Q)
    line = text.split("\n")[1]
    note = f"line 2: 2 | «{line.removeprefix('2 | ')}»"
    assert caught.value.__notes__ == [note]
    assert isinstance(caught.value, ArmError)
    assert 'title="not read: nothing is graded"' in caught.value.marked_text._repr_markdown_()


def test_unread_number_of_configuration_leaves_answer_unmarked():
    with pytest.raises(ArmError) as caught:
        compare_torques(print_torques(TORQUES), PANDA, "0.1 0.5 0.2 -1 0.3 0.4 0.2l2")
    assert not isinstance(caught.value, UnreadNumberError) or "0.2l2" in str(
        caught.value.marked_text
    )


def make_long_text(count, kind_of_last):
    lines = [TextPiece("0.5", "entry", "an entry"), TextPiece("\n")] * count
    return MarkedText((*lines, TextPiece("7", kind_of_last, "a note")), {"entry": "entry"})


def test_long_text_shows_only_notable_lines():
    html = make_long_text(300, "context").format_html()
    assert html.count("</u>") == 0
    assert html.count("</s>") == 1
    assert make_long_text(300, "label").format_html() == ""
    assert make_long_text(20, "label").format_html().count("an entry") == 20


def test_long_text_of_wrong_entries_is_cut():
    pieces = [TextPiece("0.5", "wrong"), TextPiece("\n")] * 300
    html = MarkedText(tuple(pieces), {}).format_html()
    assert html.count("</b>") == 200
    assert "…" in html


def test_every_kind_of_mark_has_an_element():
    marked_text = compare_torques(print_torques(TORQUES), PANDA, Q).marked_text
    assert list(marked_text.names) == list(_ELEMENTS)


def test_wrong_torque_is_marked_in_list_per_joint():
    configurations = np.array([Q, np.roll(Q, 1), np.roll(Q, 2)])
    torques = statics.static_torque(PANDA, configurations, np.zeros(6))
    torques[1, 3] += 1
    text = "\n".join(" ".join(f"{x:.3f}" for x in joint) for joint in torques.T)
    verdict = compare_torques(text, PANDA, configurations)
    assert list_pieces(verdict.marked_text, "wrong") == [f"{torques[1, 3]:.3f}"]


def test_jacobian_in_one_column_marks_entry_by_its_row():
    wrong = JACOBIAN.copy()
    wrong[2, 3] *= -1
    text = "\n".join(f"{x:.4f}" for x in wrong.ravel())
    marked_text = compare_jacobian(text, PANDA, Q).marked_text
    (piece,) = [piece for piece in marked_text.pieces if piece.kind == "wrong"]
    assert piece.description.startswith("entry of vz, joint 4, read as ")


def test_torques_in_order_of_listed_names_mark_their_joints():
    names = [7, 6, 5, 4, 3, 2, 1]
    torques = TORQUES.copy()
    torques[1] *= -1
    values = [f"{torques[k - 1]:.3f}" for k in names]
    text = f"name: [{', '.join(f'joint{k}' for k in names)}]\neffort: [{', '.join(values)}]"
    marked_text = compare_torques(text, PANDA, Q).marked_text
    (piece,) = [piece for piece in marked_text.pieces if piece.kind == "wrong"]
    assert (piece.text, piece.description[:16]) == (values[5], "entry of joint 2")


def list_marks(verdict):
    pieces = verdict.marked_text.pieces
    return [(piece.text, piece.kind, piece.description) for piece in pieces if piece.kind]


@pytest.mark.parametrize(
    "centres", ["", "\tCentre of mass"], ids=["numbers alone", "vectors in brackets"]
)
def test_other_columns_of_table_are_marked_as_set_aside(centres):
    vector = "\t[0, 0.1, 0.2]" if centres else ""
    text = (
        f"a\talpha\td\ttheta\tMass [kg]{centres}\n0\t90\t0.5\tq1\t3{vector}\n"
        f"0.4\t0\t0\tq2\t2.2{vector}\n0.35\t0\t0\tq3\t1.1{vector}"
    )
    verdict = compare_tables(text, ELBOW)
    marks = list_marks(verdict)
    assert "".join(piece.text for piece in verdict.marked_text.pieces) == text
    assert list_pieces(verdict.marked_text, "wrong") == ["0.35"]
    masses = [mark for mark in marks if mark[2] == "set aside: column Mass [kg]"]
    assert masses == [(mass, "context", masses[0][2]) for mass in ("3", "2.2", "1.1")]
    assert sum(mark[2] == "set aside: column Centre of mass" for mark in marks) == (
        9 if centres else 0
    )
    assert "Mass [kg]" in str(verdict)


def test_column_of_offsets_is_marked_as_entries_of_theta():
    text = (
        "i|theta|d|a|alpha|offset|home\n1|q1|0.5|0|90|0|10\n2|q2|0|0.4|0|30|20\n3|q3|0|0.3|0|0|30"
    )
    marks = list_marks(compare_tables(text, ELBOW))
    (description,) = [mark[2] for mark in marks if mark[0] == "30" and mark[1] == "entry"]
    assert description.startswith("entry of row 2, θ, read as q_2 + 30°")
    assert ("10", "context", "set aside: column home") in marks
