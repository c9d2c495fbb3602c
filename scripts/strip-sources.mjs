// Removes from source texts what the built files do not need.

/**
 * GLSL without comments, indentation and blanks without meaning: the built files do not need them. Preprocessor lines
 * do not change.
 * @param {string} text
 */
export function stripGlsl(text) {
  const bare = text.replace(/\/\*[\s\S]*?\*\//g, ' ').replace(/\/\/.*$/gm, '');
  const lines = bare
    .split('\n')
    .map((line) => line.trim())
    .filter(Boolean);
  // Without the blank, two signs in a row would become another operator.
  const keepsBlanks = (/** @type {string} */ line) => /[-+]\s+[-+]/.test(line);
  const pack = (/** @type {string} */ line) =>
    keepsBlanks(line) ? line : line.replace(/\s*([-+*/=<>!&|?:;,(){}[\]])\s*/g, '$1');
  const packed = lines.map((line) => (line.startsWith('#') ? `\n${line}\n` : `${pack(line)} `));
  return `${packed
    .join('')
    .replace(/([;{},(]) /g, '$1')
    .replace(/ *\n+/g, '\n')
    .trim()}\n`;
}

/**
 * Style sheets in a script, without comments and without needless blanks.
 * @param {string} code
 */
export function stripCss(code) {
  return code.replace(/css`([^`]*)`/g, (_, /** @type {string} */ text) => {
    const bare = text.replace(/\/\*[\s\S]*?\*\//g, '').replace(/\s+/g, ' ');
    return `css\`${bare
      .replace(/ ?([{};,]) ?/g, '$1')
      .replace(/: /g, ':')
      .replace(/;}/g, '}')
      .trim()}\``;
  });
}

/**
 * A script in ASCII: where a page does not declare its character set, browsers do not read its classic scripts as UTF-8.
 * Then signatures of files and special characters in texts would be wrong.
 * @param {string} code
 */
export function escapeToAscii(code) {
  return code.replace(/[^\0-\x7f]/g, (sign) => `\\u${sign.charCodeAt(0).toString(16).padStart(4, '0')}`);
}
