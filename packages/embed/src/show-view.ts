import { addText, loadPlayer } from './page-parts.ts';
import type { EmbedPlan } from './read-address.ts';
import { english } from './words.ts';

/** Shows the volume that the address names, and its companions below it. */
export function showView({ attributes, companions }: EmbedPlan): void {
  const main = document.querySelector('main')!;
  const view = document.createElement('volume-view');
  for (const [name, text] of attributes) view.setAttribute(name, text);
  main.append(view, ...companions.map((name) => document.createElement(name)));
  view.addEventListener('error', (event) => explainPlace(view, event as CustomEvent<{ code?: string } | null>));
  void loadPlayer();
}

/** Authors of the frame may expect addresses relative to the page around it; but they are relative to this page. */
function explainPlace(view: Element, { detail }: CustomEvent<{ code?: string } | null>): void {
  const src = view.getAttribute('src')?.trim() ?? '';
  if (detail?.code !== 'source/not-found' || /^(\w+:|\/)/.test(src) || document.querySelector('.place')) return;
  const above = src
    .split(/\s+/)
    .map((one) => `../${one}`)
    .join('%20');
  addText('p', english.place(new URL('.', location.href).pathname, above)).className = 'hint place';
}
