import type { Vector3 } from '../src/volume/matrix.ts';
import { groundReach } from '../src/volume/polar-box.ts';
import type { Volume } from '../src/volume/volume.ts';
import { invalid, parseLength } from './parse-attributes.ts';

/** Circles around a radar at the height of its antenna, and the line to the north. */
export interface Rings {
  /** World coordinates. */
  readonly lines: readonly (readonly Vector3[])[];
  readonly labels: readonly RingLabel[];
}

export interface RingLabel {
  readonly text: string;
  /** World coordinates. */
  readonly at: Vector3;
}

/** Corners of a ring. */
const corners = 180;

/** Rings that a radar's reach is cut into by itself, at most. */
const mostAutomatic = 6;

/** A ring this share beyond the reach is still drawn: that is shorter along the ground than along the beam. */
const beyondReach = 0.01;

/** More would be a gray disc. */
const mostRings = 100;

/**
 * The rings that an attribute asks for: empty for round distances, else their distance in kilometres. The outermost one
 * is where the scan ends, or before.
 * @throws {VolumeViewError} `attribute/invalid`
 */
export function readRings(text: string | null, volume: Volume): Rings | null {
  if (text === null) return null;
  if (!volume.polar) throw invalid('rings', text, 'a radar scan, which alone has rings');
  const reach = groundReach(volume.polar) * (1 + beyondReach);
  const spacing = text.trim() === '' ? roundDistance(reach) : parseLength('rings', text) * 1000;
  const count = Math.floor(reach / spacing);
  if (count < 1 || count > mostRings) {
    throw invalid('rings', text, `kilometres from ring to ring, of which 1 to ${mostRings} fit into the scan's ${Math.round(reach / 1000)} km`);
  }
  const radii = Array.from({ length: count }, (_, i) => (i + 1) * spacing);
  const outermost = radii.at(-1)!;
  const north: Vector3[] = [[0, 0, 0], [0, outermost * 1.04, 0]];
  return {
    lines: [...radii.map(circle), north],
    labels: [
      ...radii.map((radius): RingLabel => ({ text: `${formatKilometres(radius)} km`, at: [radius, 0, 0] })),
      { text: 'N', at: [0, outermost * 1.07, 0] },
    ],
  };
}

/** 1, 2 or 5 times a power of ten metres. */
function roundDistance(reach: number): number {
  const least = reach / mostAutomatic;
  const power = 10 ** Math.floor(Math.log10(least));
  return [1, 2, 5, 10].map((factor) => factor * power).find((distance) => distance >= least * (1 - 1e-9))!;
}

function formatKilometres(metres: number): string {
  return String(Number((metres / 1000).toPrecision(6)));
}

function circle(radius: number): Vector3[] {
  return Array.from({ length: corners + 1 }, (_, i) => {
    const angle = (2 * Math.PI * (i % corners)) / corners;
    return [radius * Math.sin(angle), radius * Math.cos(angle), 0];
  });
}
