import { loadScript } from './load-script.ts';
import { frameDocument, withDataUrls } from './frame-document.ts';

declare global {
  interface Window {
    /** The samples as `data:` URLs, by name: for pages from a disk. */
    sampleFiles?: Record<string, string>;
  }
}

/** Pictures that are alive at a time: each is a page of its own. */
const maxAlive = 3;

/** Milliseconds without a key before the picture follows. */
const pause = 800;

/** The pictures of the page's examples: each comes when it is in sight, and follows what is written. @param root - of the site */
export function startExamples(root: string): void {
  const examples = [...document.querySelectorAll<HTMLElement>('figure.example')].map(
    (figure) => new Example(figure, root),
  );
  const seen = new IntersectionObserver(
    (entries) => {
      for (const { target, isIntersecting } of entries) {
        const example = examples.find(({ picture }) => picture === target);
        if (!example) continue;
        example.isInSight = isIntersecting;
        if (isIntersecting) example.start();
      }
      const rest = examples.filter(({ isAlive, isInSight }) => isAlive && !isInSight);
      const alive = examples.filter(({ isAlive }) => isAlive).length;
      for (const one of rest.slice(0, Math.max(0, alive - maxAlive))) one.stop();
    },
    { threshold: 0.25 },
  );
  for (const { picture } of examples) seen.observe(picture);
}

class Example {
  isInSight = false;
  readonly picture: HTMLElement;
  readonly #code: HTMLElement;
  readonly #files: readonly string[];
  readonly #original: string;
  #frame: HTMLIFrameElement | null = null;
  #timer = 0;

  constructor(
    figure: HTMLElement,
    readonly root: string,
  ) {
    this.picture = figure.querySelector<HTMLElement>('.picture')!;
    this.#code = figure.querySelector<HTMLElement>('pre')!;
    this.#files = (figure.dataset.files ?? '').split(' ').filter(Boolean);
    this.#original = this.#code.textContent;
    this.#code.setAttribute('contenteditable', 'plaintext-only');
    this.#code.addEventListener('input', () => {
      clearTimeout(this.#timer);
      this.#timer = window.setTimeout(() => void this.#show(), pause);
    });
    figure.querySelector('.buttons')!.append(
      buttonOf('Copy', () => void navigator.clipboard?.writeText(this.#text)),
      buttonOf('As it was', () => {
        this.#code.textContent = this.#original;
        void this.#show();
      }),
    );
  }

  get isAlive(): boolean {
    return this.#frame !== null;
  }

  get #text(): string {
    return this.#code.textContent;
  }

  start(): void {
    if (!this.#frame) void this.#show();
  }

  /** The picture goes, and with it its memory; it comes again when it is in sight. */
  stop(): void {
    this.#frame?.remove();
    this.#frame = null;
  }

  /** A new frame each time: the address of one that is there would become a step of the history. */
  async #show(): Promise<void> {
    const isFromDisk = location.protocol === 'file:';
    const text = this.#text;
    const frame = document.createElement('iframe');
    frame.title = 'Picture of the example';
    frame.allow = 'fullscreen';
    this.#frame?.remove();
    this.#frame = frame;
    try {
      if (isFromDisk)
        await Promise.all(this.#files.map((name) => loadScript(`${this.root}examples/from-disk/${name}.js`)));
      if (this.#frame !== frame) return;
      frame.srcdoc = frameDocument(isFromDisk ? withDataUrls(text, window.sampleFiles ?? {}) : text, {
        base: `${this.root}examples/`,
        isFromDisk,
      });
      this.picture.replaceChildren(frame);
    } catch {
      this.#frame = null;
      this.picture.textContent = 'The files of this example could not be loaded.';
    }
  }
}

function buttonOf(text: string, act: () => void): HTMLButtonElement {
  const button = document.createElement('button');
  button.type = 'button';
  button.textContent = text;
  button.addEventListener('click', act);
  return button;
}
