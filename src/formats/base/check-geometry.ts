import { VolumeViewError } from '../../core/errors.ts';
import { longest, maxVoxelsPerAxis } from '../../volume/grid-limits.ts';
import { isSoundGrid } from '../../volume/sound-grid.ts';
import { isPolar } from '../../volume/volume.ts';
import type { Volume } from '../../volume/volume.ts';
import type { DecodedVolume } from './decoded-volume.ts';

/**
 * Throws if a volume's position or the scaling of its values is invalid.
 * @throws {VolumeViewError} `format/corrupt`, `format/too-large`
 */
export function checkGeometry(volume: DecodedVolume): void {
  const { grid, slope, intercept, format } = volume;
  if (!isSoundGrid(grid) || (isPolar(volume) && !areSoundSweeps(volume.grid))) {
    throw new VolumeViewError(
      'format/corrupt',
      `the ${format} has ${grid.dimensions.join(' x ')} voxels, ${grid.spacing.map(say).join(' x ')} long, the first of them at ${[3, 7, 11].map((i) => say(grid.indexToWorld[i])).join(', ')}; ` +
        `expected up to ${maxVoxelsPerAxis.toLocaleString('en')} voxels along each axis, axes that do not lie in one plane, and lengths and places from 1e-12 to 1e12. ` +
        'Check its spacing, its affine and its ranges, or say another "spacing"',
    );
  }
  if (!Number.isFinite(slope) || slope === 0 || !Number.isFinite(intercept)) {
    throw new VolumeViewError(
      'format/corrupt',
      `the ${format} scales its values by ${slope} and shifts them by ${intercept}; expected finite numbers, the first one not 0`,
    );
  }
}

function areSoundSweeps({ sweeps, beamWidth, box }: Extract<DecodedVolume['grid'], { kind: 'polar' }>): boolean {
  const all = sweeps.flatMap(({ elevation, firstGate, gateLength, gates }) => [
    elevation,
    firstGate,
    gateLength,
    gates * gateLength,
  ]);
  return (
    [beamWidth, ...box.low, ...box.high, ...all].every((n) => Math.abs(n) <= longest) &&
    sweeps.every(
      ({ azimuths, elevations, gateLength }) =>
        gateLength > 0 && azimuths.every(Number.isFinite) && (elevations?.every(Number.isFinite) ?? true),
    )
  );
}

/** @throws {VolumeViewError} `format/corrupt` */
export function refuseRange({ range, format }: Pick<Volume, 'range' | 'format'>): never {
  throw new VolumeViewError(
    'format/corrupt',
    `the ${format} has values from ${range[0]} to ${range[1]}, which lie too far apart; expected finite numbers: check its slope and intercept, or its data`,
  );
}

const say = (n: number): string => String(Number(n.toPrecision(4)));
