// SPDX-License-Identifier: Apache-2.0
// What a case's text says where: its tables, keys and numbers. The program alone judges it; this is for sliders and help.
"use strict";

// The line with blanks in place of texts and comments.
const masked = line => {
  let quote = "", result = "";
  for (let i = 0; i < line.length; ++i) {
    const c = line[i];
    if (!quote && c === "#") return result.padEnd(line.length);
    if (quote) {
      result += " ";
      if (c === "\\" && quote === '"') { result += " "; ++i; } else if (c === quote) quote = "";
    } else {
      if (c === '"' || c === "'") quote = c;
      result += quote ? " " : c;
    }
  }
  return result;
};

// For each line { table, key }: the table without numbers of entries and the key, as docs/case_files.md names them; and all numbers:
// { path, name, line, start, end, text, value }, start and end in the whole text; name is unique.
const readCase = text => {
  const lines = [], numbers = [], counts = new Map();
  let table = "", path = "", key = "", depth = 0, at = 0;
  text.split("\n").forEach((line, number) => {
    const plain = masked(line), head = /^\s*\[(\[?)([^\][]+)\]/.exec(plain), pair = /^\s*([\w.-]+)\s*=/.exec(plain);
    if (depth === 0 && head) {
      table = head[2].trim();
      const parts = table.split(".");
      path = parts.map((part, i) => {
        const name = parts.slice(0, i + 1).join("."), last = i === parts.length - 1;
        if (last && head[1]) counts.set(name, (counts.get(name) ?? -1) + 1);
        if (last && head[1]) for (const other of counts.keys()) if (other.startsWith(name + ".")) counts.delete(other);
        return counts.has(name) ? `${part}.${counts.get(name)}` : part;
      }).join(".");
      key = "";
    } else if (depth === 0 && pair) key = pair[1];
    if (depth === 0 && !head && !pair) key = "";
    const begin = depth === 0 && pair ? pair[0].length : 0;
    if (key) for (const found of plain.slice(begin).matchAll(/(?<![\w.])[+-]?\d[\d_]*(?:\.\d+)?(?:[eE][+-]?\d+)?(?![\w.:])/g)) {
      const inner = /([\w-]+)\s*=\s*[^=]*$/.exec(plain.slice(begin, begin + found.index))?.[1];
      const whole = [path, key, inner].filter(Boolean).join(".");
      const count = numbers.filter(n => n.path === whole).length;
      const start = at + begin + found.index;
      numbers.push({ path: whole, name: `${whole}#${count}`, line: number, start, end: start + found[0].length, text: found[0], value: Number(found[0].replace(/_/g, "")) });
    }
    lines.push({ table, key });
    for (const c of head && depth === 0 ? "" : plain.slice(begin)) depth += c === "[" || c === "{" ? 1 : c === "]" || c === "}" ? -1 : 0;
    depth = Math.max(0, depth);
    at += line.length + 1;
  });
  return { lines, numbers };
};

// The number as text that the place had before: whole where it was whole, with a point where it had one.
const numberText = (value, like) => {
  if (/^[+-]?[\d_]+$/.test(like)) return String(Math.round(value));
  const text = String(Number(value.toPrecision(4)));
  return /[.e]/.test(text) ? text : text + ".0";
};

// Numbers that a reader may want to move first: what flows in and how hot, what is inside, where it leaves, what it meets.
const firstNumbers = numbers => {
  const wanted = [/^inflator\.0\.mass_flow(\.value)?$/, /^inflator\.0\.temperature$/, /^gas\.initial\.(pressure|temperature)$/, /^tank\.volume(\.value)?$/,
    /^vent\.0\.area/, /^fabric\.porosity$/, /^inflator\.0\.jet\.(long_side|radius|area)$/, /^pendulum\.(mass|initial_.*)$/, /^impactor\./, /^membrane\./];
  const chosen = [];
  for (const pattern of wanted) {
    const fit = numbers.filter(n => pattern.test(n.path) && n.value !== 0);
    if (fit.length > 0) chosen.push(fit.reduce((a, b) => (Math.abs(b.value) > Math.abs(a.value) ? b : a)).name);
  }
  return chosen.slice(0, 3);
};
