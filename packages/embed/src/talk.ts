// Messages between this page and the page around its frame.
import type { Request } from './read-message.ts';
import { messageVersion } from './protocol.ts';
import { readMessage } from './read-message.ts';
import { mayTalk } from './peers.ts';
import type { Peers } from './peers.ts';
import { toPlain } from './plain-value.ts';

/** It may not be defined yet. */
interface View extends HTMLElement {
  readonly volume?: object | null;
  getView?(): Record<string, string>;
}

interface Tour extends HTMLElement {
  step: number | null;
  next(): boolean;
  previous(): boolean;
}

/** Answers the page around the frame. */
export class Talk {
  /** Where events go; null until they are asked for. */
  #origin: string | null = null;
  #types: readonly string[] = [];
  readonly #listened = new Set<string>();

  constructor(readonly peers: Peers) {
    addEventListener('message', (event) => this.#answer(event));
    this.#post({ event: 'ready', detail: null }, '*'); // It says nothing of the data.
  }

  /** Send an event, if it was asked for. */
  send(event: string, detail: unknown): void {
    if (this.#origin !== null && this.#types.includes(event)) this.#post({ event, detail }, this.#origin);
  }

  #post(message: object, origin: string): void {
    // An origin that no page shares can not be named.
    parent.postMessage({ volumeView: messageVersion, ...message }, origin === 'null' ? '*' : origin);
  }

  #answer({ source, origin, data }: MessageEvent<unknown>): void {
    if (source !== parent || !mayTalk(origin, this.peers)) return;
    const message = readMessage(data, location.href);
    if (!message) return;
    const { id, request } = message;
    const { problem = null, ...more } = request ? this.#run(request, origin) : { problem: message.problem };
    this.#post(problem === null ? { id, ok: true, ...more } : { id, ok: false, problem }, origin);
  }

  #run(request: Request, origin: string): { problem?: string } & Record<string, unknown> {
    switch (request.kind) {
      case 'events':
        this.#origin = origin;
        this.#types = request.types;
        request.types.forEach((type) => this.#listen(type));
        return { isShown: isShown() };
      case 'get':
        return { attributes: readAttributes(), ...readStep(), isShown: isShown() };
      case 'set': {
        const view = findView();
        if (!view) return { problem: noView };
        for (const [name, text] of request.attributes)
          if (text === null) view.removeAttribute(name);
          else view.setAttribute(name, text);
        return {};
      }
      case 'step':
        return openStep(request.step);
    }
  }

  /** Events of the elements do not bubble, but are seen on their way to them. */
  #listen(type: string): void {
    if (this.#listened.has(type)) return;
    this.#listened.add(type);
    document.addEventListener(
      type,
      (event) => {
        const isOurs = event.target instanceof Element && event.target.localName.startsWith('volume-');
        if (isOurs) this.send(type, toPlain((event as CustomEvent<unknown>).detail) ?? null);
      },
      true,
    );
  }
}

const noView =
  'there is no volume; expected the message after the reader has asked for it, or an address that names one';

/** The first view: a lesson may have several. */
const findView = (): View | null => document.querySelector<View>('volume-view');

const findTour = (): Tour | null => document.querySelector<Tour>('volume-tour');

const isShown = (): boolean => Boolean(findView()?.volume);

/** The attributes of the view, and those of the camera as a reader has turned it. Without addresses that have megabytes of data inside. */
function readAttributes(): Record<string, string> {
  const view = findView();
  if (!view) return {};
  const own = Object.fromEntries([...view.attributes].map(({ name, value }) => [name, value]));
  const all = Object.entries({ ...own, ...view.getView?.() });
  return Object.fromEntries(all.filter(([, text]) => !/^\s*data:/i.test(text)));
}

function readStep(): { step: number | null; steps: number | null } {
  const tour = findTour();
  return tour
    ? { step: tour.step ?? 1, steps: tour.querySelectorAll('volume-step').length }
    : { step: null, steps: null };
}

function openStep(step: number | 'next' | 'previous'): { problem?: string } {
  const tour = findTour();
  if (!tour?.next) return { problem: 'there is no tour; expected a lesson with <volume-tour>' };
  if (step === 'next') tour.next();
  else if (step === 'previous') tour.previous();
  else {
    const { steps } = readStep();
    if (step > (steps ?? 0)) return { problem: `got step ${step}; expected at most ${steps}` };
    tour.setAttribute('step', String(step));
  }
  return {};
}
