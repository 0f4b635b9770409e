#!/usr/bin/env node
// SPDX-License-Identifier: Apache-2.0
// The command gasjet as WebAssembly, on node: it sees this machine's files.
"use strict";
const fs = require("fs");
const path = require("path");
const Gasjet = require(path.join(__dirname, "gasjet.js"));

const write = (descriptor, line) => {
  try {
    fs.writeSync(descriptor, line + "\n");
  } catch (error) {
    if (error.code !== "EPIPE") throw error;
  }
};

Gasjet({
  wasmBinary: fs.readFileSync(path.join(__dirname, "gasjet.wasm")),
  print: line => write(1, line),
  printErr: line => write(2, line),
}).then(program => {
  const { FS, NODEFS } = program;
  for (const name of fs.readdirSync("/")) {
    if (["dev", "proc", "sys"].includes(name) || !fs.statSync("/" + name, { throwIfNoEntry: false })?.isDirectory()) continue;
    if (!FS.analyzePath("/" + name).exists) FS.mkdir("/" + name);
    FS.mount(NODEFS, { root: "/" + name }, "/" + name);
  }
  FS.chdir(process.cwd());
  process.exitCode = program.callMain(process.argv.slice(2));
});
