// SPDX-License-Identifier: Apache-2.0
// Renders the equations of a folder's HTML pages in place, with KaTeX. An equation that KaTeX does not read is an error.
// usage: node render_equations.js FOLDER
const fs = require("fs");
const path = require("path");
const katex = require("katex");

const equation = /<(span|div) class="arithmatex">\\([([])([^]*?)\\[)\]]<\/\1>/g;
const entities = { "&lt;": "<", "&gt;": ">", "&quot;": '"', "&amp;": "&" };
let failures = 0;
let rendered = 0;

function renderPage(page) {
  const html = fs.readFileSync(page, "utf8");
  const result = html.replace(equation, (match, tag, bracket, escaped) => {
    const source = escaped.replace(/&(lt|gt|quot|amp);/g, (entity) => entities[entity]);
    rendered += 1;
    try {
      return katex.renderToString(source, { displayMode: bracket === "[", throwOnError: true });
    } catch (error) {
      failures += 1;
      console.error(`${page}: ${error.message}`);
      return match;
    }
  });
  if (result !== html) fs.writeFileSync(page, result);
}

function renderFolder(folder) {
  for (const entry of fs.readdirSync(folder, { withFileTypes: true })) {
    const name = path.join(folder, entry.name);
    if (entry.isDirectory()) renderFolder(name);
    else if (entry.name.endsWith(".html")) renderPage(name);
  }
}

renderFolder(process.argv[2]);
if (rendered === 0) console.error("no equation found");
else console.log(`${rendered} equations`);
process.exit(failures > 0 || rendered === 0 ? 1 : 0);
