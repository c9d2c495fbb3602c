// Rays that meet surfaces: in boxes within boxes, cut by ClipPlanes, and as the end of a pick's ray.
import { expect } from '@esm-bundle/chai';
import { TriangleTree } from '../../../../src/optics/surfaces/triangle-tree.ts';
import type { WorldRay } from '../../../../src/optics/surfaces/triangle-tree.ts';
import { cutSurface } from '../../../../src/volume/cut-surface.ts';
import { identity, length, subtract } from '../../../../src/volume/matrix.ts';
import type { Vector3 } from '../../../../src/volume/matrix.ts';
import type { Surface } from '../../../../src/volume/surface.ts';
import type { WorldCut } from '../../../../src/volume/world-cut.ts';
import type { ShownSurface } from '../../../../src/renderer/layers/shown-surfaces.ts';
import { socketOf } from '../../../../src/viewer/model/view-socket.ts';
import { endAtSurface } from '../../../../src/viewer/picking/pick-surfaces.ts';
import { ballPly, surfaceOf, trianglesOf } from '../../../helpers/meshes.ts';

/** All t of a ray, triangle by triangle, by the plane of each and the sides of its corners. */
function meetAll(surface: Surface, { origin, direction }: WorldRay): number[] {
  const volume = (a: Vector3, b: Vector3, c: Vector3): number =>
    a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
  const found = trianglesOf(surface).flatMap((corners) => {
    const [a, b, c] = corners.map((corner) => subtract(corner, origin));
    const sides = [volume(direction, a, b), volume(direction, b, c), volume(direction, c, a)];
    if (!(sides.every((side) => side >= 0) || sides.every((side) => side <= 0))) return [];
    const t = volume(a, b, c) / (sides[0] + sides[1] + sides[2]);
    return t >= 0 ? [t] : [];
  });
  found.sort((x, y) => x - y);
  return found;
}

const shownOf = (surface: Surface): ShownSurface => ({ surface, color: [0.2, 0.4, 0.6], usesOwnColors: true });

describe('rays and surfaces', () => {
  it('meet where each triangle alone says, and on a ball within its facets', async () => {
    const surface = await surfaceOf(ballPly([3, -4, 5], 10, 30));
    const tree = new TriangleTree(surface.parts[0]);
    let hits = 0;
    for (let i = 0; i < 200; i++) {
      const origin: Vector3 = [25 * Math.sin(i), 22 * Math.cos(1.7 * i), 20 * Math.sin(2.3 * i + 1)];
      const direction: Vector3 = subtract(
        [3 + 9 * Math.sin(5 * i), -4 + 9 * Math.sin(7 * i), 5 + 9 * Math.cos(3 * i)],
        origin,
      );
      const [found, wanted] = [[...tree.meet({ origin, direction }, 0)], meetAll(surface, { origin, direction })];
      expect(found.length).to.equal(wanted.length);
      found.forEach((t, j) => expect(t).to.be.closeTo(wanted[j], 1e-9));
      if (found.length === 0) continue;
      hits++;
      const place = origin.map((x, axis) => x + found[0] * direction[axis]) as unknown as Vector3;
      expect(length(subtract(place, [3, -4, 5]))).to.be.within(9.9, 10.0001);
    }
    expect(hits).to.be.above(100);
    // Along an axis, and from within.
    expect(tree.meet({ origin: [3.1, -4.2, 5.3], direction: [0, 0, 1] }, 0)).to.have.length(1);
    expect(tree.meet({ origin: [3.1, -4.2, 5.3], direction: [0, 0, 1] }, -Infinity)).to.have.length(2);
    expect(tree.meet({ origin: [30, -4.2, 5.3], direction: [0, 0, 1] }, 0)).to.have.length(0);
  });

  it('end at the nearest one that no ClipPlane cuts, wherever the volume is', async () => {
    const host = document.createElement('div');
    const [near, far] = [document.createElement('volume-surface'), document.createElement('volume-terrain')];
    const parts: readonly [HTMLElement, ShownSurface][] = [
      [far, shownOf(await surfaceOf(ballPly([0.5, 0.5, 5], 0.4)))],
      [near, shownOf(await surfaceOf(ballPly([0.5, 0.5, 0.5], 0.3)))],
    ];
    for (const [element, surface] of parts) void socketOf(host).join({ key: 'surface', element, surface });
    const ray = { point: [0.5, 0.51, -1] as Vector3, direction: [0, 0, 1] as Vector3, lengthPerT: 1 };
    const box = { entry: 1, exit: 2, behind: null };
    const end = endAtSurface(host, ray, identity, 0)!;
    expect(end.hit.element).to.equal(near);
    expect(end.hit.t).to.be.closeTo(1.2, 0.01);
    const { exit, behind } = end.stage(ray, box);
    expect([exit, behind]).to.deep.equal([end.hit.t, [0.2, 0.4, 0.6, 1]]);
    expect(end.isPicked(ray, [0.5, 0.51, end.hit.t - 1])).to.equal(true);
    expect(end.isPicked(ray, [0.5, 0.51, end.hit.t - 1.001])).to.equal(false);
    // What is nearer is cut away: its far side, which is kept, is met; and then the other one, behind the volume.
    host.innerHTML = '<clipplane plane="0 0 2 -1.2"></clipplane>';
    expect(endAtSurface(host, ray, identity, 0)!.hit.t).to.be.closeTo(1.8, 0.01);
    host.innerHTML = '<clipplane plane="0 0 1 -1"></clipplane>';
    const last = endAtSurface(host, ray, identity, 0)!;
    expect(last.hit.element).to.equal(far);
    expect(last.stage(ray, box)).to.deep.equal({ ...box, behind: [0.2, 0.4, 0.6, 1] });
    expect(last.isPicked(ray, [0.5, 0.51, 1])).to.equal(true); // The end of the volume, behind which it stands.
    // A slice that hides it, and a ray beside the volume.
    const slice = { ...box, behind: [1, 1, 1, 1] as const };
    expect(last.stage(ray, { ...box, behind: [1, 1, 1, 1] }).behind).to.deep.equal(slice.behind);
    expect(last.stage(ray, { entry: 3, exit: 2, behind: null })).to.deep.equal({
      entry: 3,
      exit: 3,
      behind: [0.2, 0.4, 0.6, 1],
    });
    expect(endAtSurface(host, { ...ray, point: [5, 5, -1] }, identity, 0)).to.equal(null);
  });

  it('go through what has been cut away of one with its volume', async () => {
    const host = document.createElement('div');
    const whole = await surfaceOf(ballPly([0.5, 0.5, 0.5], 0.3));
    const part = { key: 'surface', element: host, surface: shownOf(whole) };
    void socketOf(host).join(part);
    const ray = { point: [0.5, 0.51, -1] as Vector3, direction: [0, 0, 1] as Vector3, lengthPerT: 1 };
    const meetAfter = (away: WorldCut): number | undefined => {
      part.surface = { ...shownOf(cutSurface(whole, away)!), cut: { whole, away } };
      return endAtSurface(host, ray, identity, 0)?.hit.t;
    };
    const away = { kept: [], removed: null };
    expect(meetAfter(away)).to.be.closeTo(1.2, 0.01);
    expect(
      meetAfter({
        ...away,
        removed: [
          [0, 1],
          [0, 1],
          [0, 0.5],
        ],
      }),
    ).to.be.closeTo(1.8, 0.01);
    expect(
      meetAfter({
        ...away,
        removed: [
          [0, 1],
          [0.505, 1],
          [0, 1],
        ],
      }),
    ).to.equal(undefined);
    expect(meetAfter({ ...away, kept: [{ normal: [0, 0, -1], at: -0.5 }] })).to.be.closeTo(1.2, 0.01);
    expect(meetAfter({ ...away, kept: [{ normal: [0, 0, 1], at: 0.5 }] })).to.be.closeTo(1.8, 0.01);
    // By a ClipPlane as well.
    host.innerHTML = '<clipplane plane="0 0 -1 0.6"></clipplane>';
    expect(endAtSurface(host, ray, identity, 0)).to.equal(null);
  });
});
