// Coasts and borders around a radar.
import { expect } from '@esm-bundle/chai';
import { buildGroundMap, readLine } from '../../../src/radar/ground-map.ts';
import type { GroundMap } from '../../../src/radar/ground-map.ts';
import type { Vector3 } from '../../../src/volume/matrix.ts';

const reach = 250_000;
/**
 * Kilometres, and degrees clockwise from north, to the nearest coast and border in world-atlas 2.0.2 (countries-50m.json), all of its points, with pyproj 3
 * (`aeqd` on a sphere of 6,371 km) and shapely 2.
 */
const places: Record<
  string,
  { at: [latitude: number, longitude: number]; coast?: [number, number]; border?: [number, number] }
> = {
  'Captains Flat': { at: [-35.661, 149.512], coast: [64.6, 108] },
  Helchteren: { at: [51.069072, 5.4064], coast: [89.5, 294], border: [20.1, 43] },
  Tokyo: { at: [35.69, 139.69], coast: [12.4, 129] },
  'Suva, on both sides of 180 degrees': { at: [-18.05, 178.57], coast: [6.7, 178] },
};

/** The nearest place of some lines: kilometres, and degrees clockwise from north. */
function nearest(lines: readonly (readonly Vector3[])[]): [number, number] | undefined {
  let [best, angle] = [Infinity, 0];
  for (const line of lines) {
    for (let i = 1; i < line.length; i++) {
      const [[ax, ay], [bx, by]] = [line[i - 1], line[i]];
      const [dx, dy] = [bx - ax, by - ay];
      const t = Math.min(1, Math.max(0, -(ax * dx + ay * dy) / (dx * dx + dy * dy)));
      const [x, y] = [ax + t * dx, ay + t * dy];
      if (Math.hypot(x, y) < best) [best, angle] = [Math.hypot(x, y), (Math.atan2(x, y) * 180) / Math.PI];
    }
  }
  return best < Infinity ? [best / 1000, (angle + 360) % 360] : undefined;
}

const pointsOf = ({ coasts, borders }: GroundMap): Vector3[] => [...coasts, ...borders].flat();

describe('the map around a radar', () => {
  for (const [
    name,
    {
      at: [latitude, longitude],
      coast,
      border,
    },
  ] of Object.entries(places)) {
    it(`has the nearest coast and border of ${name} where they are`, () => {
      const map = buildGroundMap({ latitude, longitude }, reach);
      for (const [found, expected] of [
        [nearest(map.coasts), coast],
        [nearest(map.borders), border],
      ] as const) {
        expect(found === undefined, 'whether there is one').to.equal(expected === undefined);
        if (!found || !expected) continue;
        expect(found[0]).to.be.closeTo(expected[0], 1.5); // Lines were simplified by 0.01 degrees.
        expect(Math.abs(((found[1] - expected[1] + 540) % 360) - 180)).to.be.below(8);
      }
    });

    it(`ends at the last ring of ${name}, and lies on the ground`, () => {
      for (const [x, y, z] of pointsOf(buildGroundMap({ latitude, longitude }, reach))) {
        expect(Math.hypot(x, y)).to.be.at.most(reach * (1 + 1e-9));
        expect(z).to.equal(0);
      }
    });
  }

  it('is cut where a line enters and leaves', () => {
    const [far, near] = [reach, 100_000].map((radius) =>
      buildGroundMap({ latitude: -35.661, longitude: 149.512 }, radius),
    );
    const ends = near.coasts.flatMap((line) => [line[0], line.at(-1)!]).map(([x, y]) => Math.hypot(x, y));
    expect(ends.some((distance) => Math.abs(distance - 100_000) < 1)).to.equal(true);
    expect(pointsOf(near).length).to.be.below(pointsOf(far).length / 2);
  });

  it('is empty far out at sea, and at the poles has no lines across them', () => {
    expect(pointsOf(buildGroundMap({ latitude: 0, longitude: -140 }, reach))).to.deep.equal([]);
    for (const latitude of [90, -90])
      for (const line of buildGroundMap({ latitude, longitude: 0 }, reach).coasts) {
        for (let i = 1; i < line.length; i++)
          expect(Math.hypot(line[i][0] - line[i - 1][0], line[i][1] - line[i - 1][1])).to.be.below(reach);
      }
  });

  it('reads numbers as "encoded polylines" have them', () => {
    // The example of Google's description of the format, of hundred-thousandths of a degree; here the first number is the longitude, and counts hundredths.
    const points = readLine('_p~iF~ps|U_ulLnnqC_mqNvxq`@');
    expect(
      points.map(({ longitude, latitude }) => [longitude, latitude].map((x) => Math.round(x * 100))),
    ).to.deep.equal([
      [3850000, -12020000],
      [4070000, -12095000],
      [4325200, -12645300],
    ]);
  });
});
