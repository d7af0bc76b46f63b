// `cargo xtask serve` gives the page, working, and nothing else of the checkout.
import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import { once } from "node:events";
import { connect } from "node:net";
import { createInterface } from "node:readline";
import { after, before, test } from "node:test";
import { root } from "../browser/browser.js";
import { openPage } from "../browser/harness.js";

const xtask = process.env.LEVALAB_XTASK;
assert(xtask, "LEVALAB_XTASK names the built xtask: run `cargo xtask test serve`");
const server = spawn(xtask, ["serve", "--release", "--no-open", "--port", "0"], { cwd: root, stdio: ["ignore", "pipe", "inherit"] });
let url = "";

before(async () => {
  for await (const line of createInterface({ input: server.stdout })) {
    const address = /http:\S+/.exec(line);
    if (address) {
      url = address[0];
      return;
    }
  }
  assert.fail("the server ended before it said where it listens");
});

after(async () => {
  server.kill();
  await once(server, "exit");
});

for (const [file, type] of [
  ["", "text/html"],
  ["web/main.js", "text/javascript"],
  ["web/styles/tokens.css", "text/css"],
  ["web/pkg/levalab_wasm_bg.wasm", "application/wasm"],
]) {
  test(`/${file} is ${type}, always fresh`, async () => {
    const response = await fetch(url + file);
    assert.equal(response.status, 200);
    assert(response.headers.get("content-type")?.startsWith(type));
    assert.equal(response.headers.get("cache-control"), "no-cache");
  });
}

for (const target of ["/Cargo.toml", "/.git/config", "/web/../Cargo.toml", "/web/%2e%2e/Cargo.toml", "//etc/passwd", "/web/pkg/.levalab-wasm.stamp"]) {
  test(`${target} is not served`, async () => {
    assert.match(await statusLine(target), / 404 /);
  });
}

test("the page as it lies in the checkout draws without complaint", async (t) => {
  await openPage(t, { url });
});

/** Asks for a path exactly as written; `fetch` would tidy it first. @param {string} target */
async function statusLine(target) {
  const { port } = new URL(url);
  const socket = connect(Number(port), "127.0.0.1");
  socket.end(`GET ${target} HTTP/1.1\r\nHost: 127.0.0.1\r\nConnection: close\r\n\r\n`);
  let answer = "";
  for await (const chunk of socket) answer += chunk;
  return answer.split("\r\n")[0];
}
