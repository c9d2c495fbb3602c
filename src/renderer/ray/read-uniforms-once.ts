/** Uniforms that can be copied: not samplers, arrays, or matrices that the code indexes. */
const declared = /\buniform (float|vec[234]|mat3) u(\w+);/g;

/**
 * Change a program so that it reads each uniform once, at its start. Software GL checks at each read whether it is within the buffer.
 * That takes about thirty instructions for each number: in a ray's loop it was an eighth of the time. Other compilers make this change
 * by themselves.
 * @param chunks - as they are written, or minified
 * @param main - the chunk with `main()`, which comes last
 */
export function readUniformsOnce(chunks: readonly string[], main: string): string[] {
  const all = [...chunks, main];
  const names = new Set(all.flatMap((chunk) => [...chunk.matchAll(declared)].map(([, , name]) => name)));
  for (const [, name] of all.join('\n').matchAll(/\bu([A-Z]\w*)\[/g)) names.delete(name); // The code indexes this uniform, so it has to stay in memory.
  const hold = (chunk: string): string =>
    chunk
      .replace(/\bu([A-Z]\w*)/g, (read, name: string) => (names.has(name) ? `held${name}` : read))
      .replace(/\buniform (\w+) held(\w+);/g, 'uniform $1 u$2;\n$1 held$2;\n#define HOLDS_$2\n');
  // The options (defines) of the chunks decide which uniforms a program declares.
  const copies = [...names].map((name) => `#ifdef HOLDS_${name}\n  held${name} = u${name};\n#endif\n`).join('');
  return all
    .map(hold)
    .map((text, i) =>
      i === chunks.length ? text.replace(/\bvoid main\(\) ?\{/, (begin) => `${begin}\n${copies}`) : text,
    );
}
