import { keepColors } from '../../volume/channels.ts';
import { cartesianGrid } from '../../volume/grid.ts';
import { chooseReduction, reduceVolume } from '../../volume/reduce.ts';
import type { Block, DeviceLimits } from '../../volume/reduce.ts';
import type { Samples } from '../../volume/samples.ts';
import { colorSliceStops } from '../../volume/slice-stops.ts';
import { isSingleSlice } from '../../volume/volume.ts';
import { hasColors } from './channels.ts';
import type { DecodedCartesianVolume, FileColors } from './decoded-volume.ts';

/** Bytes on the GPU of the brightness and of the colours of a voxel. */
const bytesOnDevice = 5;

/** The opacity of a reference length of white. */
const opacityOfWhite = 0.2;

/**
 * Makes a volume in colours fit the device. Where all of them are grays, these are a volume as any other.
 * @returns without `colors`
 */
export function fitColors(
  { colors, ...decoded }: DecodedCartesianVolume,
  limits: DeviceLimits,
): DecodedCartesianVolume {
  if (!colors) return decoded;
  const { grid, samples } = decoded;
  const { rgb, range } = colors;
  // Also where it is dark: what has colours is made for a screen. Of numbers of 16 bits not all may be in use.
  const isOfScreen = isSingleSlice(grid) && range[1] - range[0] === 0xff;
  if (!hasColors(rgb, 3)) return isOfScreen ? { ...decoded, window: decoded.window ?? range } : decoded;
  const factors = chooseReduction(
    { ...grid, samples: new Uint8Array(0) },
    { ...limits, maxBytes: limits.maxBytes / bytesOnDevice },
  );
  const isSmaller = factors.some((factor) => factor > 1);
  const fit = (all: Samples): Block => {
    const block = { ...grid, samples: all };
    return isSmaller ? reduceVolume(block, factors) : block;
  };
  const fitted = fit(samples);
  return {
    ...decoded,
    grid: cartesianGrid(fitted.dimensions, fitted.indexToWorld),
    samples: fitted.samples,
    counts: isSmaller ? undefined : decoded.counts,
    channels: keepColors(splitPlanes(rgb).map((plane) => fit(plane).samples as Uint8Array<ArrayBuffer>)),
    window: decoded.window ?? range,
    transferFunction: decoded.transferFunction ?? (isSingleSlice(grid) ? colorSliceStops : opacities(range)),
    ...(isSmaller && { reduced: { from: grid.dimensions, to: fitted.dimensions } }),
  };
}

function splitPlanes(rgb: Uint8Array): Uint8Array<ArrayBuffer>[] {
  const planes = [0, 1, 2].map(() => new Uint8Array(rgb.length / 3));
  for (let i = 0, at = 0; at < rgb.length; i++, at += 3) for (let c = 0; c < 3; c++) planes[c][i] = rgb[at + c];
  return planes;
}

/** White, so that the colours stay, and more opaque the brighter: its extinction is proportional to the brightness. */
function opacities([black, white]: FileColors['range']): string {
  const steps = 4;
  return Array.from({ length: steps + 1 }, (_, step) => {
    const share = step / steps;
    return `${black + share * (white - black)} white ${Number((1 - (1 - opacityOfWhite) ** share).toPrecision(6))}`;
  }).join(', ');
}
