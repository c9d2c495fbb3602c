// The beginning of the classic script. The code that a page needs at once is in this script, as part 0. All other parts are scripts of
// their own in the folder next to it, and run on demand. A part is a function, which its script puts into this list; parts of other
// versions are in the list, too.
const parts = (globalThis.volumeViewParts ??= {});
const modules = {};
const coming = {};

function keyOf(part) {
  return part + '-' + VERSION;
}

/** Return a part that has been loaded, and run it with its imports if it has not run yet. */
function need(part) {
  if (!modules[part]) parts[keyOf(part)](need, load, (modules[part] = {}));
  return modules[part];
}

/** Return a part that may not have been loaded yet. If loading fails, the next request tries again. */
function load(part) {
  return Promise.all([part].concat(PART_NEEDS[part] || []).map(bring)).then(function () {
    return need(part);
  });
}

function bring(part) {
  if (parts[keyOf(part)]) return null;
  // The entry may still be running, where the page already contains elements.
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
