// Short names for the parameters and variables of GLSL functions, in the built files.

/** A declaration inside a function: its name is followed by a value, by the next parameter, or by the end of the declaration. */
const declaration = /\b(?:float|int|bool|[bi]?vec[234]|mat[234]|[A-Z]\w*[a-z]\w*) (\w+)(?=[=;,)[])/g;

/**
 * The beginning of a function. `main` keeps its names, as the texts that a program defines (`NEEDS_RAYS`) contain some of them.
 */
const beginning = /\b(?:void|float|int|bool|[bi]?vec[234]|mat[234]|[A-Z]\w*) (?!main\b)\w+\([^()]*\)\{/g;

const shortNames = 'abcdefghijklmnopqrstuvwxyz'
  .split('')
  .flatMap((letter, _, all) => [letter, ...all.map((next) => letter + next)]);
/** Words of the language are no names. */
const words = new Set(['do', 'if', 'in']);

shortNames.sort((a, b) => a.length - b.length);

/**
 * GLSL with short names inside of its functions. What other texts see keeps its name: functions, uniforms, structs and their members.
 * @param {string} text - of stripGlsl
 */
export function shortenGlsl(text) {
  let shortened = '';
  let done = 0;
  for (const { 0: begin, index } of text.matchAll(beginning)) {
    const end = findEnd(text, index + begin.length);
    shortened += text.slice(done, index) + shortenFunction(text.slice(index, end));
    done = end;
  }
  return shortened + text.slice(done);
}

/** The index after the bracket that closes a block. @param {string} text @param {number} start - after the bracket that opens it */
function findEnd(text, start) {
  let end = start;
  for (let open = 1; open > 0; end++) open += { '{': 1, '}': -1 }[text[end]] ?? 0;
  return end;
}

/** @param {string} text - a function */
function shortenFunction(text) {
  const used = new Set(text.match(/\b[a-z_]\w*/gi));
  const declared = new Set(Array.from(text.matchAll(declaration), ([, name]) => name));
  const free = shortNames.filter((name) => !used.has(name) && !words.has(name));
  /** @type {Map<string, string>} */
  const names = new Map();
  for (const name of declared) {
    // A function may have the same name, and a line of the preprocessor may mean something else.
    const keeps = name.length === 1 || new RegExp(String.raw`\b${name}\(|^#.*\b${name}\b`, 'm').test(text);
    if (!keeps) names.set(name, free[names.size]);
  }
  return text.replace(/\.?\b[a-z_]\w*/gi, (name) => names.get(name) ?? name);
}
