// Begins the classic script: what a page needs at once is in it, and all else lies beside it, in scripts of their own that are run
// when they are needed. A part is a function that is given to this list by its script.
const parts = (globalThis.volumeViewParts ??= {});
const modules = {};
const coming = {};

/** A part that is there, and what it needs. */
function need(name) {
  if (!modules[name]) parts[name](need, load, (modules[name] = {}));
  return modules[name];
}

/** A part that may not be there yet. What could not be loaded is tried again when it is asked for again. */
function load(name) {
  return Promise.all([name].concat(PART_NEEDS[name] || []).map(bring)).then(function () {
    return need(name);
  });
}

function bring(name) {
  if (parts[name]) return null;
  // The entry may still be running, where elements stand in the page already.
  return (coming[name] ??= Promise.resolve()
    .then(function () {
      const entry = need('./entry.js');
      return entry.injectScript(new URL('classic/' + name.slice(2), entry.scriptUrl).href);
    })
    .finally(function () {
      delete coming[name];
    }));
}
