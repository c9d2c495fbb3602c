import { VolumeViewError } from '../../src/core/errors.ts';
import { hostOf } from '../../src/page/page-children.ts';
import { emit } from './volume-view-events.ts';

/** Report an error if an element is not inside the element that it belongs to. @param host - tag name of the element that it belongs to */
export function reportIfLost(element: HTMLElement, host: string): void {
  // A script may insert this element first, and put the host around it later.
  queueMicrotask(() => {
    if (!element.isConnected || hostOf(element, host)) return;
    const { code, message } = new VolumeViewError(
      'attribute/invalid',
      `<${element.localName}> got no <${host}> around it; expected it between the tags of one.`,
    );
    console.warn(message); // There is no picture in which the error could be shown.
    emit(element, 'error', { code, message, cause: undefined });
  });
}
