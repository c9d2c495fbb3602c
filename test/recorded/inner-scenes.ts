// Scenes of what an element does only by itself, when it sees fit: adaptive rays, pictures in pieces, probes.
import type { Box, Drawing, Radar, Shown } from './scene-adapter.ts';

export interface InnerScene {
  /** Scenes of one family may have the same picture. */
  readonly family: string;
  readonly name: string;
  readonly shown: Shown;
  /** Floats for a probe. */
  readonly use: (drawing: Drawing) => Uint8ClampedArray | Float32Array;
}

const shells = (x: number, y: number, z: number): number => {
  const r = Math.hypot(x - 0.5, y - 0.45, z - 0.55);
  return r < 0.5 ? 0.5 + 0.5 * Math.sin(30 * r + 2 * x) : 0;
};
const hole = (x: number, y: number, z: number): number =>
  Math.hypot(x - 0.3, y - 0.5, z - 0.6) < 0.2 ? NaN : shells(x, y, z);

const box = (kind: Box['kind'], field: Box['field'] = shells): Box => ({ dimensions: [36, 40, 32], kind, field });

const circle = (rays: number, first = 180 / rays): number[] =>
  Array.from({ length: rays }, (_, i) => first + (i * 360) / rays);

/** A storm to the north-east and a band of rain, 0..1. */
const rain = (azimuth: number, gate: number): number => {
  const [x, y] = [gate * Math.sin((azimuth * Math.PI) / 180), gate * Math.cos((azimuth * Math.PI) / 180)];
  return Math.min(
    1,
    Math.exp(-(((x - 18) / 9) ** 2 + ((y - 15) / 9) ** 2)) + 0.6 * Math.exp(-(((y + 8 + 0.3 * x) / 5) ** 2)),
  );
};
/** An elevation that goes up and down. */
const wave =
  (elevation: number, height: number, phase: number) =>
  (azimuth: number): number =>
    elevation + height * Math.sin((3 * azimuth * Math.PI) / 180 + phase);

type Sweep = Radar['sweeps'][number];

const radar = (change: (sweep: Sweep, i: number) => Partial<Sweep> = () => ({}), more: Partial<Radar> = {}): Radar => ({
  exaggeration: 3,
  ...more,
  sweeps: [0.5, 1.5, 3, 6, 12].map((elevation, i) => {
    const sweep: Sweep = {
      elevation,
      azimuths: circle(48),
      gates: 40,
      kind: 'uint8',
      stored: (a, g) => 1 + Math.round(254 * rain(a, g)),
      slope: 0.5,
      intercept: -32,
    };
    return { ...sweep, ...change(sweep, i) };
  }),
});

const view = { orbit: { theta: 0.6, phi: 1.1, radius: 1.1 }, width: 151, height: 113, steps: 70 };

const ofBox = (volume: Box, more: Partial<Shown> = {}): Shown => ({
  ...view,
  volume,
  stops: [
    { value: 0.2, color: [0, 0, 0.4], opacity: 0 },
    { value: 0.5, color: [0.9, 0.3, 0.1], opacity: 0.1 },
    { value: 0.9, color: [1, 1, 0.8], opacity: 0.5 },
  ],
  referenceLength: 0.12,
  ...more,
});

const ofRadar = (volume: Radar, more: Partial<Shown> = {}): Shown => ({
  ...view,
  volume,
  stops: [
    { value: -15, color: [0.1, 0.3, 1], opacity: 0 },
    { value: 20, color: [0.1, 0.8, 0.3], opacity: 0.1 },
    { value: 70, color: [1, 0.4, 0.1], opacity: 0.6 },
  ],
  referenceLength: 0.02,
  ...more,
});

const floats = ({ stored }: Sweep): Partial<Sweep> => ({
  kind: 'float32',
  stored: (a, g) => (g % 13 < 3 ? NaN : stored(a, g)),
});
const folded: Partial<Shown> = {
  stops: [
    { value: -30, color: [0.2, 1, 0.5], opacity: 0.4 },
    { value: 0, color: [0.6, 0.6, 0.6], opacity: 0.02 },
    { value: 30, color: [1, 0.3, 0.2], opacity: 0.4 },
  ],
};

const volumes: Record<string, Shown> = {
  'box, 8 bits': ofBox(box('uint8')),
  'box, 16 bits': ofBox(box('uint16'), { orbit: { theta: 2, phi: 0.8, radius: 1.2 } }),
  'box, floats with a hole': ofBox(box('float32', hole)),
  'box, region': ofBox(box('uint8'), { region: [-10, -20, -16, 14, 8, 10] }),
  'polar, 8 bits': ofRadar(radar()),
  'polar, 16 bits': ofRadar(
    radar(({ stored }) => ({ kind: 'uint16', stored: (a, g) => 257 * stored(a, g), slope: 0.5 / 257 })),
    { orbit: { theta: 2.5, phi: 0.9, radius: 1 } },
  ),
  'polar, floats without data': ofRadar(radar(floats)),
  'polar, rays of their own elevations': ofRadar(
    radar(({ elevation }, i) => ({ azimuths: circle(40 + 5 * i), rayElevation: wave(elevation, 0.4, i) })),
  ),
  'polar, sweeps that cross': ofRadar(
    radar(({ elevation }, i) => ({
      azimuths: circle(44 + i, 2),
      rayElevation: wave(elevation, i < 3 ? 1 : 0.1, 2 * i),
    })),
  ),
  'polar, folds': ofRadar(
    radar(
      () => ({ nyquist: 30, stored: (a, g) => 1 + Math.round((2 * a + 9 * g) % 120), slope: 0.5, intercept: -30 }),
      { isVelocity: true },
    ),
    folded,
  ),
  'polar, straight beams': ofRadar(radar(undefined, { straightBeams: true })),
  'polar, slices': ofRadar(radar(), {
    opacityFactor: 0.2,
    cuts: [
      { cut: 'sweep', number: 2 },
      { cut: 'upright', from: [-15_000, 20_000], direction: [0.6, -0.8], length: 40_000 },
      { cut: 'height', metres: 2500 },
    ],
  }),
};

const sphere =
  '<transform translation="4 6 8"><shape><appearance><material diffusecolor="orange"></material></appearance><sphere radius="8"></sphere></shape></transform>';

const plain = Object.entries(volumes).map(([family, shown]) => ({
  family,
  name: family,
  shown,
  use: (d: Drawing) => d.draw(),
}));

/** A way of drawing. */
interface Way {
  readonly how: string;
  /** Ways with the same one may come to the same picture; that of drawing at once is empty. */
  readonly family: string;
  readonly use: InnerScene['use'];
}

/** Volumes drawn in another way, by names. */
function drawnBy({ how, family, use }: Way, names: readonly string[]): InnerScene[] {
  return names.map((name) => ({ family: `${name}${family}`, name: `${name}, ${how}`, shown: volumes[name], use }));
}

/** In WebGL 2 and 1. */
export const innerScenes: readonly InnerScene[] = [
  ...plain,
  {
    family: 'box, a shape',
    name: 'box, a shape',
    shown: ofBox(box('uint8'), { children: sphere }),
    use: (d) => d.draw(),
  },
  {
    family: 'box, a shape, probe',
    name: 'box, a shape, probe',
    shown: ofBox(box('uint8'), { children: sphere }),
    use: (d) => d.probe(5),
  },
  ...drawnBy({ how: 'adaptive rays', family: ', adaptive', use: (d) => d.drawAdaptive(12) }, [
    'box, 8 bits',
    'box, floats with a hole',
    'polar, 8 bits',
    'polar, folds',
  ]),
  ...drawnBy({ how: 'many adaptive rays', family: ', many', use: (d) => d.drawAdaptive(3) }, [
    'box, 16 bits',
    'polar, rays of their own elevations',
  ]),
  ...drawnBy({ how: 'in pieces', family: '', use: (d) => d.drawInPieces(17, 0) }, [
    'box, 16 bits',
    'box, region',
    'polar, slices',
  ]),
  ...drawnBy({ how: 'adaptive rays in pieces', family: ', adaptive', use: (d) => d.drawInPieces(17, 12) }, [
    'box, 8 bits',
    'polar, 8 bits',
  ]),
  ...drawnBy({ how: 'without skipping', family: '', use: (d) => d.drawSlowly() }, [
    'box, 8 bits',
    'polar, 8 bits',
    'polar, slices',
  ]),
  ...drawnBy({ how: 'undivided steps', family: ', undivided', use: (d) => d.drawCoarsely(1) }, [
    'box, 8 bits',
    'polar, 8 bits',
  ]),
  ...drawnBy({ how: 'probe', family: ', probe', use: (d) => d.probe(7) }, [
    'box, 8 bits',
    'box, floats with a hole',
    'polar, 8 bits',
    'polar, folds',
    'polar, slices',
  ]),
];
