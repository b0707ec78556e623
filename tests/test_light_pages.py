"""What is taken out of the built pages, and what must stay."""

from types import SimpleNamespace

from tools.light_pages import lighter, without_repository, without_unused

HEAD = """<script defer src="_static/scripts/fontawesome.js?digest=1"></script>
<script src="_static/documentation_options.js?v=2"></script>
<script src="_static/doctools.js?v=3"></script>
    <script src="_static/searchtools.js"></script>
    <script src="searchindex.js"></script>
<script data-sd-tabs-storage-prefix="x-" src="_static/design-tabs.js?v=4"></script>"""


def test_unused_scripts_go_and_small_ones_wait(tmp_path):
    html = lighter(HEAD, tmp_path)
    assert "fontawesome" not in html
    assert "search" not in html
    assert '<script defer src="_static/doctools.js?v=3">' in html
    assert (
        '<script defer data-sd-tabs-storage-prefix="x-" src="_static/design-tabs.js?v=4">' in html
    )
    assert '<script src="_static/documentation_options.js?v=2">' in html, "inline code follows it"
    assert lighter(html, tmp_path) == html


def test_the_page_of_search_results_keeps_its_scripts(tmp_path):
    html = lighter(HEAD, tmp_path, search=True)
    assert html.strip() == HEAD.split("\n", 1)[1]


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
    assert '<img alt="A" src="a.svg" width="400" height="200" loading="lazy"/>' in html
    assert html.count("width") == 1
    assert lighter(html, tmp_path) == html


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
    assert f'<span class="nowrap">{formula},</span> then {formula} and' in html
    assert f'<span class="nowrap">{formula}).</span></p>' in html
    assert lighter(html, tmp_path) == html


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
