import type { AppearanceSettings } from './settings.ts';

/** Of a page that says nothing. */
export const plainAppearance: AppearanceSettings = {
  named: null,
  transferFunction: null,
  window: null,
  referenceLength: null,
  opacityFactor: null,
  lightFactor: 1,
  projection: null,
  shading: null,
  surfaces: null,
  gradientOpacity: null,
  transferFunction2d: null,
};
