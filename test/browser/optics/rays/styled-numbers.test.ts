import { expect } from '@esm-bundle/chai';
import { allSubsteps } from '../../../../src/optics/cells/substeps.ts';
import { autoSteps, stepLengthOf } from '../../../../src/quality/steps.ts';
import { eachLitScene } from '../../../accuracy/lit-scenes.ts';
import { changePlan, drawAt } from '../../../helpers/change-plan.ts';
import { withScene } from '../../../helpers/picture.ts';
import { probe } from '../../../helpers/probe.ts';
import '../../../helpers/provide-substeps.ts';

const size = { width: 96, height: 72 };

/** With so many steps a voxel, some segments are so short that rounding makes their length negative. */
const stepsPerVoxel = 24;

describe('pictures of styles with many steps', () => {
  it('consist of numbers, also where planes of voxels meet and something is opaque at once', async function () {
    this.timeout(120_000);
    let scenes = 0;
    await withScene({}, async (gpu) => {
      changePlan(gpu, { picture: size });
      for await (const { kind, name, volume, style, camera, ...one } of eachLitScene(true)) {
        if (!kind.startsWith('`gradient-opacity`') || !name.includes('jumps')) continue;
        scenes++;
        const { transferFunction, referenceLength } = one;
        const optics = { transferFunction, referenceLength, opacityFactor: 1, lightFactor: 1 };
        await gpu.prepare(volume, optics);
        gpu.setVolume(volume);
        await gpu.setAppearance({ style, optics });
        changePlan(gpu, { camera, substeps: allSubsteps });
        const stepLength = stepLengthOf(volume.grid, stepsPerVoxel * autoSteps(volume.grid));
        drawAt(gpu, stepLength);
        const [picture] = probe(gpu, [stepLength], { stride: 1, first: [0, 0], ...size }, size)!;
        // Before such segments counted as empty, 15 of 27,648 numbers were none.
        expect(picture.filter((x) => !Number.isFinite(x))).to.have.length(0);
        expect(Math.max(...picture)).to.be.above(0.3);
      }
    });
    expect(scenes).to.equal(1);
  });
});
