// What is opaque at once where rays do not walk from voxel to voxel, or labels have a say: functions of labels, surfaces in fog, volumes of labels, radars.
import { orbitCamera } from '../../src/optics/rays/camera.ts';
import { parseTransferFunction } from '../../src/optics/transfer/parse-transfer-function.ts';
import type { TransferFunction } from '../../src/optics/transfer/transfer-function.ts';
import { boundingSphere } from '../../src/volume/grid.ts';
import type { Volume } from '../../src/volume/volume.ts';
import type { RestScene } from '../helpers/at-rest.ts';
import type { LabelMap, ShownLabels } from '../../src/volume/labels.ts';
import { blocks, labelMap, plainAppearance } from '../helpers/labels.ts';
import { cloudCamera, cloudVolume } from '../helpers/polar-cloud.ts';
import { randomNumbers } from '../helpers/synthetic.ts';
import { byIndex } from './hard-volumes.ts';
import { smoothNoise } from './voxel-block.ts';

const edge = 28;
const step = '0.55 #ffe8c0 0, 0.55 #ffe8c0 100%, 1 #c04020 100%';
const shell = '0.55 #fa6 0, 0.55 #fa6 100%, 0.6 #fa6 100%, 0.6 #fa6 0';
const size = { width: 60, height: 60 } as const;

function clouds(): Volume {
  const at = smoothNoise(edge, 5, randomNumbers(31));
  return byIndex([edge, edge, edge], at, { kind: 'uint16' });
}

const parse = (text: string): TransferFunction => parseTransferFunction(text, [0, 1]);

function plain(volume: Volume, appearance: string, more: Partial<RestScene> = {}): RestScene {
  const { center, radius } = boundingSphere(volume.grid);
  return {
    volume,
    style: null,
    transferFunction: parse(appearance),
    camera: orbitCamera({ theta: 0.8, phi: 1.1, radius: 2.6 * radius }, center, 0.7),
    size,
    optics: { referenceLength: radius / 60 },
    ...more,
  };
}

/** A volume with labels, some of which have transfer functions of their own. */
function labelled(
  appearance: string,
  own: readonly string[],
  {
    map = blocks([edge, edge, edge], 3, 7),
    styles = [plainAppearance, { ...plainAppearance, group: 1 }, plainAppearance],
  }: Partial<Pick<ShownLabels, 'map' | 'styles'>> = {},
): RestScene {
  const functions = own.map(parse);
  return plain(clouds(), appearance, {
    set: (gpu) => gpu.setLabels({ map, styles, ...(functions.length > 0 && { functions }) }),
  });
}

/** Each voxel has one of three labels, whatever its neighbours have. */
function scattered(): LabelMap {
  const random = randomNumbers(8);
  return labelMap([edge, edge, edge], () => Math.floor(3 * random()), 3);
}

const faint = '0 #246 0, 1 #8ac 10%';
const otherStep = '0.45 #40c080 0, 0.45 #40c080 100%, 1 #2050a0 100%';
const ownOfTwo = [plainAppearance, { ...plainAppearance, group: 1 }, { ...plainAppearance, group: 2 }];

/** Volumes of labels have no values between labels. */
function named(): Volume {
  const { numbers } = blocks([edge, edge, edge], 4, 5);
  return { ...byIndex([edge, edge, edge], (i, j, k) => numbers[i + edge * (j + edge * k)] / 3), isDiscrete: true };
}

const surface = { value: 0.5, color: [0.8, 0.9, 1], opacity: 0.4 } as const;

/** Scenes by name; what is true of them is told by rays with many steps. */
export const opaqueOthers: Readonly<Record<string, () => RestScene>> = {
  "labels' own function, a step": () => labelled(faint, [step]),
  "labels' own function, a shell": () => labelled(faint, [shell]),
  "labels, and a step of the volume's own": () => labelled(step, [faint]),
  'labels that are hidden, and a step': () =>
    labelled(step, [], { styles: [plainAppearance, { ...plainAppearance, opacityFactor: 0 }, plainAppearance] }),
  'labels of single voxels, and a step': () => labelled(step, [faint], { map: scattered() }),
  'labels with two steps of their own, and a step': () => labelled(step, [otherStep, shell], { styles: ownOfTwo }),
  'labels of single voxels, with two steps of their own': () =>
    labelled(faint, [otherStep, shell], { styles: ownOfTwo, map: scattered() }),
  'a surface in fog with a step': () => plain(clouds(), step, { style: { surfaces: [surface] } }),
  'a surface in fog with a shell': () => plain(clouds(), shell, { style: { surfaces: [surface] } }),
  'a volume of labels, a step': () => plain(named(), '0.5 #ffe8c0 0, 0.5 #ffe8c0 100%, 1 #c04020 100%'),
  'a radar, a step': () => {
    const volume = cloudVolume(1);
    const [low, high] = volume.range;
    const at = low + 0.6 * (high - low);
    return {
      volume,
      style: null,
      transferFunction: parseTransferFunction(`${at} #ffe8c0 0, ${at} #ffe8c0 100%, ${high} #c04020 100%`, [low, high]),
      camera: cloudCamera,
      size,
      optics: { referenceLength: 3000 },
    };
  },
};
