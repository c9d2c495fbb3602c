import type { SourceSettings } from '../../formats/base/source-settings.ts';
import type { Vector3 } from '../../volume/matrix.ts';
import { parseMosaicSize } from '../../volume/mosaic-size.ts';
import { longest } from '../../volume/grid-limits.ts';
import type { GivenSource } from '../model/given-source.ts';
import {
  invalid,
  isNumber,
  parseLength,
  parseNumbers,
  parseRegion,
  parseWord,
  split,
} from '../model/parse-attributes.ts';

/** Metres and degrees above this can't belong to a radar. */
const farthest = 1e9;

/** The number of sweeps that a radar file may have. */
const maxSweeps = 4096;

/** @throws {VolumeViewError} `attribute/invalid` */
export function readSource(given: GivenSource): SourceSettings {
  const {
    mosaic,
    slices,
    spacing,
    coordinates,
    elevations,
    range,
    azimuth,
    moment,
    beamModel,
    verticalExaggeration,
    clean,
    series,
    region,
    maxBytes,
    maxGpuBytes,
    crossOrigin,
  } = given;
  return {
    spherical:
      coordinates === null
        ? undefined
        : parseWord('coordinates', coordinates, ['cartesian', 'spherical']) === 'spherical',
    elevations: elevations === null ? undefined : parseElevations(elevations),
    range:
      range === null
        ? undefined
        : parsePair('range', range, 'metres to the first gate and from gate to gate, like "250 500"'),
    azimuth:
      azimuth === null
        ? undefined
        : parsePair('azimuth', azimuth, 'degrees of the first ray and from ray to ray, like "0.5 1"'),
    moment: moment === null ? undefined : parseName('moment', moment),
    beamModel: beamModel === null ? undefined : parseWord('beam-model', beamModel, ['standard', 'straight']),
    verticalExaggeration:
      verticalExaggeration === null ? undefined : parseLength('vertical-exaggeration', verticalExaggeration),
    mosaic: mosaic === null ? undefined : parseMosaic(mosaic),
    slices: slices === null ? undefined : parseCount('slices', slices),
    spacing: spacing === null ? undefined : parseSpacing(spacing),
    clean: clean === null ? undefined : parseClean(clean),
    series: series === null ? undefined : parseCount('series', series),
    region: region === null ? undefined : (parseRegion(region) ?? undefined),
    maxBytes: maxBytes === null ? undefined : parseLength('max-bytes', maxBytes),
    maxGpuBytes: maxGpuBytes === null ? undefined : parseLength('max-gpu-bytes', maxGpuBytes),
    credentials: sendsCookies(crossOrigin) ? 'include' : undefined,
  };
}

/** As `crossorigin` of `<img>`, but a word that is none of its is an error. */
function sendsCookies(text: string | null): boolean {
  const words = ['anonymous', 'use-credentials'] as const;
  return text !== null && text.trim() !== '' && parseWord('crossorigin', text, words) === 'use-credentials';
}

/** `x y z`, none zero; a negative one reverses its axis, for instance for slices that run from head to feet. */
function parseSpacing(text: string): Vector3 {
  const spacing = parseNumbers('spacing', text, 3);
  if (!spacing.every((s) => Math.abs(s) >= 1 / longest && Math.abs(s) <= longest))
    throw invalid('spacing', text, 'three lengths that are not zero');
  return spacing as unknown as Vector3;
}

/** Empty for `auto`, a value, or `none` for no cleaning. */
function parseClean(text: string): number | 'auto' | undefined {
  const word = text.trim().toLowerCase();
  if (word === '') return 'auto';
  if (word === 'none') return undefined;
  if (!isNumber(word))
    throw invalid('clean', text, 'nothing, or the data value from which on something is shown, like "150"');
  return Number(word);
}

/** A name, or an empty text. */
function parseName(name: string, text: string): string | undefined {
  if (text.length > 200) throw invalid(name, text, 'a name of at most 200 characters');
  return text.trim() || undefined;
}

/** `COLUMNSxROWS`. */
function parseMosaic(text: string): { columns: number; rows: number } {
  const size = parseMosaicSize(text);
  if (!size) throw invalid('mosaic', text, 'tiles per row and column, like "10x10"');
  return size;
}

/** A whole number above zero. */
function parseCount(name: string, text: string): number {
  const count = Number(text);
  if (!/^\s*\d+\s*$/.test(text) || !Number.isSafeInteger(count) || count < 1)
    throw invalid(name, text, 'a whole number from 1');
  return count;
}

/** `first step`, the step not zero. */
function parsePair(name: string, text: string, expected: string): [number, number] {
  const words = split(name, text);
  const [first, step] = words.map(Number);
  if (
    words.length !== 2 ||
    !words.every(isNumber) ||
    Math.max(Math.abs(first), Math.abs(step)) > farthest ||
    step === 0
  )
    throw invalid(name, text, expected);
  return [first, step];
}

/** Degrees from -90 to 90, one or more. */
function parseElevations(text: string): number[] {
  const words = split('elevations', text);
  const angles = words.map(Number);
  const isFine =
    words.length > 0 &&
    words.length <= maxSweeps &&
    words.every(isNumber) &&
    angles.every((angle) => Math.abs(angle) <= 90);
  if (!isFine) throw invalid('elevations', text, 'degrees, one a tile, like "0.5 1.2 2.4"');
  return angles;
}
