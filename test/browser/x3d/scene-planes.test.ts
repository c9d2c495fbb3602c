// Planes through cartesian volumes: the GPU against the float64 twin.
import { expect } from '@esm-bundle/chai';
import { orbitCamera } from '../../../src/optics/rays/camera.ts';
import type { Orbit } from '../../../src/optics/rays/camera.ts';
import { sampleSlab } from '../../../src/optics/attachments/plane-slices.ts';
import type { PlaneSlice } from '../../../src/optics/attachments/plane-slices.ts';
import { cartesianField } from '../../../src/optics/rays/ray-field.ts';
import { fillRows } from '../../../src/panes/fill-slice.ts';
import { SlicedVolume } from '../../../src/panes/slice-field.ts';
import { planeOf } from '../../../src/panes/slice-plane.ts';
import { readPlanes } from '../../../src/viewer/cuts/read-planes.ts';
import { boundingSphere, longestDiagonal } from '../../../src/volume/grid.ts';
import { dot, invertAffine, transformPoint } from '../../../src/volume/matrix.ts';
import type { Vector3 } from '../../../src/volume/matrix.ts';
import { unitToWorld } from '../../../src/volume/grid.ts';
import type { CartesianGrid } from '../../../src/volume/grid.ts';
import { casesIn } from '../../helpers/cases.ts';
import { cloudVolume } from '../../helpers/polar-cloud.ts';
import { bothWalks, comparePictures, drawPicture, drawReference, shareScene } from '../../helpers/picture.ts';
import { syntheticVolume } from '../../helpers/synthetic.ts';

const volume = syntheticVolume({ dimensions: [14, 18, 11], spacing: [1, 0.8, 1.4] });

/** The planes that tags ask for, of a volume of values from 0 to 1. */
function planesOf(
  html: string,
  window: readonly [number, number] | null = null,
  of = volume,
): { planes: readonly PlaneSlice[]; code: string | null; message: string } {
  const host = document.createElement('div');
  host.innerHTML = html;
  const { cuts, error } = readPlanes([...host.children], of, window);
  return {
    planes: (cuts[0]?.items ?? []) as readonly PlaneSlice[],
    code: error?.code ?? null,
    message: error?.message ?? '',
  };
}

const slice = (attributes: string): string => `<volume-slice ${attributes}></volume-slice>`;

interface Case {
  readonly name: string;
  readonly html: string;
  readonly orbit?: Orbit;
  readonly opacityFactor?: number;
}

const cases: Case[] = [
  { name: 'axial', html: slice('type="axial" value-window="0 1"') },
  {
    name: 'three, with nothing around them',
    html: ['axial', 'coronal', 'sagittal'].map((type) => slice(`type="${type}" value-window="0.1 0.7"`)).join(''),
    opacityFactor: 0,
  },
  {
    name: "oblique, in the volume's colours, from below",
    html: slice('type="oblique" normal="0.4 -1 0.7" colors="volume"'),
    orbit: { theta: 2, phi: 2.3, radius: 1.2 },
  },
  {
    name: 'a narrow window',
    html: slice('type="coronal" value-window="0.5 0.52"'),
    orbit: { theta: 0.2, phi: 1.4, radius: 1 },
  },
  {
    name: 'thick ones: the mean, the largest and the smallest value',
    html: ['axial" projection="average', 'coronal" projection="max', 'sagittal" projection="min']
      .map((type) => slice(`type="${type}" thickness="4.5" value-window="0 1"`))
      .join(''),
    opacityFactor: 0,
  },
  {
    name: "a thick and a thin one, in the volume's colours",
    html:
      slice('type="oblique" normal="1 2 3" thickness="3" projection="max" colors="volume"') +
      slice('type="axial" at="-2" value-window="0 1"'),
    orbit: { theta: 2, phi: 2.3, radius: 1.2 },
  },
  {
    name: 'four at once, from inside',
    html: ['axial', 'coronal', 'sagittal', 'oblique']
      .map((type) => slice(`type="${type}" normal="1 1 1" value-window="0 1"`))
      .join(''),
    orbit: { theta: 1, phi: 1.1, radius: 0.15 },
  },
];

for (const webgl1 of [false, true]) {
  describe(`planes through a volume${webgl1 ? ' in WebGL 1' : ''}`, () => {
    const scene = shareScene({ webgl1 });

    for (const { name, html, orbit = { theta: 0.6, phi: 1.1, radius: 1.1 }, opacityFactor = 0.4 } of casesIn(
      webgl1 ? 1 : 2,
      cases,
      (_, i) => [1, 4, 5].includes(i),
    )) {
      it(`${name}: the same as in float64`, () => {
        const sphere = boundingSphere(volume.grid);
        const { planes, code } = planesOf(html);
        expect(code).to.equal(null);
        const camera = orbitCamera({ ...orbit, radius: orbit.radius * 3 * sphere.radius }, sphere.center, 0.6);
        const views = bothWalks({
          volume,
          camera,
          planes,
          stepLength: longestDiagonal(volume.grid) / 40,
          optics: {
            transferFunction: [
              { value: 0.15, color: [0, 0, 0.4], opacity: 0 },
              { value: 0.4, color: [0.9, 0.3, 0.1], opacity: 0.06 },
              { value: 0.8, color: [1, 1, 0.8], opacity: 0.35 },
            ],
            referenceLength: 1,
            opacityFactor,
            lightFactor: 1,
          },
        });
        for (const view of views) {
          const picture = drawPicture(scene(), view);
          const reference = drawReference(view);
          const lit = reference.filter((x, i) => i % 4 === 3 && x > 254).length;
          expect(lit, 'opaque pixels').to.be.above(100);
          // A pixel at a plane's very edge may be on the other side of it in floats.
          const atEdge = (pixel: number): boolean => Math.abs(picture[4 * pixel + 3] - reference[4 * pixel + 3]) > 100;
          const edges = Array.from({ length: reference.length / 4 }, (_, pixel) => pixel).filter(atEdge).length;
          expect(edges, 'pixels at edges').to.be.below(4);
          expect(comparePictures(picture, reference, atEdge).worst).to.be.below(2.01);
        }
      });
    }
  });
}

describe('tags of planes', () => {
  it('lie where they say, in the middle by default', () => {
    const toWorld = unitToWorld(volume.grid);
    for (const [html, normal, at] of [
      [slice('type="sagittal" at="0.3"'), [1, 0, 0], 0.3],
      [slice('type="axial"'), [0, 0, 1], null],
      [slice('type="oblique" normal="0 3 4" at="-0.2"'), [0, 0.6, 0.8], -0.2],
    ] as const) {
      const {
        planes: [plane],
      } = planesOf(html);
      // Where the plane meets a line through the unit cube, the world has the place that was asked for.
      const [from, along] = [
        [0.2, 0.1, 0.3],
        [0.5, 0.7, 0.4],
      ] as const;
      const t = (plane.offset - dot(plane.normal, from)) / dot(plane.normal, along);
      const place = transformPoint(toWorld, [from[0] + t * along[0], from[1] + t * along[1], from[2] + t * along[2]]);
      const expected = at ?? dot(normal, boundingSphere(volume.grid).center);
      expect(dot(normal, place), html).to.be.closeTo(expected, 1e-9);
    }
  });

  it('that are thick show what a pane shows of the same slab', () => {
    const grid = volume.grid as CartesianGrid;
    const sliced = new SlicedVolume(volume, grid);
    const field = cartesianField({ ...volume, dimensions: grid.dimensions });
    const toUnit = invertAffine(unitToWorld(grid))!;
    for (const projection of ['average', 'max', 'min'] as const) {
      const {
        planes: [plane],
      } = planesOf(slice(`type="oblique" normal="1 -2 2" thickness="5" projection="${projection}"`));
      const normal: Vector3 = [1 / 3, -2 / 3, 2 / 3];
      const slab = { normal, thickness: 5, projection };
      expect(plane.slab!.kind).to.equal(projection);
      for (const world of [
        [0.3, 0.2, -0.7],
        [3, -2, 4],
        [-6.4, 2, 1],
      ] as const) {
        const values = new Float64Array(1);
        fillRows(
          {
            field: sliced.field(false),
            pixels: { width: 1, height: 1, first: world, across: [1, 0, 0], down: [0, 1, 0] },
            slab,
          },
          values,
          [0, 1],
        );
        const { value } = sampleSlab(field, transformPoint(toUnit, world), plane.slab!);
        expect(value, `${projection} at ${world.join(', ')}`).to.be.closeTo(
          volume.slope * values[0] + volume.intercept,
          1e-12,
        );
      }
    }
    expect(planesOf(slice('type="axial" thickness="0"')).planes[0].slab).to.equal(null);
    const labels = { ...volume, isDiscrete: true };
    expect(planesOf(slice('type="axial" thickness="4"'), null, labels).planes[0].slab, 'labels have no mean').to.equal(
      null,
    );
    expect(planesOf(slice('type="axial" thickness="4" projection="max"'), null, labels).planes[0].slab).not.to.equal(
      null,
    );
    expect(
      new SlicedVolume(labels, grid).thicknessAt(0, { normal: [0, 0, 1], thickness: 4, projection: 'average' }),
    ).to.equal(0);
    // What is far thicker than the volume shows all of it.
    const { low, high } = sliced.boxAlong(planeOf('axial'));
    const [all, more] = [high.d - low.d, 1e6].map(
      (thickness) => planesOf(slice(`type="axial" thickness="${thickness}"`)).planes[0].slab!,
    );
    for (const one of [all, more]) expect(Math.abs(one.way[2])).to.be.closeTo(1, 1e-9);
    expect(planesOf(slice('type="axial" thickness="-1"')).code).to.equal('attribute/invalid');
  });

  it('have the window of the tag, of the page, or one that suits; labels have their colours', () => {
    expect(planesOf(slice('type="axial" value-window="2 7"'), [0, 1]).planes[0].window).to.deep.equal([2, 7]);
    expect(planesOf(slice('type="axial" value-window="2 7" window-function="linear"')).planes[0].window).to.deep.equal([
      2, 6,
    ]);
    expect(planesOf(slice('type="axial"'), [3, 4]).planes[0].window).to.deep.equal([3, 4]);
    expect(planesOf(slice('type="axial"'), null, { ...volume, unit: 'HU' }).planes[0].window).to.deep.equal([
      -160, 240,
    ]);
    expect(planesOf(slice('type="axial"'), null, { ...volume, isDiscrete: true }).planes[0].window).to.equal(null);
  });

  it('that can not be read are left out, and the first error is reported', () => {
    for (const [attributes, said] of [
      ['type="diagonal"', 'axial or coronal'],
      ['type="oblique" normal="0 0 0"', 'may not be 0 0 0'],
      ['type="axial" at="x"', 'a place along'],
      ['type="axial" at="1e300"', 'a place along'],
      ['type="axial" value-window="3 1"', 'the lower value first'],
      ['type="axial" colors="red"', 'gray or volume'],
      ['type="oblique" normal="1e300 0 0"', 'a direction'],
    ] as const) {
      const { planes, code, message } = planesOf(slice(attributes) + slice('type="axial"'));
      expect(planes, attributes).to.have.length(1);
      expect(code, attributes).to.equal('attribute/invalid');
      expect(message).to.contain(said);
    }
    expect(planesOf(slice('type="axial"').repeat(5)).message).to.contain('at most 4');
    expect(planesOf(slice('type="axial"'), null, cloudVolume(1)).message).to.contain('ppi, cappi, rhi or section');
  });
});
