"""The tool that runs notebooks as other processors would: it notices what a last digit moves, and
nothing else."""

import nbformat
import numpy as np
import pytest

from helpers.kinematics import tip
from helpers.robots import PANDA
from tools.noise import KERNELS, SEEDS, Setting, outside, said, settings, tight
from tools.rerun import difference, words
from tools.rounding import Noise

QUIET = Setting("this processor", {})
NOISES = [Setting(f"noise {seed}", {}, seed) for seed in (1, 2)]
INVERSE = np.linalg.inv(np.vander([1.1, 2.2, 3.3])).tolist()
HEAD = """import numpy as np
from helpers.checks import check
from helpers.kinematics import tip
from helpers.robots import PANDA
long, many = np.linalg.norm([1.0, 2.0, 7.6]), np.arange(200.0)[:, None]"""


@pytest.fixture(scope="module")
def planted(tmp_path_factory):
    """A notebook with one cell of each kind, its outputs as this processor gives them."""
    cells = {
        "rounded": ("print(f'{long:.4f}')", "7.9221\n"),
        "all digits": ("print(np.linalg.inv(np.vander([1.1, 2.2, 3.3])).tolist())", f"{INVERSE}\n"),
        "a product": ("print((many @ [[1.0]] == many).all())", "True\n"),
        "a tight check": ("check('many', many @ [[1.0]], many, 8e-14)", "✔ many (within 8e-14)\n"),
        "a fair check": ("check('long', long, np.sqrt(62.76), 1e-12)", "✔ long (within 1e-12)\n"),
        "a quoted number": ("check('long', long, 7.922, 5e-4)", "✔ long (within 0.0005)\n"),
        "trigonometry": ("print(np.cos(many).sum())", f"{np.cos(np.arange(200.0)).sum()}\n"),
        "a pose": (
            "print(tip(PANDA, PANDA.home).tolist())",
            f"{tip(PANDA, PANDA.home).tolist()}\n",
        ),
    }
    path = tmp_path_factory.mktemp("noise") / "planted.ipynb"
    value = nbformat.v4.new_output("execute_result", data={"text/plain": "'a last value'"})
    code = [nbformat.v4.new_code_cell(HEAD)]
    for source, text in cells.values():
        output = nbformat.v4.new_output("stream", name="stdout", text=text)
        code.append(nbformat.v4.new_code_cell(source, outputs=[output]))
    code.append(nbformat.v4.new_code_cell("'a last value'", outputs=[value]))
    nbformat.write(nbformat.v4.new_notebook(cells=code), path)
    return str(path), ["the imports", *cells, "a last value"]


@pytest.fixture(scope="module")
def runs(planted):
    return [outside(setting, [planted[0]]) for setting in (QUIET, *NOISES)]


def test_without_noise_nothing_changes(planted, runs):
    assert not runs[0][planted[0]].changed


def test_a_planted_last_digit_is_noticed(planted, runs):
    path, names = planted
    changed = {names[cell] for run in runs[1:] for cell, _ in run[path].changed}
    assert changed == {"all digits", "a product", "trigonometry", "a pose"}
    assert all("planted.ipynb [" in line for line in said(NOISES[0], runs[1]))


def test_a_tolerance_that_rounding_uses_up_is_told(planted, runs):
    (line,) = tight(runs)
    assert f"[{planted[1].index('a tight check')}] 'many': uses 0 to" in line


def test_a_figure_is_compared_by_its_coordinates_and_not_by_the_ids_drawn_from_them():
    def figure(point, name):
        return words({"image/svg+xml": f'<path d="M{point}" clip-path="url(#f{name}-1)"/>'})

    assert figure(2.25, "01234567") == figure(2.25, "89abcdef")
    before, after = difference([figure(2.25, "0" * 8)], [figure(2.26, "0" * 8)]).split(" becomes ")
    assert "M2.25" in before
    assert "M2.26" in after


def test_every_kernel_and_every_seed_has_its_run(monkeypatch):
    from numpy._core import _multiarray_umath

    def found(**features):
        monkeypatch.setattr(_multiarray_umath, "__cpu_features__", features)
        return settings()

    every = found(**{needs: True for needs, *_ in KERNELS.values()})
    assert [one.environment["OPENBLAS_CORETYPE"] for one in every] == list(KERNELS)
    assert [one.seed for one in every] == list(SEEDS)
    old = found(SSE3=True, SSE42=True, AVX2=False)
    assert [one.name.split(",")[0] for one in old] == ["Prescott", "Nehalem"] * 3
    assert [(one.environment, one.seed) for one in found()] == [({}, seed) for seed in SEEDS]


@pytest.mark.parametrize("value", [np.linspace(-2, 2, 500), np.geomspace(1e-300, 1e300, 500)])
def test_noise_is_two_units_in_the_last_place_at_most(value):
    for seed in range(50):
        off = np.abs(Noise(seed)(value) - value) / np.spacing(np.abs(value))
        assert 1 < off.max() <= 2
        assert (off == 0).any()
        both = Noise(seed)(value + 1j * value)
        assert (both.real == Noise(seed)(value)).all()
        assert (both.imag == both.real).all()


def test_noise_leaves_alone_what_no_rounding_moves():
    noise = Noise()
    for exact in (3, True, -0.0, "text", None, np.arange(4), [1.0], 0.0, np.inf):
        assert noise(exact) is exact or noise(exact) == exact
    assert not noise(np.zeros(9)).any()
    for kind in (float, np.float64, np.array):
        assert type(noise(kind(0.7))) in (type(kind(0.7)), np.float64)
    assert type(noise(0.7)) is float


def test_the_same_computation_gives_the_same_number_twice_but_not_on_another_processor():
    values = np.linspace(0.1, 1, 99)
    assert (Noise(7)(values) == [Noise(7)(value) for value in values.tolist()]).all()
    assert 30 < (Noise(7)(values) != Noise(8)(values)).sum() < 99
