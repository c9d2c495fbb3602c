import labels from '../../../../shaders/chunks/attachments/labels.glsl?raw';
import labels3d from '../../../../shaders/chunks/attachments/labels-3d.glsl?raw';
import labelsMosaic from '../../../../shaders/chunks/attachments/labels-mosaic.glsl?raw';
import vote from '../../../../shaders/chunks/field/vote.glsl?raw';
import type { ShownLabels } from '../../../volume/labels.ts';
import type { RayText, RayTwin } from '../ray-module.ts';
import { twinOf, usualTwins } from '../ray-twin.ts';

/** Texels in a row of the labels' table. */
export const labelsAcross = 1024;

/** How labels lie on the GPU, and what they are for. */
export interface LabelOptions {
  /** In a 3D texture (WebGL 2 only), else a mosaic in a 2D texture. */
  readonly texture3d: boolean;
  /** More than 256 labels. */
  readonly twoBytes: boolean;
  /** What is hidden counts as without data: to projections, which know no opacity. */
  readonly hides: boolean;
  /** Groups have transfer functions of their own. */
  readonly groups?: boolean;
}

/** Which label a place has, and what labels look like. */
export function labelsText({ texture3d, twoBytes, hides, groups = false }: LabelOptions): RayText {
  return {
    name: 'labels',
    stage: 'field',
    defines: {
      LABELS_3D: Number(texture3d), LABEL_TWO_BYTES: Number(twoBytes), LABELS_HIDE: Number(hides), LABELS_ACROSS: labelsAcross.toFixed(1), ...(hides && { NO_DATA: 1 }),
    },
    chunks: [vote, texture3d ? labels3d : labelsMosaic, labels],
    samplers: ['uLabels', 'uLabelTable'],
    members: ['vec4 look', ...(groups ? ['float group'] : [])],
  };
}

/** @param hides - as in `LabelOptions` */
export const labelsTwin = (labels: ShownLabels, hides: boolean): RayTwin => twinOf(usualTwins, ({ labelField }) => ({ moreFields: [labelField(labels, hides)] }));
