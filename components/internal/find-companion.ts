import { socketOf } from '../../src/viewer/model/view-socket.ts';

/** A companion in the page that speaks of a view, and is seen. @param name - its tag's */
export function findCompanion(view: HTMLElement, name: string): HTMLElement | null {
  return socketOf(view).parts.find(({ key, element }) => key === name && element!.offsetHeight > 0)?.element ?? null;
}
