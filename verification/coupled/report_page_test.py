# SPDX-License-Identifier: Apache-2.0
"""The page of `gasjet report` in a real browser."""
import json
import os

import browser
import pytest
from command import load, numbers, ok, table, write, write_table

EVIL = "</script><script>throw 1</script><img src=x onerror=alert(1)>&amp;\"'"
CURVES = "cases/tank_test_curves.csv"


def check(what, holds):
    assert holds, what


def look(page, name, **how):
    """Opens a page; whatever else happens it logs no error and asks for nothing but itself."""
    page.open(name, **how)
    check(f"{name} logs {page.errors}", not page.errors)
    check(f"{name} asks for {page.requests}", page.requests == ["file://" + os.path.abspath(name)])


def slide(page, value):
    page.run(f"{{ const s = document.getElementById('slider'); s.value = {value}; s.dispatchEvent(new Event('input')); }}")
    page.settle()


def colour(page, quantity):
    page.run(f"{{ const q = document.getElementById('quantity'); q.value = '{quantity}'; q.dispatchEvent(new Event('change')); }}")


def canvas(page, k=0):
    return page.run(f"document.querySelectorAll('.view canvas')[{k}].toDataURL()")


def a_run(page):
    look(page, "run.html")
    history = table("run/history.csv")
    colour(page, "none")
    for part in ("jet", "edges"):
        page.run(f"document.getElementById('{part}').click()")
    page.run("player.views[0].impactor.visible = player.views[0].arm.visible = false; player.show()")
    first = canvas(page)  # of the skin alone: what differs is its shape
    slide(page, 8)
    later = canvas(page)
    check("the slider moves the bag", first != later)
    check("the clock says 8 ms", page.run("document.getElementById('clock').textContent") == "8.0 ms")
    pictures_of = []
    for quantity in ("strain", "speed", "overpressure", "jet_overpressure", "mask"):
        colour(page, quantity)
        pictures_of.append(canvas(page))
    check("colours follow the quantity", len({later, *pictures_of}) == 6)
    page.run("document.getElementById('jet').click()")
    strain = canvas(page)
    check("the jet is shown", strain != pictures_of[-1])
    page.run("document.getElementById('edges').click()")
    check("edges are shown", canvas(page) != strain)
    bare = canvas(page)
    page.run("document.getElementById('through').click()")
    check("the skin can be seen through", canvas(page) != bare)
    # The cursor of the charts is where the slider is.
    cursor = page.run("(() => { const c = Chart.all[0]; return [Number(c.cursor.getAttribute('x1')), c.x(0.008)]; })()")
    check(f"cursor at {cursor}", abs(cursor[0] - cursor[1]) < 1.0)
    # Values under the mouse are the cells of the file.
    box = page.run("(() => { const c = Chart.all[0], b = c.svg.getBoundingClientRect(); return [b.left + c.x(0.006), b.top + 40]; })()")
    page.mouse("mouseMoved", *box)
    tip = page.run("document.getElementById('tip').innerText").split()
    row = min(history, key=lambda r: abs(float(r["time_s"]) - float(tip[1])))
    check(f"the mouse reads {tip}", tip[1] == row["time_s"] and row["pressure_Pa"] in tip and abs(float(tip[1]) - 0.006) < 5e-5)
    # A click on the legend hides a line, and the chart is scaled to the others.
    lines = "(() => { const c = Chart.all.find(c => c.unit === 'N'); return [c.shown.length, c.svg.querySelectorAll('polyline').length, c.bounds.high]; })()"
    before = page.run(lines)
    page.run("Chart.all.find(c => c.unit === 'N').root.querySelectorAll('.legend button').forEach((b, i) => i !== 3 && b.click())")
    after = page.run(lines)
    check(f"the legend hides lines: {before}, {after}", before[:2] == [5, 5] and after[:2] == [1, 1] and after[2] < before[2])
    # Keys: the next row of a chart, the slider, play.
    page.run("Chart.all[0].svg.focus(); 0")
    page.key("ArrowRight", 39)
    tip = page.run("document.getElementById('tip').innerText").split()
    following = history[history.index(row) + 1]
    check(f"the arrow reads {tip}", tip[1] == following["time_s"] and following["pressure_Pa"] in tip)
    page.run("document.getElementById('slider').focus()")
    page.key("ArrowRight", 39)
    check("the arrow moves the slider", page.run("document.getElementById('slider').value") == "9")
    page.run("document.activeElement.blur(); document.body.focus(); 0")
    page.key(" ", 32, " ")
    page.run("new Promise(done => setTimeout(done, 300))")
    check("space plays", page.run("document.getElementById('slider').value") == "10")
    # What the run comes to stands above all.
    keys = dict(page.run("[...document.querySelectorAll('#keys tr')].map(row => [...row.cells].slice(0, 2).map(cell => cell.textContent))"))
    summary = load("run/summary.json")
    check(f"peaks are told: {keys}", abs(float(keys["pressure"]) / summary["peak"]["pressure_Pa"] - 1) < 1e-5)
    check(f"residuals are told: {keys}", abs(float(keys["largest residual of a balance, relative"]) / max(v for k, v in summary["residual"].items() if k.endswith("_rel")) - 1) < 1e-5)
    # A drag turns the camera.
    before = page.run("player.views[0].camera.position.x")
    x, y = page.run("(() => { const b = document.querySelector('.view canvas').getBoundingClientRect(); return [b.left + b.width / 2, b.top + b.height / 2]; })()")
    page.mouse("mousePressed", x, y)
    page.call("Input.dispatchMouseEvent", type="mouseMoved", x=x + 60, y=y, button="left", buttons=1)
    page.mouse("mouseReleased", x + 60, y)
    check("a drag turns the bag", page.run("player.views[0].camera.position.x") != before)
    # Every column of the history is in a chart, and the residual of the energy.
    drawn = page.run("Chart.all.flatMap(c => c.series.map(s => s.column))")
    check("all columns are drawn", set(history[0]) - {"time_s"} <= set(drawn))
    check("the balance of the gas is drawn", page.run("Chart.all.some(c => c.title.startsWith('Where the gas went'))"))
    check("the residual is drawn", page.run("Chart.all.some(c => c.title.startsWith('Residual of the energy'))"))
    marked = page.run("[...document.querySelectorAll('td')].filter(cell => cell.textContent === 'default').map(cell => cell.parentNode.firstChild.textContent)")
    check(f"defaults are marked: {marked}", sorted(marked) == sorted(load("run/check.json")["defaults"]))


def a_pair(page):
    look(page, "pair.html", dark=True)
    slide(page, 2)
    colour(page, "none")
    left, right = canvas(page, 0), canvas(page, 1)
    away = "player.views.map(v => v.camera.position.clone().sub(v.controls.target).toArray())"
    before = page.run(away)
    page.run("document.querySelector('.view canvas').focus()")
    for key, code in (("ArrowLeft", 37), ("ArrowUp", 38), ("-", 189)):
        page.key(key, code)
    after = page.run(away)
    size = lambda v: sum(x * x for x in v) ** 0.5
    check(f"keys turn both bags: {before}, {after}", all(abs(a - b) < 1e-9 for a, b in zip(*after)) and after[0][2] > before[0][2] + 0.1 and abs(size(after[0]) * 0.9 - size(before[0])) < 1e-6)
    slide(page, 10)
    check("one slider moves both bags", canvas(page, 0) != left and canvas(page, 1) != right)
    pressure = page.run("[...document.querySelectorAll('#keys tr')].find(row => row.cells[0].textContent === 'pressure').cells[2].textContent")
    peaks = [load(f"{name}/summary.json")["peak"]["pressure_Pa"] for name in ("run", "no_jet")]
    off = float(pressure.split("(")[1].split()[0].replace("−", "-"))
    check(f"peaks are compared: {pressure}, {peaks}", abs(off - 100 * (peaks[1] / peaks[0] - 1)) <= 5e-3 * abs(off))
    check("the ground is dark", page.run("getComputedStyle(document.body).backgroundColor") == "rgb(20, 23, 27)")


def narrow_screens(page):
    for name in ("run.html", "tank.html", "pair.html"):
        look(page, name, width=390, height=800)
        page.run("document.body.style.fontFamily = 'monospace'; 0")  # as wide as any machine's font
        wide = page.run("document.documentElement.scrollWidth")
        check(f"{name} is {wide} px wide on a screen of 390", wide <= 390)


def a_tank(page):
    look(page, "tank.html")
    check("a tank has no view", page.run("document.getElementById('player').hidden") and page.run("Chart.all.length") >= 5)
    shown = page.run("document.getElementById('heads').textContent")
    check(f"names are text: {shown}", EVIL in shown and page.run("document.querySelectorAll('img').length") == 0)


def a_target(page):
    look(page, "target.html")
    check("a rigid target has what does not move", page.run("[...document.getElementById('quantity').options].map(o => o.value)") == ["jet_overpressure", "mask", "none"])
    drawn = []
    for number in (1, 10, 20):
        slide(page, number)
        drawn.append((canvas(page), page.run("player.views[0].jets[0].edge.visible")))
    check("overpressures follow the slider", len({picture for picture, _ in drawn}) == 3)
    check("a jet is shown while it flows", [jet for _, jet in drawn] == [True, True, False])
    check("the outlet is in the picture", page.run("(v => v.jets[0].centre.clone().project(v.camera).toArray().every(x => Math.abs(x) < 1))(player.views[0])"))


def many_runs(page):
    look(page, "many.html")
    check("more runs than a browser can show", page.run("player.views.length") == 8 and "the first 8 runs, of 9" in page.run("document.getElementById('notices').textContent"))


def a_compared_tank(page):
    look(page, "compared.html")
    check("all lines are named", page.run("[...document.querySelectorAll('.legend span')].every(entry => entry.textContent)"))
    check("the verdict is shown", "Compared with reference.csv: inside" in page.run("document.getElementById('details').textContent"))
    check("and at the head", "compared with reference.csv: inside" in page.run("document.getElementById('heads').textContent"))
    tip = page.run("(c => { c.read(0.05, 0, 0); return document.getElementById('tip').innerText; })(Chart.all[0])").split("\n")
    exact = next(r for r in table("reference.csv") if r["time_s"] == "0.05")
    check(f"the tip has value, band and unit: {tip}", f"pressure, reference\t{exact['pressure_Pa']} ± {exact['pressure_Pa_band']} Pa" in tip)
    check("the band is drawn", page.run("Chart.all.some(c => c.series.some(s => s.low && s.result === 'reference'))"))


def paper(page):
    look(page, "run.html")
    page.call("Emulation.setEmulatedMedia", media="print")
    shown = page.run("[...document.querySelectorAll('#controls > *')].filter(part => getComputedStyle(part).display !== 'none').map(part => part.textContent)")
    check(f"the time of the picture is on paper: {shown}", shown == ["5.0 ms"])
    check("browsers print the scale's colours", page.run("getComputedStyle(document.querySelector('#scale .bar')).webkitPrintColorAdjust") == "exact")
    page.call("Emulation.setEmulatedMedia", media="")
    look(page, "tank.html")
    closed = "document.querySelectorAll('details:not([open])').length"
    before = page.run(closed)
    page.run("dispatchEvent(new Event('beforeprint'))")
    check("all is open on paper", before > 0 and page.run(closed) == 0)
    page.run("dispatchEvent(new Event('afterprint'))")
    check("and closed again", page.run(closed) == before)


def other_results(page):
    look(page, "ensemble.html")
    check("bands of the mean", page.run("Chart.all[0].series[0].low.filter((v, i) => v < Chart.all[0].series[0].value[i]).length") > 10)
    check("single runs are thin lines", page.run("Chart.all[0].svg.querySelectorAll('polyline.single').length") == 2 * page.run("Chart.all[0].series.length"))
    check("single runs lie about the mean", page.run("(s => { const [a, b] = s.singles.map(v => v[v.length - 1]), m = s.value[s.value.length - 1]; return Math.abs((a + b) / 2 - m) <= 1e-5 * Math.abs(m); })(Chart.all[0].series[0])"))
    check("single runs are dots", page.run("document.querySelectorAll('svg.strip')[0].querySelectorAll('circle').length") == 2)
    look(page, "ladder.html")
    check("rungs are drawn", page.run("document.querySelectorAll('#charts circle').length") >= 2)
    boxes = page.run("[...document.querySelectorAll('#charts svg text')].filter(t => /[a-z]{4}/.test(t.textContent)).map(t => { const b = t.getBBox(); return [b.x, b.y, b.width, b.height]; })")
    overlap = [1 for i, a in enumerate(boxes) for b in boxes[:i] if min(a[0] + a[2], b[0] + b[2]) - max(a[0], b[0]) > 1 and min(a[1] + a[3], b[1] + b[3]) - max(a[1], b[1]) > 3]
    check(f"names of rungs lie on one another: {overlap}", not overlap)
    look(page, "judged.html")
    check("an ensemble is judged", "Compared with ensemble.csv" in page.run("document.getElementById('details').textContent"))
    look(page, "curves.html")
    check("bands of curves", page.run("Chart.all[0].series[0].low.length") > 10)
    drawn = page.run("(s => s.value.map((v, i) => [s.low[i] < v || s.high[i] > v, s.interval(i)]))(Chart.all[1].series[0])")
    expected = [("%s to %s" % (r["temperature_low_K"], r["temperature_high_K"])) if r["band_claimed"] == "1" else "" for r in table(CURVES)]
    check("bands where they are claimed", drawn == [[bool(text), ", " + (text or "no band")] for text in expected] and len(set(map(bool, expected))) == 2)
    look(page, "one_end.html")
    check("one end is no interval", page.run("Chart.all[0].series.map(s => [s.name, s.low])") == [["force", None], ["force low", None]])


def test_report_page():
    """Eleven pages, no error, no request."""
    if not browser.program():
        pytest.skip("Chromium is missing (package chromium)")
    short = "--quiet --set scene.end_time=0.01 --set output.frames=10"
    ok(f"run cases/passenger_pendulum.toml --out run {short}")
    ok(f"run cases/passenger_pendulum_no_jet.toml --out no_jet {short}")
    ok("run cases/rigid_tank.toml --quiet --out tank --set", "scene.name=" + json.dumps(EVIL))
    write("exact.csv", ok("exact tank_fill --times 0:0.1:0.01").out)
    rows = numbers("exact.csv")
    write_table("reference.csv", {**{name: [row[name] for row in table("exact.csv")] for name in rows}, "pressure_Pa_band": ["2e-8"] * 11,
                                  "temperature_K_band": ["2e-10"] * 11})
    ok("ensemble cases/jet_bag.toml --runs 2 --quiet --out ensemble --set scene.end_time=0.003")
    ok("ladder cases/rigid_tank.toml --quantity pressure --quiet --out ladder")
    write("one_end.csv", "time_s,force_N,force_low_N", "0,1,0.5", "1,2,1")
    ok("run cases/plate_jet.toml --quiet --out target --set", "inflator.0.mass_flow={ time = [0.0, 0.01, 0.019], value = [0.0, 2.0, 0.0] }")
    for page, results in (("run", "run"), ("pair", "run no_jet"), ("tank", "tank"), ("compared", "tank --against reference.csv"),
                          ("ensemble", "ensemble"), ("judged", "ensemble --against ensemble/jet_bag/ensemble.csv"), ("ladder", "ladder"),
                          ("curves", CURVES), ("one_end", "one_end.csv"), ("target", "target"), ("many", "run " * 9)):
        ok(f"report {results} --out {page}.html")
    with browser.Browser() as page:
        for look_at in (a_run, a_pair, narrow_screens, a_tank, a_compared_tank, paper, other_results, a_target, many_runs):
            look_at(page)
