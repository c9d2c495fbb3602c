// Which blocks of HTML in the guide are live examples: those with a volume whose files the site has.
import { missingFiles, sampleFiles } from './sample-files.mjs';

/** Attributes with addresses of files: lists are separated by white space. */
const withFiles = /\b(src|table|poster)="([^"]*)"/g;

/**
 * @typedef {object} Example
 * @property {string} code
 * @property {string[]} files - the names of files in it
 * @property {string} reason - why there is no picture; '' where there is one
 */

/** The element's own files: they lie beside the samples. @param {string} name */
const isElement = (name) => /^dist\/[\w.-]+\.(js|css)$/.test(name);

/**
 * The files that an example names.
 * @param {string} code
 * @returns {string[]} without repetitions
 */
export function filesOf(code) {
  const names = [...code.matchAll(withFiles)].flatMap(([, , value]) => value.split(/\s+/));
  const framed = [...code.matchAll(/embed\.html\?src=\.\.\/([\w.-]+)/g)].map(([, name]) => name);
  return [...new Set([...names.filter((name) => name && !name.includes('embed.html') && !isElement(name)), ...framed])];
}

/**
 * What a block of HTML is; null for one without a tag of the package.
 * @param {string} code
 * @returns {Example | null}
 */
export function exampleOf(code) {
  if (!/<volume-|embed\.html/.test(code)) return null;
  const files = filesOf(code);
  const reasonOf = (/** @type {string} */ name) =>
    name in sampleFiles
      ? ''
      : name in missingFiles
        ? `It needs ${missingFiles[name]}, which the site does not have.`
        : /^https?:/.test(name)
          ? 'It needs data on another server.'
          : `Its file ${name} is not among the samples.`;
  const isWhole = /<volume-(view|slice-view)\b|embed\.html/.test(code) && files.length > 0;
  const reason = isWhole ? (files.map(reasonOf).find(Boolean) ?? '') : 'It is a part of a page.';
  return { code, files, reason };
}
