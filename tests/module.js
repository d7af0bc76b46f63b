// The page's numbers outside a browser: read and written by the module that was built last.
import { readFile } from "node:fs/promises";
import { connectNumbers } from "../web/numbers.js";
import * as module from "../web/pkg/levalab_wasm.js";

module.initSync({ module: await readFile(new URL("../web/pkg/levalab_wasm_bg.wasm", import.meta.url)) });
connectNumbers(() => module);
