import { expect } from '@esm-bundle/chai';
import { colorTableStops } from '../../../../src/optics/transfer/color-tables.ts';
import { colorTables } from '../../../../src/optics/transfer/preset-names.ts';
import { parseCssColor } from '../../../../src/optics/transfer/css-color.ts';

/** Linear light to the value of sRGB. Source: CSS Color 4, 10.2 */
const encode = (light: number): number => (light <= 0.0031308 ? 12.92 * light : 1.055 * light ** (1 / 2.4) - 0.055);

describe('CSS colours', () => {
  // A gray of 0.5 has its light from the transfer curve of the space alone. Source: CSS Color 4, sample code for colour conversions
  for (const [space, light] of [
    ['srgb', ((0.5 + 0.055) / 1.055) ** 2.4],
    ['display-p3', ((0.5 + 0.055) / 1.055) ** 2.4],
    ['a98-rgb', 0.5 ** (563 / 256)],
    ['prophoto-rgb', 0.5 ** 1.8],
    ['rec2020', ((0.5 + 0.09929682680944) / 1.09929682680944) ** (1 / 0.45)],
    ['srgb-linear', 0.5],
  ] as const) {
    it(`knows the space ${space}`, () => {
      const { color, alpha } = parseCssColor(`color(${space} 0.5 0.5 0.5 / 0.25)`)!;
      for (const channel of color) expect(channel).to.be.closeTo(encode(light), 2e-4);
      expect(alpha).to.equal(0.25);
    });
  }

  it('colours beyond sRGB are clipped', () => {
    for (const space of ['display-p3', 'a98-rgb', 'prophoto-rgb', 'rec2020']) {
      const { color } = parseCssColor(`color(${space} 0 1 0)`)!;
      expect(color[1], space).to.be.closeTo(1, 1e-9);
      expect(Math.min(...color), space).to.equal(0);
    }
  });

  it('colour tables begin and end as they are known to', () => {
    const ends = Object.fromEntries(
      colorTables.map((name) => {
        const stops = colorTableStops(name, [0, 1]);
        return [name, [stops[0], stops.at(-1)!].map(({ color }) => color.map((c) => Math.round(255 * c)))];
      }),
    );
    // Source: matplotlib's viridis, 0 and 255
    expect(ends.viridis).to.deep.equal([
      [68, 1, 84],
      [253, 231, 37],
    ]);
    expect(ends.inferno).to.deep.equal([
      [0, 0, 4],
      [252, 255, 164],
    ]);
    expect(colorTableStops('turbo', [0, 1])).to.have.length(65);
  });
});
