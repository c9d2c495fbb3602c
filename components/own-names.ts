/** Our own elements. Their shadow trees hold no other element of ours. */
export const ownNames = new Set(['volume-view', 'volume-clip', 'volume-label', 'volume-label-list', 'volume-labels', 'volume-legend', 'volume-measure', 'volume-readout', 'volume-slice', 'volume-slice-view', 'volume-surface', 'volume-terrain', 'volume-timeline', 'volume-transfer-function']);
