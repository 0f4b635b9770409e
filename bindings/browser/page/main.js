// SPDX-License-Identifier: Apache-2.0
// The page: case, sliders, runs, files, links.
"use strict";

const at = id => document.getElementById(id);
let cases = {}, jobs, runs, editor, sliders = [], extra = {}, checked = 0, checkBegan = 0, again = null, isBusy = false, runningText = "", checkWaits = false, chosenColumn = "", reportTimer = 0;

const status = (text, part) => {
  at("status").textContent = text;
  at("bar").value = part ?? at("bar").value;
};
const files = () => ({ ...extra, "case.toml": editor.text });
const fileName = () => /^\s*name\s*=\s*"([\w.-]+)"/m.exec(editor.text)?.[1] ?? "case";

// Sliders stand for numbers of the text and move them there.
const moveNumber = (name, value) => {
  const place = editor.read.numbers.find(n => n.name === name);
  if (!place) return undefined;
  const text = numberText(value, place.text);
  editor.replace(place.start, place.end, text);
  if (at("auto").checked) start("run");
  return text;
};

const drawSliders = () => {
  at("sliders").replaceChildren(...sliders.map(slider => {
    const { name } = slider, number = editor.read.numbers.find(n => n.name === name);
    const title = number ? number.path + (/#0$/.test(name) ? "" : ` (${Number(name.split("#")[1]) + 1})`) : `${name}: no such number now`;
    const remove = Object.assign(document.createElement("button"), { type: "button", textContent: "×", title: `no slider for ${name}` });
    remove.addEventListener("click", () => { sliders = sliders.filter(s => s.name !== name); drawSliders(); });
    return sliderRow(title, { ...slider, value: number?.value, text: number?.text ?? "" }, value => moveNumber(name, value), remove);
  }));
};

const addSlider = name => {
  const number = editor.read.numbers.find(n => n.name === name);
  if (!number || sliders.some(s => s.name === name)) return;
  const [low, high] = rangeOf(number.value);
  sliders.push({ name, low, high, whole: /^[+-]?[\d_]+$/.test(number.text) });
};

// The newest text counts; a check that takes long makes room for it. A text that runs is checked when its run is over.
const check = async () => {
  checkWaits = isBusy && editor.text === runningText;
  if (checkWaits) return;
  if (checkBegan && performance.now() - checkBegan > 1000) jobs.stop("check");
  checkBegan = performance.now();
  const mine = ++checked, answer = await jobs.run({ files: files(), commands: [["check", "case.toml"]] }, { group: "check" });
  if (mine !== checked || answer.stopped) return;
  checkBegan = 0;
  editor.show(messagesOf(answer.says, "case.toml"));
};

let checkTimer = 0;
const textChanged = read => {
  clearTimeout(checkTimer);
  checkTimer = setTimeout(check, 120);
  const select = at("numbers"), names = read.numbers.map(n => n.name).join("\n");
  if (select.dataset.names !== names) {
    select.dataset.names = names;
    select.replaceChildren(...read.numbers.map(n => new Option(`${n.path} ${/#0$/.test(n.name) ? "" : `(${Number(n.name.split("#")[1]) + 1}) `}= ${n.text}`, n.name)));
    drawSliders();
  }
  at("both").disabled = jetsOf(editor.text) === 0;
};

const draw = () => {
  const drawn = runs.drawn;
  if (runs.now.length === 0) return;
  const columns = columnsOf(runs.now[0].table), select = at("column");
  if (select.options.length !== columns.length || select.options[0].value !== columns[0]) select.replaceChildren(...columns.map(c => new Option(named(c).filter(Boolean).join(", "), c)));
  const shown = columns.slice(0, 3);
  if (columns.includes(chosenColumn) && !shown.includes(chosenColumn)) shown.push(chosenColumn);
  else if (columns[3]) shown.push(columns[3]);
  at("charts").replaceChildren(...shown.map(column => drawChart(column, drawn)));
  at("peaks").replaceChildren(...runs.peaks());
};

const reportSoon = folders => {
  clearTimeout(reportTimer);
  reportTimer = setTimeout(() => at("reporting").open && runs.showReport(folders ?? runs.folders()), 300);
};

const variants = kind => {
  const count = jetsOf(editor.text), name = fileName();
  if (kind !== "both") return [{ label: name, words: [] }];
  const without = [...editor.text.matchAll(/^\s*\[(\[inflator\]|inflator\.jet)\]/gm)].reduce((all, m) => {
    if (m[1] === "[inflator]") ++all.at;
    else all.words.push("--unset", `inflator.${all.at}.jet`);
    return all;
  }, { at: -1, words: [] }).words;
  return count === 0 ? [{ label: name, words: [] }] : [{ label: `${name}, with jet`, words: [] }, { label: `${name}, without`, words: without }];
};

// What the buttons start. While something runs, the last wish is kept and follows.
const start = async kind => {
  if (isBusy) return void (again = kind);
  isBusy = true;
  runningText = editor.text;
  at("stop").disabled = false;
  const began = performance.now(), show = (part, text) => status(text || "running", part);
  status("running", 0);
  let answer;
  if (kind === "ensemble") answer = await runs.ensemble(files(), 16, show);
  else if (kind === "ladder") answer = await runs.ladder(files(), chosenColumn || at("column").value || "pressure_Pa", show);
  else answer = await runs.run(files(), variants(kind), show);
  isBusy = false;
  at("stop").disabled = true;
  runs.bytes = answer.bytes ?? runs.bytes;
  const seconds = (performance.now() - began) / 1000;
  if (answer.stopped) status("stopped", 0);
  else {
    const faults = messagesOf(answer.says, "case.toml");
    if (answer.failed) editor.show(faults);
    status(answer.failed ? `failed: ${faults.find(m => m.kind === "error")?.text ?? "see the messages"}` : `done in ${seconds.toFixed(2)} s` + (answer.bytes ? `, ${(answer.bytes / 1048576).toFixed(0)} MiB` : ""), answer.failed ? 0 : 1);
    if (kind === "ensemble" || kind === "ladder") { if (answer.files && !answer.failed) reportSoon({ [kind]: answer.files }); } else if (runs.now.length > 0) {
      draw();
      at("results").disabled = false;
      reportSoon();
    }
    document.body.dataset.done = String(Number(document.body.dataset.done ?? 0) + 1);
    document.body.dataset.first ??= String(performance.now());
  }
  const next = again;
  again = null;
  if (next) start(next);
  else if (checkWaits) check();
};

const stop = () => {
  again = null;
  jobs.stop("run");
};

const show = (text, others, chosen) => {
  extra = others;
  sliders = [];
  runs.old = runs.now = [];
  at("files").textContent = Object.keys(others).length ? `Beside it: ${Object.keys(others).join(", ")}.` : "";
  editor.text = text;
  for (const name of chosen ?? firstNumbers(editor.read.numbers)) addSlider(name);
  drawSliders();
};

const choose = name => {
  show(cases[name].text, cases[name].files);
  stop();
  start("run");
};

// Dropped or opened files: a case takes the place of the text, others lie beside it.
const take = async list => {
  const texts = await Promise.all([...list].map(async file => [file.name, file.size <= 2e7 ? await file.text() : null]));
  for (const [name, text] of texts) if (text === null) return status(`${name}: is larger than 20 MB`, 0);
  const others = { ...extra, ...Object.fromEntries(texts.filter(([name]) => !/\.toml$/i.test(name))) }, found = texts.find(([name]) => /\.toml$/i.test(name));
  at("case").value = "";
  if (found) show(found[1], others);
  else {
    extra = others;
    at("files").textContent = `Beside it: ${Object.keys(others).join(", ")}.`;
    check();
  }
};

const share = async () => {
  const link = `${location.href.split("#")[0]}#case=${await toLink({ text: editor.text, files: extra, sliders: sliders.map(s => s.name) })}`;
  history.replaceState(null, "", link);
  try {
    await navigator.clipboard.writeText(link);
    status(`the link is in the address bar and on the clipboard (${link.length} characters)`);
  } catch {
    status(`the link is in the address bar (${link.length} characters)`);
  }
};

const results = () => {
  const all = { "case.toml": new TextEncoder().encode(editor.text) };
  for (const [name, own] of Object.entries(runs.folders())) for (const [file, bytes] of Object.entries(own)) all[`${name}/${file.split("/").slice(1).join("/")}`] = bytes;
  if (runs.page) all["report.html"] = new TextEncoder().encode(runs.page);
  download(`${fileName()}.zip`, zipped(all));
};

const fromFragment = async () => {
  const found = /^#case=([\w-]+)$/.exec(location.hash), named = /^#run=([\w.-]+)$/.exec(location.hash);
  if (named && cases[named[1]]) at("case").value = named[1];
  if (!found) return false;
  try {
    const { text, files: others, sliders: chosen } = await fromLink(found[1]);
    if (typeof text !== "string") throw new Error("no text");
    at("case").value = "";
    show(text, others ?? {}, Array.isArray(chosen) ? chosen : undefined);
    start("run");
    return true;
  } catch {
    status("the link holds no case: it is cut or changed", 0);
    return false;
  }
};

const listen = () => {
  for (const kind of ["run", "both", "ensemble", "ladder"]) at(kind).addEventListener("click", () => start(kind));
  at("stop").addEventListener("click", stop);
  at("share").addEventListener("click", share);
  at("save").addEventListener("click", () => download(`${fileName()}.toml`, editor.text));
  at("results").addEventListener("click", results);
  at("clear").addEventListener("click", () => { runs.old = []; draw(); });
  at("add").addEventListener("click", () => { addSlider(at("numbers").value); drawSliders(); });
  at("case").addEventListener("change", () => choose(at("case").value));
  at("column").addEventListener("change", () => { chosenColumn = at("column").value; draw(); });
  at("open").addEventListener("change", () => take(at("open").files));
  at("reporting").addEventListener("toggle", () => runs.now.length > 0 && reportSoon());
  window.addEventListener("hashchange", fromFragment);
  document.addEventListener("keydown", event => {
    if (event.key === "Enter" && (event.ctrlKey || event.metaKey)) start("run");
    if (event.key === "Escape") stop();
  });
  for (const name of ["dragover", "dragleave", "drop"]) document.addEventListener(name, event => {
    event.preventDefault();
    document.body.classList.toggle("dropping", name === "dragover");
    if (name === "drop") take(event.dataTransfer.files);
  });
};

(async () => {
  const { data, ...program } = await startProgram(Object.fromEntries(["wasm", "worker", "data"].map(name => [name, at(name).textContent])));
  ({ jobs } = program);
  ({ cases, three, units: unitEndings } = data);
  runs = new Runs(jobs);
  editor = new Editor(data.keys, textChanged);
  at("case").append(...Object.keys(cases).map(name => new Option(name, name)), new Option("your own", ""));
  at("case").value = "passenger_pendulum";
  listen();
  document.body.classList.toggle("inside", window !== window.top);
  if (!(await fromFragment())) choose(at("case").value);
})().catch(error => status(`this browser cannot run it: ${error.message}`, 0));
