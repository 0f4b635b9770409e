// SPDX-License-Identifier: Apache-2.0
// Part of gasjet.js (--post-js). Files in memory grow by doubling, from 64 MB on by that: emscripten's own, above 1 MB, grow by an
// eighth, and a tenth of a run went into copies.
MEMFS.expandFileStorage = (node, capacity) => {
  const old = node.contents ? node.contents.length : 0;
  if (old >= capacity) return;
  const contents = new Uint8Array(Math.max(capacity, old + Math.min(Math.max(old, 65536), 1 << 26)));
  if (node.usedBytes > 0) contents.set(node.contents.subarray(0, node.usedBytes));
  node.contents = contents;
};
