// Surfaces that are cut: areas against closed forms, no place lost or doubled, normals, and what stays the same array.
import { expect } from '@esm-bundle/chai';
import { cutSurface } from '../../../src/volume/cut-surface.ts';
import { cross, dot, length, scale, subtract } from '../../../src/volume/matrix.ts';
import type { Vector3 } from '../../../src/volume/matrix.ts';
import type { Surface, SurfacePart } from '../../../src/volume/surface.ts';
import { boundsBetween, isKept, sidesOf } from '../../../src/volume/world-cut.ts';
import type { HalfWorld, WorldCut } from '../../../src/volume/world-cut.ts';
import { ballPly, surfaceOf, trianglesOf } from '../../helpers/meshes.ts';

const areaOf = (surface: Pick<Surface, 'parts'> | null): number =>
  (surface ? trianglesOf(surface) : []).reduce(
    (sum, [a, b, c]) => sum + length(cross(subtract(b, a), subtract(c, a))) / 2,
    0,
  );

const at = (normal: Vector3, offset: number): HalfWorld => ({ normal, at: offset });
const behind = (...kept: HalfWorld[]): WorldCut => ({ kept, removed: null });
const without = (box: readonly number[], ...kept: HalfWorld[]): WorldCut => ({ kept, removed: boundsBetween(box, 1) });
const opposite = ({ normal, at: offset }: HalfWorld): HalfWorld => at(scale(normal, -1), -offset);

/** A cube around the origin, twelve triangles in 8 vertices that are red at low x and green at high x. */
function cube(half: number): Surface {
  const corners = Array.from({ length: 8 }, (_, i) => [i & 1, (i >> 1) & 1, i >> 2].map((end) => (end ? half : -half)));
  const sides = [
    [0, 2, 3, 1],
    [4, 5, 7, 6],
    [0, 1, 5, 4],
    [2, 6, 7, 3],
    [0, 4, 6, 2],
    [1, 3, 7, 5],
  ];
  const part: SurfacePart = {
    positions: Float32Array.from(corners.flat()),
    normals: Float32Array.from(
      corners.flatMap((corner) => scale(corner as unknown as Vector3, 1 / (half * Math.sqrt(3)))),
    ),
    indices: Uint16Array.from(sides.flatMap(([a, b, c, d]) => [a, b, c, a, c, d])),
    colors: Float32Array.from(corners.flatMap(([x]) => (x > 0 ? [0, 1, 0] : [1, 0, 0]))),
  };
  return {
    parts: [part],
    low: [-half, -half, -half],
    high: [half, half, half],
    triangles: 12,
    format: 'a cube',
    notes: [],
  };
}

/** Each place of a grid on each side of the cube, and how often triangles cover it. */
function coverOf(surface: Surface, half: number): { place: Vector3; times: number }[] {
  const triangles = trianglesOf(surface);
  const covers = (place: Vector3): number =>
    triangles.filter(([a, b, c]) => {
      const normal = cross(subtract(b, a), subtract(c, a));
      if (Math.abs(dot(normal, subtract(place, a))) > 1e-4 * length(normal)) return false;
      return [
        [a, b],
        [b, c],
        [c, a],
      ].every(([from, to]) => dot(normal, cross(subtract(to, from), subtract(place, from))) > 0);
    }).length;
  const steps = Array.from({ length: 11 }, (_, i) => half * (-0.971 + 0.1937 * i));
  return [0, 1, 2].flatMap((axis) =>
    [-half, half].flatMap((end) =>
      steps.flatMap((u) =>
        steps.map((v) => {
          const place = [0, 0, 0].map((_, one) =>
            one === axis ? end : one === (axis + 1) % 3 ? u : v + 0.0131,
          ) as unknown as Vector3;
          return { place, times: covers(place) };
        }),
      ),
    ),
  );
}

describe('surfaces that are cut', () => {
  it('by a plane: a sphere leaves a cap of 2 pi r h, and both sides together are the whole', async () => {
    const [radius, rings] = [10, 96];
    const ball = await surfaceOf(ballPly([1, -2, 3], radius, rings));
    const whole = areaOf(ball);
    const share = whole / (4 * Math.PI * radius ** 2);
    expect(share).to.be.within(0.999, 1);
    for (const normal of [
      [0, 0, 1],
      [0.6, 0, -0.8],
      [2, -3, 6],
    ] as const) {
      for (const height of [0.5, 7.3, 10, 16]) {
        const half = at(normal, dot(normal, [1, -2, 3]) + length(normal) * (radius - height));
        const [kept, removed] = [cutSurface(ball, behind(half)), cutSurface(ball, behind(opposite(half)))].map(areaOf);
        expect((kept + removed) / whole).to.be.closeTo(1, 1e-6);
        expect(kept / (2 * Math.PI * radius * height * share), `${String(normal)}, ${height}`).to.be.closeTo(
          1,
          height < 1 ? 0.02 : 0.001,
        );
      }
    }
  });

  it('by a box or all but a box: a corner of a cube, and what is left', () => {
    const whole = cube(3);
    const corner = [1, 0.5, -1, 9, 9, 9];
    const [kept, removed] = [
      cutSurface(whole, behind(...sidesOf([boundsBetween(corner, 1)]))),
      cutSurface(whole, without(corner)),
    ];
    const faces = 2.5 * 4 + 2 * 4 + 2 * 2.5; // At high x, high y and high z.
    expect(areaOf(kept)).to.be.closeTo(faces, 1e-5);
    expect(areaOf(removed)).to.be.closeTo(6 * 36 - faces, 1e-4);
    expect(kept!.triangles).to.equal(trianglesOf(kept!).length);
    // A notch in the middle of an edge, and a hole in the middle of a side.
    expect(areaOf(cutSurface(whole, without([-1, 2, 2, 1, 4, 4])))).to.be.closeTo(6 * 36 - 2 * 2, 1e-4);
    expect(areaOf(cutSurface(whole, without([-1, -1, 2, 1, 1, 4])))).to.be.closeTo(6 * 36 - 4, 1e-4);
    // With a plane as well.
    expect(areaOf(cutSurface(whole, without([-1, -1, 2, 1, 1, 4], at([1, 0, 0], 0))))).to.be.closeTo(
      36 + 4 * 18 - 2,
      1e-4,
    );
  });

  it('covers each place that is kept once, and no other', () => {
    const cuts = [
      without([-1.11, -0.7, -9, 1.3, 9, 0.4]),
      without([0.2, 0.3, 0.4, 9, 9, 9]),
      without([-2, -2, 2, 2, 2, 9], at([1, 2, -1], -2)),
      behind(at([1, 1, 1], 0.3), at([-1, 0.2, 0], -1)),
    ];
    for (const cut of cuts) {
      const cover = coverOf(cutSurface(cube(3), cut)!, 3);
      for (const { place, times } of cover) expect(times, String(place)).to.equal(isKept(cut, place) ? 1 : 0);
      const kept = cover.filter(({ times }) => times === 1).length;
      expect(kept).to.be.within(100, cover.length - 20);
    }
  });

  it('keeps normals at a length of 1, and runs colours along edges', async () => {
    const left = cutSurface(cube(3), without([1, -1, -9, 2, 1, 9]))!;
    for (const surface of [left, cutSurface(await surfaceOf(ballPly([0, 0, 0], 5)), behind(at([1, 2, 3], 1)))!]) {
      for (const { normals } of surface.parts)
        for (let i = 0; i < normals.length; i += 3)
          expect(Math.hypot(normals[i], normals[i + 1], normals[i + 2])).to.be.closeTo(1, 1e-6);
    }
    const { positions, colors } = left.parts.at(-1)!;
    expect(positions.length).to.be.above(30);
    for (let i = 0; i < positions.length; i += 3) {
      const green = (positions[i] + 3) / 6;
      [1 - green, green, 0].forEach((wanted, channel) => expect(colors![i + channel]).to.be.closeTo(wanted, 1e-6));
    }
  });

  it('gives two triangles of an edge the same place on it, so that no light falls through', async () => {
    const ball = await surfaceOf(ballPly([0, 0, 0], 7, 30));
    const left = cutSurface(ball, behind(at([3, -1, 2], 1.234)))!;
    // The rim of a closed surface that is cut by a plane is closed: every place on it is in two triangles or more.
    const onRim = new Map<string, number>();
    for (const corners of trianglesOf(left))
      for (const corner of corners) {
        if (Math.abs(dot([3, -1, 2], corner) - 1.234) < 1e-4)
          onRim.set(String(corner), (onRim.get(String(corner)) ?? 0) + 1);
      }
    expect(onRim.size).to.be.above(60);
    for (const [place, times] of onRim) expect(times, place).to.be.above(1);
  });

  it('leaves what is not cut as it is: the surface, its parts, and the vertices of parts', async () => {
    const ball = await surfaceOf(ballPly([0, 0, 0], 5));
    const far = await surfaceOf(ballPly([40, 0, 0], 5));
    const both: Surface = { ...ball, parts: [...ball.parts, ...far.parts], triangles: 2 * ball.triangles };
    expect(cutSurface(both, behind())).to.equal(both);
    expect(cutSurface(both, behind(at([1, 0, 0], -5.001)))).to.equal(both);
    expect(cutSurface(both, without([10, -9, -9, 20, 9, 9]))).to.equal(both);
    const left = cutSurface(both, behind(at([1, 0, 0], 1)))!;
    expect(left.parts.includes(both.parts[1]), 'beyond the plane').to.equal(true);
    expect(left.parts[0].positions).to.equal(both.parts[0].positions);
    expect(left.parts[0].indices.length).to.be.below(both.parts[0].indices.length);
    expect(cutSurface(both, without([-9, -9, -9, 9, 9, 9]))!.parts).to.deep.equal([both.parts[1]]);
  });

  it('of which nothing is left is none; what lies on the plane or on a side of the box is kept', () => {
    const whole = cube(3);
    expect(cutSurface(whole, behind(at([0, 1, 0], 3.001)))).to.equal(null);
    expect(cutSurface(whole, behind(at([0, 1, 0], 0), at([0, -1, 0], 1)))).to.equal(null);
    expect(cutSurface(whole, without([-4, -4, -4, 4, 4, 4]))).to.equal(null);
    expect(areaOf(cutSurface(whole, behind(at([0, 1, 0], 3))))).to.be.closeTo(36, 1e-4);
    expect(cutSurface(whole, without([-3, -3, -3, 3, 3, 3]))).to.equal(whole);
  });

  it('by what is no number, has no direction or holds nothing is cut by the rest', () => {
    const whole = cube(3);
    const senseless = [
      at([Number.NaN, 0, 0], 0),
      at([0, 0, 0], 1),
      at([1, 0, 0], -Infinity),
      at([0, Infinity, 0], 0),
      at([1, 0, 0], Number.NaN),
    ];
    expect(cutSurface(whole, behind(...senseless))).to.equal(whole);
    expect(areaOf(cutSurface(whole, behind(...senseless, at([0, 0, 1], 0))))).to.be.closeTo(36 + 4 * 18, 1e-4);
    for (const box of [
      [0, 0, 0, 0, 9, 9],
      [Number.NaN, 0, 0, 9, 9, 9],
    ])
      expect(cutSurface(whole, without(box)), String(box)).to.equal(whole);
    const endless = [-Infinity, -1e308, -Infinity, 0, 1e308, Infinity];
    expect(areaOf(cutSurface(whole, without(endless)))).to.be.closeTo(36 + 4 * 18, 1e-4);
    expect(areaOf(cutSurface(whole, behind(...sidesOf([boundsBetween(endless, 1)]))))).to.be.closeTo(36 + 4 * 18, 1e-4);
    expect(() => cutSurface({ ...whole, parts: [] }, behind(at([0, 0, 1], 0)))).not.to.throw();
    // A triangle without area, one with a normal that is undone half way, and a plane through a vertex.
    const part: SurfacePart = {
      positions: Float32Array.of(0, 0, 0, 1, 0, 0, 2, 0, 0, 0, 2, 0),
      normals: Float32Array.of(0, 0, 1, 0, 0, -1, 0, 0, 1, 0, 0, 1),
      indices: Uint16Array.of(0, 1, 2, 0, 1, 3),
      colors: null,
    };
    const left = cutSurface({ ...whole, parts: [part] }, behind(at([1, 0, 0], 0.5)))!;
    expect(areaOf(left)).to.be.closeTo(0.25, 1e-6);
    for (const { normals } of left.parts) expect([...normals].every(Number.isFinite)).to.equal(true);
    expect(
      areaOf(cutSurface({ ...whole, parts: [part] }, behind(at([1, 0, 0], 1)))),
      'the triangle touches it',
    ).to.equal(0);
  });

  it('in more divided triangles than short indices reach becomes several parts', () => {
    const needles = 30_000;
    const positions = new Float32Array(6 * (needles + 1));
    for (let i = 0; i <= needles; i++) positions.set([i / needles, 0, 0, i / needles, 1, 0], 6 * i);
    const parts: SurfacePart[] = [
      {
        positions,
        normals: positions.map((_, i) => Number(i % 3 === 2)),
        colors: null,
        indices: Uint16Array.from({ length: 6 * needles }, (_, i) => 2 * Math.floor(i / 6) + [0, 2, 3, 0, 3, 1][i % 6]),
      },
    ];
    const left = cutSurface({ ...cube(1), parts }, without([-1, 0.25, -1, 2, 0.75, 1]))!;
    expect(left.parts.length).to.be.above(1);
    for (const part of left.parts) expect(part.positions.length / 3).to.be.at.most(65_535);
    expect(areaOf(left)).to.be.closeTo(0.5, 1e-5);
  });
});
