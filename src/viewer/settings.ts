import type { VolumeViewError } from '../errors.ts';
import type { ScanTarget } from '../formats/choose-scan.ts';
import type { LoadRequest } from '../formats/load.ts';
import { maxSteps } from '../renderer/ray/compose-ray.ts';
import type { CameraAttributes } from './camera-rig.ts';
import { asVolumeViewError } from './internal-error.ts';
import * as parse from './parse-attributes.ts';
import { defaultTargets } from './quality-control.ts';
import type { QualityTargets } from './quality-control.ts';

/** The attributes of a view, by property: texts as they stand in HTML, null where absent. */
export type GivenAttributes = Readonly<Record<AttributeName, string | null>>;

type AttributeName =
  | 'src' | 'stack' | 'mosaic' | 'slices' | 'spacing' | 'coordinates' | 'elevations' | 'range' | 'azimuth' | 'moment' | 'beamModel' | 'verticalExaggeration'
  | 'time' | 'autoplay' | 'playSpeed'
  | 'transferFunction' | 'valueWindow' | 'referenceLength' | 'opacityFactor' | 'lightFactor'
  | 'steps' | 'maxError' | 'targetFps' | 'region' | 'rings'
  | 'cameraOrbit' | 'cameraTarget' | 'fieldOfView' | 'interaction' | 'loading';

/** What some attributes say together, or why they can't be read. */
export type Reading<T> = { readonly value: T; readonly error?: undefined } | { readonly error: VolumeViewError; readonly value?: undefined };

/** How the file is to be read. What is undefined follows from the file. */
export type SourceSettings = Omit<LoadRequest, 'url' | 'scan' | 'limits'>;

/** What the values look like. What is null follows from the volume. */
export interface LookSettings {
  /** A preset's name, or stops, as an author writes them. */
  readonly transferFunction: string | null;
  readonly window: readonly [number, number] | null;
  readonly referenceLength: number | null;
  readonly opacityFactor: number;
  readonly lightFactor: number;
}

/** All that an author says of a view, read once. Nothing of the viewer writes it. */
export interface Settings {
  /** One URL, or several, separated by blanks. */
  readonly src: string | null;
  /** Whether several URLs are the files of one volume. */
  readonly stack: boolean;
  readonly source: Reading<SourceSettings>;
  readonly time: Reading<ScanTarget>;
  readonly autoplay: boolean;
  /** Scans a second. */
  readonly playSpeed: Reading<number>;
  readonly look: Reading<LookSettings>;
  readonly camera: Reading<CameraAttributes>;
  readonly quality: Reading<QualityTargets>;
  /** Two corners of a box; null for all. */
  readonly region: Reading<readonly number[] | null>;
  /** Kilometres from ring to ring; null for none. */
  readonly rings: Reading<number | 'auto' | null>;
  /** Whether mouse, finger and keys move the camera. */
  readonly controls: boolean;
  /** Whether it loads however far away it is. */
  readonly eager: boolean;
}

/** Scans a second. */
export const defaultPlaySpeed = 2;

export const plainLook: LookSettings = { transferFunction: null, window: null, referenceLength: null, opacityFactor: 1, lightFactor: 1 };

/** Read all attributes. Those that can't be read are errors in their places, and leave the others alone. */
export function readSettings(given: GivenAttributes): Settings {
  return {
    src: given.src,
    stack: given.stack !== null,
    source: read('mosaic, spacing and other attributes of the source', () => readSource(given)),
    time: read('time', () => readTime(given.time)),
    autoplay: given.autoplay !== null,
    playSpeed: read('play-speed', () => given.playSpeed === null ? defaultPlaySpeed : parse.parseLength('play-speed', given.playSpeed)),
    look: read('value-window and other attributes of the look', () => readLook(given)),
    camera: read('camera-orbit, camera-target and field-of-view', () => readCamera(given)),
    quality: read('steps, max-error and target-fps', () => readQuality(given)),
    region: read('region', () => given.region === null ? null : parse.parseRegion(given.region)),
    rings: read('rings', () => given.rings === null ? null : parse.parseRings(given.rings)),
    controls: readControls(given.interaction),
    eager: wordOf(given.loading) === 'eager',
  };
}

/** Whether mouse, fingers and keys move the camera. */
export function readControls(interaction: string | null): boolean {
  return wordOf(interaction) !== 'none';
}

/** Whether two readings say the same. */
export function isSameReading(a: Reading<unknown>, b: Reading<unknown>): boolean {
  return a.error?.message === b.error?.message && JSON.stringify(a.value) === JSON.stringify(b.value);
}

/** @param names - what is read, for an error that nobody expects */
function read<T>(names: string, parseAll: () => T): Reading<T> {
  try {
    return { value: parseAll() };
  } catch (error) {
    return { error: asVolumeViewError(error, names) };
  }
}

function readSource(given: GivenAttributes): SourceSettings {
  const { mosaic, slices, spacing, coordinates, elevations, range, azimuth, moment, beamModel, verticalExaggeration } = given;
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

function readTime(time: string | null): ScanTarget {
  return time === null || wordOf(time) === '' ? { index: 0 } : parse.parseTime(time);
}

function readLook({ transferFunction, valueWindow, referenceLength, opacityFactor, lightFactor }: GivenAttributes): LookSettings {
  return {
    transferFunction,
    window: valueWindow === null ? null : parse.parseWindow(valueWindow),
    referenceLength: referenceLength === null ? null : parse.parseLength('reference-length', referenceLength),
    opacityFactor: opacityFactor === null ? 1 : parse.parseFactor('opacity-factor', opacityFactor),
    lightFactor: lightFactor === null ? 1 : parse.parseFactor('light-factor', lightFactor),
  };
}

function readCamera({ cameraOrbit: orbit, cameraTarget: target, fieldOfView }: GivenAttributes): CameraAttributes {
  return {
    ...(orbit === null || wordOf(orbit) === '' ? {} : parse.parseOrbit(orbit)),
    target: target === null ? undefined : parse.parseTarget(target),
    fieldOfView: fieldOfView === null ? undefined : parse.parseFieldOfView(fieldOfView),
  };
}

function readQuality({ steps, maxError, targetFps }: GivenAttributes): QualityTargets {
  return {
    steps: steps === null ? defaultTargets.steps : parse.parseSteps(steps, maxSteps),
    maxError: maxError === null ? defaultTargets.maxError : parse.parseLength('max-error', maxError),
    targetFps: targetFps === null ? defaultTargets.targetFps : parse.parseLength('target-fps', targetFps),
  };
}

function wordOf(text: string | null): string | undefined {
  return text?.trim().toLowerCase();
}
