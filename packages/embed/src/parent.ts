// embed-parent.js: for the page around a frame. It makes frames with `data-volume-view` as high as what is in them, and
// `new VolumeViewFrame(iframe)` sets attributes, opens steps and has the events.
import { eventTypes, messageVersion } from './protocol.ts';

type Answer = Record<string, unknown>;

/** Seconds that an answer may take. */
const patience = 10;

/** A frame with `embed.html`, or with a page of an embed folder. */
class VolumeViewFrame extends EventTarget {
  readonly #waiting = new Map<number, { done: (answer: Answer) => void; fail: (error: Error) => void }>();
  readonly #types = new Set<string>();
  /** Requests that wait for the frame's page; null once it is there. */
  #queue: object[] | null = [];
  #count = 0;

  constructor(readonly frame: HTMLIFrameElement) {
    super();
    if (!(frame instanceof HTMLIFrameElement)) throw new TypeError('VolumeViewFrame got no <iframe>');
    addEventListener('message', (event) => this.#receive(event));
    // A page that is there already has said `ready` before. This asks for nothing, so any page may get it.
    frame.contentWindow?.postMessage({ volumeView: messageVersion, id: 0, events: [] }, '*');
  }

  /** The attributes of the view as they are now, the open step, and the number of steps. */
  get(): Promise<Answer> {
    return this.#ask({ get: true });
  }

  /** Sets attributes of the view; null removes one. */
  set(attributes: Readonly<Record<string, string | number | boolean | null>>): Promise<Answer> {
    return this.#ask({ set: attributes });
  }

  /** Opens a step of a lesson: its number from 1, `next` or `previous`. */
  step(step: number | 'next' | 'previous'): Promise<Answer> {
    return this.#ask({ step });
  }

  override addEventListener(...given: Parameters<EventTarget['addEventListener']>): void {
    super.addEventListener(...given);
    if (!eventTypes.includes(given[0]) || this.#types.has(given[0])) return;
    this.#types.add(given[0]);
    this.#subscribe();
  }

  #subscribe(): void {
    if (this.#types.size > 0 && this.#queue === null) this.#ask({ events: [...this.#types] }).catch(() => {});
  }

  /** The frame's page is there. If it is another one than before, it does not know which events are asked for. */
  #begin(): void {
    const queue = this.#queue ?? [];
    this.#queue = null;
    this.#subscribe();
    queue.forEach((message) => this.#post(message));
  }

  /** Where the frame's page comes from: a frame in a sandbox has no origin that could be named. */
  get #origin(): string {
    const { sandbox, src } = this.frame;
    const isOpaque = this.frame.hasAttribute('sandbox') && !sandbox.contains('allow-same-origin');
    return isOpaque ? 'null' : new URL(src, document.baseURI).origin;
  }

  #ask(request: object): Promise<Answer> {
    const id = ++this.#count;
    return new Promise((done, fail) => {
      this.#waiting.set(id, { done, fail });
      const message = { volumeView: messageVersion, id, ...request };
      if (this.#queue) this.#queue.push(message);
      else this.#post(message);
    });
  }

  #post(message: object): void {
    const { id } = message as { id: number };
    setTimeout(() => this.#end(id, { ok: false, problem: 'the frame does not answer' }), 1000 * patience);
    const origin = this.#origin;
    this.frame.contentWindow?.postMessage(message, origin === 'null' ? '*' : origin);
  }

  #end(id: number, answer: Answer): void {
    const waiting = this.#waiting.get(id);
    this.#waiting.delete(id);
    if (answer.ok === true) waiting?.done(answer);
    else waiting?.fail(new Error(String(answer.problem)));
  }

  #receive({ source, origin, data }: MessageEvent<unknown>): void {
    if (source !== this.frame.contentWindow || origin !== this.#origin) return;
    if (typeof data !== 'object' || data === null) return;
    const { volumeView, event, detail, id, ...answer } = data as Record<string, unknown>;
    if (volumeView !== messageVersion) return;
    if (event === 'ready' || (id === 0 && this.#queue)) this.#begin();
    if (typeof id === 'number') this.#end(id, answer);
    if (typeof event === 'string') this.dispatchEvent(new CustomEvent(event, { detail }));
  }
}

/** Keeps a frame as high as its page asks for, within bounds. */
function follow(frame: HTMLIFrameElement): void {
  new VolumeViewFrame(frame).addEventListener('height', (event) => {
    const height = Number((event as CustomEvent<unknown>).detail);
    if (height > 0) frame.style.height = `${Math.min(Math.max(height, 150), 4000)}px`;
  });
}

Object.assign(globalThis, { VolumeViewFrame });
const begin = (): void => document.querySelectorAll<HTMLIFrameElement>('iframe[data-volume-view]').forEach(follow);
if (document.readyState === 'loading') addEventListener('DOMContentLoaded', begin);
else begin();
