// SPDX-License-Identifier: Apache-2.0
// Bytes as text and back, compressed; links that hold a case; folders as one file.
"use strict";

const through = async (bytes, stream) => new Uint8Array(await new Response(new Blob([bytes]).stream().pipeThrough(stream)).arrayBuffer());

// What make_page.py packed: gzip, seven bits a character.
const unpacked = text => {
  const bytes = new Uint8Array(Math.floor(text.length * 7 / 8));
  for (let i = 0, bits = 0, count = 0, size = 0; i < text.length; ++i) {
    bits = (bits << 7) | (text.charCodeAt(i) & 127);
    count += 7;
    if (count >= 8) bytes[size++] = bits >> (count -= 8);
  }
  return through(bytes, new DecompressionStream("gzip"));
};
const asText = bytes => new TextDecoder().decode(bytes);

const toLink = async value => {
  const bytes = await through(new TextEncoder().encode(JSON.stringify(value)), new CompressionStream("deflate-raw"));
  let text = "";
  for (const byte of bytes) text += String.fromCharCode(byte);
  return btoa(text).replace(/\+/g, "-").replace(/\//g, "_").replace(/=+$/, "");
};

const fromLink = async text => {
  const bytes = Uint8Array.from(atob(text.replace(/-/g, "+").replace(/_/g, "/")), c => c.charCodeAt(0));
  return JSON.parse(asText(await through(bytes, new DecompressionStream("deflate-raw"))));
};

const crcTable = Uint32Array.from({ length: 256 }, (_, n) => {
  for (let k = 0; k < 8; ++k) n = n & 1 ? 0xedb88320 ^ (n >>> 1) : n >>> 1;
  return n >>> 0;
});
const crc32 = bytes => {
  let sum = 0xffffffff;
  for (const byte of bytes) sum = crcTable[(sum ^ byte) & 255] ^ (sum >>> 8);
  return (sum ^ 0xffffffff) >>> 0;
};

// { name: bytes } as a ZIP file, stored as they are.
const zipped = files => {
  const parts = [], list = [];
  let place = 0, size = 0;
  const numbers = (...pairs) => {
    const bytes = [];
    for (const [value, count] of pairs) for (let k = 0; k < count; ++k) bytes.push((value / 256 ** k) & 255);
    return Uint8Array.from(bytes);
  };
  for (const [name, bytes] of Object.entries(files)) {
    const label = new TextEncoder().encode(name);
    const about = [[20, 2], [0x800, 2], [0, 2], [0, 2], [0x21, 2], [crc32(bytes), 4], [bytes.length, 4], [bytes.length, 4], [label.length, 2], [0, 2]];
    parts.push(numbers([0x04034b50, 4], ...about), label, bytes);
    list.push(numbers([0x02014b50, 4], [20, 2], ...about, [0, 2], [0, 2], [0, 2], [0, 4], [place, 4]), label);
    place += 30 + label.length + bytes.length;
    size += 46 + label.length;
  }
  const count = Object.keys(files).length;
  return new Blob([...parts, ...list, numbers([0x06054b50, 4], [0, 4], [count, 2], [count, 2], [size, 4], [place, 4], [0, 2])], { type: "application/zip" });
};

const download = (name, content) => {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(content instanceof Blob ? content : new Blob([content]));
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 1000);
};
