import { VolumeViewError } from '../../core/errors.ts';
import { overlayBlends } from '../../optics/attachments/overlay.ts';
import type { OverlayBlend } from '../../optics/attachments/overlay.ts';
import { resolveTransferFunction } from '../../optics/transfer/resolve-transfer-function.ts';
import type { TransferFunction } from '../../optics/transfer/transfer-function.ts';
import { colorSliceStops, isGraySlice } from '../../volume/slice-stops.ts';
import type { Volume } from '../../volume/volume.ts';
import { findWindow } from './find-window.ts';
import { parseFactor, parseWindow, parseWord } from '../model/parse-attributes.ts';

/** What an author says of a layer's appearance: texts as the HTML has them, null where absent. */
export interface OverlayAttributes {
  readonly transferFunction: string | null;
  readonly valueWindow: string | null;
  readonly blend: string | null;
  readonly opacityFactor: string | null;
}

/** The appearance of a layer. */
export interface OverlayAppearance {
  readonly transferFunction: TransferFunction;
  /** Data values that presets and percentages span. */
  readonly window: readonly [number, number];
  readonly blend: OverlayBlend;
  readonly opacityFactor: number;
}

/** For values of one sign, such as the uptake in a PET: small values are clear, large ones glow. */
const glow = '0% #200404 0, 20% #5c0808 0, 45% #c82808 5%, 70% #fc8c14 16%, 100% #fff4b8 34%';

/** For values of both signs, such as t: values near 0 are clear, so that the volume below stays visible. */
const bothSigns =
  '0% #d8f6ff 60%, 22% #3f9cf0 35%, 32% #1c50b8 14%, 38% #163a80 0, 62% #7a1a10 0, 68% #c83018 14%, 78% #f8702c 35%, 100% #fff2a0 60%';

/** @throws {VolumeViewError} `attribute/invalid`, `transfer-function/syntax`, `format/unsupported` */
export async function resolveOverlayAppearance(
  { transferFunction, valueWindow, blend, opacityFactor }: OverlayAttributes,
  volume: Volume,
): Promise<OverlayAppearance> {
  if (volume.isDiscrete && transferFunction === null) {
    throw new VolumeViewError(
      'format/unsupported',
      '<volume-layer> got labels, whole numbers that stand for things; expected measured values. Use <volume-labels>, or say with transfer-function what these values look like.',
    );
  }
  const own = volume.transferFunction;
  // A picture of one slice would hide what is below it.
  const isPicture = isGraySlice(own) || own === colorSliceStops;
  const suggested = own === 'diverging' ? bothSigns : own === undefined || isPicture ? glow : own;
  const window =
    (valueWindow === null ? null : findWindow(parseWindow(valueWindow), volume)) ?? volume.window ?? volume.range;
  return {
    transferFunction: await resolveTransferFunction(transferFunction ?? suggested, window),
    window,
    blend: blend === null ? 'mix' : parseWord('blend', blend, overlayBlends),
    opacityFactor: opacityFactor === null ? 1 : parseFactor('opacity-factor', opacityFactor),
  };
}
