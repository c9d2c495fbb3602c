import { LocalizeController, registerTranslation as register, update } from '@shoelace-style/localize';
import type { Messages } from './messages.ts';

type ReactiveHost = ConstructorParameters<typeof LocalizeController>[0];

/** The entry of one language in the registry. Other libraries of the page may use the same registry: our messages are one entry. */
interface Entry {
  $code: string;
  $name: string;
  $dir: 'ltr';
  volumeView: string;
}

/** The languages of the package that have been requested, by code; null until the messages are loaded, and where the package has none. */
const shipped = new Map<string, Partial<Messages> | null>();

/**
 * Add a language for the elements of this page; they use it where the nearest `lang` attribute names it.
 * @param code - BCP 47, like `de` or `pt-BR`
 * @param messages - missing messages stay English; a second call for the same language replaces the first
 */
export function registerTranslation(code: string, messages: Partial<Messages>): void {
  // The direction of writing comes from the page, through CSS; but the registry needs a value.
  const entry = { $code: code, $name: code, $dir: 'ltr' as const, volumeView: messages };
  register(entry);
}

/** The messages of one element, in the language of the page around it. When the language changes, the element is rendered again. */
export class LocaleController<Own extends Partial<Messages>> extends LocalizeController<Entry> {
  /** @param english - used where no translation has the message */
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

  /** Messages that the page has registered override those of the package; English ones fill the gaps. */
  get messages(): Own {
    const own = findShipped(this.lang());
    // The registry returns an entry that is no function unchanged; here it is an object.
    const registered = this.exists('volumeView', {}) ? (this.term('volumeView') as unknown as Partial<Own>) : null;
    return own || registered ? { ...this.english, ...own, ...registered } : this.english;
  }
}

/**
 * The package's messages of a language. The file is fetched when an element first needs it, and elements are updated when it has loaded.
 */
function findShipped(code: string): Partial<Messages> | null {
  if (/^en\b/i.test(code)) return null;
  if (!shipped.has(code)) {
    shipped.set(code, null);
    void import('./load-language.ts')
      .then(({ loadLanguage }) => loadLanguage(code))
      .then((messages) => {
        shipped.set(code, messages);
        if (messages) update();
      })
      .catch(() => {
        // If a language can't be loaded, the messages stay English; the next page tries again.
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

/** The registry observes only the attributes of the root element. */
function watchLanguages(): void {
  if (watcher) return;
  watcher = new MutationObserver(update);
  watcher.observe(document, { subtree: true, attributes: true, attributeFilter: ['lang'] });
}
