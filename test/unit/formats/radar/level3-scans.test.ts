// Several products of NEXRAD Level III: chosen files, archives and lists.
import { expect } from '@esm-bundle/chai';
import { gzipSync, zipSync } from 'fflate';
import type { LoadRequest } from '../../../../src/formats/base/load-request.ts';
import type { ScanTimes } from '../../../../src/formats/base/choose-scan.ts';
import type { ScanData } from '../../../../src/formats/base/scan-data.ts';
import type { Volume } from '../../../../src/volume/volume.ts';
import { decodeRequest } from '../../../../src/worker/decode-request.ts';
import { expectError, roomyLimits, valuesOf } from '../../../helpers/decode.ts';
import { serverOfFiles, withFiles } from '../../../helpers/file-server.ts';
import { buildLevel3, builtProducts } from '../../../helpers/level3-builder.ts';
import type { BuiltProduct } from '../../../helpers/level3-builder.ts';

const base = 'https://local-3.invalid/';
const { reflectivity94, reflectivity19, velocity99 } = builtProducts;

/** A tilt all of whose gates hold one number: 10 for 0.5 degrees at the first time, 21 for the second tilt at the second time. */
const tilt = (elevation: number, number: number, more: Partial<BuiltProduct> = {}): Uint8Array<ArrayBuffer> =>
  buildLevel3({ ...reflectivity94, elevation, numbers: Array(4).fill(Array(5).fill(number)) as number[][], ...more });

const tilts = [5, 15, 24, 34];
/** In the order of their names: all times of a tilt, then those of the next one. */
const names = tilts.flatMap((_, i) => [`KBMX_N${i}Q_0205`, `KBMX_N${i}Q_0210`]);
const bytesOf = (name: string): Uint8Array<ArrayBuffer> => {
  const [level, time] = [Number(name[6]), Number(name.endsWith('0210'))];
  return tilt(tilts[level], 10 * (time + 1) + level, time ? { seconds: 7800 } : {});
};
const filesOf = (some: readonly string[]): File[] => some.map((name) => new File([bytesOf(name)], name));

interface Opened {
  readonly volume: Volume;
  readonly times: ScanTimes;
  readonly data: readonly ScanData[];
}

/** Opens as a page does, in a worker. */
async function open(request: Partial<LoadRequest>): Promise<Opened> {
  let scans: Pick<Opened, 'times' | 'data'> = { times: [], data: [] };
  const volume = await decodeRequest(
    { url: base, limits: roomyLimits, scan: { index: 0 }, ...request },
    {
      pageOrigin: serverOfFiles,
      onProgress: () => undefined,
      onScans: (times, data = []) => (scans = { times, data: structuredClone(data) }),
    },
  );
  return { volume, ...scans };
}

const show = (data: ScanData): Promise<Volume> =>
  decodeRequest({ url: base, limits: roomyLimits, data }, { pageOrigin: serverOfFiles, onProgress: () => undefined });

const elevationsOf = ({ radar }: Volume): number[] => radar!.sweeps.map(({ elevation }) => elevation);
/** The number of the first gate of each sweep. */
const numbersOf = ({ samples, grid }: Volume): number[] =>
  grid.kind === 'polar'
    ? grid.sweeps.map(({ offset, azimuths, gates }) =>
        Math.max(...samples.subarray(offset, offset + azimuths.length * gates)),
      )
    : [];

const first = names.filter((name) => name.endsWith('0205'));

describe('several products of NEXRAD Level III', () => {
  it('of one scan are the sweeps of one volume, in an archive and among chosen files, packed or not', async () => {
    const zip = zipSync(Object.fromEntries([3, 0, 2, 1].map((i) => first[i]).map((name) => [name, bytesOf(name)])));
    const packed = first.map((name) => new File([new Uint8Array(gzipSync(bytesOf(name)))], `${name}.gz`));
    for (const files of [filesOf(first), packed, [new File([new Uint8Array(zip)], 'a.zip')]]) {
      const { volume, times } = await open({ local: { base, files } });
      expect(times).to.deep.equal([]);
      expect(elevationsOf(volume)).to.deep.equal([0.5, 1.5, 2.4, 3.4]);
      expect(numbersOf(volume)).to.deep.equal([10, 11, 12, 13]);
      expect([volume.format, volume.radar!.time]).to.deep.equal([
        'NEXRAD Level III, product 94',
        '2015-01-02T02:05:33Z',
      ]);
      expect([volume.radar!.left, volume.radar!.partial]).to.deep.equal([[], undefined]);
    }
  });

  it('of several scans are scans in time, each of its sweeps, which are read when they are shown', async () => {
    const zip = new File(
      [new Uint8Array(zipSync(Object.fromEntries(names.map((name) => [name, bytesOf(name)]))))],
      'a',
    );
    const zipOfPacked = new File(
      [new Uint8Array(zipSync(Object.fromEntries(names.map((name) => [`${name}.gz`, gzipSync(bytesOf(name))]))))],
      'a',
    );
    for (const files of [filesOf(names), [zip], [zipOfPacked]]) {
      const { volume, times, data } = await open({
        local: { base, files },
        scan: { time: Date.parse('2015-01-02T02:10:00Z') },
      });
      expect(times).to.deep.equal(['2015-01-02T02:05:33Z', '2015-01-02T02:10:00Z']);
      expect(numbersOf(volume)).to.deep.equal([20, 21, 22, 23]);
      for (const [i, one] of data.entries()) {
        const shown = await show(one);
        expect(numbersOf(shown)).to.deep.equal([0, 1, 2, 3].map((level) => 10 * (i + 1) + level));
        expect([shown.radar!.time, elevationsOf(shown)]).to.deep.equal([times[i], [0.5, 1.5, 2.4, 3.4]]);
      }
    }
  });

  it('of one tilt stay scans in time', async () => {
    const { times, data } = await open({ local: { base, files: filesOf(names.slice(0, 2)) } });
    expect(times).to.have.length(2);
    expect(elevationsOf(await show(data[1]))).to.deep.equal([0.5]);
  });

  it('of a list are read by their starts, then those of the wanted scan as a whole', async () => {
    const url = (name: string): string => `${serverOfFiles}/${name}`;
    const padded = new Map(names.map((name) => [url(name), bytesOf(name)]));
    await withFiles(padded, {}, async ({ asked }) => {
      const { volume, times, data } = await open({ url: url(names[0]), files: names.map(url), scan: { index: 1 } });
      expect(times).to.have.length(2);
      expect(numbersOf(volume)).to.deep.equal([20, 21, 22, 23]);
      expect(asked.filter(({ isPart }) => !isPart).length).to.be.at.most(5);
      expect(numbersOf(await show(data[0]))).to.deep.equal([10, 11, 12, 13]);
    });
  });

  it('of several quantities have them as moments', async () => {
    const velocity = buildLevel3({ ...velocity99, elevation: 15 });
    const files = [...filesOf(first), new File([velocity], 'N1U')];
    const { volume } = await open({ local: { base, files } });
    expect([volume.radar!.moment, volume.radar!.moments]).to.deep.equal(['REF', ['REF', 'VEL']]);
    expect(elevationsOf(volume)).to.have.length(4);
    const other = (await open({ local: { base, files }, settings: { moment: 'VEL' } })).volume;
    expect([other.unit, elevationsOf(other)]).to.deep.equal(['m/s', [1.5]]);
    expect([other.format, other.radar!.moments, other.radar!.left]).to.deep.equal([
      'NEXRAD Level III, product 99',
      ['REF', 'VEL'],
      [],
    ]);
    expect((await expectError(open({ local: { base, files }, settings: { moment: 'HCA' } }))).code).to.equal(
      'attribute/invalid',
    );
  });

  it('of several quantities at several times have them as moments at each', async () => {
    const velocity = (seconds: number): File =>
      new File([buildLevel3({ ...velocity99, elevation: 15, seconds })], `N1U-${seconds}`);
    const files = [...filesOf(names), velocity(7533), velocity(7800), velocity(8000)];
    const { times, data } = await open({ local: { base, files } });
    expect(times).to.have.length(2);
    const moment = await decodeRequest(
      { url: base, limits: roomyLimits, data: data[1], settings: { moment: 'VEL' } },
      { pageOrigin: serverOfFiles, onProgress: () => undefined },
    );
    expect([moment.unit, elevationsOf(moment), moment.radar!.moments]).to.deep.equal(['m/s', [1.5], ['REF', 'VEL']]);
    expect((await open({ local: { base, files }, settings: { moment: 'VEL' } })).times).to.have.length(3);
  });

  it('leave out, in words, what is of another radar, another kind or no product at all', async () => {
    const files = [
      ...filesOf(first),
      new File([tilt(5, 50, { latitude: 40_000 })], 'KABC'),
      new File([buildLevel3({ ...reflectivity19, elevation: 5 })], 'N0R'),
      new File([buildLevel3({ ...reflectivity94, code: 135 })], 'NET'),
    ];
    const { volume } = await open({ local: { base, files } });
    expect(numbersOf(volume)).to.deep.equal([10, 11, 12, 13]);
    expect(volume.radar!.left.join('; ')).to.match(
      /1 file without a sweep.*1 file of another radar.*1 file of another product of REF/,
    );
    expect(volume.radar!.left.join()).not.to.contain('KABC');
  });

  it('show what can be read where one is damaged, and say so; without any there is an error', async () => {
    const cut = (name: string): File => new File([bytesOf(name).slice(0, 180)], name);
    const { volume } = await open({ local: { base, files: [...filesOf(first.slice(0, 3)), cut(first[3])] } });
    expect(elevationsOf(volume)).to.deep.equal([0.5, 1.5, 2.4]);
    expect(volume.radar!.partial).to.equal('1 of 4 files of this scan can not be read');
    const error = await expectError(open({ local: { base, files: first.map(cut) } }));
    expect([error.code, error.message.includes('KBMX')]).to.deep.equal(['format/corrupt', false]);
    const none = first.map((name) => new File([buildLevel3({ ...reflectivity94, code: 135 })], name));
    expect((await expectError(open({ local: { base, files: none } }))).message).to.contain('expected products 19, 20');
  });

  it('have the values of each file alone', async () => {
    const { volume } = await open({ local: { base, files: filesOf(first) } });
    const alone = await Promise.all(
      first.map(async (name) => (await open({ local: { base, files: filesOf([name]) } })).volume),
    );
    expect(valuesOf(volume)).to.deep.equal(alone.flatMap((one) => valuesOf(one)));
  });
});
