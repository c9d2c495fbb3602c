// How high the page would like to be. A frame has the height that the page around it gives; that page may follow these messages.
import type { Talk } from './talk.ts';

/** Width to height of a picture alone. */
const aspect = 4 / 3;

/** The secret that WordPress has written into the address of its frame: letters and digits. */
const secretOf = (hash: string): string | null => /[#?&]secret=([A-Za-z0-9]{1,64})(?:&|$)/.exec(hash)?.[1] ?? null;

/** Reports the height now, and whenever it changes. @param talk - null where the page is in no frame */
export function reportHeight(talk: Talk | null): void {
  if (!talk) return;
  let last = 0;
  const report = (isAsked = false): void => {
    const height = Math.ceil(measure());
    if (height === 0 || (height === last && !isAsked)) return;
    last = height;
    talk.send('height', height);
    // The message of WordPress' own frames. The height says nothing of the data, so any page may get it.
    const secret = secretOf(location.hash);
    if (secret !== null) parent.postMessage({ message: 'height', value: height, secret }, '*');
  };
  const sizes = new ResizeObserver(() => report());
  const main = document.querySelector('main')!;
  const observe = (): void => {
    sizes.disconnect();
    for (const one of [document.documentElement, main, ...main.children]) sizes.observe(one);
  };
  new MutationObserver(observe).observe(main, { childList: true });
  observe();
  // WordPress hides the frame until it has a height, and browsers observe no sizes in a hidden frame.
  report();
  addEventListener('load', () => report(true));
  addEventListener('message', ({ source, data }: MessageEvent<unknown>) => {
    if (source !== parent || typeof data !== 'object' || data === null) return;
    // WordPress asks with `ready`; our own script with the list of events, which the talk has answered before.
    if ('message' in data && data.message === 'ready') report(true);
    else if ('events' in data) report(true);
  });
}

/** CSS pixels. A picture that fills its frame is measured by its width: else a higher frame would ask for a still higher one. */
function measure(): number {
  const main = document.querySelector('main')!;
  const filling = main.querySelector<HTMLElement>(':scope > volume-view, :scope > .poster');
  const isFilling = filling !== null && getComputedStyle(main).display === 'flex';
  if (!isFilling) return document.body.getBoundingClientRect().height;
  const others = [...main.children].filter((one) => one !== filling);
  return main.clientWidth / aspect + others.reduce((sum, one) => sum + one.getBoundingClientRect().height, 0);
}
