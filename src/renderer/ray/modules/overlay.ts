import depths from '../../../../shaders/chunks/depth/depths.glsl?raw';
import overlay from '../../../../shaders/chunks/attachments/overlay.glsl?raw';
import overlay3d from '../../../../shaders/chunks/attachments/overlay-3d.glsl?raw';
import overlayCartesian from '../../../../shaders/chunks/attachments/overlay-cartesian.glsl?raw';
import overlayField from '../../../../shaders/chunks/attachments/overlay-field.glsl?raw';
import overlayGrid from '../../../../shaders/chunks/attachments/overlay-grid.glsl?raw';
import overlayMosaic from '../../../../shaders/chunks/attachments/overlay-mosaic.glsl?raw';
import overlayPolar from '../../../../shaders/chunks/attachments/overlay-polar.glsl?raw';
import polarFolds from '../../../../shaders/chunks/radar/polar-folds.glsl?raw';
import { deepest, edgeSlack } from '../../../optics/attachments/overlay.ts';
import type { ShownOverlay } from '../../../optics/attachments/overlay.ts';
import type { FieldStage } from '../../../optics/rays/ray-stages.ts';
import type { RayText, RayTwin } from '../ray-module.ts';
import { partOf } from '../part-of-twins.ts';
import { usualTwins } from '../ray-twin.ts';
import type { Later } from '../ray-twin.ts';

/** No share of a layer's domain is smaller than this; a smaller value means no data. */
const minShare = '-1.0e18';

/** How a layer's samples are stored on the GPU and how shaders read them. */
export interface OverlayOptions {
  /** True: in a 3D texture (WebGL 2 only); false: as a mosaic in a 2D texture. */
  readonly texture3d: boolean;
  /** 16-bit samples in two 8-bit channels. */
  readonly twoBytes: boolean;
  /** The device's filter interpolates. */
  readonly filter: boolean;
  /** The filter interpolates floats of which some have no data, see `weighTexels`. */
  readonly holes: boolean;
}

/** The text that finds the value of a layer with its own grid at a place. */
export function overlayText({ texture3d, twoBytes, filter, holes }: OverlayOptions): RayText {
  return {
    name: 'overlay',
    stage: 'field',
    defines: {
      OVERLAY_3D: Number(texture3d),
      OVERLAY_TWO_BYTES: Number(twoBytes),
      OVERLAY_FILTER: Number(filter),
      OVERLAY_HOLES: Number(holes),
      OVERLAY_SLACK: edgeSlack,
      MIN_OVERLAY: minShare,
    },
    chunks: [overlayGrid, texture3d ? overlay3d : overlayMosaic, overlayCartesian, overlayField],
    samplers: ['uOverlay'],
    members: ['float overlay'],
  };
}

/** The same for another moment of a radar: its gates are stored and fetched together with those of the volume. */
export function secondMomentText(folds: boolean): RayText {
  return {
    name: 'overlay',
    stage: 'field',
    defines: { SECOND_MOMENT: 1, OVERLAY_FOLDS: Number(folds), MIN_OVERLAY: minShare },
    chunks: [...(folds ? [polarFolds] : []), overlayPolar, overlayField],
    samplers: ['uOverlay'],
    members: ['float overlay'],
  };
}

/** How a layer changes the picture. */
export interface OverlayLookOptions {
  /** True: the layer colours the volume; false: it is a medium that emits and absorbs. */
  readonly color: boolean;
  /** The device filters floats. */
  readonly tableFilter: boolean;
  /** Its values fold, as velocities do. */
  readonly folds: boolean;
}

export function overlayAppearanceText({ color, tableFilter, folds }: OverlayLookOptions): RayText {
  return {
    name: 'overlayAppearance',
    stage: 'shade',
    defines: {
      OVERLAY_COLOR: Number(color),
      OVERLAY_TABLE_FILTER: Number(tableFilter),
      OVERLAY_FOLDS: Number(folds),
      OVERLAY_DEEPEST: deepest.toFixed(1),
    },
    chunks: [depths, overlay],
    samplers: ['uOverlayTable'],
  };
}

/** A layer's field in float64, as a function of places in the volume's unit cube. */
type OverlayField = (overlay: ShownOverlay) => FieldStage;

const onOwnGrid: Later<OverlayField> = partOf(usualTwins, ({ cartesianOverlay }) => cartesianOverlay);

/** A layer's two modules in float64. */
export interface OverlayTwins {
  readonly field: RayTwin;
  readonly look: RayTwin;
}

/** @param field - for a layer that has no cartesian grid of its own */
export function overlayTwins(overlay: ShownOverlay, field = onOwnGrid): OverlayTwins {
  const load = (): Promise<unknown> => Promise.all([usualTwins.load(), field.load()]);
  return {
    field: { load, parts: () => ({ moreFields: [usualTwins.code.overlayField(field.code(overlay))] }) },
    look: {
      load,
      parts: ({ optics, rays }) => ({
        shades: usualTwins.code.overlayStages(overlay, field.code(overlay), { optics, diameter: rays.diameter }).shades,
      }),
    },
  };
}
