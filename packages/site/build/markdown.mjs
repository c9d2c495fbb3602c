// Pages in Markdown as HTML: headings with the anchors of GitHub, links to pages, and live examples.
import MarkdownIt from 'markdown-it';
import { anchorOf } from './anchor-of.mjs';
import { exampleOf } from './examples.mjs';

export const { escapeHtml } = new MarkdownIt().utils;

/** @param {import('./examples.mjs').Example} example @param {string} label @returns {string} */
function writeExample({ code, files, reason }, label) {
  const block = `<pre tabindex="0" role="textbox" aria-multiline="true" aria-label="${label}" spellcheck="false"><code>${escapeHtml(code)}</code></pre>`;
  if (reason)
    return `<figure class="plain"><pre tabindex="0"><code>${escapeHtml(code)}</code></pre><figcaption>${escapeHtml(reason)}</figcaption></figure>\n`;
  // Elements that stand under the picture.
  const isTall =
    /<volume-(slice-view|timeline|legend|transfer-function|label-list|readout|tour|workspace|measure|series)\b/.test(
      code,
    );
  return `<figure class="example${isTall ? ' tall' : ''}" data-files="${escapeHtml(files.join(' '))}"><div class="code">${block}<div class="buttons"></div></div><div class="picture"></div></figure>\n`;
}

/**
 * @typedef {object} Rendered
 * @property {string} title - of its first heading
 * @property {string} html
 * @property {{ anchor: string, heading: string, text: string }[]} sections - for the search; the first one is the beginning of the page
 * @property {import('./examples.mjs').Example[]} examples
 */

/**
 * Renders a page.
 * @param {string} text - in Markdown
 * @param {(target: string) => string | null} resolve - where a link leads in the site; null for what is not in it: then only its text is there
 * @param {(target: string) => { width: number, height: number } | null} [sizeOf] - of a picture: then its room is free before it comes
 * @returns {Rendered}
 */
export function renderPage(text, resolve, sizeOf = () => null) {
  const markdown = new MarkdownIt({ html: false, linkify: false });
  /** @type {Rendered['examples']} */
  const examples = [];
  /** @type {Rendered['sections']} */
  const sections = [];
  markdown.renderer.rules.fence = (tokens, index) => {
    const { info, content } = tokens[index];
    const example = info.trim() === 'html' ? exampleOf(content) : null;
    if (!example) return `<pre tabindex="0"><code>${escapeHtml(content)}</code></pre>\n`;
    examples.push(example);
    return writeExample(example, `Example ${examples.length}, HTML that you can change`);
  };
  markdown.renderer.rules.table_open = () => '<div class="table" tabindex="0"><table>\n';
  markdown.renderer.rules.table_close = () => '</table></div>\n';
  const tokens = markdown.parse(text, {});
  tokens.forEach((token, i) => {
    const inside = tokens[i + 1];
    if (token.type === 'heading_open') {
      const heading = (inside.children ?? []).map(({ content }) => content).join('');
      token.attrSet('id', anchorOf(heading));
      if (token.tag !== 'h4') sections.push({ anchor: sections.length ? anchorOf(heading) : '', heading, text: '' });
    } else if (token.type === 'inline' && sections.length) {
      sections[sections.length - 1].text += ` ${(token.children ?? []).map(({ content }) => content).join(' ')}`;
    }
    // A cell that is the head of nothing is a plain one.
    if (token.type === 'th_open' && !inside.content) token.tag = tokens[i + 2].tag = 'td';
    // A link to what is not in the site becomes text.
    /** @type {boolean[]} */
    const open = [];
    for (const child of token.children ?? []) {
      if (child.type === 'image') {
        const target = resolve(String(child.attrGet('src')));
        if (target === null) throw new Error(`a picture is missing: ${child.attrGet('src')}`);
        const size = sizeOf(target);
        child.attrSet('src', target);
        child.attrSet('loading', 'lazy');
        if (size)
          for (const side of /** @type {const} */ (['width', 'height'])) child.attrSet(side, String(size[side]));
      } else if (child.type === 'link_open') {
        const target = resolve(String(child.attrGet('href')));
        open.push(target !== null);
        if (target === null) Object.assign(child, { type: 'text', tag: '', content: '' });
        else child.attrSet('href', target);
      } else if (child.type === 'link_close' && !open.pop())
        Object.assign(child, { type: 'text', tag: '', content: '' });
    }
  });
  const html = markdown.renderer.render(tokens, markdown.options, {});
  return { title: sections[0]?.heading ?? '', html, sections, examples };
}
