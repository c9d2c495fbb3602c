// Begins the classic script: what a page needs at once is in it, part 0, and all else lies beside it, in scripts of their own that are
// run when they are needed. A part is a function, which its script puts into this list; those of other versions are in it, too.
const parts = (globalThis.volumeViewParts ??= {});
const modules = {};
const coming = {};

function keyOf(part) {
  return part + '-' + VERSION;
}

/** A part that is there, and what it needs. */
function need(part) {
  if (!modules[part]) parts[keyOf(part)](need, load, (modules[part] = {}));
  return modules[part];
}

/** A part that may not be there yet. What could not be loaded is tried again when it is asked for again. */
function load(part) {
  return Promise.all([part].concat(PART_NEEDS[part] || []).map(bring)).then(function () {
    return need(part);
  });
}

function bring(part) {
  if (parts[keyOf(part)]) return null;
  // The entry may still be running, where elements stand in the page already.
  return (coming[part] ??= Promise.resolve()
    .then(function () {
      const entry = need(0);
      return entry.injectScript(new URL('classic/' + keyOf(part) + '.js', entry.scriptUrl).href);
    })
    .then(function () {
      // Many servers answer with a page where a file is missing.
      if (!parts[keyOf(part)]) throw new Error('part ' + keyOf(part) + ' is another file');
    })
    .finally(function () {
      delete coming[part];
    }));
}
