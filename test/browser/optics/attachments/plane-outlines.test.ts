import { expect } from '@esm-bundle/chai';
import { orbitCamera, projectionMatrix, viewMatrix } from '../../../../src/optics/rays/camera.ts';
import { meetsOutline, outlinesOf } from '../../../../src/optics/attachments/plane-outlines.ts';
import type { HalfSpace, Outline, Plane } from '../../../../src/optics/attachments/plane-outlines.ts';
import { crossVolume, rayThrough, setUpRays } from '../../../../src/optics/rays/rays.ts';
import type { RaySetup } from '../../../../src/optics/rays/rays.ts';
import { planeOfSlice } from '../../../../src/radar/slices.ts';
import { outlinesText, outlineUniforms } from '../../../../src/renderer/ray/outline-uniforms.ts';
import { add, cross, dot, scale, subtract } from '../../../../src/volume/matrix.ts';
import type { Vector3 } from '../../../../src/volume/matrix.ts';
import { cutRegion } from '../../../../src/volume/region.ts';
import { createGl, releaseGl, runChunk } from '../../../helpers/gl.ts';
import { syntheticVolume } from '../../../helpers/synthetic.ts';

const { grid } = syntheticVolume({ dimensions: [14, 18, 11], spacing: [1, 0.8, 1.4] });
const planes: readonly (Plane & { readonly within?: readonly HalfSpace[] })[] = [
  { normal: [0, 0, 1], offset: 0.4 },
  { normal: [1, -0.3, 0.5], offset: 0.6 },
  { normal: [0.2, 1, 0], offset: 0.5, within: [{ normal: [1, 0, 0], offset: 0.3 }] },
];
const parallel = [0.05, 0, 0, 0, 0, 0.06, 0, 0, 0, 0, -0.01, -1, 0, 0, 0, 1];
const perspective = projectionMatrix(0.7, 1.3, 1, 100);

const setUp = (radius: number, projection: readonly number[], region: readonly number[] | null = null): RaySetup =>
  setUpRays(
    grid,
    viewMatrix(orbitCamera({ theta: 0.7, phi: 1.2, radius }, [1, 0, 0.5], 0.7)),
    projection,
    region && cutRegion(grid, region, 1),
  )!;

/** Whether a ray meets a plane within all that ends it. */
function isMet(plane: (typeof planes)[number], rays: RaySetup, [x, y]: readonly [number, number]): boolean {
  const ray = rayThrough(rays, x, y);
  const t = (plane.offset - dot(plane.normal, ray.point)) / dot(plane.normal, ray.direction);
  const [entry, exit] = crossVolume(rays, ray);
  const place = add(ray.point, scale(ray.direction, t));
  return (
    t >= Math.max(entry, rays.eyeT + 1e-3) &&
    t <= exit &&
    (plane.within ?? []).every(({ normal, offset }) => dot(normal, place) >= offset)
  );
}

/** Whether a place is within a polygon: edges to its right are crossed an odd number of times. */
const isWithin = (outlines: readonly Outline[], [x, y]: readonly [number, number]): boolean =>
  outlines.filter(([ax, ay, bx, by]) => ay > y !== by > y && ax + ((y - ay) / (by - ay)) * (bx - ax) > x).length % 2 ===
  1;

describe('outlines of planes', () => {
  const cases: Record<string, RaySetup> = {
    'from outside': setUp(40, perspective),
    'in a parallel projection': setUp(40, parallel),
    'of a region': setUp(40, perspective, [-3, -4, -5, 4, 3, 4]),
    'from inside': setUp(2, perspective),
  };
  for (const [name, rays] of Object.entries(cases)) {
    it(`are where rays begin to meet them: ${name}`, () => {
      let met = 0;
      for (const plane of planes) {
        const outlines = outlinesOf([plane], rays);
        expect(outlines.length).to.be.within(3, 10);
        for (let i = 0; i < 900; i++) {
          const place = [((i % 30) - 14.6) / 15, (Math.floor(i / 30) - 14.7) / 15] as const;
          if (outlines.some((edge) => meetsOutline(edge, place, [1e-6, 1e-6]))) continue;
          met += Number(isMet(plane, rays, place));
          expect(isWithin(outlines, place), place.join(', ')).to.equal(isMet(plane, rays, place));
        }
      }
      expect(met).to.be.within(60, 2600);
    });
  }

  it('are nothing of a plane that does not meet the volume', () => {
    expect(outlinesOf([{ normal: [1, 0, 0], offset: 1.2 }], cases['from outside'])).to.deep.equal([]);
  });

  it('of a plane seen from its side are a line', () => {
    const rays = setUp(40, perspective);
    const eye = add(rays.point[0], scale(rays.direction[0], rays.eyeT));
    // The plane through the eye, the middle of the volume and one of its corners.
    const normal = cross(subtract([0.5, 0.5, 0.5], eye), [0.5, 0.5, 0.5]);
    const outlines = outlinesOf([{ normal, offset: dot(normal, eye) }], rays);
    const areas = outlines.reduce((sum, [ax, ay, bx, by]) => sum + (ax * by - ay * bx) / 2, 0);
    expect(Math.abs(areas)).to.be.below(1e-9);
    expect(Math.max(...outlines.map(([ax, ay, bx, by]) => Math.hypot(bx - ax, by - ay)))).to.be.above(0.3);
  });

  it("of a radar's level and upright slices lie where these do", () => {
    const box = { low: [-4000, -3000, -100], high: [4000, 5000, 9000] } as const;
    const place: Vector3 = [0.3, 0.6, 0.2];
    const local = place.map((x, axis) => box.low[axis] + x * (box.high[axis] - box.low[axis]));
    const level = planeOfSlice({ kind: 'level', height: local[2] }, box);
    expect(dot(level.normal, place)).to.be.closeTo(level.offset, 1e-12);
    const upright = planeOfSlice(
      { kind: 'upright', from: [local[0] - 300, local[1] - 400], direction: [0.6, 0.8], length: 600 },
      box,
    );
    expect(dot(upright.normal, place)).to.be.closeTo(upright.offset, 1e-12);
    // The place is 500 m from the beginning, and 100 m before the end.
    const inside = upright.within.map(({ normal, offset }) => dot(normal, place) - offset);
    expect(inside[0] / inside[1]).to.be.closeTo(5, 1e-9);
  });
});

for (const version of [1, 2] as const) {
  it(`edges meet rectangles as the twin says in WebGL ${version}`, () => {
    const test = createGl(version);
    const rays = setUp(40, perspective);
    const outlines = outlinesOf(planes, rays);
    const reach = [0.013, 0.017] as const;
    const middles = Array.from(
      { length: 1600 },
      (_, i) => [((i % 40) - 19.5) / 20, (Math.floor(i / 40) - 19.5) / 20] as const,
    );
    const got = runChunk(test, {
      defines: outlinesText.defines,
      chunks: ['uniform vec2 uQuads;', ...outlinesText.chunks],
      a: middles.map((middle) => [...middle, 0, 0]),
      result: `vec4(meetsOutlines(QuadPlace(vec2(0.0), a.xy, vec2(${reach.join(', ')}) / 1.25)) ? 1.0 : 0.0)`,
      uniforms: outlineUniforms(outlines),
    }).map(([x]) => x === 1);
    const expected = middles.map((middle) => outlines.some((edge) => meetsOutline(edge, middle, reach)));
    expect(got).to.deep.equal(expected);
    expect(expected.filter(Boolean).length).to.be.within(50, 800);
    // More than there is room for: all quads get rays.
    const many = runChunk(test, {
      defines: outlinesText.defines,
      chunks: ['uniform vec2 uQuads;', ...outlinesText.chunks],
      a: [[5, 5, 0, 0]],
      result: 'vec4(meetsOutlines(QuadPlace(vec2(0.0), a.xy, vec2(0.01))) ? 1.0 : 0.0)',
      uniforms: outlineUniforms(Array.from({ length: 100 }, () => outlines[0])),
    });
    expect(many[0][0]).to.equal(1);
    releaseGl(test);
  });
}
