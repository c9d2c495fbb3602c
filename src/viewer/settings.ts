import { VolumeViewError } from '../errors.ts';
import type { ScanTarget } from '../formats/choose-scan.ts';
import type { LoadRequest } from '../formats/load.ts';
import { defaultPreset, resolveTransferFunction } from '../optics/presets.ts';
import { windowFromHistogram } from '../optics/window.ts';
import { maxSteps } from '../renderer/ray/compose-ray.ts';
import { edgeLengths } from '../volume/grid.ts';
import type { Histogram } from '../volume/histogram.ts';
import type { CameraAttributes } from './camera-rig.ts';
import * as parse from './parse-attributes.ts';
import type { PlaySettings } from './scan-player.ts';
import type { ScanModel } from './scan-model.ts';
import { defaultTargets } from './quality-control.ts';
import type { QualityTargets } from './quality-control.ts';
import type { VolumeOptics } from './volume-info.ts';

/** Attributes that say how the file is to be read, as an author wrote them; null where absent. */
export const sourceAttributes = ['mosaic', 'slices', 'spacing', 'coordinates', 'elevations', 'range', 'azimuth', 'moment', 'beamModel', 'verticalExaggeration'] as const;

/** Scans a second. */
const defaultPlaySpeed = 2;

export type SourceAttributes = Readonly<Record<(typeof sourceAttributes)[number], string | null>>;

/** Attributes that say what the values look like. */
export interface OpticsAttributes {
  readonly transferFunction: string | null;
  readonly window: string | null;
  readonly referenceLength: string | null;
  readonly opacityFactor: string | null;
  readonly lightFactor: string | null;
}

/** @throws {VolumeViewError} `attribute/invalid` */
export function readSource(attributes: SourceAttributes): Omit<LoadRequest, 'url' | 'scan' | 'limits'> {
  const { mosaic, slices, spacing, coordinates, elevations, range, azimuth, moment, beamModel, verticalExaggeration } = attributes;
  return {
    spherical: coordinates === null ? undefined : parse.parseWord('coordinates', coordinates, ['cartesian', 'spherical']) === 'spherical',
    elevations: elevations === null ? undefined : parse.parseElevations(elevations),
    range: range === null ? undefined : parse.parsePair('range', range, 'metres to the first gate and from gate to gate, like "250 500"'),
    azimuth: azimuth === null ? undefined : parse.parsePair('azimuth', azimuth, 'degrees of the first ray and from ray to ray, like "0.5 1"'),
    moment: moment?.trim() || undefined,
    beamModel: beamModel === null ? undefined : parse.parseWord('beam-model', beamModel, ['standard', 'straight']),
    verticalExaggeration: verticalExaggeration === null ? undefined : parse.parseLength('vertical-exaggeration', verticalExaggeration),
    mosaic: mosaic === null ? undefined : parse.parseMosaic(mosaic),
    slices: slices === null ? undefined : parse.parseCount('slices', slices),
    spacing: spacing === null ? undefined : parse.parseSpacing(spacing),
  };
}

/**
 * What a volume looks like: the attributes, else what its file says, else what its histogram suggests.
 * @throws {VolumeViewError} `attribute/invalid` or `transfer-function/syntax`
 */
export async function readOptics(attributes: OpticsAttributes, volume: ScanModel): Promise<VolumeOptics> {
  const window =
    attributes.window === null
      ? (volume.window ?? suggestWindow(volume))
      : parse.parseWindow(attributes.window);
  const text = attributes.transferFunction ?? volume.transferFunction ?? suggestPreset(volume);
  return {
    transferFunction: await resolveTransferFunction(text, window),
    window,
    referenceLength:
      attributes.referenceLength === null
        ? Math.max(...edgeLengths(volume.grid)) / 100
        : parse.parseLength('reference-length', attributes.referenceLength),
    opacityFactor: readFactor('opacity-factor', attributes.opacityFactor),
    lightFactor: readFactor('light-factor', attributes.lightFactor),
  };
}

/** @throws {VolumeViewError} `attribute/invalid` */
export function readCamera(orbit: string | null, target: string | null, fieldOfView: string | null): CameraAttributes {
  return {
    ...(orbit === null || orbit.trim() === '' ? {} : parse.parseOrbit(orbit)),
    target: target === null ? undefined : parse.parseTarget(target),
    fieldOfView: fieldOfView === null ? undefined : parse.parseFieldOfView(fieldOfView),
  };
}

/** @throws {VolumeViewError} `attribute/invalid` */
export function readQuality(steps: string | null, maxError: string | null, targetFps: string | null): QualityTargets {
  return {
    steps: steps === null ? defaultTargets.steps : parse.parseSteps(steps, maxSteps),
    maxError: maxError === null ? defaultTargets.maxError : parse.parseLength('max-error', maxError),
    targetFps: targetFps === null ? defaultTargets.targetFps : parse.parseLength('target-fps', targetFps),
  };
}

/**
 * Which of several scans is wanted.
 * @throws {VolumeViewError} `attribute/invalid`
 */
export function readTime(time: string | null): ScanTarget {
  return time === null || time.trim() === '' ? { index: 0 } : parse.parseTime(time);
}

/** @throws {VolumeViewError} `attribute/invalid` */
export function readPlay(on: boolean, speed: string | null): PlaySettings {
  return { on, speed: speed === null ? defaultPlaySpeed : parse.parseLength('play-speed', speed) };
}

/** Whatever was thrown, as an error that a page can be told of. */
export function toVolumeViewError(error: unknown): VolumeViewError {
  if (error instanceof VolumeViewError) return error;
  return new VolumeViewError('format/corrupt', 'The volume could not be shown for a reason that is not the page\'s fault. Please report it, with the file.', { cause: error });
}

function readFactor(name: string, text: string | null): number {
  return text === null ? 1 : parse.parseFactor(name, text);
}

/** Velocities lie around 0, other moments of a radar anywhere; elsewhere the background is left out. */
function suggestWindow({ grid, unit, range, histogram }: ScanModel): [number, number] {
  if (grid.kind !== 'polar' || !(range[1] > range[0])) return windowFromHistogram(histogram);
  const fastest = Math.max(...range.map(Math.abs));
  return unit === 'm/s' ? [-fastest, fastest] : [...range];
}

/** Some units have a scale that everybody knows. */
function suggestPreset({ grid, unit, histogram }: ScanModel): string {
  if (grid.kind !== 'polar') return { dBZ: 'radar-dbz', HU: 'ct-bone' }[unit] ?? defaultPreset;
  if (unit === 'm/s') return 'radar-velocity';
  return unit === 'dBZ' && !isCloud(histogram) ? 'radar-dbz' : 'turbo';
}

/** What a weather radar's scale begins with, dBZ. */
const minRain = 5;

/** A cloud radar's reflectivities lie below those of rain: on the scale of that there would be nothing to be seen. */
function isCloud({ low, high, counts }: Histogram): boolean {
  const first = Math.ceil(((minRain - low) / (high - low)) * counts.length);
  const sum = (values: Uint32Array): number => values.reduce((total, count) => total + count, 0);
  return sum(counts.subarray(Math.max(0, first))) < 0.05 * sum(counts);
}
