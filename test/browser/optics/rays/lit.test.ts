import { expect } from '@esm-bundle/chai';
import { orbitCamera, viewMatrix } from '../../../../src/optics/rays/camera.ts';
import { castRay } from '../../../../src/optics/rays/cast-ray.ts';
import { fadeAtCuts, uncut } from '../../../../src/optics/rays/cut-fade.ts';
import { cartesianGradient, differ, flatChange, weighChange } from '../../../../src/optics/rays/gradient.ts';
import {
  fogFlat,
  fogMaterial,
  headlightAlone,
  plainMaterial,
  shadeSurface,
} from '../../../../src/optics/transfer/lights.ts';
import type { LitMaterial, SceneLight } from '../../../../src/optics/transfer/lights.ts';
import { litShade, pointField } from '../../../../src/optics/rays/lit.ts';
import { cartesianField, storedField } from '../../../../src/optics/rays/ray-field.ts';
import { setUpRays } from '../../../../src/optics/rays/rays.ts';
import { stagesOf } from '../../../../src/optics/reference.ts';
import type { ReferenceScene } from '../../../../src/optics/reference.ts';
import { beamTaps, beamToLocalGradient, polarGradient } from '../../../../src/radar/polar-gradient.ts';
import { beamToLocal, standardEarthRadius, stretchOf } from '../../../../src/radar/polar-geometry.ts';
import { unitToWorld } from '../../../../src/volume/grid.ts';
import { dot, identity, normalize, transformPoint } from '../../../../src/volume/matrix.ts';
import type { Matrix4, Vector3 } from '../../../../src/volume/matrix.ts';
import { cutRegion } from '../../../../src/volume/region.ts';
import { plainOptics } from '../../../helpers/picture.ts';
import { castPixels } from '../../../helpers/pixel-rays.ts';
import { obliqueAffine, randomNumbers, syntheticVolume } from '../../../helpers/synthetic.ts';
import { evenAzimuths, radarVolume } from '../../../helpers/synthetic-radar.ts';

/** A parallel projection of a square, so wide in world units. */
const parallel = (wide: number): Matrix4 => [2 / wide, 0, 0, 0, 0, 2 / wide, 0, 0, 0, 0, -0.001, 0, 0, 0, 0, 1];

const matte = { ...plainMaterial, specular: 0 };

describe('gradients', () => {
  it('are those of precomputed central differences, interpolated, inside of the grid', () => {
    const volume = syntheticVolume({
      dimensions: [9, 8, 7],
      kind: 'float32',
      field: (x, y, z) => Math.sin(7 * x) * Math.cos(5 * y + z),
    });
    const { grid, samples } = volume;
    const gradient = cartesianGradient(cartesianField({ ...volume, dimensions: grid.dimensions }), grid);
    const [nx, ny] = grid.dimensions;
    const at = (i: number, j: number, k: number): number => samples[i + nx * (j + ny * k)];
    const place = [3.3, 4.7, 2.9]; // In voxels, centres at whole numbers.
    let expected = 0;
    for (const corner of [0, 1, 2, 3, 4, 5, 6, 7]) {
      const [i, j, k] = place.map((x, axis) => Math.floor(x) + ((corner >> axis) & 1));
      const weight = place.reduce((product, x, axis) => product * ((corner >> axis) & 1 ? x % 1 : 1 - (x % 1)), 1);
      expected += (weight * (at(i, j + 1, k) - at(i, j - 1, k))) / 2;
    }
    const unit = place.map((x, axis) => (x + 0.5) / grid.dimensions[axis]) as unknown as Vector3;
    const known = cartesianField({ ...volume, dimensions: grid.dimensions }).sampleAt(unit);
    expect(gradient(unit, known).perVoxel[1]).to.be.closeTo(expected, 1e-12);
  });

  it('stand at right angles to the planes of a linear field, on sheared grids too', () => {
    const random = randomNumbers(5);
    for (let n = 0; n < 20; n++) {
      const volume = syntheticVolume({
        dimensions: [8, 9, 10],
        kind: 'float32',
        indexToWorld: obliqueAffine(random, [0.4, 1, 3], [5, 6, 7]),
        field: () => 0,
      });
      const normal = normalize([random() - 0.5, random() - 0.5, random() - 0.5]);
      const toWorld = unitToWorld(volume.grid);
      const field = storedField((p) => dot(normal, transformPoint(toWorld, p)), { slope: 1, intercept: 0 });
      const { world } = cartesianGradient(field, volume.grid)([0.4, 0.5, 0.6], field.sampleAt([0.4, 0.5, 0.6]));
      expect(dot(normalize(world), normal)).to.be.closeTo(1, 1e-12);
    }
  });

  it('are one-sided next to no data, and none where a value folds or nothing is known', () => {
    const known = { value: 5, valid: true };
    const tap = (value: number) => ({ value, valid: !Number.isNaN(value) });
    const taps = [
      [NaN, 7],
      [2, NaN],
      [NaN, NaN],
    ];
    expect(
      differ(
        known,
        (axis, side) => tap(taps[axis][side < 0 ? 0 : 1]),
        () => false,
      ),
    ).to.deep.equal([2, 3, 0]);
    expect(
      differ(
        known,
        (_, side) => tap(side < 0 ? 4 : -50),
        (a, b) => Math.abs(a - b) > 20,
      ),
    ).to.deep.equal([1, 1, 1]);
  });

  it("of height are vertical in a radar's grid, with displayed heights and over a round Earth", () => {
    const volume = radarVolume(
      {
        sweeps: [0.5, 3, 8].map((elevation) => ({
          elevation,
          azimuths: evenAzimuths(360),
          gates: 400,
          gateLength: 500,
        })),
        beamWidth: 1,
      },
      { verticalExaggeration: 5 },
    );
    const { grid } = volume;
    // Height, tilted to the east by half: each known exactly by range, azimuth and elevation.
    for (const tilt of [0, 0.5]) {
      const field = {
        isFolded: () => false,
        sampleBeam: (beam: Parameters<typeof beamToLocal>[0]) => {
          const [x, , z] = beamToLocal(beam, grid.earthRadius);
          return { value: z + tilt * x, valid: true };
        },
      };
      for (const [range, azimuth, elevation] of [
        [20e3, 10, 2],
        [90e3, 100, 4],
        [180e3, 359.8, 1],
        [60e3, 225, 7.5],
      ]) {
        const local = beamToLocal({ range, azimuth, elevation }, grid.earthRadius);
        const { low, high } = grid.box;
        const place = local.map((x, i) => (x - low[i]) / (high[i] - low[i])) as unknown as Vector3;
        const { world } = polarGradient(field, grid)(place, { value: local[2] + tilt * local[0], valid: true });
        const expected = normalize([tilt, 0, 1 / stretchOf(grid)]);
        expect(dot(normalize(world), expected), `${range} ${azimuth} ${elevation} ${tilt}`).to.be.above(
          Math.cos(0.004),
        );
      }
    }
  });

  it('are taken from radial to radial where a radar looks at a sector, across north too', () => {
    const angleOf = (azimuths: readonly number[], beamWidth = 0.9): number =>
      beamTaps(
        radarVolume({ sweeps: [0.5, 3].map((elevation) => ({ elevation, azimuths, gates: 20 })), beamWidth }, {}).grid,
      ).angle;
    const sector = Array.from({ length: 40 }, (_, i) => (340.5 + i) % 360);
    expect(angleOf(sector)).to.be.closeTo(1, 1e-9);
    expect(angleOf(sector, 1.4)).to.equal(1.4);
    expect(angleOf(evenAzimuths(40))).to.be.closeTo(9, 1e-9);
    expect(angleOf([77])).to.equal(0.9);
  });

  it('by beam and by metres are the same change', () => {
    const field = ([x, y, z]: Vector3): number => 2 * x - 3 * y + 5 * z;
    const [range, azimuth, elevation] = [70e3, 200, 3];
    const at = (r: number, a: number, e: number): number =>
      field(beamToLocal({ range: r, azimuth: a, elevation: e }, standardEarthRadius));
    const degree = Math.PI / 180;
    const h = 1e-3;
    const byBeam: Vector3 = [
      (at(range + 1, azimuth, elevation) - at(range - 1, azimuth, elevation)) / 2,
      (at(range, azimuth + h, elevation) - at(range, azimuth - h, elevation)) / (2 * h * degree),
      (at(range, azimuth, elevation + h) - at(range, azimuth, elevation - h)) / (2 * h * degree),
    ];
    const local = beamToLocalGradient(
      byBeam,
      beamToLocal({ range, azimuth, elevation }, standardEarthRadius),
      standardEarthRadius,
    );
    [2, -3, 5].forEach((x, i) => expect(local[i]).to.be.closeTo(x, 1e-6));
  });
});

describe('what lies next to a cut', () => {
  it('is lit from a voxel on, whatever cuts it', () => {
    const fade = (cuts: Partial<typeof uncut>, place: Vector3): number =>
      fadeAtCuts({ ...uncut, ...cuts }, [10, 20, 40])(place);
    expect(fade({}, [0.5, 0.5, 0.5])).to.equal(1);
    expect(fade({}, [0.05, 0.5, 0.5]), 'half a voxel').to.be.closeTo(0.5, 1e-12);
    expect(fade({}, [0.5, 0.5, 1 - 0.25 / 40])).to.be.closeTo(0.25, 1e-12);
    const half: Matrix4 = [2, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
    expect(fade({ unitToRegion: half }, [0.47, 0.5, 0.5]), 'a region').to.be.closeTo(0.3, 1e-12);
    expect(fade({ halfSpaces: [{ normal: [0, 0, 3], offset: 1.5 }] }, [0.5, 0.5, 0.505]), 'a plane').to.be.closeTo(
      0.2,
      1e-12,
    );
    expect(fade({ halfSpaces: [{ normal: [0, 0, 3], offset: 1.5 }] }, [0.5, 0.5, 0.4]), 'beyond it').to.equal(0);
    expect(fade({ unitToCutout: half }, [0.53, 0.5, 0.5]), 'a box that is cut out').to.be.closeTo(0.3, 1e-12);
    expect(fade({ unitToCutout: identity }, [0.5, 0.5, 0.5])).to.equal(0);
  });
});

describe('light', () => {
  const place: Vector3 = [0, 0, 0];
  const toEye: Vector3 = [0, 0, 1];
  const facing = normalize([0.3, -0.2, 0.8]);
  const sun: SceneLight = {
    kind: 'directional',
    color: [1, 1, 1],
    intensity: 1,
    ambientIntensity: 0,
    direction: [0, 0, -1],
    location: [0, 0, 0],
    attenuation: [1, 0, 0],
    radius: Infinity,
    beamWidth: 0.3,
    cutOffAngle: 0.5,
  };

  it('at the eye leaves what faces it its own colour, and ambient light at edges', () => {
    const at = (normal: Vector3) => shadeSurface(headlightAlone, matte, { place, normal, toEye });
    expect(at(toEye).diffuse[0]).to.be.closeTo(1, 1e-12);
    expect(at([0, 0, -1]).diffuse[0], 'both sides').to.be.closeTo(1, 1e-12);
    expect(at([1, 0, 0]).diffuse[0]).to.be.closeTo(0.3, 1e-12);
  });

  it("from the eye's side is as from the eye, and from behind none", () => {
    const by = (light: SceneLight, normal = facing) =>
      shadeSurface({ headlight: false, lights: [light] }, plainMaterial, { place, normal, toEye });
    const [ours, theirs] = [by(sun), shadeSurface(headlightAlone, plainMaterial, { place, normal: facing, toEye })];
    expect(ours.diffuse[0]).to.be.closeTo(theirs.diffuse[0], 1e-12);
    expect(ours.specular[0]).to.be.closeTo(theirs.specular[0], 1e-12);
    expect(by({ ...sun, direction: [0, 0, 1] }).diffuse[0]).to.be.closeTo(plainMaterial.ambient, 1e-12);
    expect(by(sun, [-facing[0], -facing[1], -facing[2]]).diffuse[0], 'the normal turned round').to.be.closeTo(
      ours.diffuse[0],
      1e-12,
    );
    expect(
      by({ ...sun, color: [1, 0, 0.5], intensity: 0.5 }).diffuse.map(
        (x) => Math.round((1e9 * (x - 0.3)) / (ours.diffuse[0] - 0.3)) / 1e9,
      ),
    ).to.deep.equal([0.5, 0, 0.25]);
  });

  it('of a place falls off as X3D says, and a spot ends at its edge', () => {
    const lamp: SceneLight = { ...sun, kind: 'point', location: [0, 0, 10] };
    const diffuse = (light: SceneLight): number =>
      (shadeSurface({ headlight: false, lights: [light] }, matte, { place, normal: toEye, toEye }).diffuse[0] - 0.3) /
      0.7;
    expect(diffuse(lamp), 'none').to.be.closeTo(1, 1e-12);
    expect(diffuse({ ...lamp, attenuation: [1, 0.1, 0.02] })).to.be.closeTo(1 / 4, 1e-12);
    expect(diffuse({ ...lamp, radius: 9 })).to.equal(0);
    const aim = (angle: number): Vector3 => [Math.sin(angle), 0, -Math.cos(angle)];
    for (const [angle, share] of [
      [0.2, 1],
      [0.4, 0.5],
      [0.6, 0],
    ])
      expect(diffuse({ ...lamp, kind: 'spot', direction: aim(angle) }), String(angle)).to.be.closeTo(share, 1e-9);
  });

  it('changes by noise no more than noise is of what counts as a change', () => {
    const random = randomNumbers(3);
    const shadeOf = (perVoxel: Vector3): number => {
      const weight = weighChange(perVoxel, 1);
      return (
        1 + weight * (shadeSurface(headlightAlone, matte, { place, normal: normalize(perVoxel), toEye }).diffuse[0] - 1)
      );
    };
    let worst = 0;
    for (let n = 0; n < 4000; n++) {
      const size = 10 ** (3 * random() - 2);
      const [g, noise] = [0, 1].map(() => [random() - 0.5, random() - 0.5, random() - 0.5]);
      const base = normalize(g as unknown as Vector3).map((x) => x * size) as unknown as Vector3;
      const sigma = 1e-4;
      const moved = base.map((x, i) => x + (sigma * noise[i]) / Math.hypot(...noise)) as unknown as Vector3;
      worst = Math.max(worst, Math.abs(shadeOf(moved) - shadeOf(base)) / sigma);
    }
    // The weight rises by 9 / (8 sqrt 3) at most, the direction turns by 1 / 2 of it at most: at right angles to each other.
    const bound = 0.7 * Math.hypot(9 / (8 * Math.sqrt(3)), 0.5);
    console.log(`noise of one flat change: ${worst.toFixed(3)} of shade, bound ${bound.toFixed(3)}`);
    expect(worst).to.be.within(0.6 * bound, bound);
  });
});

describe('a lit volume', () => {
  const size: [number, number] = [9, 9];

  it('of a linear field is the unlit one times a constant', () => {
    const volume = syntheticVolume({ dimensions: [20, 20, 20], kind: 'float32', field: () => 0 });
    const normal: Vector3 = [0.04, 0.02, 0.05];
    const field = storedField(([x, y, z]) => 0.1 + 8 * (normal[0] * x + normal[1] * y + normal[2] * z), {
      slope: 1,
      intercept: 0,
    });
    const camera = orbitCamera({ theta: 0.7, phi: 1, radius: 60 }, [0, 0, 0], 0.3);
    // In the middle, as cuts fade.
    const region = cutRegion(volume.grid, [-6, -6, -6, 6, 6, 6])!;
    const rays = setUpRays(volume.grid, viewMatrix(camera), parallel(8), region)!;
    const transferFunction = [
      { value: 0, color: [0.1, 0.2, 0.3], opacity: 0.02 },
      { value: 1.5, color: [0.5, 0.3, 0.2], opacity: 0.3 },
    ] as const;
    const scene: ReferenceScene = { ...volume, ...plainOptics, transferFunction, field, stepLength: 0.7 };
    const gradient = cartesianGradient(field, volume.grid);
    const flat = flatChange([0, 1.5], [0, 1]);
    const lit = {
      moreFields: [pointField],
      shades: [litShade({ grid: volume.grid, gradient, flat: flat / fogFlat, material: matte })],
    };
    const [stages, litOnes] = [stagesOf(scene, rays), stagesOf({ ...scene, ...lit }, rays)];
    const plain = castPixels(rays, size, (ray) => castRay(stages, ray));
    const seen = castPixels(rays, size, (ray) => castRay(litOnes, ray));
    const ray = setUpRays(volume.grid, viewMatrix(camera), parallel(8))!.direction[0];
    const toEye = normalize(ray.map((x, i) => -x * (i < 2 ? -20 : 20)) as unknown as Vector3);
    const { perVoxel, world } = gradient([0.5, 0.5, 0.5], field.sampleAt([0.5, 0.5, 0.5]));
    const factor =
      1 + weighChange(perVoxel, flat) * (matte.ambient + matte.diffuse * Math.abs(dot(normalize(world), toEye)) - 1);
    expect(factor).to.be.within(0.4, 0.9);
    expect(Math.max(...plain)).to.be.above(0.2);
    seen.forEach((x, i) => expect(x).to.be.closeTo(plain[i] * (i % 4 === 3 ? 1 : factor), 1e-12));
  });

  it('is asked for its gradients only where something shows', () => {
    const volume = syntheticVolume({ dimensions: [20, 20, 20], kind: 'float32', field: () => 0 });
    const fromMiddle = (p: Vector3): number => Math.hypot(...p.map((x) => 20 * (x - 0.5)));
    const field = storedField((p) => 6 - fromMiddle(p), { slope: 1, intercept: 0 });
    const transferFunction = [
      { value: 0, color: [1, 1, 1], opacity: 0 },
      { value: 6, color: [1, 1, 1], opacity: 0.1 },
    ] as const;
    const rays = setUpRays(
      volume.grid,
      viewMatrix(orbitCamera({ theta: 0.4, phi: 1.2, radius: 60 }, [0, 0, 0], 0.3)),
      parallel(20),
    )!;
    const asked: number[] = [];
    const gradient = cartesianGradient(field, volume.grid);
    const shade = litShade({
      grid: volume.grid,
      flat: 0.1,
      gradient: (place, known) => (asked.push(fromMiddle(place)), gradient(place, known)),
    });
    const stepLength = 0.5;
    const stages = stagesOf(
      { ...volume, ...plainOptics, transferFunction, field, stepLength, moreFields: [pointField], shades: [shade] },
      rays,
    );
    const opacities = castPixels(rays, size, (ray) => castRay(stages, ray)).filter((_, i) => i % 4 === 3);
    expect(opacities.filter((opacity) => opacity === 0)).to.have.length.above(20);
    expect(opacities.filter((opacity) => opacity > 0)).to.have.length.above(20);
    expect(asked).to.have.length.above(200);
    // A piece of a ray that shows at one end is lit at both.
    expect(Math.max(...asked)).to.be.within(6, 6 + stepLength);
  });

  it('that is an opaque sphere has two thirds of diffuse light over its disc, in a parallel projection; as it is by default it is about as bright as without light', function () {
    this.timeout(180_000);
    const volume = syntheticVolume({ dimensions: [64, 64, 64], kind: 'float32', field: () => 0 });
    const radius = 20;
    const field = storedField((p) => radius - Math.hypot(...p.map((x) => 64 * (x - 0.5))), { slope: 1, intercept: 0 });
    const rays = setUpRays(
      volume.grid,
      viewMatrix(orbitCamera({ theta: 0.4, phi: 1.2, radius: 200 }, [0, 0, 0], 0.3)),
      parallel(2 * radius),
    )!;
    const gray = 0.5;
    const transferFunction = [
      { value: -0.02, color: [gray, gray, gray], opacity: 0 },
      { value: 0.02, color: [gray, gray, gray], opacity: 0.999 },
    ] as const;
    const gradient = cartesianGradient(field, volume.grid);
    const meanOf = (side: number, material?: LitMaterial): number => {
      const lit = {
        moreFields: [pointField],
        shades: [litShade({ grid: volume.grid, gradient, flat: 1e-6, ...(material && { material }) })],
      };
      const scene: ReferenceScene = {
        ...volume,
        ...plainOptics,
        transferFunction,
        field,
        opacityFactor: 100,
        stepLength: 0.25,
        ...lit,
      };
      const stages = stagesOf(scene, rays);
      const picture = castPixels(rays, [side, side], (ray) => castRay(stages, ray));
      let [sum, count] = [0, 0];
      for (let i = 0; i < picture.length; i += 4) {
        sum += picture[i];
        count += picture[i + 3];
      }
      return sum / count / gray;
    };
    expect(meanOf(60, { ambient: 0, diffuse: 1, specular: 0, shininess: 1 })).to.be.closeTo(2 / 3, 0.005);
    const { ambient, diffuse, specular, shininess } = fogMaterial;
    const expected = ambient + (2 / 3) * diffuse + ((2 / (shininess + 2)) * specular) / gray;
    expect(expected).to.be.within(0.92, 1);
    expect(meanOf(24)).to.be.closeTo(expected, 0.01);
  });
});
