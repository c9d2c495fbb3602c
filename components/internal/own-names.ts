/** Our own elements. */
export const ownNames = new Set(['volume-view', 'volume-clip', 'volume-label', 'volume-label-list', 'volume-labels', 'volume-layer', 'volume-legend', 'volume-measure', 'volume-readout', 'volume-slice', 'volume-slice-view', 'volume-surface', 'volume-terrain', 'volume-timeline', 'volume-transfer-function', 'volume-workspace']);

/** Whether the shadow tree of an element of this name may have elements of ours in it. Of ours, that of one has. */
export const mayHoldOthers = (localName: string): boolean => localName === 'volume-workspace' || !ownNames.has(localName);
