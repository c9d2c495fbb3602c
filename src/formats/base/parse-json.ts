/**
 * Parses JSON, also as Python writes it: its numbers that are none (NaN, Infinity, -Infinity) are texts here.
 * @throws {SyntaxError}
 */
export function parseJson(text: string): unknown {
  try {
    return JSON.parse(text);
  } catch {
    // Within a text that looks so, too: nobody reads such a one.
    return JSON.parse(text.replace(/([:,[]\s*)(NaN|-?Infinity)(?=\s*[,\]}])/g, '$1"$2"'));
  }
}
