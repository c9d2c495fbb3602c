/** Elements that keep company with <volume-view>, and where their code is. It is fetched when a page has such an element. */
export const companions: Partial<Record<string, () => Promise<unknown>>> = {
  'volume-label-list': () => import('./define/volume-label-list.ts'),
  'volume-labels': () => import('./define/volume-labels.ts'),
  'volume-legend': () => import('./define/volume-legend.ts'),
  'volume-readout': () => import('./define/volume-readout.ts'),
  'volume-slice': () => import('./define/volume-slice.ts'),
  'volume-slice-view': () => import('./define/volume-slice-view.ts'),
  'volume-timeline': () => import('./define/volume-timeline.ts'),
  'volume-transfer-function': () => import('./define/volume-transfer-function.ts'),
};
