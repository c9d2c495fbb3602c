// The beginning of the classic script. The code that a page needs at once is in this script, as part 0. All other parts are scripts of
// their own in the folder next to it, and run on demand. A part is a CommonJS module in a function, which its script puts into this list;
// parts of other versions are in the list, too.
const parts = (globalThis.volumeViewParts ??= {});
const modules = {};
const coming = {};

function keyOf(part) {
  return part + '-' + VERSION;
}

/** The address of a part, from the script. */
function fileOf(part) {
  return 'classic/' + keyOf(part) + '.js';
}

function run(part, factory) {
  factory(require, (modules[part] = {}));
}

const needs = PART_NEEDS.split(',');

/** A part and those that it needs, directly or not. */
function listNeeds(part) {
  const all = new Set([Number(part)]);
  for (const one of all) {
    let [needed, gap] = [0, 0];
    for (const letter of needs[one]) {
      gap = 26 * gap + parseInt(letter, 36) - 10;
      if (letter < 'a') continue;
      all.add((needed += gap));
      gap = 0;
    }
  }
  return [...all];
}

/**
 * What a part's code calls with './NUMBER'. It returns the part, and runs it if it has not run yet; or a promise of it, where its script
 * or those that it needs have not been loaded. Only import('./NUMBER') can ask for such a part, and that returns a promise anyway.
 */
function require(name) {
  const part = name.slice(2);
  if (!modules[part]) {
    const missing = listNeeds(part).filter((one) => !parts[keyOf(one)]);
    if (missing.length > 0) return Promise.all(missing.map(bring)).then(() => require(name));
    run(part, parts[keyOf(part)]);
  }
  return modules[part];
}

/** Load the script of a part. If loading fails, the next request tries again. */
function bring(part) {
  // The entry may still be running, where the page already contains elements.
  return (coming[part] ??= Promise.resolve()
    .then(() => modules[0].injectScript(new URL(fileOf(part), modules[0].scriptUrl).href))
    .then(() => {
      // Many servers answer with a page where a file is missing.
      if (!parts[keyOf(part)]) throw new Error('part ' + keyOf(part) + ' is another file');
    })
    .finally(() => {
      delete coming[part];
    }));
}
