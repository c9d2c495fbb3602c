// What is cut away, on the GPU: against the float64 twin.
import { expect } from '@esm-bundle/chai';
import { orbitCamera } from '../../../src/optics/rays/camera.ts';
import type { Orbit } from '../../../src/optics/rays/camera.ts';
import type { PlaneSlice } from '../../../src/optics/attachments/plane-slices.ts';
import type { ProjectionKind } from '../../../src/optics/rays/ray-style.ts';
import { rayThrough } from '../../../src/optics/rays/rays.ts';
import { stagesOf } from '../../../src/optics/reference.ts';
import type { TransferFunction } from '../../../src/optics/transfer/transfer-function.ts';
import { stretchOf } from '../../../src/radar/polar-geometry.ts';
import type { Slice } from '../../../src/radar/slices.ts';
import { boundingSphere, longestDiagonal } from '../../../src/volume/grid.ts';
import { dot } from '../../../src/volume/matrix.ts';
import type { Vector3 } from '../../../src/volume/matrix.ts';
import { planeInCube } from '../../../src/viewer/cuts/plane-in-cube.ts';
import type { Volume } from '../../../src/volume/volume.ts';
import { casesIn, takesAll } from '../../helpers/cases.ts';
import { cutBox, keep } from '../../helpers/clips.ts';
import { cloudCamera, cloudColors, cloudVolume } from '../../helpers/polar-cloud.ts';
import { isEdge, listOff } from '../../helpers/edges.ts';
import { blocks, mixedAppearances } from '../../helpers/labels.ts';
import {
  bothWalks,
  comparePictures,
  drawPicture,
  drawReference,
  height,
  plainOptics,
  raysOf,
  referenceOf,
  shareScene,
  width,
  walksOf,
} from '../../helpers/picture.ts';
import type { Clips, View } from '../../helpers/picture.ts';
import { syntheticVolume } from '../../helpers/synthetic.ts';

const turned: readonly number[] = [0.9, 0.5, 0, -9, -0.5, 0.9, 0, -2, 0, 0, 1.4, -8, 0, 0, 0, 1];
const volume = syntheticVolume({ dimensions: [16, 14, 12], indexToWorld: turned });
const { center } = boundingSphere(volume.grid);
const diagonal = longestDiagonal(volume.grid);
const storm = cloudVolume(1);
/** Of the cloud, metres. */
const cloud: Vector3 = [16_600, 6_000, 9_400];

const place = (...offset: Vector3): Vector3 =>
  [0, 1, 2].map((axis) => center[axis] + offset[axis]) as unknown as Vector3;
const normals: readonly Vector3[] = [
  [1, 0, 0],
  [-1, 0.2, 0],
  [0, 1, 0.3],
  [0.1, -1, 0],
  [0, 0, 1],
  [0.3, 0.3, -1],
];
/** Six planes around the middle. */
const six = (of: Volume): Clips['kept'] =>
  normals.map((normal) => keep(of.grid, normal, normal.reduce((sum, x, axis) => sum + x * center[axis], 0) - 4.5));

interface Case {
  readonly name: string;
  readonly clips: Clips;
  readonly orbit?: Orbit;
  readonly more?: Partial<View>;
}

const octant = cutBox(volume.grid, place(-0.7, -0.4, -0.3), place(40, 40, 40));
const hole = cutBox(volume.grid, place(-2.6, -2.2, -1.9), place(2.1, 2.9, 2.4));

const cases: Case[] = [
  {
    name: 'six planes',
    clips: { kept: six(volume), cutout: cutBox(volume.grid, place(90, 90, 90), place(91, 91, 91)) },
  },
  { name: 'a corner', clips: { kept: [keep(volume.grid, [1, 2, 0.5], 2)], cutout: octant } },
  { name: 'a hole in the middle', clips: { kept: [], cutout: hole }, more: { stepLength: diagonal / 25 } },
  {
    name: 'from inside of what is cut out',
    clips: { kept: six(volume), cutout: hole },
    orbit: { theta: 1, phi: 1.1, radius: 0.02 },
  },
];

/** As opaque as the value is large. */
const ramp: TransferFunction = [
  { value: 0, color: [1, 1, 1], opacity: 0 },
  { value: 1, color: [1, 1, 1], opacity: 1 },
];

/** By program, so that few are made. */
const projected: readonly ProjectionKind[] = ['max', 'average'];

for (const webgl1 of [false, true]) {
  describe(`what is cut away${webgl1 ? ' in WebGL 1' : ''}`, () => {
    const scene = shareScene({ webgl1 });

    const viewOf = ({ clips, orbit = { theta: 0.6, phi: 1.1, radius: 1.3 }, more }: Case): View => ({
      volume,
      clips,
      camera: orbitCamera({ ...orbit, radius: orbit.radius * diagonal }, center, 0.7),
      stepLength: diagonal / 60,
      ...more,
    });

    const compare = (view: View): Uint8ClampedArray => {
      const picture = drawPicture(scene(), view);
      const reference = drawReference(view);
      expect(reference.filter((x, i) => i % 4 === 3 && x > 20).length, 'pixels that show something').to.be.above(80);
      expect(
        comparePictures(drawReference({ ...view, clips: undefined }), reference).worst,
        'something is cut away',
      ).to.be.above(20);
      expect(comparePictures(picture, reference).worst).to.be.below(2.01);
      return picture;
    };

    for (const one of casesIn(webgl1 ? 1 : 2, cases, (_, i) => i === 1 || i === 3)) {
      it(`${one.name}: the same as in float64, and skipping changes nothing`, () => {
        for (const view of walksOf(viewOf(one), cases.indexOf(one))) {
          const picture = compare(view);
          scene().layers[0].skipping = false;
          const all = drawPicture(scene(), view);
          scene().layers[0].skipping = true;
          expect(comparePictures(picture, all).worst).to.equal(0);
        }
      });
    }

    it('a slice in it is not seen, one next to it is', () => {
      const plane = { kind: 'plane', slab: null, normal: [0.2, -0.1, 1], offset: 0.55, window: [0, 1] } as const;
      const opaque = (data: ArrayLike<number>): number =>
        Array.from(data).filter((x, i) => i % 4 === 3 && x > 254).length;
      for (const view of bothWalks(viewOf({ ...cases[1], more: { planes: [plane] } }))) {
        const [picture, reference, whole] = [
          drawPicture(scene(), view),
          drawReference(view),
          drawReference({ ...view, clips: undefined }),
        ];
        expect(opaque(reference)).to.be.within(30, opaque(whole) - 30);
        const atEdge = (pixel: number): boolean => Math.abs(picture[4 * pixel + 3] - reference[4 * pixel + 3]) > 60;
        expect(Array.from({ length: reference.length / 4 }, (_, pixel) => pixel).filter(atEdge).length).to.be.below(4);
        expect(comparePictures(picture, reference, atEdge).worst).to.be.below(2.01);
      }
    });

    if (takesAll || !webgl1)
      it('slices on the faces of what is cut out are seen from both of their sides, all of them', () => {
        const corner = place(0.37, -0.11, 0.23);
        const normals: readonly Vector3[] = [
          [1, 0, 0],
          [0, 1, 0],
          [0, 0, 1],
        ];
        const planes = normals.map((normal, axis): PlaneSlice => ({
          kind: 'plane',
          slab: null,
          window: [-1, 0],
          ...planeInCube(normal, corner[axis], volume.grid),
        }));
        const clips = {
          kept: [keep(volume.grid, [0, 0, -1], -90)],
          cutout: cutBox(volume.grid, corner, place(40, 40, 40)),
        };
        const from = (orbit: Orbit): View =>
          viewOf({ name: '', clips, orbit, more: { planes, optics: { ...plainOptics, opacityFactor: 0 } } });
        for (const view of [
          from({ theta: 0.7, phi: 1, radius: 1.3 }),
          from({ theta: -2, phi: 2.1, radius: 1.3 }),
        ].flatMap(bothWalks)) {
          const picture = drawPicture(scene(), view);
          const rays = raysOf(view);
          const margins = Array.from({ length: width * height }, (_, pixel) => {
            const ray = rayThrough(
              rays,
              (2 * (pixel % width) + 1) / width - 1,
              1 - (2 * Math.floor(pixel / width) + 1) / height,
            );
            // How far a plane is met within the volume.
            return Math.max(
              ...planes.map(({ normal, offset }) => {
                const t = (offset - dot(normal, ray.point)) / dot(normal, ray.direction);
                return Math.min(
                  ...ray.point.flatMap((x, axis) => [x + t * ray.direction[axis], 1 - x - t * ray.direction[axis]]),
                );
              }),
            );
          });
          const wrong = margins.filter(
            (margin, pixel) => Math.abs(margin) > 1e-3 && picture[4 * pixel + 3] !== (margin > 0 ? 255 : 0),
          );
          expect(wrong).to.have.length(0);
          expect(
            comparePictures(picture, drawReference(view), (pixel) => Math.abs(margins[pixel]) < 1e-3).worst,
          ).to.be.below(2.01);
        }
      });

    if (takesAll || !webgl1)
      it('what is cut off up to a face of the volume leaves nothing for a projection to find', async () => {
        await scene().setAppearance({ style: { projection: 'max' } });
        const straight = syntheticVolume({
          dimensions: [16, 14, 12],
          spacing: [1.1, 0.9, 1.3],
          field: (_x, _y, z) => (z > 0.9 ? 0.9 : 0.2),
        });
        const middle = boundingSphere(straight.grid).center;
        const [low, high] = [-1, 1].map(
          (side) => middle.map((x, axis) => x + side * [8.8, 6.3, 7.8][axis]) as unknown as Vector3,
        );
        for (const [from, max] of [
          [low, 0],
          [[low[0], low[1], middle[2]], 60],
        ] as const) {
          const whole: View = {
            ...viewOf({ name: '', clips: { kept: [], cutout: cutBox(straight.grid, from, high) } }),
            volume: straight,
            projection: 'max',
            optics: { ...plainOptics, transferFunction: ramp },
          };
          for (const view of bothWalks(whole)) {
            const picture = drawPicture(scene(), view);
            expect(Math.max(...picture)).to.be.within(max && 40, max);
            expect(comparePictures(picture, drawReference(view)).worst).to.be.below(2.01);
          }
        }
        await scene().setAppearance({ style: null });
      });

    for (const projection of casesIn(webgl1 ? 1 : 2, projected, (_, i) => i === 0)) {
      it(`${projection} of both pieces of a ray: the same as in float64`, async () => {
        await scene().setAppearance({ style: { projection } });
        for (const view of walksOf(viewOf({ ...cases[2], more: { projection } }), projected.indexOf(projection)))
          compare(view);
        await scene().setAppearance({ style: null });
      });
    }

    it('of a volume with labels: the same as in float64', async () => {
      const labels = mixedAppearances(blocks(volume.grid.dimensions, 9));
      await scene().setLabels(labels);
      for (const view of bothWalks({ ...viewOf(cases[1]), labels })) {
        const picture = drawPicture(scene(), view);
        const [reference, whole] = [drawReference(view), drawReference({ ...view, clips: undefined })];
        const rays = raysOf(view);
        const stages = stagesOf(referenceOf(view), rays);
        const edges = new Set([...listOff(picture, reference)].filter((pixel) => isEdge(stages, rays, pixel)));
        expect(edges.size).to.be.below(0.02 * width * height);
        expect(comparePictures(picture, reference, (pixel) => edges.has(pixel)).worst).to.be.below(2.01);
        expect(comparePictures(whole, reference).worst).to.be.above(20);
      }
      await scene().setLabels(null);
    });

    it('a storm of a radar: the same as in float64', async () => {
      await scene().prepare(storm);
      const views = bothWalks({
        volume: storm,
        camera: cloudCamera,
        stepLength: longestDiagonal(storm.grid) / 150,
        optics: { ...plainOptics, transferFunction: cloudColors, referenceLength: 3000 },
        clips: {
          kept: [keep(storm.grid, [0.2, -0.1, -1], -11_000)],
          cutout: cutBox(storm.grid, cloud, [60_000, 60_000, 60_000]),
        },
      });
      for (const view of views) compare(view);
    });

    it("a radar's slices on faces of what is cut out are whole", () => {
      const [, , height] = cloud;
      const slices: readonly Slice[] = [
        { kind: 'level', height },
        { kind: 'upright', from: [cloud[0], 0], direction: [0, 1], length: Infinity },
      ];
      const stretch = stretchOf(storm.grid);
      const corner: Vector3 = [cloud[0], -2e5, height * stretch];
      const cutouts = [
        cutBox(storm.grid, corner, [2e5, 2e5, 2e5]),
        cutBox(storm.grid, [-2e5, -2e5, -2e5], [corner[0], 2e5, corner[2]]),
      ];
      const views = bothWalks({
        volume: storm,
        camera: cloudCamera,
        stepLength: longestDiagonal(storm.grid) / 50,
        optics: { ...plainOptics, transferFunction: cloudColors, opacityFactor: 0 },
        slices,
      });
      for (const view of views) {
        const whole = drawPicture(scene(), view);
        expect(whole.filter((x, i) => i % 4 === 3 && x > 254).length).to.be.above(100);
        for (const cutout of cutouts) {
          const cut = drawPicture(scene(), { ...view, clips: { kept: [keep(storm.grid, [0, 0, -1], -1e6)], cutout } });
          expect(comparePictures(cut, whole).worst).to.equal(0);
        }
      }
    });
  });
}
