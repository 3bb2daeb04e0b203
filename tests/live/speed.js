// node speed.js ENGINE.JS LIVE: the engine without a browser. Asks every figure as it begins and with each control moved by one
// step, compares what it says with the program LIVE, and prints how long the engine took, the median of five.
"use strict";
const { execFileSync } = require("child_process"), fs = require("fs"), zlib = require("zlib");

const [file, live] = process.argv.slice(2);
globalThis.self = globalThis;
(0, eval)(fs.readFileSync(file, "utf8"));
const unpack = text => zlib.gunzipSync(Buffer.from(text, "base64"));
const { glue, wasm } = globalThis.signoriniEngine;
const make = new Function("require", "process", "__dirname", "__filename", unpack(glue).toString() + "\nreturn Signorini;");

(async () => {
  const begin = performance.now(), engine = await make(require, process, __dirname, __filename)({ wasmBinary: unpack(wasm) });
  const there = performance.now() - begin, packed = [glue, wasm].map(text => Buffer.from(text, "base64").length), brotli = [glue, wasm].map(t => zlib.brotliCompressSync(unpack(t)).length);
  const most = 1e6;    // bytes of the engine that a web server sends, packed by brotli
  const sum = sizes => `${(sizes.reduce((a, b) => a + b) / 1e6).toFixed(3)} MB`;
  console.log(`engine: ${sum([fs.statSync(file).size])} as a script, ${sum(packed)} by gzip, ${sum(brotli)} by brotli, there after ${there.toFixed(0)} ms`);
  const ask = words => JSON.parse(engine.ccall("live_answer", "string", ["string"], [words]));
  const native = lines => execFileSync(live, { input: lines.join("\n") + "\n", maxBuffer: 1 << 28 }).toString().trim().split("\n").map(l => JSON.parse(l));
  const names = /there are: (.*)/i.exec(ask("no_such_figure").error)[1].split(", ");
  let bad = 0;
  if (brotli[0] + brotli[1] > most) { ++bad; console.log(`the engine has more than ${most} bytes by brotli`); }
  for (const name of names) {
    const requests = [name];
    for (const c of ask(`figure ${name}`).controls)
      requests.push(`${name} ${c.name}=${c.choices ? c.choices[(c.value + 1) % c.choices.length] : +(c.value + (c.value + c.step <= c.most ? c.step : -c.step)).toPrecision(10)}`);
    const wanted = native(requests), times = [];
    for (let run = 0; run < 5; ++run)
      requests.forEach((words, k) => {
        const start = performance.now(), got = ask(words);
        times.push(performance.now() - start);
        const same = got.error === wanted[k].error && JSON.stringify(got.sets) === JSON.stringify(wanted[k].sets);
        if (!same && run === 0) { ++bad; console.log(`${words}: sets differ from those of ${live}`); }
      });
    times.sort((a, b) => a - b);
    console.log(`${name.padEnd(16)} median ${times[times.length >> 1].toFixed(1)} ms, at most ${times[times.length - 1].toFixed(1)} ms`);
  }
  process.exit(bad ? 1 : 0);
})();
