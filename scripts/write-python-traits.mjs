// The attributes of <volume-view> as traits of the widget for notebooks, from the custom-elements manifest: `npm run docs` writes them.
import { readElements } from './write-tag-data.mjs';

/** Where the file is in the project. */
export const traitsFile = 'packages/jupyter/src/volume_view/attributes.py';

/** @param {string} text */
const oneLine = (text) => text.replace(/\s+/g, ' ').trim();

/** The text of the file. */
export function writeTraits() {
  const view = readElements().find(({ tagName }) => tagName === 'volume-view');
  const lines = view?.attributes.map((/** @type {Record<string, any>} */ { name, type, description = '' }) => {
    const kind = type?.text === 'boolean' ? 'Flag' : 'Words';
    return `    ${name.replaceAll('-', '_')} = ${kind}(${JSON.stringify(name)}, ${JSON.stringify(oneLine(description))})`;
  });
  return `"""The attributes of <volume-view>. Written by \`npm run docs\`; edit the element, not this file."""

import traitlets

from .trait import Flag, Words


class Attributes(traitlets.HasTraits):
    """A trait for each attribute."""

${lines.join('\n')}
`;
}
