// SPDX-License-Identifier: Apache-2.0
// Charts over time: lines, bands, a cursor that follows the slider, values under the mouse as the file has them.
"use strict";

const element = (name, properties = {}, ...children) => {
  const node = document.createElement(name);
  for (const [key, value] of Object.entries(properties)) key === "class" ? (node.className = value) : (node[key] = value);
  node.append(...children);
  return node;
};

const drawn = (name, attributes = {}, text) => {
  const node = document.createElementNS("http://www.w3.org/2000/svg", name);
  for (const [key, value] of Object.entries(attributes)) node.setAttribute(key, value);
  if (text !== undefined) node.textContent = text;
  return node;
};

// Round numbers from low to high, about `count` of them.
const ticks = (low, high, count) => {
  const rough = (high - low) / count, power = 10 ** Math.floor(Math.log10(rough));
  const step = power * [1, 2, 5, 10].find(f => f * power >= rough * 0.999);
  const list = [];
  for (let i = Math.ceil(low / step - 1e-9); i * step <= high + 1e-9 * step; ++i) list.push(i * step);
  return list.map(value => ({ value, text: label(value, step) }));
};

const label = (value, step) => {
  const size = Math.max(Math.abs(value), step);
  if (value === 0) return "0";
  if (size >= 1e6 || size < 1e-3) return String(Number(value.toPrecision(6)).toExponential()).replace("e+", "e");
  return Number(value.toPrecision(12)).toFixed(Math.max(0, -Math.floor(Math.log10(step) + 1e-9)));
};

// Index of the time nearest to t in an increasing list.
const nearest = (times, t) => {
  let low = 0, high = times.length - 1;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    times[middle] <= t ? (low = middle) : (high = middle);
  }
  return t - times[low] <= times[high] - t ? low : high;
};

const dashes = ["", "7 4", "9 3 2 3", "14 4", "9 3 2 3 2 3", "4 6", "18 3 2 3", "2 3"];
const referenceDash = dashes.length - 1; // no other result has it
const margin = { left: 58, right: 10, top: 6, bottom: 30 };

// series: { name, result, time, value, text, low, high, error, interval, singles, singlesTime, colour, dash, dots, filled }; values may be null (band only).
class Chart {
  constructor(place, { title, unit, series, zero = false, height = 190 }) {
    Object.assign(this, { title, unit, series, zero, height, time: null });
    this.root = element("div", { class: "chart" }, element("h3", { textContent: title + (unit ? ` [${unit}]` : "") }));
    this.svg = drawn("svg", { height, tabindex: 0, role: "img", "aria-label": `${title}, arrow keys read values` });
    this.root.append(this.svg);
    if (series.length > 1) this.root.append(this.legend());
    place.append(this.root);
    this.svg.addEventListener("mousemove", event => this.hover(event));
    for (const name of ["mouseleave", "blur"]) this.svg.addEventListener(name, () => hideTip());
    this.svg.addEventListener("click", event => this.onpick && this.onpick(this.timeAt(event)));
    this.svg.addEventListener("keydown", event => this.key(event));
    Chart.all.push(this);
    new ResizeObserver(() => this.draw()).observe(this.root);
  }

  // Each name once; where there are several results, their lines too.
  legend() {
    const list = element("div", { class: "legend" }), results = new Map(this.series.map(s => [s.result, s.dash]));
    const sample = (s, stroke) => {
      const svg = drawn("svg");
      svg.append(s.filled ? drawn("rect", { width: 22, height: 8, "fill-opacity": .55, ...stroke }) : drawn("line", { x1: 0, x2: 24, y1: 4, y2: 4, "stroke-width": 2, ...stroke }));
      return svg;
    };
    const named = this.series.reduce((all, s) => all.set(s.name, [...(all.get(s.name) ?? []), s]), new Map());
    if (named.size > 1) for (const [name, group] of named) {
      const s = group[0], colour = `var(--c${s.colour})`;
      const stroke = s.filled ? { stroke: "none", fill: colour } : { stroke: colour, "stroke-dasharray": results.size > 1 ? "" : dashes[s.dash] };
      const entry = element("button", { type: "button", title: "show or hide" }, sample(s, stroke), name);
      entry.setAttribute("aria-pressed", "true");
      entry.addEventListener("click", () => {
        for (const one of group) one.hidden = !one.hidden;
        entry.setAttribute("aria-pressed", String(!s.hidden));
        this.width = null;
        this.draw();
      });
      list.append(s.filled ? element("span", {}, ...entry.childNodes) : entry);
    }
    if (results.size > 1) for (const [result, dash] of results) list.append(element("span", {}, sample({}, { stroke: "var(--ink)", "stroke-dasharray": dashes[dash] }), result));
    return list;
  }

  get shown() { return this.series.filter(s => !s.hidden); }

  range() {
    let low = this.zero ? 0 : Infinity, high = this.zero ? 0 : -Infinity, end = -Infinity, start = Infinity;
    for (const s of this.shown.length ? this.shown : this.series) {
      for (const list of [s.value, s.low, s.high, ...(s.singles ?? [])])
        if (list) for (const v of list) { if (v < low) low = v; if (v > high) high = v; }
      start = Math.min(start, s.time[0]);
      end = Math.max(end, s.time[s.time.length - 1]);
    }
    if (!(high > low)) { const pad = Math.abs(low) * 1e-3 || 1; low -= pad; high += pad; }
    const pad = 0.04 * (high - low);
    return { low: low - pad, high: high + pad, start, end: end > start ? end : start + 1 };
  }

  draw() {
    const width = this.root.clientWidth;
    if (!width || width === this.width) return;
    this.width = width;
    this.svg.setAttribute("viewBox", `0 0 ${width} ${this.height}`);
    const r = this.bounds = this.range(), right = width - margin.right, bottom = this.height - margin.bottom;
    this.x = t => margin.left + (t - r.start) / (r.end - r.start) * (right - margin.left);
    const y = v => bottom - (v - r.low) / (r.high - r.low) * (bottom - margin.top);
    this.svg.replaceChildren(drawn("rect", { class: "frame", x: margin.left, y: margin.top, width: right - margin.left, height: bottom - margin.top }));
    const scale = r.end - r.start <= 1 ? 1e3 : 1;
    for (const t of ticks(r.start * scale, r.end * scale, Math.max(2, width / 60)))
      this.svg.append(drawn("text", { x: this.x(t.value / scale), y: bottom + 13, "text-anchor": "middle" }, t.text));
    this.svg.append(drawn("text", { x: right, y: bottom + 26, "text-anchor": "end" }, scale === 1 ? "time [s]" : "time [ms]"));
    for (const v of ticks(r.low, r.high, 4)) {
      this.svg.append(drawn("line", { class: "frame", x1: margin.left, x2: right, y1: y(v.value), y2: y(v.value) }));
      this.svg.append(drawn("text", { x: margin.left - 5, y: y(v.value) + 4, "text-anchor": "end" }, v.text));
    }
    const path = (times, values) => times.map((t, i) => `${this.x(t).toFixed(1)},${y(values[i]).toFixed(1)}`);
    for (const s of this.shown) {
      const colour = `var(--c${s.colour})`;
      if (s.low) {
        const points = [...path(s.time, s.high), ...path(s.time, s.low).reverse()].join(" ");
        this.svg.append(drawn("polygon", { points, fill: colour, "fill-opacity": s.filled ? .55 : .25, stroke: "none" }));
      }
      for (const values of s.singles ?? [])
        this.svg.append(drawn("polyline", { class: "single", points: path(s.singlesTime, values).join(" "), fill: "none", stroke: colour, "stroke-width": 0.8, "stroke-opacity": 0.35 }));
      if (s.value) this.svg.append(drawn("polyline", { points: path(s.time, s.value).join(" "), fill: "none", stroke: colour, "stroke-width": s.bold ? 2.6 : 1.3, "stroke-dasharray": dashes[s.dash], "stroke-linejoin": "round" }));
      if (s.dots) for (const point of path(s.time, s.value)) this.svg.append(drawn("circle", { cx: point.split(",")[0], cy: point.split(",")[1], r: 3, fill: colour }));
    }
    this.mark = drawn("line", { class: "mark", y1: margin.top, y2: bottom, visibility: "hidden" });
    this.cursor = drawn("line", { class: "cursor", y1: margin.top, y2: bottom });
    this.svg.append(this.mark, this.cursor);
    this.setTime(this.time);
  }

  setTime(time) {
    this.time = time;
    if (!this.cursor) return;
    const inside = time !== null && time >= this.bounds.start && time <= this.bounds.end;
    this.cursor.setAttribute("visibility", inside ? "visible" : "hidden");
    if (inside) for (const end of ["x1", "x2"]) this.cursor.setAttribute(end, this.x(time));
  }

  timeAt(event) {
    const box = this.svg.getBoundingClientRect(), r = this.bounds;
    const share = (event.clientX - box.left - margin.left) / (box.width - margin.left - margin.right);
    return r.start + Math.min(1, Math.max(0, share)) * (r.end - r.start);
  }

  hover(event) { this.read(this.timeAt(event), event.clientX, event.clientY); }

  // Values of the rows nearest to a time, in the digits of the file.
  read(time, x, y) {
    this.readAt = time;
    for (const end of ["x1", "x2"]) this.mark.setAttribute(end, this.x(time));
    this.mark.setAttribute("visibility", "visible");
    hideTip.mark = this.mark;
    const rows = this.shown.map(s => {
      const i = nearest(s.time, time);
      return [s.result ? `${s.name}, ${s.result}` : s.name, s.text[i] + (s.error ? ` ± ${s.error[i]}` : "") + (this.unit ? " " + this.unit : "") + (s.interval ? s.interval(i) : "")];
    });
    // Results whose rows stand at other times have a time each.
    const at = new Map();
    for (const s of this.shown) at.set(s.timeText[nearest(s.time, time)], s.result);
    const times = [...at].map(([text, result]) => [at.size > 1 && result ? `time, ${result}` : "time", text + " s"]);
    showTip([...times, ...rows], x, y);
  }

  key(event) {
    const move = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
    if (!move) return;
    event.preventDefault();
    const times = this.series[0].time, from = nearest(times, this.readAt ?? this.time ?? times[0]);
    const at = times[Math.min(times.length - 1, Math.max(0, from + move * (event.shiftKey ? 10 : 1)))];
    const box = this.svg.getBoundingClientRect();
    this.read(at, box.left + this.x(at), box.top + 20);
  }
}
Chart.all = [];

const showTip = (rows, x, y) => {
  const tip = document.getElementById("tip"), table = element("table");
  for (const [name, value] of rows) table.append(element("tr", {}, element("td", { textContent: name }), element("td", { textContent: value })));
  tip.replaceChildren(table);
  tip.hidden = false;
  const box = tip.getBoundingClientRect();
  tip.style.left = Math.max(4, Math.min(x + 14, innerWidth - box.width - 6)) + "px";
  tip.style.top = Math.max(4, Math.min(y + 14, innerHeight - box.height - 6)) + "px";
};

const hideTip = () => {
  document.getElementById("tip").hidden = true;
  if (hideTip.mark) hideTip.mark.setAttribute("visibility", "hidden");
};
