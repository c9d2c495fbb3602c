import { expect } from '@esm-bundle/chai';
import { layOutRadials, packRows, radialAt, turnAt } from '../../../src/radar/polar-layout.ts';
import type { PolarLayout } from '../../../src/radar/polar-layout.ts';
import type { PolarVolume } from '../../../src/volume/volume.ts';
import type { PolarGrid } from '../../../src/volume/polar-grid.ts';
import { polarScenes, radarVolume, unequalSweeps } from '../../helpers/synthetic-radar.ts';

const texelsOf = ({ width, height }: PolarLayout): number => width * height;

/** Texel of a radial's first gate, by sweep and index of the radial. */
function firstTexel({ sweeps, width }: PolarLayout, sweep: number, place: number, gates: number): number {
  const { firstRow, radialsPerRow } = sweeps[sweep];
  return (firstRow + Math.floor(place / radialsPerRow)) * width + (place % radialsPerRow) * gates;
}

function packAll(volume: PolarVolume, layout: PolarLayout, rowsAtOnce: number): number[] {
  const texels: number[] = [];
  for (let first = 0; first < layout.height; first += rowsAtOnce) {
    const count = Math.min(rowsAtOnce, layout.height - first);
    for (const texel of packRows(volume.samples, volume.grid, layout, { first, count })) texels.push(texel);
  }
  return texels;
}

describe('the layout of radials in a texture', () => {
  for (const [name, options] of Object.entries(polarScenes)) {
    it(`gives each radial its own texels, with any pieces: ${name}`, () => {
      const volume = radarVolume(options);
      const { grid, samples } = volume;
      for (const maxSize of [256, 8192]) {
        const layout = layOutRadials(grid, maxSize)!;
        expect(Math.max(layout.width, layout.height)).to.be.at.most(maxSize);
        const texels = packAll(volume, layout, 3);
        expect(texels)
          .to.have.length(texelsOf(layout))
          .and.to.deep.equal(packAll(volume, layout, layout.height));
        const taken = new Set<number>();
        grid.sweeps.forEach((sweep, i) => {
          const placed = layout.sweeps[i];
          expect(placed.radials).to.equal(sweep.azimuths.length + 2);
          expect(placed.firstNumber % placed.radialsPerRow).to.equal(0);
          const seen = new Set<number>();
          for (let place = 0; place < placed.radials; place++) {
            const ray = radialAt(sweep, placed, place);
            if (place > 0 && place + 1 < placed.radials) seen.add(ray);
            for (let gate = 0; gate < sweep.gates; gate++) {
              const texel = firstTexel(layout, i, place, sweep.gates) + gate;
              if (taken.has(texel)) throw new Error(`texel ${texel} is taken twice`);
              taken.add(texel);
              expect(texels[texel]).to.deep.equal(samples[sweep.offset + ray * sweep.gates + gate]);
            }
          }
          expect(seen.size, 'each ray is there').to.equal(sweep.azimuths.length);
        });
      }
    });

    it(`counts turns from the widest gap: ${name}`, () => {
      const { sweeps } = radarVolume(options).grid;
      const layout = layOutRadials({ sweeps } as PolarGrid, 8192)!;
      sweeps.forEach((sweep, i) => {
        const turns = Array.from({ length: sweep.azimuths.length + 4 }, (_, place) =>
          turnAt(sweep, layout.sweeps[i], layout.from, place),
        );
        for (let place = 1; place < turns.length; place++) expect(turns[place]).to.be.above(turns[place - 1]);
        expect(turns[0]).to.be.below(0);
        expect(turns[1]).to.be.at.least(0);
        expect(turns[sweep.azimuths.length]).to.be.at.most(layout.extent + 1e-9);
        turns.forEach((turn, place) => {
          const off = (layout.from + turn - sweep.azimuths[radialAt(sweep, layout.sweeps[i], place)]) / 360;
          expect(off).to.be.closeTo(Math.round(off), 1e-12);
        });
      });
    });
  }

  it('takes no more texels for short radials than they need', () => {
    const { grid, samples } = radarVolume(unequalSweeps);
    const padded =
      grid.sweeps.reduce((sum, { azimuths }) => sum + azimuths.length, 0) *
      Math.max(...grid.sweeps.map(({ gates }) => gates));
    expect(padded / samples.length, 'padded to the longest').to.be.above(2);
    for (const maxSize of [4096, 16384]) {
      expect(texelsOf(layOutRadials(grid, maxSize)!) / samples.length, `on a device of ${maxSize}`).to.be.below(1.12);
    }
  });

  it('says if there is not enough space', () => {
    const { grid } = radarVolume({ sweeps: [{ elevation: 1, gates: 300 }] });
    expect(layOutRadials(grid, 299)).to.equal(null);
    expect(layOutRadials(grid, 300)).to.include({ width: 300, height: 26 });
    expect(layOutRadials({ ...grid, sweeps: Array.from({ length: 12 }, () => grid.sweeps[0]) }, 300)).to.equal(null);
  });
});
