// SPDX-License-Identifier: Apache-2.0
// Charts of the runs: the newest in colour, older ones grey behind. Drawn anew at each run, within a few milliseconds.
"use strict";

let unitEndings = {}; // of columns, set at the start

// "pressure_Pa" -> ["pressure", "Pa"], by the endings of the program's columns.
const named = column => {
  const ending = Object.keys(unitEndings).sort((a, b) => b.length - a.length).find(e => column.endsWith(e));
  return ending ? [column.slice(0, -ending.length).replaceAll("_", " "), unitEndings[ending]] : [column.replaceAll("_", " "), ""];
};

const parseTable = text => {
  const lines = text.split("\n").filter(line => line && !line.startsWith("#")), names = lines[0].split(",");
  const table = Object.fromEntries(names.map(name => [name, new Float64Array(lines.length - 1)]));
  for (let i = 1; i < lines.length; ++i) {
    const cells = lines[i].split(",");
    for (let k = 0; k < names.length; ++k) table[names[k]][i - 1] = Number(cells[k]);
  }
  return table;
};

const svg = (name, attributes, text) => {
  const node = document.createElementNS("http://www.w3.org/2000/svg", name);
  for (const [key, value] of Object.entries(attributes)) node.setAttribute(key, value);
  if (text !== undefined) node.textContent = text;
  return node;
};

const steps = (low, high, count) => {
  const rough = (high - low) / count, power = 10 ** Math.floor(Math.log10(rough));
  const step = power * [1, 2, 5, 10].find(f => f * power >= rough * 0.999), list = [];
  for (let i = Math.ceil(low / step - 1e-9); i * step <= high + 1e-9 * step; ++i) list.push(Number((i * step).toPrecision(9)));
  return list;
};

// The path of a line of at most about a thousand points; of each group the least and the largest value stay.
const pathOf = (time, value, x, y) => {
  const group = Math.max(1, Math.floor(time.length / 500));
  let path = "";
  for (let i = 0; i < time.length; i += group) {
    let low = i, high = i;
    for (let k = i; k < Math.min(i + group, time.length); ++k) {
      if (value[k] < value[low]) low = k;
      if (value[k] > value[high]) high = k;
    }
    for (const k of low === high ? [low] : [Math.min(low, high), Math.max(low, high)]) path += `${path ? "L" : "M"}${x(time[k]).toFixed(1)} ${y(value[k]).toFixed(1)}`;
  }
  return path;
};

// Lines of one or more columns over the column `over` of each run. runs: { table, label, colour: number or -1 for an old one, over:
// "time_s" if it is missing, column: of this run }, drawn in this order; axis: [name, unit] where the column's name does not say it.
const drawChart = (column, runs, axis) => {
  const width = 420, height = 200, left = 62, right = 410, top = 8, bottom = 172, [title, unit] = named(column);
  const root = document.createElement("div"), head = document.createElement("h3"), picture = svg("svg", { viewBox: `0 0 ${width} ${height}`, role: "img", "aria-label": title });
  root.className = "chart";
  head.textContent = title + (unit ? ` [${unit}]` : "");
  const shown = runs.map(run => ({ ...run, value: run.table[run.column ?? column], x: run.table[run.over ?? "time_s"] })).filter(run => run.value);
  const ends = name => shown.reduce((all, run) => run[name].reduce(([low, high], v) => [Math.min(low, v), Math.max(high, v)], all), [Infinity, -Infinity]);
  let [low, high] = ends("value");
  const [start, end] = ends("x");
  if (!(high - low > 1e-9 * Math.max(Math.abs(low), Math.abs(high)))) [low, high] = [low - (Math.abs(low) * 1e-3 || 1), high + (Math.abs(high) * 1e-3 || 1)];
  const pad = 0.04 * (high - low), x = t => left + (right - left) * (t - start) / (end - start || 1), y = v => bottom - (bottom - top) * (v - low + pad) / (high - low + 2 * pad);
  picture.append(svg("rect", { class: "frame", x: left, y: top, width: right - left, height: bottom - top }));
  for (const v of steps(low, high, 4)) picture.append(svg("text", { x: left - 5, y: y(v) + 4, "text-anchor": "end" }, String(v)));
  const [over, size] = axis ?? named(shown[0]?.over ?? "time_s"), scale = size === "s" && end <= 1 ? 1000 : 1;
  for (const t of steps(start * scale, end * scale, 5)) picture.append(svg("text", { x: x(t / scale), y: bottom + 14, "text-anchor": "middle" }, String(t)));
  picture.append(svg("text", { x: right, y: height - 2, "text-anchor": "end" }, over + (size ? ` [${scale === 1 ? size : "ms"}]` : "")));
  for (const run of shown)
    picture.append(svg("path", { d: pathOf(run.x, run.value, x, y), fill: "none", ...(run.colour < 0 ? { class: "old" } : { stroke: `var(--c${run.colour})`, "stroke-width": 1.8, ...(run.dots ? { "stroke-dasharray": "1 6", "stroke-width": 5, "stroke-linecap": "round" } : {}) }) }));
  const legend = document.createElement("div");
  legend.className = "legend";
  for (const run of shown.filter(r => r.colour >= 0)) {
    const name = document.createElement("span");
    name.textContent = `${run.label}: ${Number(run.value.at(-1).toPrecision(5))} at the end`;
    name.style.color = `var(--c${run.colour})`;
    legend.append(name);
  }
  root.append(head, picture, legend);
  return root;
};

// A slider with its name and value, and what stands after them; moved(number) gives the text to show. stops: { low, high, whole, value, text }.
const sliderRow = (title, { low, high, whole, value, text }, moved, ...after) => {
  const row = document.createElement("label"), name = Object.assign(document.createElement("span"), { textContent: title });
  const range = Object.assign(document.createElement("input"), { type: "range", min: low, max: high, step: whole ? 1 : (high - low) / 200, disabled: value === undefined });
  const shown = document.createElement("output");
  range.value = value ?? 0;
  range.setAttribute("aria-label", title);
  shown.value = text;
  range.addEventListener("input", () => { shown.value = moved(Number(range.value)) ?? shown.value; });
  row.append(name, range, shown, ...after);
  return row;
};

// Where a slider of a number begins and ends if nobody says.
const rangeOf = value => (value === 0 ? [-1, 1] : [value / 3, value * 3].sort((a, b) => a - b));

const firstColumns = ["pressure_Pa", "pendulum_angle_rad", "temperature_K", "jet_force_N", "contact_force_N", "volume_m3", "gas_mass_kg"];
const columnsOf = table => {
  const names = Object.keys(table).filter(name => name !== "time_s");
  return [...firstColumns.filter(name => names.includes(name)), ...names.filter(name => !firstColumns.includes(name))];
};
