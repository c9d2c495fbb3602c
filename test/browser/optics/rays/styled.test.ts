// X3D's rendering styles against their formulas.
import { expect } from '@esm-bundle/chai';
import { orbitCamera, viewMatrix } from '../../../../src/optics/rays/camera.ts';
import { castRay } from '../../../../src/optics/rays/cast-ray.ts';
import { cartesianGradient, flatChange, flatShare, weighChange } from '../../../../src/optics/rays/gradient.ts';
import { clipInterval } from '../../../../src/optics/rays/clip-intervals.ts';
import type { RayStyle } from '../../../../src/optics/rays/ray-style.ts';
import type { SceneLights } from '../../../../src/optics/transfer/lights.ts';
import { maxSubsteps } from '../../../../src/optics/transfer/substep-limits.ts';
import { litShade, pointField } from '../../../../src/optics/rays/lit.ts';
import { cartesianField, storedField } from '../../../../src/optics/rays/ray-field.ts';
import type { RayStages, ShadeStage } from '../../../../src/optics/rays/ray-stages.ts';
import { setUpRays } from '../../../../src/optics/rays/rays.ts';
import type { RaySetup } from '../../../../src/optics/rays/rays.ts';
import { stagesOf } from '../../../../src/optics/reference.ts';
import type { ReferenceScene } from '../../../../src/optics/reference.ts';
import { composite } from '../../../../src/optics/rays/segment.ts';
import { perGradientReach, styledShade } from '../../../../src/optics/rays/styled.ts';
import {
  buildStyleTable,
  fromHsv,
  gradientReach,
  shareOfChange,
  styleColumns,
  toHsv,
  withLight,
} from '../../../../src/optics/transfer/volume-styles.ts';
import type { StyleChain, VolumeStyle } from '../../../../src/optics/transfer/volume-styles.ts';
import type { Premultiplied } from '../../../../src/optics/transfer/transfer-function.ts';
import { composeTwins, loadTwins } from '../../../../src/renderer/ray/compose-twins.ts';
import { createClip } from '../../../../src/renderer/ray/modules/clip.ts';
import type { Optics, RayCut } from '../../../../src/renderer/ray/ray-module.ts';
import { dot, normalize } from '../../../../src/volume/matrix.ts';
import type { Matrix4, Vector3 } from '../../../../src/volume/matrix.ts';
import { cutRegion } from '../../../../src/volume/region.ts';
import type { Volume } from '../../../../src/volume/volume.ts';
import { plainOptics } from '../../../helpers/picture.ts';
import { castPixels } from '../../../helpers/pixel-rays.ts';
import { createQuietLayer } from '../../../helpers/quiet-layer.ts';
import { syntheticVolume } from '../../../helpers/synthetic.ts';

const parallel = (wide: number): Matrix4 => [2 / wide, 0, 0, 0, 0, 2 / wide, 0, 0, 0, 0, -0.001, 0, 0, 0, 0, 1];

const volume = syntheticVolume({ dimensions: [20, 20, 20], kind: 'float32', field: () => 0 });
const slopes: Vector3 = [0.04, 0.02, 0.05];
/** Linear: it changes by `slopes` from voxel to voxel, which are a world unit apart. */
const field = storedField(([x, y, z]) => 0.1 + 20 * (slopes[0] * (x - 0.2) + slopes[1] * y + slopes[2] * (z - 0.2)), {
  slope: 1,
  intercept: 0,
});
const camera = orbitCamera({ theta: 0.7, phi: 1, radius: 60 }, [0, 0, 0], 0.3);
// In the middle, as cuts fade.
const rays = setUpRays(volume.grid, viewMatrix(camera), parallel(8), cutRegion(volume.grid, [-6, -6, -6, 6, 6, 6]))!;
/** One colour, and an extinction that does not depend on the value. */
const transferFunction = [
  { value: 0, color: [0.6, 0.3, 0.2], opacity: 0.03 },
  { value: 1.5, color: [0.6, 0.3, 0.2], opacity: 0.03 },
] as const;
const gradient = cartesianGradient(field, volume.grid);
const flat = flatChange([0, 1.5], [0, 1]);
const referenceLength = 1.3;

interface Drawn {
  readonly stepLength?: number;
  readonly opacityFactor?: number;
  readonly lights?: SceneLights;
}

function draw(styles: readonly VolumeStyle[] | null, options: Drawn = {}): Premultiplied[] {
  return drawChains(styles && [{ weight: 1, styles }], options);
}

function drawChains(
  chains: readonly StyleChain[] | null,
  { stepLength = 0.7, opacityFactor = 1, lights }: Drawn = {},
): Premultiplied[] {
  const opticalScale = (rays.diameter / referenceLength) * opacityFactor;
  const shades = chains
    ? [
        styledShade({
          grid: volume.grid,
          gradient,
          flat,
          chains,
          referenceLength,
          opticalScale,
          ...(lights && { lights }),
        }),
      ]
    : [];
  const scene: ReferenceScene = {
    ...volume,
    ...plainOptics,
    transferFunction,
    referenceLength,
    opacityFactor,
    field,
    stepLength,
    moreFields: [pointField],
    shades,
  };
  const stages = stagesOf(scene, rays);
  const picture = castPixels(rays, [5, 5], (ray) => castRay(stages, ray));
  return Array.from({ length: 25 }, (_, i) => picture.slice(4 * i, 4 * i + 4) as unknown as Premultiplied);
}

const depth = (alpha: number): number => -Math.log1p(-alpha);
const direction = setUpRays(volume.grid, viewMatrix(camera), parallel(8))!.direction[0];
const toEye = normalize(direction.map((x, i) => -x * (i < 2 ? -20 : 20)) as unknown as Vector3);

describe('on a linear field', () => {
  const { perVoxel, world } = gradient([0.5, 0.5, 0.5], field.sampleAt([0.5, 0.5, 0.5]));
  const facing = Math.abs(dot(normalize(world), toEye));
  const weight = weighChange(perVoxel, flat);
  const change = (Math.hypot(...slopes) * referenceLength) / 1.5;
  const entry = (row: number, share: number, styles: VolumeStyle[]): number[] => {
    const table = buildStyleTable(styles);
    const at = share * (styleColumns - 1);
    const low = Math.floor(at);
    return [0, 1, 2, 3].map(
      (c) =>
        table[4 * (row * styleColumns + low) + c] * (1 - at + low) +
        table[4 * (row * styleColumns + low + 1) + c] * (at - low),
    );
  };

  it('is as steep as it is', () => {
    expect(Math.hypot(...perVoxel)).to.be.closeTo(Math.hypot(...slopes), 1e-12);
    expect(facing).to.be.within(0.1, 0.99);
    expect(flat).to.equal(1.5 * flatShare);
  });

  for (const [name, style, expected] of [
    ['boundary', { kind: 'boundary', retained: 0.2, boundary: 9, power: 1.5 }, 0.2 + 9 * change ** 1.5],
    [
      'gradient-opacity',
      {
        kind: 'gradient',
        stops: [
          [0.01, 0.2],
          [0.1, 0.92],
        ],
      },
      0.2 + (0.72 * (Math.hypot(...slopes) - 0.01)) / 0.09,
    ],
    [
      'silhouette',
      { kind: 'silhouette', retained: 0.3, boundary: 1.1, sharpness: 3 },
      0.3 + weight * 1.1 * (1 - facing) ** 3,
    ],
  ] as const satisfies readonly (readonly [string, VolumeStyle, number])[]) {
    it(`${name}: the opacity of a reference length is X3D's, times a constant, at any step`, () => {
      const own = 0.03;
      const expectedDepth = -Math.log1p(-expected * own);
      for (const stepLength of [0.35, 0.7, 2]) {
        const [plain, seen] = [draw(null, { stepLength }), draw([style], { stepLength })];
        const factor = depth(seen[12][3]) / depth(plain[12][3]);
        expect(factor, 'extinction, but for the table').to.be.closeTo(expectedDepth / -Math.log1p(-own), 1e-3);
        plain.forEach((before, i) => {
          expect(depth(seen[i][3]) / depth(before[3]), 'extinction').to.be.closeTo(factor, 1e-12);
          expect(seen[i][0] / seen[i][3], 'colour').to.be.closeTo(before[0] / before[3], 1e-12);
        });
      }
    });
  }

  for (const style of [
    { kind: 'edge', color: [0, 0.1, 0.4], threshold: 0.4 },
    { kind: 'cartoon', parallel: [0, 0, 0], orthogonal: [1, 0.5, 0], steps: 4 },
  ] as const satisfies readonly VolumeStyle[]) {
    it(`${style.kind}: colours are the formula's, opacity stays`, () => {
      const [plain, seen] = [draw(null), draw([style])];
      const row = entry(1, facing, [style]);
      plain.forEach((before, i) => {
        expect(seen[i][3]).to.be.closeTo(before[3], 1e-12);
        [0, 1, 2].forEach((c) =>
          expect(seen[i][c] / seen[i][3]).to.be.closeTo(
            (1 + weight * (row[3] - 1)) * transferFunction[0].color[c] + weight * row[c],
            1e-12,
          ),
        );
      });
    });
  }

  it('tone: cool to warm by the mean of the lights, and a light that is not at the eye says so', () => {
    const style: VolumeStyle = { kind: 'tone', cool: [0, 0, 1], warm: [1, 1, 0] };
    const away = toEye.map((x) => x) as unknown as Vector3;
    const lights: SceneLights = {
      headlight: false,
      lights: [
        {
          kind: 'directional',
          color: [1, 1, 1],
          intensity: 0.5,
          ambientIntensity: 0,
          direction: away,
          location: [0, 0, 0],
          attenuation: [1, 0, 0],
          radius: Infinity,
          beamWidth: 0,
          cutOffAngle: 0,
        },
      ],
    };
    for (const [towards, options] of [
      [facing, {}],
      [-facing, { lights }],
    ] as const) {
      const share = 0.5 + 0.5 * towards;
      for (const seen of draw([style], options)) {
        expect(seen[0] / seen[3]).to.be.closeTo((1 - weight) * 0.6 + weight * share, 1e-12);
        expect(seen[1] / seen[3]).to.be.closeTo((1 - weight) * 0.3 + weight * share, 1e-12);
        expect(seen[2] / seen[3]).to.be.closeTo((1 - weight) * 0.2 + weight * (1 - share), 1e-12);
      }
    }
  });

  it("shaded: Blinn and Phong's light by its material", () => {
    const light = 0.2 + facing;
    const seen = draw([
      {
        kind: 'shaded',
        material: { ambient: 0.2, diffuse: [0.5, 1, 0.25], specular: [0, 0.3, 0], emissive: [0.1, 0, 0], shininess: 8 },
      },
    ]);
    expect(seen).to.have.length(25);
    for (const [red, green, blue, opacity] of seen) {
      expect(red / opacity).to.be.closeTo(0.6 * (1 + weight * (0.5 * light - 1)) + weight * 0.1, 1e-12);
      expect(green / opacity).to.be.closeTo(0.3 * (1 + weight * (light - 1)) + weight * 0.3 * facing ** 8, 1e-12);
      expect(blue / opacity).to.be.closeTo(0.2 * (1 + weight * (0.25 * light - 1)), 1e-12);
    }
  });

  it('blended: opacities and colours of both by their weights, at any step', () => {
    const [boundary, silhouette]: VolumeStyle[] = [
      { kind: 'boundary', retained: 0.2, boundary: 9, power: 1.5 },
      { kind: 'silhouette', retained: 0.3, boundary: 1.1, sharpness: 3 },
    ];
    const [edge, cartoon]: VolumeStyle[] = [
      { kind: 'edge', color: [0, 0.1, 0.4], threshold: 0.9 },
      { kind: 'cartoon', parallel: [0, 0, 0], orthogonal: [1, 0.5, 0], steps: 4 },
    ];
    const weights = [0.7, 0.25];
    const opacities = [
      entry(3, shareOfChange(change), [boundary])[1],
      0.3 + weight * (entry(3, facing, [silhouette])[0] - 0.3),
    ];
    const rows = [edge, cartoon].map((style) => entry(1, facing, [style]));
    const own = 0.03;
    const expectedDepth = -Math.log1p(-own * (weights[0] * opacities[0] + weights[1] * opacities[1]));
    const chains = [
      { weight: weights[0], styles: [boundary, edge] },
      { weight: weights[1], styles: [silhouette, cartoon] },
    ];
    for (const stepLength of [0.35, 0.7, 2]) {
      const [plain, seen] = [draw(null, { stepLength }), drawChains(chains, { stepLength })];
      plain.forEach((before, i) => {
        expect(depth(seen[i][3]) / depth(before[3]), 'extinction').to.be.closeTo(
          expectedDepth / -Math.log1p(-own),
          1e-12,
        );
        [0, 1, 2].forEach((c) => {
          const parts = rows.map(
            (row, chain) =>
              weights[chain] * ((1 + weight * (row[3] - 1)) * transferFunction[0].color[c] + weight * row[c]),
          );
          expect(seen[i][c] / seen[i][3], 'colour').to.be.closeTo(parts[0] + parts[1], 1e-12);
        });
      });
    }
  });

  it('twice at half the opacity factor is once', () => {
    const styles: VolumeStyle[] = [
      { kind: 'boundary', retained: 0.3, boundary: 2, power: 1 },
      { kind: 'silhouette', retained: 0.5, boundary: 1, sharpness: 0.5 },
    ];
    const [once, half] = [draw(styles), draw(styles, { opacityFactor: 0.5 })];
    once.forEach((expected, i) => {
      const twice: Premultiplied = [...half[i]];
      composite(twice, half[i]);
      twice.forEach((x, c) => expect(x).to.be.closeTo(expected[c], 1e-12));
    });
  });
});

describe('a table of styles', () => {
  const row = (styles: VolumeStyle[], y: number, x: number): number[] => [
    ...buildStyleTable(styles).slice(4 * (y * styleColumns + x), 4 * (y * styleColumns + x) + 4),
  ];
  const edge: VolumeStyle = { kind: 'edge', color: [1, 0, 0], threshold: 0.4 };

  it('of none changes nothing', () => {
    for (const y of [0, 1, 2]) expect(row([], y, 100)).to.deep.equal([0, 0, 0, 1]);
    expect(row([], 3, 100).slice(0, 2)).to.deep.equal([1, 1]);
  });

  it("draws edges where X3D does: beyond the angle of the threshold, 85 % of a sphere's disc by default", () => {
    const table = buildStyleTable([edge]);
    let area = 0;
    for (let i = 0; i < styleColumns; i++) area += (1 - table[4 * (styleColumns + i) + 3]) * 2 * (i / 255) * (1 / 255);
    expect(area).to.be.closeTo(0.85, 0.01);
    expect(row([edge], 1, 250)).to.deep.equal([0, 0, 0, 1]);
  });

  it('has as many colours as there are steps, between the ends, without a hue that neither has', () => {
    const style: VolumeStyle = { kind: 'cartoon', parallel: [0, 0, 0], orthogonal: [0.2, 0.4, 1], steps: 4 };
    const seen = [255, 200, 130, 10].map((x) => row([style], 1, x).map((v) => Math.round(1e6 * v) / 1e6));
    expect(seen.map(([, , blue]) => blue)).to.deep.equal([0, 0.333333, 0.666667, 1]);
    seen.forEach(
      ([red, green, blue]) =>
        expect(red).to.be.closeTo(0.2 * blue, 1e-5) && expect(green).to.be.closeTo(0.4 * blue, 1e-5),
    );
    expect(
      row([{ ...style, steps: 1 }], 1, 255)
        .slice(0, 3)
        .map((x) => Math.round(1e9 * x) / 1e9),
    ).to.deep.equal([0.2, 0.4, 1]);
  });

  it('has the factors of gradient-opacity up to where they stay the same: between stops within a column, jumps and all', () => {
    const stops = [
      [0, 0.1],
      [20, 0.1],
      [20, 0.6],
      [50, 1],
      [900, 1],
    ] as const;
    const style: VolumeStyle = { kind: 'gradient', stops };
    expect(gradientReach([edge, style])).to.equal(50);
    expect(gradientReach([edge])).to.equal(0);
    for (const [at, factor] of [
      [0, 0.1],
      [101, 0.1],
      [102, 0.6],
      [255, 1],
    ])
      expect(row([edge, style], 3, at)[2]).to.be.closeTo(factor, 1e-12);
    expect(row([style], 3, 204)[2]).to.be.closeTo(0.6 + (0.4 * 20) / 30, 1e-12);
    expect(
      row(
        [
          {
            kind: 'gradient',
            stops: [
              [3, 0.4],
              [9, 0.4],
            ],
          },
        ],
        3,
        77,
      )[2],
    ).to.equal(0.4);
    expect(
      Math.fround(
        perGradientReach(
          [
            {
              kind: 'gradient',
              stops: [
                [0, 0],
                [1e-299, 1],
              ],
            },
          ],
          1,
          1,
        ),
      ),
      'a number of the shader',
    ).to.be.below(Infinity);
  });

  it('forgets what stands before a style that sets the colour again, and keeps the order around light', () => {
    expect(row([edge, { kind: 'tone', cool: [0, 0, 0], warm: [1, 1, 1] }], 1, 0)).to.deep.equal([0, 0, 0, 1]);
    const styles: VolumeStyle[] = [{ kind: 'shaded', material: null }, edge];
    expect(row(styles, 1, 0)).to.deep.equal([0, 0, 0, 1]);
    expect(row(styles, 2, 0)).to.deep.equal([1, 0, 0, 0]);
  });

  it('knows hues', () => {
    for (const color of [
      [1, 0, 0],
      [0.2, 0.9, 0.3],
      [0.1, 0.2, 0.8],
      [0.9, 0.1, 0.8],
      [0.5, 0.5, 0.5],
    ] as const)
      fromHsv(toHsv(color)).forEach((x, c) => expect(x).to.be.closeTo(color[c], 1e-12));
  });
});

describe('a lit view with a style', () => {
  it('has the light of lit fog, where the style leaves all as it is', () => {
    const draws = (shade: ShadeStage): readonly number[] => {
      const scene: ReferenceScene = {
        ...volume,
        ...plainOptics,
        transferFunction,
        referenceLength,
        field,
        stepLength: 0.7,
        moreFields: [pointField],
        shades: [shade],
      };
      const stages = stagesOf(scene, rays);
      return castPixels(rays, [3, 3], (ray) => castRay(stages, ray));
    };
    const surroundings = {
      grid: volume.grid,
      gradient,
      flat,
      referenceLength,
      opticalScale: rays.diameter / referenceLength,
    };
    const fog = draws(litShade(surroundings));
    const styles: VolumeStyle[] = [{ kind: 'gradient', stops: [[0, 1]] }];
    const styled = draws(styledShade({ ...surroundings, chains: withLight([{ weight: 1, styles }]) }));
    styled.forEach((x, i) => expect(x).to.be.closeTo(fog[i], 1e-9));
    expect(
      Math.max(
        ...fog.map((x, i) => Math.abs(x - draws(styledShade({ ...surroundings, chains: [{ weight: 1, styles }] }))[i])),
      ),
    ).to.be.above(0.01);
  });
});

/** The stages of a pick's rays through a ball. */
async function pickedStages(
  ball: Volume,
  setup: RaySetup,
  {
    style,
    optics,
    stepLength,
    cuts = [],
  }: { style: RayStyle; optics: Optics; stepLength: number; cuts?: readonly RayCut[] },
): Promise<RayStages> {
  const layer = createQuietLayer();
  await layer.prepare(ball, optics);
  layer.set(ball);
  layer.plan = { ...layer.plan, cuts };
  await layer.setAppearance({ optics, style });
  const twins = layer.twins(false, true)!;
  const frame = { volume: ball, optics, rays: setup, placesOnly: true };
  await loadTwins(twins, frame);
  return composeTwins(twins, frame, { stepLength, maxSubsteps });
}

describe('a pick in a volume that has styles', () => {
  it('casts the rays of the picture: cuts, region and all', async () => {
    const styles: VolumeStyle[] = [
      { kind: 'boundary', retained: 0.3, boundary: 2, power: 1 },
      { kind: 'silhouette', retained: 0.2, boundary: 1, sharpness: 0.5 },
    ];
    const ball = syntheticVolume({
      dimensions: [12, 12, 12],
      kind: 'float32',
      field: (x, y, z) => 1.4 - 2 * Math.hypot(x - 0.5, y - 0.5, z - 0.5),
    });
    const { grid } = ball;
    const setup = setUpRays(grid, viewMatrix(camera), parallel(8), cutRegion(grid, [-5, -5, -5, 4, 4, 4]))!;
    const optics = { ...plainOptics, transferFunction, opacityFactor: 0.7, referenceLength };
    const kept = { kind: 'half-space' as const, normal: [1, 0.2, 0] as Vector3, offset: 0.5 };
    const own = cartesianField({ ...ball, dimensions: grid.dimensions });
    const expected = styledShade({
      grid,
      gradient: cartesianGradient(own, grid),
      flat: flatChange([0, 1.5], ball.range),
      chains: [{ weight: 1, styles }],
      referenceLength,
      opticalScale: (0.7 * setup.diameter) / referenceLength,
      cuts: { unitToRegion: setup.unitToRegion, halfSpaces: [kept], unitToCutout: null },
    });
    const scene: ReferenceScene = {
      ...ball,
      ...optics,
      stepLength: 0.7,
      moreFields: [pointField],
      shades: [expected],
      ends: [clipInterval([kept])],
    };
    const picked = await pickedStages(ball, setup, {
      style: { styles: [{ weight: 1, styles }] },
      optics,
      stepLength: 0.7,
      cuts: [{ create: createClip, items: [kept] }],
    });
    const pictures = [stagesOf(scene, setup), picked].map((stages) =>
      castPixels(setup, [5, 5], (ray) => castRay(stages, ray)),
    );
    expect(Math.max(...pictures[0])).to.be.above(0.05);
    expect(pictures[1]).to.deep.equal(pictures[0]);
  });

  it('sees surfaces as thin as their silhouette makes them', async () => {
    const ball = syntheticVolume({
      dimensions: [24, 24, 24],
      kind: 'float32',
      field: (x, y, z) => 1.4 - 2 * Math.hypot(x - 0.5, y - 0.5, z - 0.5),
    });
    const setup = setUpRays(ball.grid, viewMatrix(camera), parallel(8), null)!;
    const surfaces = { surfaces: [{ value: 0.9, color: [1, 1, 1], opacity: 0.8 }], clear: true } as const;
    const optics = { ...plainOptics, transferFunction, referenceLength };
    const opacityOf = async (retained: number): Promise<number> => {
      const style: RayStyle = {
        ...surfaces,
        surfaceStyles: [{ kind: 'silhouette', retained, boundary: 0, sharpness: 1 }],
      };
      const stages = await pickedStages(ball, setup, { style, optics, stepLength: 0.5 });
      return castPixels(setup, [1, 1], (ray) => castRay(stages, ray))[3];
    };
    // In, and out again.
    expect(await opacityOf(1)).to.be.closeTo(1 - 0.2 ** 2, 1e-6);
    expect(await opacityOf(0.25), 'of a quarter').to.be.closeTo(1 - 0.8 ** 2, 1e-3);
  });
});
