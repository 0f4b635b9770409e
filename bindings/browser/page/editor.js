// SPDX-License-Identifier: Apache-2.0
// The text of a case with numbers of lines, help for the key under the mouse or the cursor, and the program's messages at their lines.
"use strict";

class Editor {
  constructor(reference, onchange) {
    this.reference = reference; // "table.key" -> [meaning, unit, allowed, default]
    this.onchange = onchange;
    this.area = document.getElementById("text");
    this.errors = [];
    this.area.addEventListener("input", () => this.changed());
    this.area.addEventListener("scroll", () => this.place());
    this.area.addEventListener("mousemove", event => this.help(this.lineAt(event.offsetY)));
    for (const name of ["keyup", "click", "focus"]) this.area.addEventListener(name, () => this.help(this.lineOfCursor()));
    new ResizeObserver(() => this.place()).observe(this.area);
  }

  get text() { return this.area.value; }

  set text(text) {
    this.area.value = text;
    this.changed();
  }

  // The same text but for one place; cursor and history of the field stay.
  replace(start, end, text) {
    this.area.setRangeText(text, start, end);
    this.changed();
  }

  changed() {
    this.read = readCase(this.text);
    this.place();
    this.onchange(this.read);
  }

  lineAt(y) { return Math.floor((y + this.area.scrollTop - 4) / 19); }
  lineOfCursor() { return this.text.slice(0, this.area.selectionStart).split("\n").length - 1; }

  help(line) {
    const { table = "", key = "" } = this.read.lines[line] ?? {};
    const parts = key.split("."), names = [`${table}.${key}`, ...parts.map((_, i) => `${table}.${parts.slice(i).join(".")}`), `${table}.${parts[0]}`, table && !key ? `${table}.${table.split(".").pop()}` : ""];
    const found = names.map(name => this.reference[name]).find(Boolean), place = document.getElementById("help");
    if (!found) return void (place.textContent = "\u00a0");
    const [meaning, unit, allowed, byDefault] = found;
    place.textContent = `${key || table}: ${meaning}${unit ? ` [${unit}]` : ""}. Allowed: ${allowed || "any"}. Default: ${byDefault || "none"}.`;
  }

  // messages: { line (from 1, or 0), text, kind: error or warning }
  show(messages) {
    this.errors = messages.filter(m => m.kind === "error" && m.line > 0).map(m => m.line);
    document.getElementById("messages").replaceChildren(...messages.map(m => {
      const button = document.createElement("button");
      button.type = "button";
      button.className = m.kind;
      button.textContent = (m.line > 0 ? `line ${m.line}: ` : "") + m.text;
      button.addEventListener("click", () => this.go(m.line));
      return button;
    }));
    this.place();
  }

  go(line) {
    if (line < 1) return;
    const start = this.text.split("\n").slice(0, line - 1).join("\n").length + (line > 1);
    this.area.focus();
    this.area.setSelectionRange(start, start + (this.read ? this.text.split("\n")[line - 1].length : 0));
    this.area.scrollTop = Math.max(0, (line - 8) * 19);
  }

  place() {
    const gutter = document.getElementById("gutter"), count = this.text.split("\n").length, mark = document.getElementById("mark");
    const state = `${count} ${this.errors}`;
    if (state !== this.state) {
      this.state = state;
      gutter.replaceChildren(...Array.from({ length: count }, (_, i) => {
        const number = document.createElement(this.errors.includes(i + 1) ? "b" : "span");
        number.textContent = `${i + 1}\n`;
        return number;
      }));
    }
    gutter.scrollTop = this.area.scrollTop;
    mark.hidden = this.errors.length === 0;
    if (!mark.hidden) mark.style.top = `${4 + (this.errors[0] - 1) * 19 - this.area.scrollTop}px`;
  }
}

// What the program says of a case, `gasjet: case.toml:3:1: key: what` or `warning: key: what`, as messages of the editor.
const messagesOf = (says, file) => says.filter(Boolean).map(line => {
  const found = /^(?:gasjet: )?([^:\s]+):(\d+):\d+: (.*)$/.exec(line), warning = /^warning: (.*)$/.exec(line);
  if (warning) return { line: 0, text: warning[1], kind: "warning" };
  if (found) return { line: found[1] === file ? Number(found[2]) : 0, text: (found[1] === file ? "" : `${found[1]}, line ${found[2]}: `) + found[3], kind: "error" };
  return { line: 0, text: line.replace(/^gasjet: /, ""), kind: "error" };
});
