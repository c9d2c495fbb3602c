import labels from '../../../../shaders/chunks/attachments/labels.glsl?raw';
import labels3d from '../../../../shaders/chunks/attachments/labels-3d.glsl?raw';
import labelsMosaic from '../../../../shaders/chunks/attachments/labels-mosaic.glsl?raw';
import vote from '../../../../shaders/chunks/field/vote.glsl?raw';
import type { ShownLabels } from '../../../volume/labels.ts';
import type { RayText, RayTwin } from '../ray-module.ts';
import { twinOf, usualTwins } from '../ray-twin.ts';

/** Texels in a row of the label table. */
export const labelsAcross = 1024;

/** How labels are stored on the GPU, and how they are used. */
export interface LabelOptions {
  /** True: in a 3D texture (WebGL 2 only); false: as a mosaic in a 2D texture. */
  readonly texture3d: boolean;
  /** More than 256 labels. */
  readonly twoBytes: boolean;
  /** Hidden labels count as missing data: projections need it, because they have no opacity. */
  readonly hides: boolean;
  /** Groups have their own transfer functions. */
  readonly groups?: boolean;
}

/** The text that finds the label of a place, and the label's appearance. */
export function labelsText({ texture3d, twoBytes, hides, groups = false }: LabelOptions): RayText {
  return {
    name: 'labels',
    stage: 'field',
    defines: {
      LABELS_3D: Number(texture3d),
      LABEL_TWO_BYTES: Number(twoBytes),
      LABELS_HIDE: Number(hides),
      LABELS_ACROSS: labelsAcross.toFixed(1),
      ...(hides && { NO_DATA: 1 }),
    },
    chunks: [vote, texture3d ? labels3d : labelsMosaic, labels],
    samplers: ['uLabels', 'uLabelTable'],
    members: ['vec4 look', ...(groups ? ['float group'] : [])],
  };
}

/** @param hides - as in `LabelOptions` */
export const labelsTwin = (labels: ShownLabels, hides: boolean): RayTwin =>
  twinOf(usualTwins, ({ labelField }) => ({ moreFields: [labelField(labels, hides)] }));
