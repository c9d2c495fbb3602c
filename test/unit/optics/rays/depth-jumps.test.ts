import { expect } from '@esm-bundle/chai';
import { faint, findJump, findThin, jumps, needsRays, rayEnd } from '../../../../src/optics/rays/depth-jumps.ts';
import type { EndScale, EndsAround, RayEnd } from '../../../../src/optics/rays/depth-jumps.ts';
import { withoutThin } from '../../../../src/quality/without-thin.ts';

/** A volume between t of -0.5 and 0.5, seen from 2 diameters off. */
const inside = [-0.5, 0.5] as const;
const perspective: EndScale = { planeDepth: 2, stepLength: 0.02 };
const parallel: EndScale = { planeDepth: null, stepLength: 0.02 };

const knownPlaces = [
  [0, 0],
  [2, 0],
  [0, 2],
  [2, 2],
] as const;
const ownPlaces = [
  [0, 0],
  [1, 0],
  [0, 1],
  [1, 1],
] as const;

/** The ends of a quad where shapes stand at a t: those of the known lattice, and the others. */
function endsOf(
  scale: EndScale,
  solidT: (x: number, y: number) => number,
  ownT = solidT,
  span: (x: number, y: number) => readonly [number, number] = () => inside,
): EndsAround {
  const end =
    (t: typeof solidT) =>
    ([x, y]: readonly [number, number]): RayEnd =>
      rayEnd(span(x, y), t(x, y), scale);
  return {
    known: knownPlaces.map(end(solidT)) as unknown as EndsAround['known'],
    own: ownPlaces.map(end(ownT)) as unknown as EndsAround['own'],
  };
}

const nothing = (): number => Infinity;

/** t at which a tilted plane is met: 1 / depth is linear in the pixel. */
const plane = (x: number, y: number): number => 1 / (0.5 + 0.01 * x - 0.007 * y) - 2;

describe('rays that end at shapes', () => {
  it('are predicted where there is no shape, or none before the volume ends', () => {
    expect(findJump(endsOf(perspective, nothing))).to.equal(jumps.none);
    expect(findJump(endsOf(perspective, () => 0.6))).to.equal(jumps.none);
  });

  it('are predicted all over a plane, in a perspective as in a parallel projection, and in front of the volume', () => {
    expect(findJump(endsOf(perspective, plane))).to.equal(jumps.none);
    expect(findJump(endsOf(parallel, (x, y) => 0.1 + 0.03 * x - 0.02 * y))).to.equal(jumps.none);
    expect(findJump(endsOf(perspective, (x) => -0.6 - 0.1 * x))).to.equal(jumps.none);
  });

  it('are not where a surface bends by more than a sixteenth of a step', () => {
    const bent =
      (bend: number) =>
      (x: number): number =>
        0.1 + bend * (x - 1) ** 2;
    expect(findJump(endsOf(parallel, bent(0.001)))).to.equal(jumps.none);
    expect(findJump(endsOf(parallel, bent(0.002)))).to.equal(jumps.nearer);
    expect(findJump(endsOf(parallel, bent(-0.002)))).to.equal(jumps.farther);
  });

  it('are not at a line, wherever it crosses the quad; it only takes light away', () => {
    for (const [i, [lineX, lineY]] of ownPlaces.entries()) {
      const ends = endsOf(perspective, nothing, (x, y) => (x === lineX && y === lineY ? 0 : Infinity));
      expect(findJump(ends), `${lineX}, ${lineY}`).to.equal(jumps.nearer);
      expect(findThin(ends.own, endsOf(perspective, nothing).own)).to.equal(2 ** i);
    }
  });

  it('are not next to the edge of a shape, on either side', () => {
    expect(findJump(endsOf(perspective, (x) => (x < 1 ? 0 : Infinity)))).to.equal(jumps.farther);
    expect(findJump(endsOf(perspective, (x) => (x > 0 ? 0 : Infinity)))).to.equal(jumps.nearer);
    // Between the known pixels and beyond the quad: the shape may be interpolated into it.
    expect(findJump(endsOf(perspective, (x) => (x > 1 ? 0 : Infinity)))).to.equal(jumps.farther);
  });

  it('are not where a shape meets the outline of the volume', () => {
    const span = (x: number): readonly [number, number] => (x < 1 ? [1, 0] : inside);
    expect(findJump(endsOf(perspective, plane, plane, span))).to.equal(jumps.farther);
    expect(findJump(endsOf(perspective, nothing, nothing, span))).to.equal(jumps.none);
  });

  it('take a ray of their own, but not for a shape in the dark', () => {
    expect(needsRays(jumps.none, 1)).to.equal(false);
    expect(
      [0, faint, 2 * faint].map((brightest) => needsRays(128 / 255, brightest)),
      'nearer',
    ).to.deep.equal([false, false, true]);
    expect(needsRays(jumps.farther, 0), 'what is behind may be bright').to.equal(true);
  });
});

describe('a picture without thin lines', () => {
  const [width, height] = [8, 6];
  const slope = (x: number, y: number, c: number): number => 20 + 8 * x + 6 * y + c;
  /** @param isThin - whether a line crosses a pixel */
  function restore(isThin: (x: number, y: number) => boolean): { worst: number } {
    const data = Uint8Array.from({ length: 4 * width * height }, (_, i) => {
      const [x, y] = [(i >> 2) % width, Math.floor((i >> 2) / width)];
      return isThin(x, y) ? 255 : slope(x, y, i & 3);
    });
    const [columns, rows] = [width / 2, height / 2];
    const marks = Uint8Array.from({ length: 4 * columns * rows }, (_, i) => {
      const [x, y] = [2 * ((i >> 2) % columns), 2 * Math.floor((i >> 2) / columns)];
      return (i & 3) === 1
        ? 17 * ownPlaces.reduce((sum, [dx, dy], bit) => sum + (isThin(x + dx, y + dy) ? 2 ** bit : 0), 0)
        : 0;
    });
    const restored = withoutThin({ data, width, height }, { data: marks, width: columns, height: rows }).data;
    let worst = 0;
    for (let i = 0; i < restored.length; i++)
      worst = Math.max(worst, Math.abs(restored[i] - slope((i >> 2) % width, Math.floor((i >> 2) / width), i & 3)));
    return { worst };
  }

  it('has what is on both sides of a line in its place, whichever way it runs', () => {
    for (const isThin of [
      () => false,
      (x: number) => x === 3,
      (_: number, y: number) => y === 2,
      (x: number, y: number) => x === y && x > 0 && y < 5,
      (x: number) => x === 3 || x === 4,
    ]) {
      expect(restore(isThin).worst, String(isThin)).to.be.at.most(1);
    }
  });

  it('has what is on one side at the edge of the picture', () => {
    expect(restore((x) => x === 0).worst).to.equal(8);
    expect(restore((_, y) => y === 5).worst).to.equal(6);
  });

  it('keeps what has nothing on any side', () => {
    expect(restore(() => true).worst).to.be.above(100);
  });
});
