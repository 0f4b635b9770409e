// SPDX-License-Identifier: Apache-2.0
// A worker's script, after gasjet.js. A job is { id, files: { name: text or bytes }, commands: [[argument, ...], ...], take: [name] }:
// it writes the files into an empty folder, runs the commands until one fails, and answers { id, code, out, says, files, bytes }.
// A folder in `take` stands for all its files. Meanwhile it tells { id, progress }.
"use strict";
const folder = "/job";
let compiled = null, program = null, now = null;

const start = () => Gasjet({
  instantiateWasm(imports, done) {
    const instance = new WebAssembly.Instance(compiled, imports);
    done(instance, compiled);
    return instance.exports;
  },
  print: line => now.out.push(line),
  printErr: line => now.says.push(line),
  progress: text => postMessage({ id: now.id, progress: text }),
});

const remove = (FS, name) => {
  if (!FS.isDir(FS.lstat(name).mode)) return FS.unlink(name);
  for (const entry of FS.readdir(name)) if (entry !== "." && entry !== "..") remove(FS, name + "/" + entry);
  FS.rmdir(name);
};

const writeAll = (FS, files) => {
  for (const [name, content] of Object.entries(files)) {
    FS.mkdirTree(folder + "/" + name.split("/").slice(0, -1).join("/"));
    FS.writeFile(folder + "/" + name, content);
  }
};

const readAll = (FS, name, found) => {
  const place = folder + "/" + name;
  if (!FS.analyzePath(place).exists) return;
  if (!FS.isDir(FS.stat(place).mode)) found[name] = FS.readFile(place);
  else for (const entry of FS.readdir(place)) if (entry !== "." && entry !== "..") readAll(FS, name + "/" + entry, found);
};

const work = async job => {
  program ??= await start();
  const { FS } = program;
  const files = {};
  let code = 0;
  FS.chdir("/");
  if (FS.analyzePath(folder).exists) remove(FS, folder);
  FS.mkdirTree(folder);
  writeAll(FS, job.files);
  FS.chdir(folder);
  for (const command of job.commands) {
    code = program.callMain(command);
    if (code !== 0) break;
  }
  for (const name of job.take ?? []) readAll(FS, name, files);
  return { code, files, bytes: program.HEAP8.length };
};

onmessage = async ({ data }) => {
  if (data.compiled) {
    compiled = data.compiled;
    program = await start();
    postMessage({ ready: true });
    return;
  }
  now = { id: data.id, out: [], says: [] };
  let answer;
  try {
    answer = await work(data);
  } catch (error) { // a trap, or memory is at its end: the next job gets a program of its own
    program = null;
    answer = { code: 3, files: {}, bytes: 0 };
    now.says.push(`the program has stopped: ${error.message ?? error}`);
  }
  postMessage({ ...now, ...answer }, Object.values(answer.files).map(bytes => bytes.buffer));
};
