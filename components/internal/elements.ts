// The one table of the elements that belong to <volume-view>. An element is a folder of components and a line here: from it come
// what is loaded when a page has such a tag, the files of the build, and the entries of the package.

/** Fetches and defines an element, by its name. */
export const elements: Readonly<Record<string, () => Promise<unknown>>> = {
  'volume-clip': () => import('../volume-clip/define.ts'),
  'volume-label': () => import('../volume-label/define.ts'),
  'volume-label-list': () => import('../volume-label-list/define.ts'),
  'volume-labels': () => import('../volume-labels/define.ts'),
  'volume-layer': () => import('../volume-layer/define.ts'),
  'volume-legend': () => import('../volume-legend/define.ts'),
  'volume-measure': () => import('../volume-measure/define.ts'),
  'volume-readout': () => import('../volume-readout/define.ts'),
  'volume-slice': () => import('../volume-slice/define.ts'),
  'volume-slice-view': () => import('../volume-slice-view/define.ts'),
  'volume-surface': () => import('../volume-surface/define.ts'),
  'volume-terrain': () => import('../volume-terrain/define.ts'),
  'volume-timeline': () => import('../volume-timeline/define.ts'),
  'volume-transfer-function': () => import('../volume-transfer-function/define.ts'),
  'volume-workspace': () => import('../volume-workspace/define.ts'),
};
