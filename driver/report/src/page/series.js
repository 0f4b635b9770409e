// SPDX-License-Identifier: Apache-2.0
// From tables of results to series of charts.
"use strict";

const names = {
  Pa: "Pressure", K: "Temperature", "m³": "Volume", "m²": "Area", kg: "Mass", "kg/s": "Mass flow", W: "Heat flow", N: "Force", m: "Length",
  rad: "Angle", "rad/s": "Angular velocity", "m/s²": "Acceleration", "m/s": "Speed", J: "Energy", "": "Numbers",
};

// { quantity, unit, name } of a column, or of a quantity of the summary.
const split = column => {
  const [ending, unit] = data.units.find(([ending]) => column.endsWith(ending)) ?? ["", ""];
  const quantity = column.slice(0, column.length - ending.length);
  return { quantity, unit, name: quantity.replace(/,?_cfc_?(\d+)/i, ", CFC $1").replaceAll("_", " ") };
};

// Columns of a table: texts as in the file, and their values.
const read = table => {
  const columns = Object.fromEntries(table.columns.map(name => [name, []]));
  const lists = table.columns.map(name => columns[name]);
  for (const line of table.rows.split("\n")) line.split(",").forEach((cell, i) => lists[i].push(cell));
  return Object.fromEntries(Object.entries(columns).map(([name, text]) => [name, { text, value: text.map(Number) }]));
};

// What belongs to a column: the ends of an interval or a half width, by name. Null if it is such a companion itself.
const companions = (column, all) => {
  const has = name => all.includes(name);
  const { quantity, unit } = split(column), ending = column.slice(quantity.length);
  if (column === "time_s") return null;
  for (const [suffix, owner] of [["_standard_error", "_mean"], ["_band", ""]])
    if (column.endsWith(suffix) && (has(column.slice(0, -suffix.length) + owner) || has(column.slice(0, -suffix.length) + "_reference"))) return null;
  const owner = quantity.replace(/_(low|high)$/, "");
  if (owner !== quantity && ["", "_low", "_high"].every(end => has(owner + end + ending))) return null;
  const base = column.replace(/_(mean|reference)$/, "");
  const error = [base + "_standard_error", base + "_band"].find(name => name !== column && has(name) && !(name.endsWith("_band") && column === base && has(base + "_reference")));
  const ends = ["low", "high"].map(end => `${quantity}_${end}${ending}`);
  return { base, ends: ends.every(has) ? ends : null, error };
};

// Series of all columns of a table. `dash` tells results apart; `singles` is a table of single runs, COLUMN_run_SEED.
const seriesOf = (table, result, dash, singles) => {
  const columns = read(table), time = columns.time_s, list = [];
  const runs = singles ? read(singles) : {};
  const singlesOf = base => Object.entries(runs).filter(([name]) => name.replace(/_run_\d+$/, "") === base && name !== base).map(([, { value }]) => value);
  for (const column of table.columns) {
    const own = companions(column, table.columns);
    if (!own) continue;
    const { unit, name } = split(own.base), error = own.error && columns[own.error], ends = own.ends?.map(end => columns[end]);
    const claimed = i => !columns.band_claimed || columns.band_claimed.value[i] > 0;
    const end = k => columns[column].value.map((v, i) => error ? v + (2 * k - 1) * error.value[i] : claimed(i) ? ends[k].value[i] : v);
    const banded = error || ends;
    list.push({
      column, unit, result, dash: column.endsWith("_reference") ? referenceDash : dash, name: column.endsWith("_reference") ? `${name}, reference` : name,
      time: time.value, timeText: time.text, value: columns[column].value, text: columns[column].text,
      low: banded ? end(0) : null, high: banded ? end(1) : null,
      error: error ? error.text : null, interval: i => error || !ends ? "" : claimed(i) ? `, ${ends[0].text[i]} to ${ends[1].text[i]}` : ", no band",
      singles: singlesOf(own.base), singlesTime: runs.time_s?.value,
    });
  }
  return list;
};

// One chart for each unit; series of one name have one colour. Those without a unit have a chart each.
const groups = series => {
  const charts = new Map();
  for (const s of series) {
    const key = s.unit || `number ${s.name}`;
    if (!charts.has(key)) charts.set(key, { title: s.unit ? names[s.unit] ?? s.unit : s.name, unit: s.unit, series: [] });
    charts.get(key).series.push(s);
  }
  for (const chart of charts.values()) {
    const order = [...new Set(chart.series.map(s => s.name.replace(/, reference$/, "")))];
    for (const s of chart.series) {
      const place = order.indexOf(s.name.replace(/, reference$/, ""));
      s.colour = place % 8;
      if (s.dash === undefined) s.dash = 0;
      if (order.length > 8 && place >= 8) s.dash = (s.dash + 1) % 4;
    }
    if (order.length === 1) chart.title = order[0][0].toUpperCase() + order[0].slice(1);
  }
  return [...charts.values()];
};

// What is held and was spent, one upon another; what was supplied, a line. The residual is what lies between.
// terms: { name, change, text }. The seven that change most have a layer each, the others share one.
const stackChart = (title, unit, common, terms, supplied) => {
  const sum = lists => common.time.map((_, i) => lists.reduce((total, list) => total + list[i], 0));
  const digits = values => values.map(v => String(Number(v.toPrecision(12))));
  const size = term => term.change.reduce((most, v) => Math.max(most, Math.abs(v)), 0);
  const small = [...terms].sort((a, b) => size(b) - size(a)).slice(7);
  const layers = terms.filter(term => !small.includes(term));
  if (small.length) {
    const change = sum(small.map(term => term.change));
    layers.push({ name: "others", change, text: digits(change) });
  }
  const up = new Float64Array(common.time.length), down = new Float64Array(common.time.length);
  const series = layers.map(({ name, change, text }, k) => {
    const low = [], high = [];
    change.forEach((v, i) => {
      const stack = v < 0 ? down : up, before = stack[i];
      stack[i] += v;
      low.push(Math.min(before, stack[i]));
      high.push(Math.max(before, stack[i]));
    });
    return { ...common, name, low, high, text: text ?? digits(change), value: null, filled: true, colour: k };
  });
  const total = sum(supplied);
  series.push({ ...common, name: "supplied", value: total, text: digits(total), colour: 6, dash: 1 });
  return { title, unit, series, height: 260 };
};

// Energies of the gas without those that it has at ambient temperature, where the table has them: a chart of absolute ones depends on the zero of enthalpy.
const sensible = columns => Object.fromEntries(Object.entries(columns).map(([name, column]) => [name, columns[name.replace(/_(internal|enthalpy)_J$/, "_sensible_J")] ?? column]));

const energyCharts = (table, roles, result) => {
  const columns = sensible(read(table)), time = columns.time_s, of = result ? `, ${result}` : "";
  const common = { result: "", time: time.value, timeText: time.text, dash: 0 };
  const changeOf = column => columns[column].value.map(v => (roles[column] === "held" ? v - columns[column].value[0] : v));
  const terms = table.columns.filter(c => ["held", "spent"].includes(roles[c])).map(column => ({ name: split(column).name.replace(/ (internal|enthalpy)$/, columns.gas_sensible_J ? ", sensible" : " $1") + (roles[column] === "spent" ? " (spent)" : ""), change: changeOf(column), text: columns[column].text }));
  if (!terms.length) return [];
  const list = [stackChart(`Where the energy went since the start${of}`, "J", common, terms, table.columns.filter(c => roles[c] === "supplied").map(c => columns[c].value))];
  for (const [column, title] of [["residual_J", "Residual of the energy"], ["kick_residual_J", "Residual of the kicks' work"]])
    if (columns[column]) list.push({ title: title + of, unit: "J", series: [{ ...common, name: title, value: columns[column].value, text: columns[column].text, colour: 1 }] });
  return list;
};

// The same for the gas: what is in the tank or bag, and the flows of the rows integrated by the trapezoid rule.
const massChart = (table, result) => {
  const columns = read(table), time = columns.time_s.value, of = result ? `, ${result}` : "";
  if (!columns.gas_mass_kg) return [];
  const total = ({ value }) => {
    let sum = 0;
    return value.map((v, i) => (sum += i > 0 ? 0.5 * (v + value[i - 1]) * (time[i] - time[i - 1]) : 0));
  };
  const held = columns.gas_mass_kg.value;
  const terms = [{ name: "gas", change: held.map(v => v - held[0]) }];
  for (const column of table.columns) if (column.endsWith("_outflow_kg_s")) terms.push({ name: split(column).name, change: total(columns[column]) });
  const common = { result: "", time, timeText: columns.time_s.text, dash: 0 };
  return [stackChart(`Where the gas went since the start, from the rows${of}`, "kg", common, terms, ["inflow_kg_s", "backflow_kg_s"].filter(c => columns[c]).map(c => total(columns[c])))];
};

// Looks at a skin that passes through itself: the volume that is counted wrongly, and how many elements cross.
const crossingCharts = (summary, result) => {
  const looks = summary?.self_intersection?.looks ?? [], of = result ? `, ${result}` : "";
  if (!looks.some(look => look.pairs > 0)) return [];
  const common = { result: "", time: looks.map(look => look.time_s), timeText: looks.map(look => String(look.time_s)), dash: 0, dots: true };
  const series = (key, name, colour, error) => ({
    ...common, name, colour, value: looks.map(look => look[key]), text: looks.map(look => String(look[key])),
    ...(error && { error: looks.map(look => String(look[error])), low: looks.map(look => look[key] - look[error]), high: looks.map(look => look[key] + look[error]) }),
  });
  const list = [{ title: `Elements that pass through each other${of}`, unit: "", zero: true, series: [series("pairs", "pairs", 0), series("elements", "elements", 1)] }];
  if (looks.every(look => "volume_m3" in look))
    list.push({ title: `Volume counted wrongly, where the skin passes through itself${of}`, unit: "m³", zero: true, series: [
      series("counted_twice_m3", "counted twice", 0, "counted_twice_standard_error_m3"), series("inside_out_m3", "inside out", 1, "inside_out_standard_error_m3")] });
  return list;
};
