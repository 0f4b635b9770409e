// SPDX-License-Identifier: Apache-2.0
// Part of gasjet.js (--post-js). The program's standard error is a terminal: its progress bar begins with a carriage return and ends
// with ESC [ K, and goes to the function `progress` of who made the program.
TTY.default_tty1_ops.put_char = function (tty, code) {
  if (code === 13) return;
  if (code !== 10) tty.output.push(code);
  const text = () => {
    const line = UTF8ArrayToString(tty.output, 0, tty.output.length);
    tty.output = [];
    return line;
  };
  if (code === 75 && tty.output.slice(-3).join() === "27,91,75") {
    const bar = text().slice(0, -3);
    if (Module["progress"]) Module["progress"](bar);
  } else if (code === 10) err(text());
};
