import type { ScanTarget } from '../../formats/base/choose-scan.ts';
import type { LocalFiles } from '../../formats/base/load-request.ts';
import { projectionKinds, shadings } from '../../optics/rays/ray-style.ts';
import type { ProjectionKind, Shading } from '../../optics/rays/ray-style.ts';
import { maxSteps } from '../../renderer/ray/compose-ray.ts';
import { defaultLimits } from './camera-attributes.ts';
import type { CameraAttributes, CameraLimits } from './camera-attributes.ts';
import { pickSource } from './given-source.ts';
import type { GivenSource, SourceName } from './given-source.ts';
import * as parse from './parse-attributes.ts';
import type { RingSetting, WindowSetting } from './parse-attributes.ts';
import { defaultTargets } from './quality-targets.ts';
import type { QualityTargets } from './quality-targets.ts';

/** The attributes of a view, by property: their texts as the HTML has them, null where an attribute is absent. */
export type GivenAttributes = Readonly<Record<AttributeName, string | null>>;

type AttributeName =
  | 'src'
  | 'stack'
  | SourceName
  | 'time'
  | 'autoplay'
  | 'playSpeed'
  | 'look'
  | 'transferFunction'
  | 'valueWindow'
  | 'referenceLength'
  | 'opacityFactor'
  | 'lightFactor'
  | 'projection'
  | 'shading'
  | 'surfaceValues'
  | 'gradientOpacity'
  | 'transferFunction2d'
  | 'steps'
  | 'maxError'
  | 'detail'
  | 'targetFps'
  | 'rings'
  | 'cameraOrbit'
  | 'cameraTarget'
  | 'fieldOfView'
  | 'minCameraOrbit'
  | 'maxCameraOrbit'
  | 'interpolationDecay'
  | 'interaction'
  | 'loading';

/** The value of some attributes together, or the error of reading them: a VolumeViewError, or another error if our code has a mistake. */
export type Reading<T> =
  | { readonly value: T; readonly error?: undefined }
  | { readonly error: Error; readonly value?: undefined };

/** The appearance of the values. The viewer derives from the volume what is null. */
export interface AppearanceSettings {
  /** Name of a ready-made appearance, for all that the other attributes leave open; null for none. */
  readonly named: string | null;
  /** A preset's name, or stops, as the author writes them. */
  readonly transferFunction: string | null;
  readonly window: WindowSetting | null;
  readonly referenceLength: number | null;
  /** null where the author gives none: then 1, unless `named` gives another factor. */
  readonly opacityFactor: number | null;
  readonly lightFactor: number;
  /** null for emission and absorption. */
  readonly projection: ProjectionKind | null;
  /** null where the author gives none: then only surfaces of values are lit. */
  readonly shading: Shading | null;
  /** Surfaces, as the author writes them; null for none. */
  readonly surfaces: string | null;
  /** Factors by gradient, as the author writes them; null for none. */
  readonly gradientOpacity: string | null;
  /** Boxes and Gaussians of value and gradient, as the author writes them; null for none. */
  readonly transferFunction2d: string | null;
}

/** All that an author's attributes say about a view, read once. The viewer never changes it. */
export interface Settings {
  /** One URL, or several, separated by blanks. */
  readonly src: string | null;
  /** Files of the reader's disk, which `src` is the base of. */
  readonly local: LocalFiles | undefined;
  /** Whether several URLs are the files of one volume. */
  readonly stack: boolean;
  /** How to read the file, as the author gives it: it is parsed together with the file. null where the author gives nothing. */
  readonly source: GivenSource | null;
  readonly time: Reading<ScanTarget>;
  readonly autoplay: boolean;
  /** Scans a second. */
  readonly playSpeed: Reading<number>;
  readonly look: Reading<AppearanceSettings>;
  readonly camera: Reading<CameraAttributes>;
  readonly limits: Reading<CameraLimits>;
  readonly quality: Reading<QualityTargets>;
  /** Two corners of a box; null for the whole volume. */
  readonly region: Reading<readonly number[] | null>;
  /** Kilometres from ring to ring; null where the author gives none. */
  readonly rings: Reading<RingSetting | null>;
  /** Whether mouse, finger and keys move the camera. */
  readonly controls: boolean;
  /** Whether the view loads its volume even when it is far from the visible part of the page. */
  readonly eager: boolean;
}

/** Scans a second. */
export const defaultPlaySpeed = 2;

/** Of a chosen file; a page may give anything. */
const nameOf = (file: unknown): unknown => (file as File | null | undefined)?.name;

/** Read all attributes. If one can't be read, its error is in its own place, and the others are still read. */
export function readSettings(given: GivenAttributes, local?: LocalFiles): Settings {
  return {
    src: local ? local.base : given.src,
    local,
    stack: given.stack !== null,
    // Of a Zarr only the region is read: files of it have these letters in their names. Others with them are read again for a new region, which costs time only.
    source: pickSource(
      /zarr|ozx/.test(String(local ? local.files.map(nameOf) : given.src)) ? given : { ...given, region: null },
    ),
    time: read(() => readTime(given.time)),
    autoplay: given.autoplay !== null,
    playSpeed: read(() =>
      given.playSpeed === null ? defaultPlaySpeed : parse.parseLength('play-speed', given.playSpeed),
    ),
    look: read(() => readAppearance(given)),
    camera: read(() => readCamera(given)),
    limits: read(() => readLimits(given)),
    quality: read(() => readQuality(given)),
    region: read(() => (given.region === null ? null : parse.parseRegion(given.region))),
    rings: read(() => (given.rings === null ? null : parse.parseRings(given.rings))),
    controls: readControls(given.interaction),
    eager: wordOf(given.loading) === 'eager',
  };
}

/** Whether mouse, fingers and keys move the camera. */
export function readControls(interaction: string | null): boolean {
  return wordOf(interaction) !== 'none';
}

/** Whether two readings have the same value or the same error. */
export function isSameReading(a: Reading<unknown>, b: Reading<unknown>): boolean {
  return a.error?.message === b.error?.message && JSON.stringify(a.value) === JSON.stringify(b.value);
}

function read<T>(parseAll: () => T): Reading<T> {
  try {
    return { value: parseAll() };
  } catch (error) {
    return { error: error as Error };
  }
}

function readTime(time: string | null): ScanTarget {
  return time === null || wordOf(time) === '' ? { index: 0 } : parse.parseTime(time);
}

function readAppearance({
  look: appearance,
  transferFunction,
  valueWindow,
  referenceLength,
  opacityFactor,
  lightFactor,
  projection,
  shading,
  surfaceValues,
  gradientOpacity,
  transferFunction2d,
}: GivenAttributes): AppearanceSettings {
  return {
    named: appearance?.trim() ? appearance : null,
    transferFunction,
    window: valueWindow === null ? null : parse.parseWindow(valueWindow),
    referenceLength: referenceLength === null ? null : parse.parseLength('reference-length', referenceLength),
    opacityFactor: opacityFactor === null ? null : parse.parseFactor('opacity-factor', opacityFactor),
    lightFactor: lightFactor === null ? 1 : parse.parseFactor('light-factor', lightFactor),
    projection: readWord('projection', projection, projectionKinds),
    shading: readWord('shading', shading, shadings),
    surfaces: surfaceValues,
    gradientOpacity,
    transferFunction2d,
  };
}

function readWord<T extends string>(name: string, text: string | null, words: readonly T[]): T | null {
  return text === null || wordOf(text) === '' ? null : parse.parseWord(name, text, words);
}

function readCamera({ cameraOrbit: orbit, cameraTarget: target, fieldOfView }: GivenAttributes): CameraAttributes {
  return {
    ...(orbit === null || wordOf(orbit) === '' ? {} : parse.parseOrbit(orbit)),
    target: target === null ? undefined : parse.parseTarget(target),
    fieldOfView: fieldOfView === null ? undefined : parse.parseFieldOfView(fieldOfView),
  };
}

function readLimits({ minCameraOrbit, maxCameraOrbit, interpolationDecay: decay }: GivenAttributes): CameraLimits {
  return {
    ...parse.parseLimits(minCameraOrbit, maxCameraOrbit),
    decay: decay === null ? defaultLimits.decay : parse.parseFactor('interpolation-decay', decay),
  };
}

function readQuality({ steps, maxError, detail, targetFps }: GivenAttributes): QualityTargets {
  return {
    steps: steps === null ? defaultTargets.steps : parse.parseSteps(steps, maxSteps),
    maxError: maxError === null ? defaultTargets.maxError : parse.parseLength('max-error', maxError),
    isFree: readWord('detail', detail, ['keep', 'free']) === 'free',
    targetFps: targetFps === null ? defaultTargets.targetFps : parse.parseLength('target-fps', targetFps),
  };
}

function wordOf(text: string | null): string | undefined {
  return text?.trim().toLowerCase();
}
