import { LocalizeController, registerTranslation as register, update } from '@shoelace-style/localize';
import type { Terms } from './terms.ts';

type ReactiveHost = ConstructorParameters<typeof LocalizeController>[0];

/** What the registry holds for one language. It may be shared with other libraries of the page: our words are one entry. */
interface Entry {
  $code: string;
  $name: string;
  $dir: 'ltr';
  volumeView: string;
}

/**
 * Give the elements of this page another language; they use it where the nearest `lang` attribute names it.
 * @param code - BCP 47, like `de` or `pt-BR`
 * @param terms - what is left out stays English; a second call for the same language replaces the first
 */
export function registerTranslation(code: string, terms: Partial<Terms>): void {
  // The direction of writing comes from the page, through CSS; the registry wants one all the same.
  const entry = { $code: code, $name: code, $dir: 'ltr' as const, volumeView: terms };
  register(entry);
}

/** The words of one element, in the language of the page around it. The element is drawn anew when that changes. */
export class Words<Own extends Partial<Terms>> extends LocalizeController<Entry> {
  /** @param english - for what no translation has */
  constructor(
    host: ReactiveHost,
    readonly english: Own,
  ) {
    super(host);
  }

  override hostConnected(): void {
    super.hostConnected();
    watchLanguages();
  }

  /** The nearest `lang` attribute, across shadow roots; else the language of the browser. */
  override lang(): string {
    return findLanguage(this.host) ?? super.lang();
  }

  get terms(): Own {
    // An entry that is no function is given back as it is, here an object.
    return this.exists('volumeView', {}) ? { ...this.english, ...(this.term('volumeView') as unknown as Partial<Own>) } : this.english;
  }
}

function findLanguage(start: Element): string | null {
  for (let element: Element | null = start; element; element = parentOf(element)) {
    const code = element.getAttribute('lang');
    if (code && isLanguage(code)) return code;
  }
  return null;
}

function parentOf({ parentElement, parentNode }: Element): Element | null {
  return parentElement ?? (parentNode instanceof ShadowRoot ? parentNode.host : null);
}

function isLanguage(code: string): boolean {
  try {
    return Intl.getCanonicalLocales(code).length === 1;
  } catch {
    return false;
  }
}

let watcher: MutationObserver | null = null;

/** The registry sees the attributes of the root element only. */
function watchLanguages(): void {
  if (watcher) return;
  watcher = new MutationObserver(update);
  watcher.observe(document, { subtree: true, attributes: true, attributeFilter: ['lang'] });
}
