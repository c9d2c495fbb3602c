import { gzipSync } from 'node:zlib';
import { buildLevel3, builtProducts } from '../../helpers/level3-builder.ts';
import type { BuiltProduct } from '../../helpers/level3-builder.ts';
import { damage, oneFile } from '../fuzz-case.ts';
import { makeGates } from '../gates.ts';
import type { Grammar } from '../fuzz-case.ts';
import { bzip2, bzip2OfRuns } from './bzip2-writer.ts';

/** NEXRAD Level III: products, packets, counts and lengths that lie; runs that are too long; symbols that swell. Source: ICD 2620001 */
export const level3: Grammar = (random) => {
  const product = random.pick(Object.values(builtProducts));
  const radials = random.isHostile() ? random.pick([300, 1000]) : random.int(1, 12);
  const gates = random.isHostile() ? random.pick([1, 2000]) : random.int(1, 40);
  const top = product.isRuns ? 15 : 255;
  const built: BuiltProduct = {
    ...product,
    code: random.or(product.code, 16, 135, 300),
    numbers: makeGates(random, [radials, gates], top),
    levels: random.or(product.levels, [0, 0], { scale: NaN, offset: 1 }, { scale: 1e-40, offset: 1e30 }),
    elevation: random.or(random.int(-10, 900), -32768, 32767),
    from: random.int(0, 3599),
    step: random.or(10, 5, 0, 65535),
    wrong: {
      packet: random.isWild() ? random.pick([16, 0xaf1f, 28, 0]) : undefined,
      radials: random.isWild() ? random.pick([0, 1, 0xffff]) : undefined,
      bytes: random.isWild() ? random.pick([0, 1, 0xffff]) : undefined,
    },
    lines: random.or(random.pick(['', 'SDUS54 KBMX 020205\r\r\nN0QBMX\r\r\n']), 'x'.repeat(200), '\r\nN0QBMX'),
    ...(random.chance(0.3) && radials * gates < 4000
      ? { pack: (bytes: Uint8Array) => (random.isWild() ? bzip2OfRuns(2, random.pick([10, 1000])) : bzip2(bytes)) }
      : {}),
  };
  const bytes = damage(random, buildLevel3(built));
  return oneFile(
    random.or('KBMX_N0Q', 'n0q.nids', 'scan'),
    random.chance(0.1) ? new Uint8Array(gzipSync(bytes)) : bytes,
  );
};
