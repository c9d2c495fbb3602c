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

/** The languages of the package that have been asked for, by code; null until one is there, and where there is none. */
const shipped = new Map<string, Partial<Terms> | null>();

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

  /** What the page has registered goes before what comes with the package, and English fills what is missing. */
  get terms(): Own {
    const own = findShipped(this.lang());
    // An entry that is no function is given back as it is, here an object.
    const registered = this.exists('volumeView', {}) ? (this.term('volumeView') as unknown as Partial<Own>) : null;
    return own || registered ? { ...this.english, ...own, ...registered } : this.english;
  }
}

/** The package's words of a language. Its file is fetched when an element first needs it, and elements are updated then. */
function findShipped(code: string): Partial<Terms> | null {
  if (/^en\b/i.test(code)) return null;
  if (!shipped.has(code)) {
    shipped.set(code, null);
    void import('./load-language.ts').then(({ loadLanguage }) => loadLanguage(code)).then((terms) => {
      shipped.set(code, terms);
      if (terms) update();
    }).catch(() => {
      // A language that did not come leaves the words English; the next page tries again.
    });
  }
  return shipped.get(code)!;
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
