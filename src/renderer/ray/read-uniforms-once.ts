/** Uniforms of which a copy can be held: not samplers, arrays, or matrices of which columns are chosen. */
const declared = /\buniform (float|vec[234]|mat3) u(\w+);/g;

/**
 * Let a program read each uniform once, before anything else. Software GL checks wherever one is read whether that is within its buffer,
 * which takes some thirty instructions for each number: in a ray's loop that was an eighth of the time. Other compilers do the same of themselves.
 * @param chunks - as they are written, or with as few lines as can be
 * @param main - the chunk with `main()`, which comes last
 */
export function readUniformsOnce(chunks: readonly string[], main: string): string[] {
  const all = [...chunks, main];
  const names = new Set(all.flatMap((chunk) => [...chunk.matchAll(declared)].map(([, , name]) => name)));
  for (const [, name] of all.join('\n').matchAll(/\bu([A-Z]\w*)\[/g)) names.delete(name); // A number of it is chosen: that is done in memory.
  const hold = (chunk: string): string => chunk
    .replace(/\bu([A-Z]\w*)/g, (read, name: string) => (names.has(name) ? `held${name}` : read))
    .replace(/\buniform (\w+) held(\w+);/g, 'uniform $1 u$2;\n$1 held$2;\n#define HOLDS_$2\n');
  // Which of them are there depends on the options of their chunks.
  const copies = [...names].map((name) => `#ifdef HOLDS_${name}\n  held${name} = u${name};\n#endif\n`).join('');
  return all.map(hold).map((text, i) => (i === chunks.length ? text.replace(/\bvoid main\(\) ?\{/, (begin) => `${begin}\n${copies}`) : text));
}
