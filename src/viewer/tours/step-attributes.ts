// Which attributes of a <volume-view> a step may set. Each attribute of the view is in one of the two lists: a test compares them.

/** Those of the appearance: they change together. */
export const lookAttributes = [
  'look',
  'transfer-function',
  'transfer-function-2d',
  'value-window',
  'reference-length',
  'opacity-factor',
  'light-factor',
  'projection',
  'shading',
  'surface-values',
  'gradient-opacity',
] as const;

/**
 * Those that a person changes too, without a change of the attribute: setting the same text again goes back to it.
 */
export const placeAttributes = ['camera-orbit', 'camera-target', 'field-of-view', 'time', 'cursor'] as const;

/** All that a step may set on the view. */
export const stepAttributes: readonly string[] = [
  ...lookAttributes,
  ...placeAttributes,
  'alt',
  'auto-rotate',
  'auto-rotate-delay',
  'autoplay',
  'clean',
  'color-moment',
  'crosshair',
  'cutout',
  'moment',
  'orientation-marker',
  'play-speed',
  'region',
  'rings',
  'rotation-per-second',
  'series',
  'vertical-exaggeration',
];

/** Attributes of the view that stay the same in all steps: its data, its room in the page, how a person uses it, its quality. */
export const notInSteps: readonly string[] = [
  'authoring',
  'azimuth',
  'beam-model',
  'controls',
  'controlslist',
  'coordinates',
  'crossorigin',
  'detail',
  'elevations',
  'height',
  'interaction',
  'interpolation-decay',
  'link-state',
  'loading',
  'max-bytes',
  'max-camera-orbit',
  'max-error',
  'max-gpu-bytes',
  'min-camera-orbit',
  'mosaic',
  'pickable',
  'poster',
  'range',
  'self-check',
  'slices',
  'spacing',
  'src',
  'stack',
  'steps',
  'target-fps',
  'width',
];
