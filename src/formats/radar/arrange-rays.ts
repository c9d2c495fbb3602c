/** Rays nearer than this share of the normal spacing see the same air: one of them is enough. */
const nearestShare = 0.25;

/** No antenna tells rays apart that are nearer than this, degrees. */
const nearestRays = 0.02;

/** A wider gap than this many normal spacings is a gap: a ray is missing, or the sector ends. */
const widestShare = 1.75;

/** From this many normal spacings on, the rays on both sides of a gap keep clear of each other. */
const wideShare = 2.25;

/** Rays of a sweep in the order in which they are stored. */
export interface RayOrder {
  /** Degrees, 0 <= azimuth < 360, ascending. */
  readonly azimuths: Float64Array<ArrayBuffer>;
  /** Index of each in the file; -1 for one without data. */
  readonly rays: Int32Array<ArrayBuffer>;
}

interface Ray {
  readonly azimuth: number;
  readonly index: number;
}

/**
 * Sort a sweep's rays by azimuth, drop those that were scanned again (the last one counts), and put rays without data
 * where the antenna left a gap: one where one is missing, two at the ends of a sector. Interpolation between valid gates
 * only then does by itself what it should: data reach half a ray's spacing beyond the last ray, and no further.
 * @param azimuths - degrees, in the file's order; what is no number is left out
 * @param beamWidth - degrees: the spacing of a ray that has no neighbour
 */
export function arrangeRays(azimuths: ArrayLike<number>, beamWidth: number): RayOrder {
  const found = Array.from(azimuths, (azimuth, index) => ({ azimuth: wrapDegrees(azimuth), index }));
  const sorted = found.filter(({ azimuth }) => Number.isFinite(azimuth));
  sorted.sort((a, b) => a.azimuth - b.azimuth);
  const spacing = normalSpacing(sorted, beamWidth);
  const rays = fillGaps(dropRepeats(sorted, Math.max(nearestRays, nearestShare * spacing)), spacing);
  return { azimuths: Float64Array.from(rays, (ray) => ray.azimuth), rays: Int32Array.from(rays, (ray) => ray.index) };
}

function wrapDegrees(azimuth: number): number {
  // The second remainder: a hair below 0 is rounded to 360.
  return (((azimuth % 360) + 360) % 360) % 360;
}

/** Degrees from each ray to the next one, around the circle. */
function gapsOf(rays: readonly Ray[]): number[] {
  return rays.map(({ azimuth }, i) => (i + 1 < rays.length ? rays[i + 1].azimuth - azimuth : rays[0].azimuth + 360 - azimuth));
}

/** The median gap; more than half a circle is no spacing, but what lies outside of a sector. */
function normalSpacing(rays: readonly Ray[], beamWidth: number): number {
  const gaps = gapsOf(rays).filter((gap) => gap > nearestRays && gap <= 180);
  gaps.sort((a, b) => a - b);
  return gaps.length > 0 ? gaps[Math.floor(gaps.length / 2)] : beamWidth;
}

function dropRepeats(rays: readonly Ray[], nearest: number): Ray[] {
  const kept: Ray[] = [];
  for (const ray of rays) {
    const before = kept.at(-1);
    if (!before || ray.azimuth - before.azimuth >= nearest) kept.push(ray);
    else if (ray.index > before.index) kept[kept.length - 1] = ray;
  }
  while (kept.length > 1 && kept[0].azimuth + 360 - kept.at(-1)!.azimuth < nearest) {
    if (kept[0].index > kept.at(-1)!.index) kept.pop();
    else kept.shift();
  }
  return kept;
}

function fillGaps(rays: readonly Ray[], spacing: number): Ray[] {
  const filled = [...rays];
  const addEmpty = (azimuth: number): number => filled.push({ azimuth: wrapDegrees(azimuth), index: -1 });
  gapsOf(rays).forEach((gap, i) => {
    const { azimuth } = rays[i];
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
