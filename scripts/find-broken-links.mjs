import { existsSync, readFileSync } from 'node:fs';
import { dirname, join, relative } from 'node:path';
import { anchorOf } from '../packages/site/build/anchor-of.mjs';
import { projectRoot } from './shared-data.mjs';

/** A page without its blocks of code. @param {string} file */
function readProse(file) {
  return readFileSync(file, 'utf8').replace(/^```[\s\S]*?^```/gm, '');
}

/** @param {string} file - a page in Markdown */
function listAnchors(file) {
  return new Set([...readProse(file).matchAll(/^#{1,6} (.+)$/gm)].map(([, heading]) => anchorOf(heading)));
}

/**
 * Relative links of Markdown pages whose file or heading does not exist.
 * @param {readonly string[]} files - absolute
 * @returns {string[]} one line for each, `page: target`
 */
export function findBrokenLinks(files) {
  return files.flatMap((file) => {
    const targets = [...readProse(file).matchAll(/\]\(([^)\s]+)\)/g)].map(([, target]) => target);
    return targets
      .filter((target) => !/^[a-z]+:/.test(target))
      .filter((target) => {
        const [path, anchor] = target.split('#');
        const to = path ? join(dirname(file), path) : file;
        return !existsSync(to) || (anchor !== undefined && !listAnchors(to).has(anchor));
      })
      .map((target) => `${relative(projectRoot, file)}: ${target}`);
  });
}
