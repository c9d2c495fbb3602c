// What is cut away, on the GPU: against the float64 twin.
import { expect } from '@esm-bundle/chai';
import { orbitCamera } from '../../src/optics/camera.ts';
import type { Orbit } from '../../src/optics/camera.ts';
import type { ProjectionKind } from '../../src/optics/projection-kinds.ts';
import { stagesOf } from '../../src/optics/reference.ts';
import { boundingSphere, longestDiagonal } from '../../src/volume/grid.ts';
import type { Vector3 } from '../../src/volume/matrix.ts';
import type { Volume } from '../../src/volume/volume.ts';
import { cutBox, keep } from '../helpers/clips.ts';
import { cloudCamera, cloudColors, cloudVolume } from '../helpers/polar-cloud.ts';
import { isEdge, listOff } from '../helpers/edges.ts';
import { blocks, mixedLooks } from '../helpers/labels.ts';
import { comparePictures, drawPicture, drawReference, height, plainOptics, raysOf, referenceOf, shareScene, width } from '../helpers/picture.ts';
import type { Clips, View } from '../helpers/picture.ts';
import { syntheticVolume } from '../helpers/synthetic.ts';

const turned: readonly number[] = [0.9, 0.5, 0, -9, -0.5, 0.9, 0, -2, 0, 0, 1.4, -8, 0, 0, 0, 1];
const volume = syntheticVolume({ dimensions: [16, 14, 12], indexToWorld: turned });
const { center } = boundingSphere(volume.grid);
const diagonal = longestDiagonal(volume.grid);
const storm = cloudVolume(1);
/** Of the cloud, metres. */
const cloud: Vector3 = [16_600, 6_000, 9_400];

const place = (...offset: Vector3): Vector3 => [0, 1, 2].map((axis) => center[axis] + offset[axis]) as unknown as Vector3;
const normals: readonly Vector3[] = [[1, 0, 0], [-1, 0.2, 0], [0, 1, 0.3], [0.1, -1, 0], [0, 0, 1], [0.3, 0.3, -1]];
/** Six planes around the middle. */
const six = (of: Volume): Clips['kept'] => normals.map((normal) => keep(of.grid, normal, normal.reduce((sum, x, axis) => sum + x * center[axis], 0) - 4.5));

interface Case {
  readonly name: string;
  readonly clips: Clips;
  readonly orbit?: Orbit;
  readonly more?: Partial<View>;
}

const octant = cutBox(volume.grid, place(-0.7, -0.4, -0.3), place(40, 40, 40));
const hole = cutBox(volume.grid, place(-2.6, -2.2, -1.9), place(2.1, 2.9, 2.4));

const cases: Case[] = [
  { name: 'six planes', clips: { kept: six(volume), cutout: cutBox(volume.grid, place(90, 90, 90), place(91, 91, 91)) } },
  { name: 'a corner', clips: { kept: [keep(volume.grid, [1, 2, 0.5], 2)], cutout: octant } },
  { name: 'a hole in the middle', clips: { kept: [], cutout: hole }, more: { stepLength: diagonal / 25 } },
  { name: 'from inside of what is cut out', clips: { kept: six(volume), cutout: hole }, orbit: { theta: 1, phi: 1.1, radius: 0.02 } },
];

/** By program, so that few are made. */
const projected: readonly ProjectionKind[] = ['max', 'average'];

for (const webgl1 of [false, true]) {
  describe(`what is cut away${webgl1 ? ' in WebGL 1' : ''}`, () => {
    const scene = shareScene({ webgl1 });

    const viewOf = ({ clips, orbit = { theta: 0.6, phi: 1.1, radius: 1.3 }, more }: Case): View => ({
      volume, clips, camera: orbitCamera({ ...orbit, radius: orbit.radius * diagonal }, center, 0.7), stepLength: diagonal / 60, ...more,
    });

    const compare = (view: View): Uint8ClampedArray => {
      const picture = drawPicture(scene(), view);
      const reference = drawReference(view);
      expect(reference.filter((x, i) => i % 4 === 3 && x > 20).length, 'pixels that show something').to.be.above(80);
      expect(comparePictures(drawReference({ ...view, clips: undefined }), reference).worst, 'something is cut away').to.be.above(20);
      expect(comparePictures(picture, reference).worst).to.be.below(2.01);
      return picture;
    };

    for (const one of cases) {
      it(`${one.name}: the same as in float64, and skipping changes nothing`, () => {
        const view = viewOf(one);
        const picture = compare(view);
        scene().layers[0].skipping = false;
        const all = drawPicture(scene(), view);
        scene().layers[0].skipping = true;
        expect(comparePictures(picture, all).worst).to.equal(0);
      });
    }

    it('a slice in it is not seen, one beside it is', () => {
      const plane = { kind: 'plane', slab: null, normal: [0.2, -0.1, 1], offset: 0.55, window: [0, 1] } as const;
      const view = viewOf({ ...cases[1], more: { planes: [plane] } });
      const [picture, reference, whole] = [drawPicture(scene(), view), drawReference(view), drawReference({ ...view, clips: undefined })];
      const opaque = (data: ArrayLike<number>): number => Array.from(data).filter((x, i) => i % 4 === 3 && x > 254).length;
      expect(opaque(reference)).to.be.within(30, opaque(whole) - 30);
      const atEdge = (pixel: number): boolean => Math.abs(picture[4 * pixel + 3] - reference[4 * pixel + 3]) > 60;
      expect(Array.from({ length: reference.length / 4 }, (_, pixel) => pixel).filter(atEdge).length).to.be.below(4);
      expect(comparePictures(picture, reference, atEdge).worst).to.be.below(2.01);
    });

    for (const projection of projected) {
      it(`${projection} of both pieces of a ray: the same as in float64`, async () => {
        await scene().setStyle(projection);
        compare(viewOf({ ...cases[2], more: { projection } }));
        await scene().setStyle(null);
      });
    }

    it('of a volume with labels: the same as in float64', async () => {
      const labels = mixedLooks(blocks(volume.grid.dimensions, 9));
      await scene().setLabels(labels);
      const view = { ...viewOf(cases[1]), labels };
      const picture = drawPicture(scene(), view);
      const [reference, whole] = [drawReference(view), drawReference({ ...view, clips: undefined })];
      const rays = raysOf(view);
      const stages = stagesOf(referenceOf(view), rays);
      const edges = new Set([...listOff(picture, reference)].filter((pixel) => isEdge(stages, rays, pixel)));
      expect(edges.size).to.be.below(0.02 * width * height);
      expect(comparePictures(picture, reference, (pixel) => edges.has(pixel)).worst).to.be.below(2.01);
      expect(comparePictures(whole, reference).worst).to.be.above(20);
      await scene().setLabels(null);
    });

    it('a storm of a radar: the same as in float64', async () => {
      await scene().prepare(storm);
      compare({
        volume: storm, camera: cloudCamera, stepLength: longestDiagonal(storm.grid) / 150, optics: { ...plainOptics, transferFunction: cloudColors, referenceLength: 3000 },
        clips: { kept: [keep(storm.grid, [0.2, -0.1, -1], -11_000)], cutout: cutBox(storm.grid, cloud, [60_000, 60_000, 60_000]) },
      });
    });
  });
}
