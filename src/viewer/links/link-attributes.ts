import { lookAttributes, placeAttributes } from '../tours/step-attributes.ts';

/**
 * The attributes of a view that a link may have: all else in a link is ignored. None of them says which data are loaded, and none starts
 * something: links come from strangers.
 */
export const linkAttributes: readonly string[] = [
  ...lookAttributes,
  ...placeAttributes,
  'cutout',
  'crosshair',
  'region',
  'rings',
];
