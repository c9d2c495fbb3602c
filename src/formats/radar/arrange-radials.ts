import { widestGap } from '../../radar/sweep-elevations.ts';

/** Radials nearer to each other than this share of the normal spacing see the same air: one of them is enough. */
const nearestShare = 0.25;

/** An antenna can't separate radials that are nearer to each other than this, degrees. */
const nearestRadials = 0.02;

/** A distance of more than this many normal spacings is a gap: a radial is missing, or the sector ends. */
const widestShare = 1.75;

/** From this many normal spacings on, each side of a gap gets an empty radial of its own. */
const wideShare = 2.25;

/** Radials of a sweep in the order in which they are stored. */
export interface RadialOrder {
  /** Degrees, 0 <= azimuth < 360, ascending. */
  readonly azimuths: Float64Array<ArrayBuffer>;
  /** Index of each in the file; -1 for one without data. */
  readonly radials: Int32Array<ArrayBuffer>;
}

interface Radial {
  readonly azimuth: number;
  readonly index: number;
}

/**
 * Sorts a sweep's radials by azimuth, drops those that were scanned again (the last one counts), and inserts radials
 * without data into gaps: one where one radial is missing, two at the ends of a sector. Then interpolation between
 * valid gates is right without special cases: data reach half a radial's spacing beyond the last radial, and no
 * further. Radials that are farther apart than `widestGap` stand alone, half a beam to each side.
 * @param azimuths - degrees, in the file's order; NaN is left out
 * @param beamWidth - degrees: the spacing of a radial that has no neighbour
 */
export function arrangeRadials(azimuths: ArrayLike<number>, beamWidth: number): RadialOrder {
  const found = Array.from(azimuths, (azimuth, index) => ({ azimuth: wrapDegrees(azimuth), index }));
  const sorted = found.filter(({ azimuth }) => Number.isFinite(azimuth));
  sorted.sort((a, b) => a.azimuth - b.azimuth);
  const spacing = normalSpacing(sorted, beamWidth);
  const radials = fillGaps(dropRepeats(sorted, Math.max(nearestRadials, nearestShare * spacing)), spacing);
  return {
    azimuths: Float64Array.from(radials, (radial) => radial.azimuth),
    radials: Int32Array.from(radials, (radial) => radial.index),
  };
}

function wrapDegrees(azimuth: number): number {
  // The second remainder is needed because an angle slightly below 0 is rounded to 360.
  return (((azimuth % 360) + 360) % 360) % 360;
}

/** Degrees from each radial to the next one, around the circle. */
function gapsOf(radials: readonly Radial[]): number[] {
  return radials.map(({ azimuth }, i) =>
    i + 1 < radials.length ? radials[i + 1].azimuth - azimuth : radials[0].azimuth + 360 - azimuth,
  );
}

/** The median gap. A gap that is not interpolated is not a spacing, but the outside of a sector. */
function normalSpacing(radials: readonly Radial[], beamWidth: number): number {
  const gaps = gapsOf(radials).filter((gap) => gap > nearestRadials && gap <= widestGap(beamWidth));
  gaps.sort((a, b) => a - b);
  return gaps.length > 0 ? gaps[Math.floor(gaps.length / 2)] : beamWidth;
}

function dropRepeats(radials: readonly Radial[], nearest: number): Radial[] {
  const kept: Radial[] = [];
  for (const radial of radials) {
    const before = kept.at(-1);
    if (!before || radial.azimuth - before.azimuth >= nearest) kept.push(radial);
    else if (radial.index > before.index) kept[kept.length - 1] = radial;
  }
  while (kept.length > 1 && kept[0].azimuth + 360 - kept.at(-1)!.azimuth < nearest) {
    if (kept[0].index > kept.at(-1)!.index) kept.pop();
    else kept.shift();
  }
  return kept;
}

function fillGaps(radials: readonly Radial[], spacing: number): Radial[] {
  const filled = [...radials];
  const addEmpty = (azimuth: number): number => filled.push({ azimuth: wrapDegrees(azimuth), index: -1 });
  gapsOf(radials).forEach((gap, i) => {
    const { azimuth } = radials[i];
    if (gap <= widestShare * spacing) return;
    if (gap < wideShare * spacing) {
      addEmpty(azimuth + gap / 2);
    } else {
      addEmpty(azimuth + spacing);
      addEmpty(azimuth + gap - spacing);
    }
  });
  filled.sort((a, b) => a.azimuth - b.azimuth);
  return filled;
}
