// Parts of the page. All texts are set as texts.
import { makeTrust } from '../../../src/core/trust.ts';
import { english } from './words.ts';

const main = (): HTMLElement => document.querySelector('main')!;

export function addText(name: 'h1' | 'p' | 'li', text: string, parent: Element = main()): HTMLElement {
  const element = document.createElement(name);
  element.textContent = text;
  parent.append(element);
  return element;
}

/** What is wrong, for the author of the frame. */
export function addProblems(heading: string, problems: readonly string[]): void {
  const box = document.createElement('div');
  box.className = 'hint';
  addText('p', heading, box);
  const list = document.createElement('ul');
  for (const one of problems) addText('li', one, list);
  box.append(list);
  main().append(box);
}

/** The page, when there is nothing to show. */
export function showMessage(heading: string, text: string): void {
  main().replaceChildren();
  addText('h1', heading);
  addText('p', text);
}

let player: Promise<void> | null = null;

/** The folder that the page's own script is in. */
const folder = (document.currentScript as HTMLScriptElement | null)?.src;

/** Marks the address of the element, and a lesson that the browser's parser reads without running anything. */
export const trust = makeTrust('volume-view-embed');

/** Load the element: not before it is needed. */
export function loadPlayer(): Promise<void> {
  player ??= runScript(new URL('volume-view.iife.js', folder).href).catch(() =>
    showMessage(english.nothing, english.playerFailed),
  );
  return player;
}

/** Run a script of this package. @param data - its data attributes. @returns rejects where it can't be loaded */
export function runScript(address: string, data: Readonly<Record<string, string>> = {}): Promise<void> {
  return new Promise((resolve, reject) => {
    const script = document.createElement('script');
    script.src = trust(address, 'createScriptURL');
    Object.assign(script.dataset, data);
    script.onload = () => resolve();
    script.onerror = () => reject(new Error(`${address} could not be loaded`));
    document.head.append(script);
  });
}
