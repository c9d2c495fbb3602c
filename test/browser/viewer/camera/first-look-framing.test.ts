import { expect } from '@esm-bundle/chai';
import { orbitCamera, projectionMatrix, viewMatrix } from '../../../../src/optics/rays/camera.ts';
import { framePlaces } from '../../../../src/optics/rays/frame-places.ts';
import { interpolate } from '../../../../src/optics/rays/interpolate.ts';
import { cartesianField } from '../../../../src/optics/rays/ray-field.ts';
import { findSeenPlaces } from '../../../../src/optics/transfer/seen-places.ts';
import type { TransferFunction } from '../../../../src/optics/transfer/transfer-function.ts';
import { rotate } from '../../../../src/viewer/camera/camera-moves.ts';
import { CameraRig } from '../../../../src/viewer/camera/camera-rig.ts';
import { createFraming } from '../../../../src/viewer/camera/framing.ts';
import { boundingSphere, cartesianGrid } from '../../../../src/volume/grid.ts';
import { buildMacrocells } from '../../../../src/volume/macrocells.ts';
import { summarize } from '../../../../src/volume/histogram.ts';
import type { Vector3 } from '../../../../src/volume/matrix.ts';
import { cutRegion } from '../../../../src/volume/region.ts';
import type { Volume } from '../../../../src/volume/volume.ts';
import { socketOf } from '../../../../src/viewer/model/view-socket.ts';
import { placesOf } from '../../../../src/viewer/attachments/surface-places.ts';
import { ballPly, surfaceOf } from '../../../helpers/meshes.ts';
import { randomNumbers } from '../../../helpers/synthetic.ts';
import { evenAzimuths, radarVolume } from '../../../helpers/synthetic-radar.ts';

const size: Vector3 = [40, 30, 20];
const white = (value: number, opacity: number) => ({ value, color: [1, 1, 1] as const, opacity });
const fromHundred: TransferFunction = [white(100, 0), white(100, 0.2), white(255, 0.2)];

/** Voxels of 1 x 2 x 3, from the origin on; 200 in a block of them, else a background that no look here shows. */
function block(low: Vector3, high: Vector3): Volume {
  const grid = cartesianGrid(size, [1, 0, 0, 0.5, 0, 2, 0, 1, 0, 0, 3, 1.5, 0, 0, 0, 1]);
  const samples = new Uint8Array(size[0] * size[1] * size[2]).fill(20);
  for (let k = low[2]; k < high[2]; k++)
    for (let j = low[1]; j < high[1]; j++)
      samples.fill(200, low[0] + size[0] * (j + size[1] * k), high[0] + size[0] * (j + size[1] * k));
  return {
    grid,
    samples,
    slope: 1,
    intercept: 0,
    unit: '',
    format: 'test',
    ...summarize(samples, 1, 0),
    macrocells: buildMacrocells(samples, size),
  };
}

function boundsOf(places: readonly Vector3[]): number[][] {
  return [0, 1, 2].map((axis) => [Math.min, Math.max].map((end) => end(...places.map((place) => place[axis]))));
}

/** Where places lie in a picture, -1..1 across and down. */
function project(
  places: readonly Vector3[],
  framed: { target: Vector3; radius: number },
  [theta, phi, aspect]: readonly [number, number, number],
): number[][] {
  const camera = orbitCamera({ theta, phi, radius: framed.radius }, framed.target, 0.5);
  const [view, p] = [viewMatrix(camera), projectionMatrix(0.5, aspect, 0.1, 1e4)];
  return boundsOf(
    places.map(([x, y, z]) => {
      const eye = [0, 4, 8].map((row) => view[row] * x + view[row + 1] * y + view[row + 2] * z + view[row + 3]);
      return [(p[0] * eye[0]) / -eye[2], (p[5] * eye[1]) / -eye[2], 0];
    }),
  ).slice(0, 2);
}

describe('what the camera frames', () => {
  const volume = block([5, 6, 7], [17, 9, 12]);
  const edges = [
    [5, 17],
    [12, 18],
    [21, 36],
  ];

  it('is where something is seen, to the voxel, and not the box', () => {
    expect(boundsOf(findSeenPlaces(volume, fromHundred, volume.grid))).to.deep.equal(edges);
  });

  it('is nothing where nothing is seen, and leaves haze out', () => {
    expect(findSeenPlaces(volume, [white(210, 0), white(255, 1)], volume.grid)).to.deep.equal([]);
    const haze: TransferFunction = [white(0, 0.001), white(99, 0.001), ...fromHundred];
    expect(boundsOf(findSeenPlaces(volume, haze, volume.grid))).to.deep.equal(edges);
  });

  it('is only what a region shows', () => {
    const region = cutRegion(volume.grid, [0, 0, 0, 10, 100, 100])!;
    expect(boundsOf(findSeenPlaces(volume, fromHundred, region))).to.deep.equal([[5, 10], edges[1], edges[2]]);
  });

  it('leaves out no place that is farthest out in any direction, of whatever is seen, and most of the others', () => {
    const random = randomNumbers(3);
    const field = (i: number, j: number, k: number): boolean =>
      (i - 20) ** 2 / 200 + (j - 15) ** 2 / 100 + (k - 10) ** 2 / 60 < 0.4 + random();
    const { samples, ...rest } = block([0, 0, 0], [0, 0, 0]);
    samples.forEach(
      (_, at) => (samples[at] = field(at % 40, Math.floor(at / 40) % 30, Math.floor(at / 1200)) ? 200 : 20),
    );
    const all: Vector3[] = [];
    samples.forEach((value, at) => {
      const [i, j, k] = [at % 40, Math.floor(at / 40) % 30, Math.floor(at / 1200)];
      if (value === 200)
        for (const x of [i, i + 1]) for (const y of [j, j + 1]) for (const z of [k, k + 1]) all.push([x, 2 * y, 3 * z]);
    });
    const places = findSeenPlaces({ ...rest, samples }, fromHundred, rest.grid);
    expect(places.length).to.be.within(50, all.length / 10);
    for (let n = 0; n < 200; n++) {
      const direction = [random() - 0.5, random() - 0.5, random() - 0.5];
      const farthest = (some: readonly Vector3[]): number =>
        Math.max(...some.map((place) => place.reduce((sum, x, axis) => sum + x * direction[axis], 0)));
      expect(farthest(places)).to.be.closeTo(farthest(all), 1e-9);
    }
  });

  it('of a radar is where echoes are', () => {
    const stored = (azimuth: number, gate: number): number =>
      azimuth > 80 && azimuth < 100 && gate > 30 && gate < 40 ? 200 : 1;
    const { grid, ...rest } = radarVolume({
      sweeps: [1, 3, 5].map((elevation) => ({
        elevation,
        azimuths: evenAzimuths(120),
        gates: 60,
        gateLength: 500,
        stored,
      })),
    });
    const [x, y] = boundsOf(findSeenPlaces({ grid, ...rest }, [white(20, 0), white(60, 0.5)], grid));
    expect(x[0]).to.be.within(8_000, 16_000);
    expect(x[1]).to.be.within(19_000, 27_000);
    expect(Math.max(-y[0], y[1])).to.be.below(9_000);
  });

  it('fills 86 % of the side that it fills most, and is in the middle of both, in any shape of picture and from any side', () => {
    const places = findSeenPlaces(volume, fromHundred, volume.grid);
    for (const view of [
      [0.5, 1.3, 4 / 3],
      [0.5, 1.3, 0.46],
      [2, 0.4, 2.2],
      [-1, 3, 1],
    ] as const) {
      const [theta, phi, aspect] = view;
      const spans = project(places, framePlaces(places, { theta, phi, fieldOfView: 0.5, aspect }), view);
      expect(Math.max(...spans.map(([low, high]) => (high - low) / 2))).to.be.closeTo(0.86, 0.01);
      for (const [low, high] of spans) expect(Math.abs(low + high)).to.be.below(0.08);
    }
  });

  it("is all in the picture around a target of the author's", () => {
    const places = findSeenPlaces(volume, fromHundred, volume.grid);
    const framed = framePlaces(places, { theta: 0.5, phi: 1.3, fieldOfView: 0.5, aspect: 1 }, [5, 12, 21]);
    expect(framed.target).to.deep.equal([5, 12, 21]);
    const farthest = Math.max(...project(places, framed, [0.5, 1.3, 1]).flat().map(Math.abs));
    expect(farthest).to.be.closeTo(0.86, 1e-6);
  });
});

describe('the camera rig and what is seen', () => {
  const volume = block([5, 6, 7], [17, 9, 12]);
  const subject = {
    ...boundingSphere(volume.grid),
    findFraming: () => createFraming(volume, fromHundred, volume.grid),
  };

  it('frames it where the author says no distance, and the box where they do', () => {
    const [free, turned, given] = [{}, { theta: 1 }, { radius: { fraction: 1 } }].map((attributes) => {
      const rig = new CameraRig();
      rig.setAttributes(attributes);
      rig.setSubject(subject);
      return rig;
    });
    expect(free.camera.target[0]).to.be.closeTo(11, 1.5);
    expect(turned.orbit.theta).to.equal(1);
    expect(turned.orbit.radius).not.to.equal(free.orbit.radius);
    expect(given.camera.target).to.deep.equal(subject.center);
    expect(given.orbit.radius).to.be.above(1.5 * free.orbit.radius);
  });

  it('keeps its view where other colours or another scan come in the same place, and frames again in another shape', () => {
    const rig = new CameraRig();
    rig.setSubject(subject);
    const before = rig.camera;
    rig.setSubject({
      ...subject,
      findFraming: () => createFraming(block([0, 0, 0], [40, 30, 20]), fromHundred, volume.grid),
    });
    expect(rig.camera).to.deep.equal(before);
    rig.setAspect(0.4);
    expect(rig.orbit.radius).not.to.equal(before.eye[0]);
    rotate(rig, 1, 0);
    rig.advance(1, true);
    const { radius } = rig.orbit;
    rig.setAspect(2);
    expect(rig.orbit.radius, "a person's view stays").to.equal(radius);
  });

  it("frames what comes to be known later, but not under a person's hand", () => {
    for (const touched of [false, true]) {
      const rig = new CameraRig();
      rig.setSubject({ ...subject, findFraming: undefined });
      const whole = rig.orbit.radius;
      if (touched) rotate(rig, 0.1, 0);
      rig.setSubject(subject);
      expect(rig.orbit.radius === whole).to.equal(touched);
    }
  });
});

describe('a field of labels', () => {
  it('has the value that most of the voxels around say, by their weights, and nothing between two', () => {
    const samples = Uint8Array.from([3, 17, 3, 40, 0, 9, 9, 3]);
    const field = cartesianField({ samples, dimensions: [2, 2, 2], slope: 1, intercept: 0, isDiscrete: true });
    const smooth = cartesianField({ samples, dimensions: [2, 2, 2], slope: 1, intercept: 0 });
    for (let i = 0; i < 200; i++) {
      const place: Vector3 = [(i * 0.37) % 1, (i * 0.61) % 1, (i * 0.83) % 1];
      const { value } = field.sampleAt(place);
      expect([...samples]).to.include(value);
      const votes = new Map<number, number>();
      samples.forEach((label, corner) => {
        const weight = place.reduce((all, x, axis) => {
          const upper = Math.min(1, Math.max(0, 2 * x - 0.5));
          return all * ((corner >> axis) & 1 ? upper : 1 - upper);
        }, 1);
        votes.set(label, (votes.get(label) ?? 0) + weight);
      });
      expect(votes.get(value)).to.be.closeTo(Math.max(...votes.values()), 1e-12);
      expect(smooth.sampleAt(place).value).to.equal(interpolate(samples, [2, 2, 2], place));
    }
    expect([field.isFolded(3, 17), field.isFolded(3, 3), smooth.isFolded(3, 17)]).to.deep.equal([true, false, false]);
  });
});

describe('surfaces that are larger than what is seen', () => {
  it('are framed alone where nothing of the volume is seen, whenever they come before the first picture, and may go', async () => {
    const volume = block([10, 10, 5], [20, 20, 10]);
    const host = document.createElement('div');
    const framing = createFraming(volume, [white(210, 0), white(255, 1)], volume.grid, host);
    const from = { theta: 0.5, phi: 1.2, fieldOfView: 0.5, aspect: 1.5 };
    expect(framing(from, null), 'nothing').to.equal(null);
    const surface = await surfaceOf(ballPly([30, 20, 20], 6));
    const part = { key: 'surface', bounds: () => placesOf(surface) };
    void socketOf(host).join(part);
    framing(from, null)!.target.forEach((x, axis) => expect(x).to.be.closeTo([30, 20, 20][axis], 0.5));
    void socketOf(host).leave(part);
    host.dispatchEvent(new Event('render'));
    expect(framing(from, null), 'gone').to.equal(null);
  });

  it('are framed too if they are there by the first picture, and move nothing later', async () => {
    const volume = block([10, 10, 5], [20, 20, 10]);
    const host = document.createElement('div');
    const surface = await surfaceOf(ballPly([30, 20, 20], 60));
    const places = placesOf(surface);
    const part = { key: 'surface', bounds: () => places };
    const create = createFraming(volume, fromHundred, volume.grid, host);
    const framing = (...from: Parameters<typeof create>): NonNullable<ReturnType<typeof create>> => create(...from)!;
    const from = { theta: 0.5, phi: 1.2, fieldOfView: 0.5, aspect: 1.5 };
    const bare = framing(from, null);
    void socketOf(host).join(part);
    const both = framing(from, null);
    expect(both.radius).to.be.above(2 * bare.radius);
    // All vertices, of which not each is looked at, are in the picture, and fill most of it.
    const vertices = surface.parts.flatMap(({ positions }) =>
      Array.from(
        { length: positions.length / 3 },
        (_, i) => [...positions.subarray(3 * i, 3 * i + 3)] as unknown as Vector3,
      ),
    );
    for (const [low, high] of project(vertices, both, [from.theta, from.phi, from.aspect]).slice(1, 2)) {
      expect(low).to.be.within(-0.9, -0.8);
      expect(high).to.be.within(0.8, 0.9);
    }
    expect(places.length).to.be.at.most(2006);

    void socketOf(host).leave(part);
    host.dispatchEvent(new Event('render'));
    void socketOf(host).join(part);
    expect(framing(from, null), 'after a picture without it').to.deep.equal(bare);
    void socketOf(host).join({ ...part, isExpected: true });
    expect(framing(from, null), 'its file was loading then').to.deep.equal(both);
    expect(
      placesOf({ ...surface, terrain: { error: 0, meanError: 0, heights: [0, 1], voids: 0 } }),
      'terrain',
    ).to.deep.equal([]);
  });
});
