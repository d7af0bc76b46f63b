import assert from "node:assert/strict";
import { test } from "node:test";
import { DRAWINGS as SMALL } from "./follower-drawings.js";
import { DRAWINGS as DIMENSIONED } from "./follower-dimensions.js";
import { CATALOGUE } from "./pkg/catalogue.js";

test("every follower of the catalogue has a small drawing and one with its dimensions", () => {
  const ids = CATALOGUE.followers.map(({ id }) => id).sort();
  assert.deepEqual(Object.keys(SMALL).sort(), ids);
  assert.deepEqual(Object.keys(DIMENSIONED).sort(), ids);
});
