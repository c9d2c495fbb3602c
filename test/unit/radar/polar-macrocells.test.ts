import { expect } from '@esm-bundle/chai';
import { polarSampler } from '../../../src/radar/interpolate-polar.ts';
import type { Vector3 } from '../../../src/volume/matrix.ts';
import type { Volume } from '../../../src/volume/volume.ts';
import { takesAll } from '../../helpers/cases.ts';
import { randomNumbers } from '../../helpers/synthetic.ts';
import { polarScenes, radarVolume } from '../../helpers/synthetic-radar.ts';

const points = takesAll ? 20_000 : 10_000;

function cellOf({ grid: { dimensions }, macrocells }: Volume, p: Vector3): number {
  const [i, j, k] = p.map((x, axis) =>
    Math.min(macrocells.dimensions[axis] - 1, Math.floor((x * dimensions[axis]) / macrocells.size)),
  );
  return i + macrocells.dimensions[0] * (j + macrocells.dimensions[1] * k);
}

describe("macrocells of a radar's box", () => {
  for (const [name, options] of Object.entries(polarScenes)) {
    for (const beamModel of ['standard', 'straight'] as const) {
      it(`hold every value that interpolation gives: ${name}, ${beamModel}`, () => {
        const volume = radarVolume(options, { beamModel });
        const valueAt = polarSampler(volume);
        const random = randomNumbers(70);
        const { low, high } = volume.macrocells;
        const outside: { p: Vector3; value: number }[] = [];
        let found = 0;
        for (let n = 0; n < points; n++) {
          const p: Vector3 = [random(), random(), random()];
          const value = valueAt(p);
          if (Number.isNaN(value)) continue;
          const cell = cellOf(volume, p);
          found++;
          if (!(low[cell] <= value * (1 + 1e-12) && high[cell] >= value * (1 - 1e-12))) outside.push({ p, value });
        }
        expect(outside, 'values that their cells do not hold').to.deep.equal([]);
        // A sector of one degree fills a few thousandths of its box.
        expect(found).to.be.above(points / 1000);
      });
    }
  }

  it('are empty where no beam reaches: below the lowest and in the cone of silence', () => {
    const volume = radarVolume(
      {
        sweeps: [
          { elevation: 5, gates: 60 },
          { elevation: 10, gates: 60 },
        ],
      },
      { beamModel: 'straight' },
    );
    const { low, high } = volume.macrocells;
    const at = (p: Vector3): boolean => low[cellOf(volume, p)] <= high[cellOf(volume, p)];
    // 50 km out, 5 degrees are 4.4 km up.
    const up = (height: number): number =>
      (height - volume.grid.box.low[2]) / (volume.grid.box.high[2] - volume.grid.box.low[2]);
    const east = (distance: number): number => 0.5 + distance / (2 * volume.grid.box.high[0]);
    expect(at([east(5e4), 0.5, up(6000)])).to.equal(true);
    expect(at([east(5.8e4), 0.5, up(100)])).to.equal(false);
    expect(at([east(1000), 0.5, up(9000)])).to.equal(false);
  });

  it('distinguish storms from empty air: cells away from the only gates with data are empty', () => {
    const stored = (azimuth: number, gate: number): number =>
      Math.abs(azimuth - 90) < 10 && gate > 30 && gate < 40 ? 200 : 0;
    const volume = radarVolume({ sweeps: [1, 2, 4, 8].map((elevation) => ({ elevation, gates: 60, stored })) });
    const { low, high } = volume.macrocells;
    const share = low.filter((value, i) => value <= high[i]).length / low.length;
    expect(share).to.be.within(0.001, 0.1);
  });
});
