// SPDX-License-Identifier: Apache-2.0
// Jobs of the program in workers (worker.js): one for each core of the machine, and one more for what is short. `compiled` is a promise:
// a worker starts while the program is compiled, once for all of them.
"use strict";

class Jobs {
  constructor(script, compiled, cores) {
    this.url = URL.createObjectURL(new Blob([script], { type: "text/javascript" }));
    this.compiled = compiled;
    this.cores = cores;
    this.idle = [];
    this.busy = new Map(); // worker -> its job
    this.waiting = [];
    this.last = 0;
  }

  // A promise of a job's answer; { stopped: true } if it was stopped. `group` names those that are stopped together.
  run(job, { group = "", progress = () => {} } = {}) {
    return new Promise(done => {
      this.waiting.push({ job: { ...job, id: ++this.last }, group, progress, done });
      this.next();
    });
  }

  stop(group) {
    for (const [worker, task] of [...this.busy]) {
      if (task.group !== group) continue;
      worker.terminate();
      this.busy.delete(worker);
      task.done({ stopped: true });
    }
    for (const task of this.waiting.filter(t => t.group === group)) task.done({ stopped: true });
    this.waiting = this.waiting.filter(t => t.group !== group);
    this.next();
  }

  next() {
    while (this.waiting.length > 0 && this.busy.size <= this.cores) {
      const worker = this.idle.pop() ?? this.hire(), task = this.waiting.shift();
      this.busy.set(worker, task);
      this.compiled.then(() => worker.postMessage(task.job));
    }
  }

  hire() {
    const worker = new Worker(this.url);
    this.compiled.then(compiled => worker.postMessage({ compiled }));
    worker.onmessage = ({ data }) => this.hear(worker, data);
    worker.onerror = event => this.hear(worker, { id: this.busy.get(worker)?.job.id, code: 3, out: [], says: [event.message], files: {}, bytes: 0 });
    return worker;
  }

  hear(worker, data) {
    const task = this.busy.get(worker);
    if (!task || data.id !== task.job.id) return;
    if (data.progress !== undefined) return task.progress(data.progress);
    this.busy.delete(worker);
    this.idle.push(worker);
    task.done(data);
    this.next();
  }
}

// What make_page.py packed, { wasm, worker, data }, as { jobs, data }.
const startProgram = async ({ wasm, worker, data }) => {
  const compiled = unpacked(wasm).then(bytes => WebAssembly.compile(bytes)), jobs = new Jobs(await unpacked(worker), compiled, Math.min(navigator.hardwareConcurrency || 2, 8));
  jobs.idle.push(jobs.hire());
  const [read] = await Promise.all([unpacked(data).then(bytes => JSON.parse(asText(bytes))), compiled]);
  return { jobs, data: read };
};
