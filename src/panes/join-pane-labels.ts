import type { PaneLabels } from './pane-labels.ts';

/** Joins several layers that cover the greys; they are painted one after the other. */
export function joinPaneLabels(several: readonly (PaneLabels | null)[]): PaneLabels | null {
  const all = several.filter((one) => one !== null);
  if (all.length < 2) return all[0] ?? null;
  return {
    paint: (...how) => all.forEach((one) => one.paint(...how)),
    nameAt: (place) => all.map((one) => one.nameAt(place)).find((name) => name !== null) ?? null,
  };
}
