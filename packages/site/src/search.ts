import MiniSearch from 'minisearch';
import type { SearchResult } from 'minisearch';
import { loadScript } from './load-script.ts';
import { searchFields } from './search-fields.mjs';

declare global {
  interface Window {
    searchIndex?: string;
  }
}

const maxResults = 8;

/** The search box of the page. Its index is loaded when somebody goes into the box. @param root - of the site */
export function startSearch(root: string): void {
  const form = document.querySelector<HTMLFormElement>('form[role=search]');
  const input = form?.querySelector('input');
  const found = form?.querySelector('.found');
  if (!form || !input || !found) return;
  let index: MiniSearch | null = null;
  const load = async (): Promise<MiniSearch> => {
    await loadScript(`${root}search-index.js`);
    return (index ??= MiniSearch.loadJSON(window.searchIndex!, searchFields));
  };
  const show = async (): Promise<void> => {
    const words = input.value.trim();
    if (!words) return found.replaceChildren();
    try {
      const results = (await load()).search(words).slice(0, maxResults);
      if (input.value.trim() !== words) return; // Somebody has written on.
      found.replaceChildren(listOf(root, results, words));
    } catch {
      found.textContent = 'The index of the search could not be loaded.';
    }
  };
  input.addEventListener('focus', () => void load().catch(() => undefined));
  input.addEventListener('input', () => void show());
  form.addEventListener('submit', (event) => {
    event.preventDefault();
    found.querySelector('a')?.click();
  });
  form.addEventListener('keydown', (event) => {
    if (event.key === 'Escape') {
      input.value = '';
      found.replaceChildren();
      input.focus();
    }
  });
}

function listOf(root: string, results: readonly SearchResult[], words: string): Node {
  if (results.length === 0) return document.createTextNode(`Nothing was found for “${words}”.`);
  const list = document.createElement('ul');
  for (const { id, page, heading } of results) {
    const link = document.createElement('a');
    link.href = root + String(id);
    link.textContent = heading === page ? String(page) : `${String(page)}: ${String(heading)}`;
    const item = document.createElement('li');
    item.append(link);
    list.append(item);
  }
  return list;
}
