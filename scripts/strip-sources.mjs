// Texts as the built files have them: without what is for readers of the source.

/**
 * GLSL without comments, indentation and blanks that mean nothing: these are for readers of the source. Lines of the
 * preprocessor stay as they are.
 * @param {string} text
 */
export function stripGlsl(text) {
  const bare = text.replace(/\/\*[\s\S]*?\*\//g, ' ').replace(/\/\/.*$/gm, '');
  const lines = bare.split('\n').map((line) => line.trim()).filter(Boolean);
  // Two signs in a row would become another operator.
  const keepsBlanks = (/** @type {string} */ line) => /[-+]\s+[-+]/.test(line);
  const pack = (/** @type {string} */ line) => (keepsBlanks(line) ? line : line.replace(/\s*([-+*/=<>!&|?:;,(){}[\]])\s*/g, '$1'));
  const packed = lines.map((line) => (line.startsWith('#') ? `\n${line}\n` : `${pack(line)} `));
  return `${packed.join('').replace(/([;{},(]) /g, '$1').replace(/ *\n+/g, '\n').trim()}\n`;
}

/**
 * Style sheets in a script without what is for readers of the source.
 * @param {string} code
 */
export function stripCss(code) {
  return code.replace(/css`([^`]*)`/g, (_, /** @type {string} */ text) => {
    const bare = text.replace(/\/\*[\s\S]*?\*\//g, '').replace(/\s+/g, ' ');
    return `css\`${bare.replace(/ ?([{};,]) ?/g, '$1').replace(/: /g, ':').replace(/;}/g, '}').trim()}\``;
  });
}

/**
 * A script in ASCII: a page that does not say its character set has its classic scripts read in another one than UTF-8,
 * and then no signature of a file and no sign of a text would be right.
 * @param {string} code
 */
export function escapeToAscii(code) {
  return code.replace(/[^\0-\x7f]/g, (sign) => `\\u${sign.charCodeAt(0).toString(16).padStart(4, '0')}`);
}
