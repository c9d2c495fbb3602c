import { VolumeViewError } from '../../src/core/errors.ts';
import { hostOf } from '../../src/page/page-children.ts';
import { tell } from './volume-view-events.ts';

/** Say of an element that nothing is around it which it could speak to. @param host - the name of what it belongs in */
export function tellIfLost(element: HTMLElement, host: string): void {
  // Who builds a page may put the element in first, and what is around it later.
  queueMicrotask(() => {
    if (!element.isConnected || hostOf(element, host)) return;
    const { code, message } = new VolumeViewError('attribute/invalid', `<${element.localName}> got no <${host}> around it; expected it between the tags of one.`);
    console.warn(message); // There is no picture in which it could stand.
    tell(element, 'error', { code, message, cause: undefined });
  });
}
