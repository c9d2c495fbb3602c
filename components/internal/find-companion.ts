import { socketOf } from '../../src/viewer/model/view-socket.ts';

/** Find a visible companion that belongs to a view. @param name - its tag name */
export function findCompanion(view: HTMLElement, name: string): HTMLElement | null {
  return socketOf(view).parts.find(({ key, element }) => key === name && element!.offsetHeight > 0)?.element ?? null;
}
