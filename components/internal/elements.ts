// The one table of the elements that belong to <volume-view>. To add an element, add a folder in components and a line here. Three things
// use the table: the code that loads an element when a page has its tag, the files of the build, and the entry points of the package.

/** Functions that fetch and define an element, by its tag name. */
export const elements: Readonly<Record<string, () => Promise<unknown>>> = {
  'volume-clip': () => import('../volume-clip/define.ts'),
  'volume-compare': () => import('../volume-compare/define.ts'),
  'volume-drop': () => import('../volume-drop/define.ts'),
  'volume-label': () => import('../volume-label/define.ts'),
  'volume-label-list': () => import('../volume-label-list/define.ts'),
  'volume-labels': () => import('../volume-labels/define.ts'),
  'volume-layer': () => import('../volume-layer/define.ts'),
  'volume-legend': () => import('../volume-legend/define.ts'),
  'volume-measure': () => import('../volume-measure/define.ts'),
  'volume-note': () => import('../volume-note/define.ts'),
  'volume-question': () => import('../volume-question/define.ts'),
  'volume-readout': () => import('../volume-readout/define.ts'),
  'volume-series': () => import('../volume-series/define.ts'),
  'volume-slice': () => import('../volume-slice/define.ts'),
  'volume-slice-view': () => import('../volume-slice-view/define.ts'),
  'volume-step': () => import('../volume-step/define.ts'),
  'volume-surface': () => import('../volume-surface/define.ts'),
  'volume-terrain': () => import('../volume-terrain/define.ts'),
  'volume-timeline': () => import('../volume-timeline/define.ts'),
  'volume-tour': () => import('../volume-tour/define.ts'),
  'volume-transfer-function': () => import('../volume-transfer-function/define.ts'),
  'volume-workspace': () => import('../volume-workspace/define.ts'),
};
