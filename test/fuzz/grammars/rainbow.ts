import { deflateSync, gzipSync } from 'node:zlib';
import { buildRainbow } from '../../helpers/rainbow-builder.ts';
import type { BuiltSlice } from '../../helpers/rainbow-builder.ts';
import { damage, oneFile } from '../fuzz-case.ts';
import { makeGates } from '../gates.ts';
import type { Grammar } from '../fuzz-case.ts';
import type { Random } from '../random.ts';

/** Rainbow 5: headers and parts that lie, are missing or of another size. */
export const rainbow: Grammar = (random) => {
  // Many slices, or long ones: both would make one case of seconds, and show nothing new.
  const many = random.isHostile() ? random.pick(['slices', 'radials'] as const) : null;
  const bytes = buildRainbow({
    slices: Array.from({ length: many === 'slices' ? random.pick([40, 300]) : random.int(1, 4) }, (_, i) =>
      writeSlice(random, i, many === 'radials' ? random.pick([400, 2000]) : random.int(1, 12)),
    ),
    type: random.or(random.pick(['vol', 'azi']), 'ele', 'poi', ''),
    rangestep: random.or(0.25, 0, -1, 1e30),
    start: random.or(0, 2, -5, 1e12),
    anglestep: random.or(1, 0, 400),
    change: (header) =>
      random.isWild()
        ? header.replace(
            random.pick([
              /bins="\d+"/g,
              /rays="\d+"/,
              /blobid="\d+"/,
              /depth="\d+"/g,
              /max="[^"]*"/g,
              /<\/scan>/,
              /posangle/,
            ]),
            random.pick([
              'bins="0"',
              'bins="99999999"',
              'rays="7"',
              'blobid="99"',
              'depth="32"',
              'max="1e308"',
              'x'.repeat(5000),
            ]),
          )
        : header,
    size: (length) => random.or(length, length - 1, length + 1, 0, 4e9),
    isPacked: random.chance(0.8),
    pack: (part) => deflateSync(part, { level: 1 }),
  });
  const whole = damage(random, bytes);
  return oneFile(random.or('scan.vol', 'scan.azi'), random.chance(0.1) ? new Uint8Array(gzipSync(whole)) : whole);
};

function writeSlice(random: Random, i: number, radials: number): BuiltSlice {
  const gates = random.int(1, 30);
  const depth = random.pick([8, 16] as const);
  const starts = Array.from({ length: radials }, (_, radial) => (radial * 182) % 65536);
  return {
    elevation: random.or(0.5 + i, -90, 200),
    starts,
    ...(random.chance(0.5) && { stops: starts.map((start) => (start + 182) % 65536) }),
    parts: [
      {
        type: random.or(random.pick(['dBZ', 'V', 'ZDR']), 'x'.repeat(300)),
        depth,
        min: random.or(-31.5, 0, 1e30),
        max: random.or(95.5, -31.5, -1e30),
        numbers: makeGates(random, [radials, gates], 2 ** depth - 1),
      },
    ],
  };
}
