import { expect } from '@esm-bundle/chai';
import { orbitCamera, projectionMatrix, viewMatrix } from '../../../../src/optics/rays/camera.ts';
import { buildDefaultPreset } from '../../../../src/optics/transfer/default-preset.ts';
import { findOpaqueJumps } from '../../../../src/optics/transfer/opaque-jumps.ts';
import { parseTransferFunction } from '../../../../src/optics/transfer/parse-transfer-function.ts';
import { compositeGather } from '../../../../src/optics/rays/ray-gather.ts';
import { rayThrough, setUpRays } from '../../../../src/optics/rays/rays.ts';
import { castSceneRay, opticsOf } from '../../../../src/optics/reference.ts';
import type { ReferenceScene } from '../../../../src/optics/reference.ts';
import type { Volume } from '../../../../src/volume/volume.ts';
import { ExactCells } from '../../../accuracy/exact-cells.ts';
import { smoothNoise } from '../../../accuracy/voxel-block.ts';
import { byIndex, noise } from '../../../accuracy/hard-volumes.ts';
import { plainOptics } from '../../../helpers/picture.ts';
import { randomNumbers } from '../../../helpers/synthetic.ts';

const parse = (text: string): ReturnType<typeof parseTransferFunction> => parseTransferFunction(text, [0, 1]);

describe('values at which a transfer function becomes opaque at once', () => {
  it('are those of its jumps, the middles of ramps, and the ends of wide ones; as many as can be looked for', () => {
    expect(findOpaqueJumps(parse('0.5 #fff 0, 0.5 #fff 100%, 1 #fff 100%'), 0.5)).to.deep.equal([0.5]);
    expect(
      findOpaqueJumps(parse('0 #fff 3%, 0.4 #fff 3%, 0.4 #fff 100%, 0.6 #fff 100%, 0.6 #fff 0, 1 #fff 0'), 0.5),
    ).to.deep.equal([0.4, 0.6]);
    const [middle, ...others] = findOpaqueJumps(parse('0 #fff 0, 0.49 #fff 0, 0.51 #fff 100%, 1 #fff 100%'), 1);
    // Half of what a voxel hides: half opaque, as a voxel is as long as the reference length.
    expect(middle).to.be.closeTo(0.5, 1e-6);
    expect(others).to.deep.equal([]);
    const [half, end] = findOpaqueJumps(parse('0 #fff 0, 0.8 #fff 100%, 1 #fff 100%'), 0.5);
    // A voxel is half as long as the reference length: 1 - (1 - 0.75)^0.5 is a half.
    expect(half).to.be.closeTo(0.6, 1e-6);
    expect(end).to.equal(0.8);
    expect(
      findOpaqueJumps(
        parse(
          '0.1 #fff 100%, 0.1 #fff 0, 0.3 #fff 0, 0.3 #fff 99%, 0.35 #fff 99%, 0.35 #fff 0, 0.5 #fff 0, 0.5 #fff 100%, 0.7 #fff 100%, 0.7 #fff 20%, 1 #fff 20%',
        ),
        0.5,
      ),
    ).to.have.length(4);
  });

  it('are none where nothing hides what is behind it within a voxel', () => {
    expect(findOpaqueJumps(buildDefaultPreset([0, 1]), 0.5)).to.deep.equal([]);
    expect(findOpaqueJumps(parse('0.5 #fff 0, 0.5 #fff 10%, 1 #fff 10%'), 0.5)).to.deep.equal([]);
    expect(findOpaqueJumps(parse('0.5 #fff 0, 0.5 #fff 10%, 1 #fff 10%'), 5), 'of a thicker voxel').to.deep.equal([
      0.5,
    ]);
    expect(findOpaqueJumps([{ value: 1, color: [1, 1, 1], opacity: 1 }], 1)).to.deep.equal([]);
  });
});

/** Smooth things a few voxels across. */
function clouds(): Volume {
  const at = smoothNoise(28, 4, randomNumbers(3));
  return byIndex([28, 28, 28], at, { kind: 'uint16' });
}

const looks = {
  step: '0 #24a 0, 0.9 #24a 0, 0.9 #fec 100%, 1 #c42 100%',
  'lower step': '0 #24a 0, 0.55 #24a 0, 0.55 #fec 100%, 1 #c42 100%',
  'step behind a veil': '0 #24a 2%, 0.55 #24a 3%, 0.55 #fec 100%, 1 #c42 100%',
  shell: '0 #fff 0, 0.55 #fa6 0, 0.55 #fa6 100%, 0.6 #fa6 100%, 0.6 #fa6 0, 1 #fff 0',
  'narrow ramp': '0 #fff 0, 0.54 #fa6 0, 0.56 #fa6 100%, 1 #fff 100%',
};

const rays = 700;

describe('rays that graze what is opaque at once', () => {
  let before = 0;
  for (const [name, volume] of [
    ['clouds', clouds()],
    ['noise', noise([20, 20, 20])],
  ] as const) {
    for (const [appearance, text] of Object.entries(looks)) {
      it(`show it, and no other do: ${name}, ${appearance}`, function () {
        this.timeout(60_000);
        const transferFunction = parse(text);
        const setup = setUpRays(
          volume.grid,
          viewMatrix(orbitCamera({ theta: 0.6, phi: 1.2, radius: 90 }, [0, 0, 0], 0.5)),
          projectionMatrix(0.4, 1, 1, 2),
        )!;
        const exact = new ExactCells({ volume, transferFunction, referenceLength: 1.5 });
        const scene: ReferenceScene = {
          ...volume,
          ...plainOptics,
          transferFunction,
          referenceLength: 1.5,
          stepLength: 0.5,
          maxSubsteps: 1,
          minSubsteps: () => 1,
        };
        const known = opticsOf(scene);
        const random = randomNumbers(7);
        const wrong = { looked: 0, before: 0 };
        for (let n = 0; n < rays; n++) {
          const ray = rayThrough(setup, 2 * random() - 1, 2 * random() - 1);
          const [, , , alpha] = exact.cast(setup, ray);
          const isOff = (color: readonly number[]): number => Number(Math.abs(color[3] - alpha) > 64 / 255);
          wrong.looked += isOff(castSceneRay(scene, setup, ray, known));
          wrong.before += isOff(castSceneRay({ ...scene, gather: compositeGather }, setup, ray, known));
        }
        console.log(
          `${name}, ${appearance}: ${wrong.looked} of ${rays} rays are off, ${wrong.before} without looking for jumps`,
        );
        expect(wrong.looked).to.equal(0);
        before += wrong.before;
        if (appearance === 'narrow ramp')
          expect(before, 'of all looks, without').to.be.above(name === 'noise' ? 20 : 2);
      });
    }
  }
});

describe('rays that are cast cell by cell', () => {
  it('are those with endlessly many steps', function () {
    this.timeout(120_000);
    const volume = clouds();
    const setup = setUpRays(
      volume.grid,
      viewMatrix(orbitCamera({ theta: 2, phi: 0.9, radius: 90 }, [0, 0, 0], 0.5)),
      projectionMatrix(0.4, 1, 1, 2),
    )!;
    for (const [name, text] of Object.entries({
      ...looks,
      fog: '0 #246 0, 0.4 #c85 5%, 1 #fff 40%',
      ramp: '0 #246 0, 0.5 #c85 0, 0.7 #fff 100%, 1 #fff 100%',
    })) {
      const transferFunction = parse(text);
      const exact = new ExactCells({ volume, transferFunction, referenceLength: 1.5 });
      const scene: ReferenceScene = {
        ...volume,
        ...plainOptics,
        transferFunction,
        referenceLength: 1.5,
        stepLength: 1 / 64,
        maxSubsteps: 1,
        gather: compositeGather,
      };
      const known = opticsOf(scene);
      const random = randomNumbers(5);
      const off = Float64Array.from({ length: 150 }, () => {
        const ray = rayThrough(setup, 2 * random() - 1, 2 * random() - 1);
        const [one, other] = [exact.cast(setup, ray), castSceneRay(scene, setup, ray, known)];
        return 255 * Math.max(...one.map((x, c) => Math.abs(x - other[c])));
      });
      off.sort();
      // One that grazes may still pass a step of a 64th of a voxel.
      console.log(`${name}: ${Array.from(off.slice(-4), (x) => x.toFixed(2)).join(', ')}`);
      expect(off.at(-3), name).to.be.below(0.6);
    }
  });
});
