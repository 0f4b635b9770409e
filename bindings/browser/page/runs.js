// SPDX-License-Identifier: Apache-2.0
// Runs of the case: their results, those kept from before, the report of the last ones.
"use strict";

const jetsOf = text => [...text.matchAll(/^\s*\[inflator\.jet\]/gm)].length;

class Runs {
  constructor(jobs) {
    this.jobs = jobs;
    this.now = []; // { label, table, summary, files }
    this.old = []; // { table } of earlier ones
    this.many = {}; // files of the last ensemble
    this.frame = document.getElementById("report");
  }

  // Runs the variants [{ label, words }] of a case side by side; false if one failed, with its messages in `says`.
  async run(files, variants, progress) {
    const parts = variants.map(() => 0);
    const answers = await Promise.all(variants.map(({ words }, i) => this.jobs.run(
      { files, commands: [["run", "case.toml", "--out", "run", ...words]], take: ["run"] },
      { group: "run", progress: text => {
        parts[i] = Number(/(\d+) %/.exec(text)?.[1] ?? 0) / 100;
        progress(parts.reduce((a, b) => a + b) / parts.length, text.replace(/.*% ?,? ?/, ""));
      } })));
    if (answers.some(a => a.stopped)) return { stopped: true };
    const done = answers.filter(a => a.files["run/history.csv"]);
    const says = answers.flatMap(a => a.says.filter(line => !/: done in /.test(line)));
    if (done.length > 0) {
      this.old = [...this.old, ...this.now.map(({ table }) => ({ table }))].slice(-6);
      this.now = answers.map((a, i) => ({ a, label: variants[i].label })).filter(({ a }) => a.files["run/history.csv"]).map(({ a, label }) => ({
        label, files: a.files, table: parseTable(asText(a.files["run/history.csv"])),
        summary: a.files["run/summary.json"] ? JSON.parse(asText(a.files["run/summary.json"])) : {} }));
    }
    return { says, failed: answers.some(a => a.code !== 0), bytes: Math.max(...answers.map(a => a.bytes)) };
  }

  get drawn() {
    return [...this.old.map(run => ({ ...run, colour: -1 })), ...this.now.map((run, i) => ({ ...run, colour: i }))];
  }

  // Peaks of the runs side by side, with the difference to the run before where there is one run alone.
  peaks() {
    const names = Object.keys(this.now[0]?.summary.peak ?? {}).filter(name => this.now.some(run => typeof run.summary.peak?.[name] === "number"));
    const digits = v => (typeof v === "number" ? String(Number(v.toPrecision(5))) : "");
    const row = (cells, kind) => {
      const tr = document.createElement("tr");
      tr.append(...cells.map(text => Object.assign(document.createElement(kind), { textContent: text })));
      return tr;
    };
    const rows = names.map(name => {
      const values = this.now.map(run => run.summary.peak?.[name]), [title, unit] = named(name);
      const change = values.length === 2 ? [digits(values[0] - values[1])] : [];
      return row([`${title}${unit ? ` [${unit}]` : ""}`, ...values.map(digits), ...change], "td");
    });
    return names.length === 0 ? [] : [row(["peak", ...this.now.map(run => run.label), ...(this.now.length === 2 ? ["difference"] : [])], "th"), ...rows];
  }

  // The page of `gasjet report` of result folders { name: files }.
  async report(folders) {
    const files = {}, names = Object.keys(folders);
    for (const [name, own] of Object.entries(folders))
      for (const [file, bytes] of Object.entries(own)) files[`${name}/${file.split("/").slice(1).join("/")}`] = bytes;
    const answer = await this.jobs.run({ files, commands: [["report", ...names, "--out", "report.html"]], take: ["report.html"] }, { group: "report" });
    if (answer.stopped || !answer.files["report.html"]) return "";
    return withThree(asText(answer.files["report.html"]));
  }

  async showReport(folders) {
    this.page = await this.report(folders);
    this.frame.srcdoc = this.page;
  }

  folders() {
    return Object.fromEntries(this.now.map(run => [run.label.replace(/[^\w.-]/g, "_"), run.files]));
  }

  // The shares of an ensemble in workers, then its means.
  async ensemble(files, count, progress) {
    const shares = Math.min(this.jobs.cores, 8), done = new Array(shares).fill(0);
    const command = ["ensemble", "case.toml", "--runs", String(count), "--out", "ensemble"];
    const answers = await Promise.all(done.map((_, i) => this.jobs.run(
      { files, commands: [[...command, "--share", `${i + 1}/${shares}`]], take: ["ensemble"] },
      { group: "run", progress: text => {
        done[i] = Number(/(\d+) %/.exec(text)?.[1] ?? 0) / 100;
        progress(done.reduce((a, b) => a + b) / shares, "ensemble");
      } })));
    if (answers.some(a => a.stopped)) return { stopped: true };
    const bad = answers.find(a => a.code !== 0 && Object.keys(a.files).length === 0);
    if (bad) return { says: bad.says, failed: true };
    const merged = await this.jobs.run({ files: Object.assign({}, files, ...answers.map(a => a.files)), commands: [command], take: ["ensemble"] }, { group: "run" });
    this.many = merged.files;
    return merged.stopped ? merged : { says: merged.says, files: merged.files, failed: merged.code !== 0 };
  }

  async ladder(files, quantity, progress) {
    const answer = await this.jobs.run({ files, commands: [["ladder", "case.toml", "--quantity", quantity, "--runs", "4", "--out", "ladder"]], take: ["ladder"] },
      { group: "run", progress: text => progress(Number(/(\d+) %/.exec(text)?.[1] ?? 0) / 100, "ladder") });
    return answer.stopped ? answer : { says: answer.says, files: answer.files, failed: ![0, 4].includes(answer.code) };
  }
}

// Reports of this program come without three.js, which this page has once.
let three = ["", ""];
const withThree = page => {
  const place = page.lastIndexOf("<script></script>\n<script></script>");
  if (place < 0) return page;
  return `${page.slice(0, place)}<script>${three[0]}</script>\n<script>${three[1]}</script>${page.slice(place + 35)}`;
};
