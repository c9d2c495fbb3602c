import { keepColors } from '../../volume/channels.ts';
import { cartesianGrid } from '../../volume/grid.ts';
import { chooseReduction, reduceVolume } from '../../volume/reduce.ts';
import type { DeviceLimits } from '../../volume/reduce.ts';
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
  if (!colors || !hasColors(colors.rgb, 3)) return decoded;
  const { grid, samples } = decoded;
  const { rgb, range } = colors;
  const factors = chooseReduction(
    { ...grid, samples: new Uint8Array(0) },
    { ...limits, maxBytes: limits.maxBytes / bytesOnDevice },
  );
  const isSmaller = factors.some((factor) => factor > 1);
  const fit = <S extends typeof samples>(all: S): S =>
    isSmaller ? (reduceVolume({ ...grid, samples: all }, factors).samples as S) : all;
  const fitted = isSmaller ? reduceVolume({ ...grid, samples }, factors) : { ...grid, samples };
  return {
    ...decoded,
    grid: cartesianGrid(fitted.dimensions, fitted.indexToWorld),
    samples: fitted.samples,
    counts: isSmaller ? undefined : decoded.counts,
    channels: keepColors(isSmaller ? joinPlanes(splitPlanes(rgb).map(fit)) : rgb),
    window: decoded.window ?? range,
    transferFunction: decoded.transferFunction ?? opacities(range),
    ...(isSmaller && { reduced: { from: grid.dimensions, to: fitted.dimensions } }),
  };
}

const splitPlanes = (rgb: Uint8Array): Uint8Array<ArrayBuffer>[] =>
  [0, 1, 2].map((c) => Uint8Array.from({ length: rgb.length / 3 }, (_, i) => rgb[3 * i + c]));

function joinPlanes(planes: readonly Uint8Array[]): Uint8Array<ArrayBuffer> {
  const rgb = new Uint8Array(3 * planes[0].length);
  for (let at = 0; at < rgb.length; at++) rgb[at] = planes[at % 3][Math.floor(at / 3)];
  return rgb;
}

/** White, so that the colours stay, and more opaque the brighter: its extinction is proportional to the brightness. */
function opacities([black, white]: FileColors['range']): string {
  const steps = 4;
  return Array.from({ length: steps + 1 }, (_, step) => {
    const share = step / steps;
    return `${black + share * (white - black)} white ${Number((1 - (1 - opacityOfWhite) ** share).toPrecision(6))}`;
  }).join(', ');
}
