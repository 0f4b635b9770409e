// SPDX-License-Identifier: Apache-2.0
// Puts the page together from the data that `gasjet report` wrote into it. Text of cases is text here, never markup.
"use strict";

const data = JSON.parse(document.getElementById("data").textContent);
const at = id => document.getElementById(id);
const runs = data.results.filter(result => result.kind === "run");

const short = v => String(Number(v.toPrecision(6)));
const numberText = (v, exact) => typeof v === "number" ? (exact ? String(v) : short(v)) : v === null ? "none" : typeof v === "object" ? JSON.stringify(v) : String(v);

const tableOf = (head, rows, exact = false) => element("div", { class: "wide" }, element("table", { class: "data" },
  element("tr", {}, ...head.map(text => element("th", { textContent: text }))),
  ...rows.map(cells => element("tr", {}, ...cells.map(cell => cell instanceof Element ? element("td", {}, cell) : element("td", { class: typeof cell === "number" ? "number" : "", textContent: numberText(cell, exact) }))))));

// Leaves of nested objects: [path, value].
const leaves = (value, path = "") => {
  if (value === null || typeof value !== "object" || Array.isArray(value) && value.every(v => v === null || typeof v !== "object")) return [[path, value]];
  return Object.entries(value).flatMap(([key, inner]) => leaves(inner, path ? `${path}.${key}` : key));
};

const fold = (title, open, ...children) => {
  const node = element("details", { open }, element("summary", { textContent: title }), ...children);
  at("details").append(node);
};

const notice = text => at("notices").append(element("div", { class: "notice", textContent: text }));

const makeHead = () => {
  const titles = data.results.map(r => r.label);
  document.title = `Gasjet: ${titles.join(", ")}`;
  at("title").textContent = titles.join(" and ");
  for (const r of data.results) {
    const s = r.summary, parts = [];
    if (r.kind === "run" && s) parts.push(`${s.scene === r.label ? "" : s.scene + ": "}${s.status}${s.steps === undefined ? "" : `, ${s.steps} steps to ${s.time_end_s} s in ${short(s.wall_s)} s`}`);
    if (r.kind === "ensemble") parts.push(`ensemble of ${r.runs} runs: mean, band of one standard error${r.singles ? ", single runs thin" : ""}`);
    if (r.kind === "ladder") parts.push(`ladder of ${split(r.ladder.quantity).name}: ${r.ladder.verdict}, cheapest within ${100 * r.ladder.tolerance} %: ${r.ladder.cheapest ?? "none"}`);
    if (r.build) parts.push(`case ${r.build.case ?? r.build.data ?? "unknown"}, gasjet ${r.build.version} (${r.build.commit})`);
    if (r.compare) parts.push(`compared with ${r.compare.reference}: ${r.compare.verdict}`);
    if (!parts.length) parts.push(`a table of ${r.history.columns.length} columns`);
    at("heads").append(element("div", { class: "small", textContent: `${r.label}: ${parts.join("; ")}` }));
    if (s?.message) notice(`${r.label}: ${s.message}`);
    for (const text of new Set([...(s?.warnings ?? []), ...(r.check?.warnings ?? []), ...r.notes])) notice(`${r.label}: ${text}`);
  }
};

// Peaks and impulses of the runs and their largest residual, side by side; runs after the first with their difference from it.
const makeKeyNumbers = () => {
  const told = runs.filter(run => run.summary?.peak);
  if (!told.length) return;
  const names = new Set(told.flatMap(run => Object.keys(run.summary.peak)));
  const compared = (value, first) => typeof value !== "number" || !first || value === first ? value ?? "" : `${short(value)} (${value > first ? "+" : "−"}${Math.abs(100 * (value / first - 1)).toPrecision(3)} %)`;
  const rows = [...names].map(name => {
    const values = told.map(run => run.summary.peak[name]);
    return [split(name).name, values[0] ?? "", ...values.slice(1).map(v => compared(v, values[0])), split(name).unit];
  });
  const worst = told.map(run => Math.max(0, ...Object.entries(run.summary.residual ?? {}).filter(([key]) => key.endsWith("_rel")).map(([, v]) => v)));
  rows.push(["largest residual of a balance, relative", ...worst, ""]);
  at("keys").append(tableOf(["peaks and impulses", ...(told.length > 1 ? told.map(run => run.label) : ["value"]), "unit"], rows));
};

// The views, one slider for all of them.
class Player {
  constructor(list) {
    this.views = list.map(([label, frames, up]) => new View(at("views"), label, frames, up));
    this.times = this.views.map(view => view.frames.time).reduce((a, b) => (b[b.length - 1] > a[a.length - 1] ? b : a));
    const rigid = this.views.every(view => view.frames.header.rigid);
    for (const [key, { title, unit, moving }] of Object.entries(quantities)) if (!(rigid && moving)) at("quantity").append(new Option(title + (unit ? ` [${unit}]` : ""), key));
    at("slider").max = this.times.length - 1;
    at("slider").addEventListener("input", () => this.show());
    for (const id of ["edges", "jet", "through"]) at(id).addEventListener("change", () => this.show());
    at("quantity").addEventListener("change", () => this.recolour());
    at("view").addEventListener("change", () => this.look());
    at("play").addEventListener("click", () => this.toggle());
    addEventListener("keydown", event => {
      if (event.key !== " " || ["BUTTON", "SELECT", "INPUT", "SUMMARY"].includes(event.target.tagName)) return;
      event.preventDefault();
      this.toggle();
    });
    for (const view of this.views) view.onturn = () => this.follow(view);
    const steps = this.views.map(v => Math.max(...v.frames.time.map((_, i) => v.frames.scalars(i).position_step_m)));
    at("loss").textContent = `Stored in 16 bits: positions are off by at most ${(0.5e6 * Math.max(...steps)).toPrecision(2)} µm, strain, speed and jet overpressure by 1/131070 of their range in the frame. Colours are of elements.`;
    at("player").hidden = false;
    at("slider").value = this.times.length >> 1;  // a bag half way says more than a folded one
    this.look();
    this.recolour();
  }

  recolour() {
    const name = at("quantity").value, { title, unit, classes, value } = quantities[name];
    this.range = scaleOf(this.views, name);
    const text = v => `${Number(v.toPrecision(4))}${unit ? " " + unit : ""}`;
    const colour = rgb => `rgb(${rgb.map(Math.round).join(",")})`;
    at("scale").replaceChildren();
    if (classes) classes.forEach((label, i) => at("scale").append(element("span", {}, Object.assign(element("span", { class: "swatch" }), { style: `background:${colour(classColours[i])}` }), label)));
    else if (value) {
      const bar = element("span", { class: "bar" });
      bar.style.background = `linear-gradient(90deg, ${ramp.map(colour).join(",")})`;
      at("scale").append(`${title}: ${text(this.range[0])}`, bar, this.range[2] > this.range[1] ? `${text(this.range[1])} and more, up to ${text(this.range[2])}` : text(this.range[1]));
    }
    this.show();
  }

  look() {
    const directions = { oblique: [1.2, -1.3, 0.45], x: [1, 0, 0], y: [0, -1, 0], z: [0, 0, 1] };
    const distance = 2.9 * Math.max(...this.views.map(view => view.size));
    for (const view of this.views) view.lookFrom(directions[at("view").value], distance);
  }

  // Other views turn with the one that is turned, each about its own middle.
  follow(own) {
    if (this.following) return;
    this.following = true;
    const away = own.camera.position.clone().sub(own.controls.target);
    for (const view of this.views) if (view !== own) {
      view.camera.position.copy(view.controls.target).add(away);
      view.controls.update();
    }
    this.following = false;
  }

  show() {
    const time = this.times[at("slider").value], options = { edges: at("edges").checked, jet: at("jet").checked, through: at("through").checked };
    for (const view of this.views) view.show(nearest(view.frames.time, time), at("quantity").value, this.range, options);
    at("clock").textContent = `${(1e3 * time).toFixed(this.times[this.times.length - 1] < 0.01 ? 3 : 1)} ms`;
    at("slider").setAttribute("aria-valuetext", at("clock").textContent);
    for (const chart of Chart.all) chart.setTime(time);
  }

  goTo(time) { at("slider").value = nearest(this.times, time); this.show(); }

  toggle() {
    if (this.timer) {
      clearInterval(this.timer);
      this.timer = null;
    } else {
      if (Number(at("slider").value) >= this.times.length - 1) at("slider").value = 0;
      this.timer = setInterval(() => {
        if (Number(at("slider").value) >= this.times.length - 1) return this.toggle();
        at("slider").value = Number(at("slider").value) + 1;
        this.show();
      }, 60);
    }
    at("play").textContent = this.timer ? "Pause" : "Play";
  }
}

const upOf = result => {
  const gravity = result.check?.settings?.scene?.gravity ?? [0, 0, -1];
  const up = new THREE.Vector3(...gravity).negate();
  return up.length() > 0 ? up.normalize() : new THREE.Vector3(0, 0, 1);
};

const hasWebGL = () => {
  try { return Boolean(document.createElement("canvas").getContext("webgl")); } catch { return false; }
};

const mostViews = 8; // browsers allow 16 at once on all pages

const makePlayer = async () => {
  const moving = runs.filter(run => run.frames);
  if (!moving.length) return null;
  if (typeof THREE === "undefined") return notice("This gasjet was built without three.js (Debian: libjs-three): no pictures in three dimensions."), null;
  const shown = moving.slice(0, mostViews);
  if (!hasWebGL()) return notice("This browser has no WebGL: no pictures in three dimensions."), null;
  if (typeof DecompressionStream === "undefined") return notice("This browser is too old to unpack the pictures in three dimensions."), null;
  if (shown.length < moving.length) notice(`Pictures in three dimensions of the first ${shown.length} runs, of ${moving.length}.`);
  return new Player(await Promise.all(shown.map(async run => [run.label, new Frames(run.frames.header, await unpacked(run.frames.data)), upOf(run)])));
};

const makeCharts = player => {
  const many = data.results.filter(r => r.history).length > 1, series = [];
  let dash = 0;
  for (const r of data.results) if (r.history) {
    const name = many || r.reference ? r.label : "";
    series.push(...seriesOf(r.history, name, dash, r.singles));
    if (r.filtered) series.push(...seriesOf(r.filtered, name, dash).map(s => ({ ...s, bold: true })));
    if (r.reference && !series.some(s => s.result === "reference")) series.push(...seriesOf(r.reference, "reference", referenceDash));
    dash = (dash + 1) % referenceDash;
  }
  const charts = groups(series).map(spec => new Chart(at("charts"), spec));
  for (const r of runs) {
    const label = many ? r.label : "", balances = [...massChart(r.history, label), ...(r.energy ? energyCharts(r.energy, r.roles, label) : []), ...crossingCharts(r.summary, label)];
    for (const spec of balances) charts.push(new Chart(at("charts"), spec));
  }
  if (player) {
    for (const chart of charts) chart.onpick = time => player.goTo(time);
    player.show();
  } else {
    document.querySelector("main").className = "flat";
  }
};

const bars = shares => {
  const most = Math.max(...shares.map(([, v]) => v)), total = shares.reduce((sum, [, v]) => sum + v, 0);
  return element("div", { class: "wide" }, element("table", { class: "data" }, ...shares.map(([name, v, text]) => {
    const bar = element("span", { class: "cost" });
    bar.style.width = `${Math.max(1, 160 * v / most)}px`;
    return element("tr", {}, element("td", { textContent: name }), element("td", {}, bar), element("td", { class: "number", textContent: text ?? `${v.toPrecision(3)} s, ${(100 * v / total).toFixed(1)} %` }));
  })));
};

const makeComparison = ({ compare }, of) => {
  if (!compare) return;
  const rows = Object.entries(compare.quantities).map(([name, q]) => [split(name).name, q.verdict, q.share_of_band ?? "", q.max_error ?? "", split(name).unit, q.reason]);
  fold(`Compared with ${compare.reference}${of}: ${compare.verdict}${compare.reason ? ", " + compare.reason : ""}`, true, tableOf(["quantity", "verdict", "share of band", "largest error", "unit", "why"], rows));
};

const makeRunDetails = run => {
  const of = runs.length > 1 ? ` of ${run.label}` : "", s = run.summary;
  const block = (title, node) => element("div", {}, element("h3", { textContent: title }), node);
  makeComparison(run, of);
  const blocks = [];
  if (s?.residual && Object.keys(s.residual).length) blocks.push(block("Greatest residuals, relative", tableOf(["balance", "residual"], Object.entries(s.residual).map(([k, v]) => [k.replace("_rel", "").replaceAll("_", " "), v]))));
  if (s?.streams) blocks.push(block("Streams", tableOf(["stream", "mass [kg]", "energy, sensible [J]"], Object.entries(s.streams).map(([k, v]) => [k, v.mass_kg, v.sensible_J ?? ""]))));
  if (s?.dt) {
    const rows = leaves(s.dt).filter(([k]) => !k.startsWith("shares")).map(([k, v]) => [k.replaceAll("_", " "), v, k.startsWith("limited_by") ? "steps" : k.startsWith("largest_") ? "" : "s"]);
    const node = element("div", {}, tableOf(["step", "value", "unit"], rows));
    if (s.dt.shares) node.append(element("div", { class: "small", textContent: "what limits it, mean shares" }), bars(Object.entries(s.dt.shares).map(([k, v]) => [k, v, `${(100 * v).toFixed(1)} %`])));
    blocks.push(block("Step", node));
  }
  if (s?.stage_seconds) blocks.push(block("Cost of the stages", bars(Object.entries(s.stage_seconds).map(([k, v]) => [k.replaceAll("_", " "), v]))));
  if (blocks.length) fold(`Summary${of}`, true, element("div", { class: "columns" }, ...blocks));
  if (run.check) {
    fold(`Forecast${of}`, false, tableOf(["group", "value", "effect", "equation"], run.check.forecast.map(g => [g.meaning, g.value, g.verdict, g.equation])));
    const defaults = new Set(run.check.defaults);
    fold(`Case${of}, with all defaults`, false, tableOf(["setting", "value", ""], leaves(run.check.settings).map(([k, v]) => [k, v, defaults.has(k) ? "default" : ""]), true));
  }
  if (s) fold(`Everything in summary.json${of}`, false, tableOf(["key", "value"], leaves(s), true));
};

// Single runs as dots between the least and the largest; the mean as a line, its standard error as a box.
const strip = q => {
  const svg = drawn("svg", { width: 220, height: 18, class: "strip", role: "img", "aria-label": `${q.values.length} runs` });
  const x = v => 8 + (q.maximum > q.minimum ? (v - q.minimum) / (q.maximum - q.minimum) : 0.5) * 204;
  const from = Math.max(0, x(q.mean - q.standard_error)), to = Math.min(220, x(q.mean + q.standard_error));
  svg.append(drawn("rect", { x: from, y: 1, width: Math.max(1, to - from), height: 16, fill: "var(--c1)", "fill-opacity": .35 }));
  svg.append(drawn("line", { x1: x(q.mean), x2: x(q.mean), y1: 1, y2: 17, stroke: "var(--c1)", "stroke-width": 2 }));
  for (const v of q.values) svg.append(drawn("circle", { cx: x(v), cy: 9, r: 3, fill: "var(--c0)", "fill-opacity": .5 }));
  return svg;
};

const makeEnsembleDetails = r => {
  makeComparison(r, data.results.length > 1 ? ` of ${r.label}` : "");
  const rows = Object.entries(r.quantities).map(([name, q]) => [split(name).name, q.mean, q.standard_error, q.minimum, q.values?.length ? strip(q) : "", q.maximum, q.runs, split(name).unit]);
  fold(`Quantities of ${r.label}`, true, tableOf(["quantity", "mean", "standard error", "least", "single runs, mean and its standard error", "largest", "runs", "unit"], rows));
};

// Error against cost, both on logarithmic scales; rungs on the front are named.
const ladderChart = ladder => {
  const rungs = ladder.rungs.filter(r => r.error !== undefined && r.cpu_s > 0), unit = split(ladder.quantity).unit;
  const width = 900, height = 420, left = 80, bottom = 370, right = 880, top = 14;
  const svg = drawn("svg", { viewBox: `0 0 ${width} ${height}`, role: "img", "aria-label": "error against cost" });
  const least = Math.max(1e-12, 1e-6 * Math.abs(ladder.reference?.value ?? 1));
  const size = r => Math.max(Math.abs(r.error), least);
  const axis = (values, from, to) => {
    const low = Math.floor(Math.log10(Math.min(...values)) - 0.1), high = Math.ceil(Math.log10(Math.max(...values)) + 0.1);
    return { place: v => from + (Math.log10(v) - low) / (high - low) * (to - from), decades: Array.from({ length: high - low + 1 }, (_, i) => low + i) };
  };
  const allowed = ladder.reference ? ladder.tolerance * Math.abs(ladder.reference.value - (ladder.counted_from ?? 0)) : 0;
  const x = axis(rungs.map(r => r.cpu_s), left, right), y = axis([...rungs.map(size), ...(allowed > 0 ? [allowed] : [])], bottom, top);
  for (const d of x.decades) svg.append(drawn("line", { class: "frame", x1: x.place(10 ** d), x2: x.place(10 ** d), y1: top, y2: bottom }), drawn("text", { x: x.place(10 ** d), y: bottom + 16, "text-anchor": "middle" }, label(10 ** d, 10 ** d)));
  for (const d of y.decades) svg.append(drawn("line", { class: "frame", x1: left, x2: right, y1: y.place(10 ** d), y2: y.place(10 ** d) }), drawn("text", { x: left - 6, y: y.place(10 ** d) + 4, "text-anchor": "end" }, label(10 ** d, 10 ** d)));
  svg.append(drawn("text", { x: right, y: bottom + 36, "text-anchor": "end" }, "time of computation [s]"), drawn("text", { x: left, y: bottom + 36 }, `vertical: error of ${split(ladder.quantity).name} [${unit}]` + (rungs.some(r => Math.abs(r.error) < least) ? `; errors below ${short(least)} are drawn there` : "")));
  if (allowed > 0) svg.append(drawn("line", { class: "mark", x1: left, x2: right, y1: y.place(allowed), y2: y.place(allowed) }), drawn("text", { x: right - 4, y: y.place(allowed) - 4, "text-anchor": "end" }, `tolerance ${short(allowed)} ${unit}`));
  const front = rungs.filter(r => r.front > 0).sort((a, b) => a.front - b.front);
  svg.append(drawn("polyline", { points: front.map(r => `${x.place(r.cpu_s)},${y.place(size(r))}`).join(" "), fill: "none", stroke: "var(--c0)" }));
  const taken = [];  // heights of names, so that none lies on another
  for (const r of rungs) {
    const dot = drawn("circle", { cx: x.place(r.cpu_s), cy: y.place(size(r)), r: r.front ? 5 : 3.5, fill: r.front ? "var(--c0)" : "var(--c6)" });
    dot.addEventListener("mousemove", event => showTip([["rung", r.rung], ["error", `${r.error} ± ${r.error_se} ${unit}`], ["time", `${r.cpu_s} s`], ["verdict", r.verdict]], event.clientX, event.clientY));
    dot.addEventListener("mouseleave", hideTip);
    svg.append(dot);
    if (!r.front) continue;
    const middle = x.place(r.cpu_s), ends = middle > 0.75 * right, width = 6.2 * r.rung.length;
    const box = { from: ends ? middle - width : middle, to: ends ? middle + 16 : middle + width + 16, y: y.place(size(r)) - 6 };
    while (taken.some(other => Math.abs(other.y - box.y) < 12 && other.from < box.to && box.from < other.to)) box.y -= 12;
    taken.push(box);
    svg.append(drawn("text", { x: middle + 8, y: box.y, "text-anchor": ends ? "end" : "start" }, r.rung));
  }
  return svg;
};

const makeLadder = r => {
  const { ladder } = r;
  if (ladder.rungs.some(rung => rung.error !== undefined && rung.cpu_s > 0))
    at("charts").append(element("div", { class: "chart broad" }, element("h3", { textContent: `Error against cost: ${split(ladder.quantity).name}, ${r.label}` }), ladderChart(ladder)));
  const unit = split(ladder.quantity).unit;
  fold(`Rungs of ${r.label}`, true, tableOf(["rung", `value [${unit}]`, `error [${unit}]`, "standard error", "time [s]", "verdict", "front", "options"],
    ladder.rungs.map(g => [g.rung, g.value ?? g.failure, g.error ?? "", g.error_se ?? "", g.cpu_s ?? "", g.verdict ?? "", g.front || "", g.options])));
};

makeHead();
makeKeyNumbers();
for (const r of data.results) if (r.kind === "ladder") makeLadder(r);
let player = null;
makePlayer().catch(() => (notice("This browser cannot unpack the pictures in three dimensions."), null)).then(made => {
  player = made;
  makeCharts(player);
  for (const r of data.results) {
    if (r.kind === "run") makeRunDetails(r);
    if (r.kind === "ensemble") makeEnsembleDetails(r);
    if (r.kind === "curves") makeComparison(r, data.results.length > 1 ? ` of ${r.label}` : "");
  }
});
// On paper nothing can be opened.
let opened = [];
addEventListener("beforeprint", () => {
  opened = [...document.querySelectorAll("details:not([open])")];
  for (const node of opened) node.open = true;
});
addEventListener("afterprint", () => opened.forEach(node => (node.open = false)));
at("foot").textContent = `Written by gasjet ${data.gasjet}. Everything shown is in this file; it asks for nothing else.`;
