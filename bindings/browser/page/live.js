// SPDX-License-Identifier: Apache-2.0
// Live figures of the documentation: a place <div class="gasjet-live" data-...> fills with sliders and charts once it is in sight.
//   data-form="name name"        closed forms of `gasjet exact`; their parameters, ranges and messages are the program's
//   data-case="name"             a shipped case, run beside them or alone
//   data-keys="parameter=key"    which key of the case a parameter is; with it, they alone have sliders
//   data-sliders="name name"     those that have sliders: of a form all if it is missing; of a case keys, as in inflator.0.temperature
//   data-without="key"           the case runs once more without this table
//   data-columns="a b+c"         charts, and which columns share one; all if it is missing
//   data-over="name first last"  draws over a parameter, not over the form's first column, which has a slider from data-at="value"
"use strict";

const words = text => (text ?? "").split(/\s+/).filter(Boolean);
const tagged = (name, properties, ...children) => {
  const node = Object.assign(document.createElement(name), properties);
  node.append(...children);
  return node;
};

class Figure {
  constructor(place, exact, forms, runner, scene) {
    Object.assign(this, { place, exact, runner, scene, given: place.dataset, values: {}, busy: false, again: false, first: null });
    this.forms = words(this.given.form).map(name => forms.find(form => form.name === name));
    if (this.forms.includes(undefined) || (this.given.case && !scene)) throw new Error(`${this.given.form ?? this.given.case} is not there`);
    this.keys = new Map(words(this.given.keys).map(pair => pair.split("=")));
    [this.over, this.from, this.to] = words(this.given.over);
    this.message = tagged("p", { className: "message" });
    this.charts = tagged("div", { className: "charts" });
  }

  async start() {
    const sliders = await this.sliders(), ranges = tagged("div", { className: "sliders" });
    for (const { name, title, like, ...stops } of sliders) {
      this.values[name] = stops.value;
      ranges.append(sliderRow(title, { ...stops, text: String(Number(stops.value.toPrecision(6))) }, value => {
        const text = numberText(value, like);
        this.values[name] = Number(text);
        this.draw();
        return text;
      }));
    }
    this.place.replaceChildren(ranges, this.charts, this.message);
    await this.draw();
  }

  settings(form, values) {
    return form.parameters.filter(p => values[p.name] !== undefined).flatMap(p => ["--set", `${p.name}=${values[p.name]}`]);
  }

  // The answer of `gasjet exact`; its code is 0 where the form holds.
  ask(form, values, times) {
    return this.exact.run({ files: {}, commands: [["exact", form.name, ...this.settings(form, values), ...(times ? ["--times", times] : [])]] });
  }

  async holds(form, values, times) {
    return (await this.ask(form, values, times)).code === 0;
  }

  // Ends of a parameter between which the form holds while the others are what they are: the program says so.
  async range(form, { name, default: value }) {
    const fits = v => this.holds(form, { [name]: v }), whole = Number.isInteger(value) && !(await fits(value + 0.5)) && !(await fits(value - 0.5));
    const wanted = whole ? [value - 3, value + 3] : value === 0 ? [0, 1] : rangeOf(value), ends = [];
    for (let end of wanted) {
      if (whole) while (end !== value && !(await fits(end))) end -= Math.sign(end - value);
      else if (!(await fits(end))) {
        let good = value;
        for (let k = 0; k < 7; ++k) {
          const middle = (good + end) / 2;
          if (await fits(middle)) good = middle; else end = middle;
        }
        end = good;
      }
      ends.push(end);
    }
    return { low: ends[0], high: ends[1], whole };
  }

  async sliders() {
    const chosen = this.keys.size ? [...this.keys.keys()] : words(this.given.sliders), list = [];
    for (const form of this.forms) for (const p of form.parameters) {
      if (p.name === this.over || list.some(s => s.name === p.name) || (chosen.length && !chosen.includes(p.name))) continue;
      list.push({ name: p.name, title: `${p.name.replaceAll("_", " ")}${p.unit === "1" ? "" : ` [${p.unit}]`}: ${p.meaning}`, value: p.default, ...(await this.range(form, p)) });
    }
    for (const slider of list) slider.like = slider.whole ? "1" : "1.0";
    if (this.over) {
      const [name, unit] = named(this.forms[0].columns[0]), value = Number(this.given.at);
      list.unshift({ name: "at", title: unit ? `${name} [${unit}]` : name, like: "1.0", value, low: 0, high: 3 * value });
    }
    if (this.scene && this.forms.length === 0) {
      const { numbers } = readCase(this.scene.text);
      for (const name of chosen) {
        const found = numbers.filter(n => n.path === name).reduce((a, b) => (Math.abs(b.value) > Math.abs(a.value) ? b : a)), [low, high] = rangeOf(found.value);
        list.push({ name: found.name, title: name, like: found.text, value: found.value, low, high, whole: /^[+-]?[\d_]+$/.test(found.text) });
      }
    }
    return list;
  }

  // The newest values count.
  async draw() {
    if (this.busy) return void (this.again = true);
    this.busy = true;
    const began = performance.now();
    try {
      await this.show();
    } catch (error) {
      this.message.textContent = error.message;
    }
    this.busy = false;
    this.place.dataset.milliseconds = String(Math.round(performance.now() - began));
    this.place.dataset.drawn = String(Number(this.place.dataset.drawn ?? 0) + 1);
    if (this.again) { this.again = false; this.draw(); }
  }

  async show() {
    const values = { ...this.values }, runs = this.scene ? await this.runs(values) : [];
    const lines = await Promise.all(this.forms.map((form, i) => (this.over ? this.acrossLine(form, values, i) : this.line(form, values, i, runs[0]))));
    const all = [...lines.filter(line => line.table), ...runs.map((run, i) => ({ ...run, colour: lines.length + i, dots: lines.length > 0 }))];
    const old = (this.first ?? []).map(line => ({ ...line, colour: -1 }));
    this.first ??= all;
    this.charts.replaceChildren(...this.groups(all).map(group => this.chart(group, [...old, ...all])));
    this.message.replaceChildren(...lines.flatMap(line => line.says).concat(this.differences(lines, runs)).map(text => tagged("span", { textContent: text })));
  }

  // Columns that share a chart; lines of old values lie behind.
  chart(group, lines) {
    const runs = lines.flatMap(line => group.filter(column => line.table[column]).map((column, k) => (
      { ...line, column, label: group.length > 1 ? named(column)[0] : line.label, colour: line.colour < 0 ? -1 : line.colour + k })));
    const axis = this.over && [this.over.replaceAll("_", " "), this.forms[0].parameters.find(p => p.name === this.over).unit];
    const chart = drawChart(group[0], runs, axis), [, unit] = named(group[0]);
    chart.querySelector("h3").textContent = group.map(column => named(column)[0]).join(", ") + (unit ? ` [${unit}]` : "");
    return chart;
  }

  groups(lines) {
    const wanted = words(this.given.columns).map(group => group.split("+"));
    return wanted.length ? wanted : [...new Set(lines.flatMap(({ table, over }) => Object.keys(table).filter(name => name !== over)))].map(name => [name]);
  }

  refused(answer) {
    return new Error(answer.says.join(" ").replace(/^gasjet: /, "") || "it was stopped");
  }

  // A form over its first column, at the times of a run where there is one; or its values alone.
  async line(form, values, colour, run) {
    const [first, last] = [form.abscissae[0], form.abscissae.at(-1)];
    let times = last > first ? `${first}:${last}:${(last - first) / 200}` : "";
    if (run) times = `0:${run.table.time_s.at(-1)}:${run.table.time_s.at(-1) / (run.table.time_s.length - 1)}`;
    form.fine ??= times !== "" && (await this.holds(form, {}, times));
    const answer = await this.ask(form, values, form.fine ? times : "");
    if (answer.code !== 0) throw this.refused(answer);
    const table = parseTable(answer.out.join("\n")), tell = (name, value) => `${named(name)[0]} ${Number(Number(value).toPrecision(6))} ${named(name)[1]}`.trim();
    if (form.abscissae.length === 0) return { says: Object.keys(table).map(name => tell(name, table[name][0])) };
    const says = form.constants.map(name => tell(name, answer.out.find(line => line.startsWith(`# ${name}: `)).split(": ")[1]));
    return { table, over: form.columns[0], label: this.forms.length > 1 ? form.name.replaceAll("_", " ") : "closed form", colour, says };
  }

  // A form over a parameter, at one value of its first column.
  async acrossLine(form, values, colour) {
    const count = 60, at = Array.from({ length: count + 1 }, (_, i) => Number(this.from) + i * (this.to - this.from) / count);
    const answer = await this.exact.run({ files: {}, commands: at.map(v => ["exact", form.name, ...this.settings(form, { ...values, [this.over]: v }), "--times", String(values.at)]) });
    if (answer.code !== 0) throw this.refused(answer);
    const head = form.columns.join(","), rows = answer.out.filter(line => !line.startsWith("#") && line !== head);
    return { table: { ...parseTable([head, ...rows].join("\n")), [this.over]: Float64Array.from(at) }, over: this.over, label: form.name.replaceAll("_", " "), colour, says: [] };
  }

  // Gasjet's runs of the case.
  async runs(values) {
    const { text, files } = this.scene, set = [...this.keys].flatMap(([name, key]) => ["--set", `${key}=${values[name]}`]);
    let changed = text;
    for (const n of this.forms.length ? [] : readCase(text).numbers.reverse()) if (values[n.name] !== undefined) changed = changed.slice(0, n.start) + numberText(values[n.name], n.text) + changed.slice(n.end);
    const variants = [{ label: this.given.without ? "with" : "Gasjet", words: [] }, ...words(this.given.without).map(key => ({ label: "without", words: ["--unset", key] }))];
    const answers = await Promise.all(variants.map(variant => this.runner.run({ files: { ...files, "case.toml": changed }, take: ["run/history.csv"],
      commands: [["run", "case.toml", "--out", "run", ...set, ...variant.words]] }, { progress: text => { this.message.textContent = text; } })));
    return answers.map((answer, i) => {
      if (answer.code !== 0) throw this.refused(answer);
      return { table: parseTable(asText(answer.files["run/history.csv"])), over: "time_s", label: variants[i].label };
    });
  }

  // How far the run is from the closed form, as a share of the column's largest value.
  differences(lines, runs) {
    if (lines.length === 0 || runs.length === 0) return [];
    return Object.keys(lines[0].table).filter(name => name !== "time_s" && runs[0].table[name]?.length === lines[0].table[name].length).map(name => {
      const exact = lines[0].table[name], mine = runs[0].table[name];
      const size = exact.reduce((all, v) => Math.max(all, Math.abs(v)), 0), most = exact.reduce((all, v, i) => Math.max(all, Math.abs(v - mine[i])), 0);
      return `Gasjet's ${named(name)[0]}: ${(most === 0 ? 0 : most / size).toExponential(1)} of its largest value from the closed form`;
    });
  }
}

// A program is loaded once a page, when the first figure that needs it is in sight.
window.gasjetPrograms = [];
const folder = new URL(".", document.currentScript.src), loaded = new Map();
const load = name => {
  if (!loaded.has(name)) loaded.set(name, new Promise((done, failed) => {
    document.head.append(tagged("script", { src: new URL(`${name}_program.js`, folder).href, onload: () => done(gasjetPrograms.pop()), onerror: () => failed(new Error(`${name}_program.js is not there`)) }));
  }).then(startProgram).then(({ jobs, data }) => {
    unitEndings = data.units;
    return { jobs, ...data };
  }));
  return loaded.get(name);
};

let catalogue = null;
const formsOf = async ({ jobs }) => JSON.parse((await jobs.run({ files: {}, commands: [["exact", "--list", "--format", "json"]] })).out.join("\n")).closed_forms;

const fill = async place => {
  place.textContent = "starting";
  try {
    const { form, case: scene } = place.dataset, exact = form && (await load("exact")), runs = scene && (await load("gasjet"));
    await new Figure(place, exact?.jobs, exact && (await (catalogue ??= formsOf(exact))), runs?.jobs, runs?.cases[scene]).start();
  } catch (error) {
    place.textContent = `This browser cannot run it: ${error.message}`;
  }
};

const watch = new IntersectionObserver(entries => {
  for (const { isIntersecting, target } of entries) if (isIntersecting) { watch.unobserve(target); fill(target); }
}, { rootMargin: "200px" });
for (const place of document.querySelectorAll(".gasjet-live")) watch.observe(place);
