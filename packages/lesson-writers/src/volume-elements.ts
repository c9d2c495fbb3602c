// Written by `npm run docs` from the comments in the source; edit them, not this file.

/** The attributes of each element, separated by blanks. */
export const volumeElements: Readonly<Record<string, string>> = {
  'volume-clip': 'for type normal keep at box',
  'volume-compare': 'layout position',
  'volume-drop': 'for',
  'volume-label': 'value name color opacity transfer-function',
  'volume-label-list': 'for',
  'volume-labels': 'src table transfer-function only',
  'volume-layer': 'src transfer-function value-window blend opacity-factor label',
  'volume-legend': 'for label layer orientation',
  'volume-measure': 'for type label color points',
  'volume-note': 'for position of latitude longitude height label hide open',
  'volume-question': 'for type position of latitude longitude height radius answer tolerance unit tries remember',
  'volume-readout': 'for coordinates curve',
  'volume-series': 'for',
  'volume-slice':
    'type elevation sweep height azimuth from to at normal thickness projection value-window window-function colors',
  'volume-slice-view':
    'for src type normal at thickness projection value-window window-function interpolation colors drag label-opacity group alt cursor',
  'volume-step':
    'label notes labels dwell slice series clean moment color-moment vertical-exaggeration time autoplay play-speed look transfer-function projection shading surface-values gradient-opacity transfer-function-2d value-window reference-length opacity-factor light-factor region cutout rings camera-orbit camera-target field-of-view auto-rotate auto-rotate-delay rotation-per-second orientation-marker cursor crosshair alt',
  'volume-surface': 'src color opacity space cut-with-volume',
  'volume-terrain': 'src corner color opacity cut-with-volume',
  'volume-timeline': 'for time-zone',
  'volume-tour': 'for step duration autoplay dwell by',
  'volume-transfer-function': 'for mode bands band-edges',
  'volume-view':
    'src stack mosaic slices spacing coordinates elevations range azimuth series max-bytes max-gpu-bytes crossorigin clean moment color-moment beam-model vertical-exaggeration time autoplay play-speed look transfer-function projection shading surface-values gradient-opacity transfer-function-2d value-window reference-length opacity-factor light-factor steps max-error detail target-fps region cutout rings camera-orbit camera-target field-of-view min-camera-orbit max-camera-orbit interpolation-decay auto-rotate auto-rotate-delay rotation-per-second orientation-marker interaction controls controlslist link-state pickable authoring self-check cursor crosshair width height alt poster loading',
  'volume-workspace': 'panes companions',
};
