# SPDX-License-Identifier: Apache-2.0
"""Figures that readers move (bindings/browser/page/live.js), in headless Chromium."""
import math
import os
import pathlib
import re
import sys
import time

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "verification" / "coupled"))
import browser  # noqa: E402

BUILT = pathlib.Path(os.environ.get("PAGE", ROOT / "build-browser" / "try.html")).resolve().parent
PLACES = re.findall(r'<div class="gasjet-live".*?</div>', (ROOT / "docs" / "teach.md").read_text())


def wait(page, condition, seconds=120):
    end = time.monotonic() + seconds
    while not page.run(condition):
        assert time.monotonic() < end, f"{condition}: {page.run('document.body.innerText')}; {page.errors}"
        time.sleep(0.02)


def drawn(number):
    return f"Number(place({number}).dataset.drawn ?? 0)"


@pytest.fixture
def show(tmp_path):
    """Opens a page with these places; at its end there are no errors, and nothing was asked for but the page's own files."""
    with browser.Browser() as page:
        def opened(*places):
            file = tmp_path / "figures.html"
            style = (ROOT / "docs/make/site/site.css").read_text()
            file.write_text(f'<!doctype html><meta charset="utf-8"><link rel="icon" href="data:,"><style>{style}</style>{"".join(places)}'
                            f'<script src="file://{BUILT}/live.js"></script><script>var place = i => document.querySelectorAll(".gasjet-live")[i];</script>')
            page.open(file)
            return page
        yield opened
        assert not page.errors
        own = (f"file://{BUILT}/", f"file://{tmp_path}/", "data:", "blob:")
        assert [url for url in page.requests if not url.startswith(own)] == []


def test_figures_of_the_teachers_page(show):
    """Each of them draws lines, says no error, and has a slider; it changes what is drawn, but where the formula says otherwise."""
    page = show(*PLACES)
    for i in range(len(PLACES)):
        page.run(f"place({i}).scrollIntoView()")
        wait(page, f"{drawn(i)} > 0 || place({i}).textContent.includes('cannot')")
        assert page.run(f"place({i}).querySelectorAll('.sliders input').length") > 0, PLACES[i]
        lines = f"[...place({i}).querySelectorAll('path:not(.old)')].map(p => p.getAttribute('d')).join()"
        before = page.run(lines)
        assert before.count("L") > 5 and "NaN" not in before, page.run(f"place({i}).textContent")
        count = page.run(drawn(i))
        page.run(f"{{ const s = place({i}).querySelector('.sliders input'); s.value = 0.9 * Number(s.value) + 0.1 * Number(s.max); s.dispatchEvent(new Event('input')); }}")
        wait(page, f"{drawn(i)} > {count}")
        is_flat = "lagged_pressure" in PLACES[i]  # its roots are a pair of modulus sqrt(1 + W_g^2), whatever the skin's stiffness
        assert (page.run(lines) == before) == is_flat, PLACES[i]
        print(PLACES[i][25:60], page.run(f"place({i}).dataset.milliseconds"), "ms")


def test_run_lies_on_its_closed_form(show):
    """Where a figure has both, it says their difference: a tank's is that of the gas at its tolerance, 1e-10, times ten for its end."""
    page = show(next(text for text in PLACES if "tank_blowdown" in text).replace(' data-columns="pressure_Pa temperature_K"', ""))
    wait(page, f"{drawn(0)} > 0")
    for volume in (None, 0.1):
        if volume:
            page.run(f"{{ const s = place(0).querySelector('input'); s.value = {volume}; s.dispatchEvent(new Event('input')); }}")
            wait(page, f"{drawn(0)} > 1")
        found = re.findall(r"Gasjet's (\w+).*?: (\S+) of", page.run("place(0).querySelector('.message').textContent"))
        assert [name for name, _ in found] == ["pressure", "temperature", "gas"]
        assert all(0 < float(size) < 1e-9 for _, size in found), found


def test_range_is_where_the_form_holds(show):
    """The program gives the ends: a heat capacity ratio is above 1 and below 3, a flag is 0 or 1."""
    page = show('<div class="gasjet-live" data-form="orifice_flow" data-sliders="heat_capacity_ratio discharge_coefficient"></div>',
                '<div class="gasjet-live" data-form="porous_flow" data-sliders="screen_law"></div>')
    wait(page, f"{drawn(0)} > 0 && {drawn(1)} > 0")
    low, high, least, most = page.run("[...place(0).querySelectorAll('input')].flatMap(s => [Number(s.min), Number(s.max)])")
    assert 1.0 < low < 1.02 and 2.95 < high < 3.0
    assert 0.0 < least < 0.5 and 1.0 <= most < 1.02
    assert page.run("[...place(1).querySelectorAll('input')].map(s => [s.min, s.max, s.step])") == [["0", "1", "1"]]


def test_values_of_a_form_without_abscissa(show):
    page = show('<div class="gasjet-live" data-form="pendulum_constants"></div>', '<div class="gasjet-live" data-form="no_such_form"></div>')
    wait(page, f"{drawn(0)} > 0 && place(1).textContent.includes('no_such_form')")
    text = page.run("place(0).querySelector('.message').textContent")
    inertia = float(re.search(r"axis inertia (\S+)", text)[1])
    assert math.isclose(inertia, 2.07 + 10.9 * 1.065**2, rel_tol=1e-5)  # six digits are shown


def test_every_closed_form_has_a_figure(show):
    """The catalogue's page: each form's figure draws a line or gives values, at its defaults."""
    names = re.findall(r"^\*\*`(\w+)`\*\*", (ROOT / "docs" / "exact.md").read_text(), re.M)
    page = show(*(f'<div class="gasjet-live" data-form="{name}" data-sliders="none"></div>' for name in names))
    for i, name in enumerate(names):
        page.run(f"place({i}).scrollIntoView()")
        wait(page, f"{drawn(i)} > 0")
        lines = page.run(f"[...place({i}).querySelectorAll('path')].map(p => p.getAttribute('d')).join()")
        values = page.run(f"place({i}).querySelector('.message').textContent")
        assert (lines or values) and "NaN" not in lines + values, f"{name}: {values}"
    assert len(names) > 80
