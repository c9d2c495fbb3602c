// Where the code of the elements is that keep company with <volume-view>: loaded with the first of them.

/** Fetches and defines an element, by its name. */
export const companionLoaders: Readonly<Record<string, () => Promise<unknown>>> = {
  'volume-clip': () => import('../define/volume-clip.ts'),
  'volume-label-list': () => import('../define/volume-label-list.ts'),
  'volume-labels': () => import('../define/volume-labels.ts'),
  'volume-layer': () => import('../define/volume-layer.ts'),
  'volume-legend': () => import('../define/volume-legend.ts'),
  'volume-measure': () => import('../define/volume-measure.ts'),
  'volume-readout': () => import('../define/volume-readout.ts'),
  'volume-slice': () => import('../define/volume-slice.ts'),
  'volume-slice-view': () => import('../define/volume-slice-view.ts'),
  'volume-surface': () => import('../define/volume-surface.ts'),
  'volume-terrain': () => import('../define/volume-terrain.ts'),
  'volume-timeline': () => import('../define/volume-timeline.ts'),
  'volume-transfer-function': () => import('../define/volume-transfer-function.ts'),
  'volume-workspace': () => import('../define/volume-workspace.ts'),
};
