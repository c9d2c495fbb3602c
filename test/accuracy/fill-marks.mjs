import { readFileSync, writeFileSync } from 'node:fs';

/**
 * Replace what stands between `<!-- name -->` and `<!-- /name -->` in a Markdown file.
 * @param {string} file
 * @param {Record<string, string>} texts
 * @throws where the file lacks a mark
 */
export function fillMarks(file, texts) {
  let content = readFileSync(file, 'utf8');
  for (const [name, text] of Object.entries(texts)) {
    const [begin, end] = [`<!-- ${name} -->`, `<!-- /${name} -->`];
    const [from, to] = [content.indexOf(begin), content.indexOf(end)];
    if (from < 0 || to < from) throw new Error(`${file} has no marks for "${name}"; expected ${begin} … ${end}`);
    content = `${content.slice(0, from + begin.length)}\n${text}\n${content.slice(to)}`;
  }
  writeFileSync(file, content);
}
