"""What is taken out of the built pages, and what must stay."""

import re
from types import SimpleNamespace

import pytest

from tools.light_pages import (
    assets,
    lighter,
    one_sheet,
    plain_classes,
    whole_sheet,
    without_repository,
    without_spans,
    without_unused,
)

HEAD = """<link rel="preload" as="script" href="_static/scripts/bootstrap.js?digest=1" />
<script defer src="_static/scripts/fontawesome.js?digest=1"></script>
<script src="_static/documentation_options.js?v=2"></script>
<script src="_static/doctools.js?v=3"></script>
    <script src="_static/searchtools.js"></script>
    <script src="searchindex.js"></script>
<script data-sd-tabs-storage-prefix="x-" src="_static/design-tabs.js?v=4"></script>"""


@pytest.fixture
def folder(tmp_path):
    """Where a page stands: with the theme's options beside it."""
    (tmp_path / "_static").mkdir()
    options = "const OPTIONS = {\n    BUILDER: 'html',\n};\n"
    (tmp_path / "_static/documentation_options.js").write_text(options, encoding="utf-8")
    return tmp_path


INLINE = "<script>const OPTIONS = { BUILDER: 'html', };</script>"


def test_unused_scripts_go_and_small_ones_wait(folder):
    html = lighter(HEAD, folder)
    assert "fontawesome" not in html
    assert "search" not in html
    assert "preload" not in html, "it would come before the style sheet"
    assert '<script defer src="_static/doctools.js?v=3">' in html
    assert (
        '<script defer data-sd-tabs-storage-prefix="x-" src="_static/design-tabs.js?v=4">' in html
    )
    assert INLINE in html, "code in the page needs it at once"
    assert lighter(html, folder) == html


def test_the_page_of_search_results_keeps_its_scripts(folder):
    html = lighter(HEAD, folder, search=True)
    assert html.strip().split("\n") == [INLINE, *HEAD.split("\n")[3:]]


def test_a_picture_gets_the_size_that_its_file_says(tmp_path):
    (tmp_path / "a.svg").write_text(
        '<svg xmlns="http://www.w3.org/2000/svg" width="300pt" height="150pt"/>', encoding="utf-8"
    )
    (tmp_path / "b.svg").write_text(
        '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 1 1"/>', encoding="utf-8"
    )
    html = lighter(
        '<img alt="A" src="a.svg" /><img alt="B" src="b.svg"><img alt="C" src="c.svg"/>', tmp_path
    )
    assert '<img alt="A" src="a.svg" width="400" height="200"/>' in html
    assert html.count("width") == 1
    assert lighter(html, tmp_path) == html


def test_pictures_far_from_the_top_wait_until_they_are_near(tmp_path):
    square = '<svg xmlns="http://www.w3.org/2000/svg" width="9" height="9"/>'
    (tmp_path / "a.svg").write_text(square, encoding="utf-8")
    picture = '<img src="a.svg"/>'
    html = lighter(f"<article>{picture}{'prose ' * 1000}{picture}</article>", tmp_path)
    near, far = re.findall("<img.*?>", html)
    assert "loading" not in near
    assert 'loading="lazy"' in far


def test_a_picture_of_several_panels_is_marked_as_wide(tmp_path):
    for name, width in (("narrow", 525), ("wide", 526)):  # points: 700 and 701 pixels
        (tmp_path / f"{name}.svg").write_text(
            f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}pt" height="150pt"/>',
            encoding="utf-8",
        )
    html = lighter('<img src="narrow.svg" /><img src="wide.svg" />', tmp_path)
    assert html.count('class="wide"') == 1
    assert html.index("wide.svg") < html.index('class="wide"')


def test_a_formula_keeps_its_comma(tmp_path):
    formula = '<span class="math notranslate nohighlight">\\(a &lt; b\\)</span>'
    html = lighter(f"<p>{formula}, then {formula} and {formula}).</p>", tmp_path)
    sized = formula.replace('light">', 'light" style="--unset:0.50em">')  # 3 signs of 9 characters
    assert f'<span class="nowrap">{sized},</span> then {sized} and' in html
    assert f'<span class="nowrap">{sized}).</span></p>' in html
    assert lighter(html, tmp_path) == html


def test_a_page_asks_for_one_style_sheet():
    head = """<title>T</title>
    <link href="_static/styles/theme.css?digest=5" rel="stylesheet" />
<link rel="stylesheet" type="text/css" href="_static/book.css?v=5ac9" />
    <link rel="icon" href="_static/favicon.svg"/>"""
    html = one_sheet(head)
    assert html.count("stylesheet") == 1
    assert 'data-of="_static/styles/theme.css _static/book.css"' in html
    assert 'href="_static/all.css' in html
    assert "favicon" in html
    assert one_sheet(html) == html


def test_the_one_style_sheet_has_the_imported_ones_and_their_addresses(tmp_path):
    (tmp_path / "styles").mkdir()
    (tmp_path / "styles/theme.css").write_text(
        '@import "../basic.css";a{b:url(../x/y.woff2)}', encoding="utf-8"
    )
    (tmp_path / "basic.css").write_text("p{b:url(file.png) url(data:image/png)}", encoding="utf-8")
    css = whole_sheet(tmp_path / "styles/theme.css", tmp_path)
    assert css == "p{b:url(file.png) url(data:image/png)}a{b:url(x/y.woff2)}"


def test_code_loses_the_spans_that_change_no_colour():
    rules = {"light": ("#080808", "#080808", "#00622F"), "dark": ("#F8F8F2", "#F8F8F2", "#F8F8F2")}
    css = "\n".join(
        f'html[data-theme="{mode}"] .highlight {{ background: #fefefe; color: {base} }}\n'
        f'html[data-theme="{mode}"] .highlight .n {{ color: {name} }} /* Name */\n'
        f'html[data-theme="{mode}"] .highlight .o {{ color: {sign} }}\n'
        f'html[data-theme="{mode}"] .highlight .gs {{ font-weight: bold }}'
        for mode, (base, name, sign) in rules.items()
    )
    assert plain_classes(css) == {"n"}, "an operator has a colour of its own in light mode"
    code = (
        '<div class="highlight"><pre><span></span><span class="n">q</span> <span'
        ' class="o">=</span></pre></div>'
    )
    prose = '<p><span class="n">q</span></p>'
    kept = '<div class="highlight"><pre>q <span class="o">=</span></pre></div>'
    assert without_spans(code + prose, {"n"}) == kept + prose


def test_properties_that_nothing_reads_go():
    css = 'a{--x:1;--y:var(--x);--z:var(--y);--u:url("data:;x");color:var(--k);--k:2}'
    css += "b{--kept:var(--w);--w:1;}"
    assert without_unused(css, {"--kept"}) == "a{color:var(--k);--k:2}b{--kept:var(--w);--w:1;}"


def test_only_rules_for_classes_that_nothing_names_go():
    css = (
        '.fa-sun:before{content:"\\f185"}.fa-ghost:before,.fa-boo:before{content:"\\f6e2"}/* {} */'
        "p:not(.ghost){a:b}:is(.ghost,.sun) p{a:b}.w-1\\/2{a:b}.fa-sun,.boo{a:b}.fa-sun.boo{a:b}"
        "@media print{.boo{a:b}p{a:b}}@keyframes boo{0%{a:b}}"
    )
    kept = without_unused(css, {"fa-sun"})
    assert kept == (
        '.fa-sun:before{content:"\\f185"}'
        "p:not(.ghost){a:b}:is(.ghost,.sun) p{a:b}.w-1\\/2{a:b}.fa-sun,.boo{a:b}"
        "@media print{p{a:b}}@keyframes boo{0%{a:b}}"
    )


def test_nothing_is_offered_to_launch_without_a_repository():
    for url, left in (("", {}), ("https://example.org/book", {"colab_url": "x"})):
        options = {"repository_url": url, "launch_buttons": {"colab_url": "x"}}
        without_repository(None, SimpleNamespace(html_theme_options=options))
        assert options["launch_buttons"] == left


def test_a_changed_asset_is_seen(tmp_path):
    for name in ("assets/vendor/a.js", "static/b.css"):
        (tmp_path / name).parent.mkdir(parents=True)
        (tmp_path / name).write_text("a", encoding="utf-8")
    config = SimpleNamespace(html_static_path=["assets", "static"])
    before = assets(tmp_path, config)
    (tmp_path / "static/b.css").write_text("b", encoding="utf-8")
    assert assets(tmp_path, config) != before
    (tmp_path / "static/b.css").write_text("a", encoding="utf-8")
    assert assets(tmp_path, config) == before
