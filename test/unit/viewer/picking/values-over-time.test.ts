// The values of a place in scans that have to be opened: a few at a time, and none is kept.
import { expect } from '@esm-bundle/chai';
import type { ScansOfView } from '../../../../src/viewer/model/scans-of-view.ts';
import type { SocketView } from '../../../../src/viewer/model/view-socket.ts';
import { readOverTime } from '../../../../src/viewer/picking/values-over-time.ts';
import type { ValuesOverTime } from '../../../../src/viewer/picking/values-over-time.ts';
import { transformPoint } from '../../../../src/volume/matrix.ts';
import type { Vector3 } from '../../../../src/volume/matrix.ts';
import type { Volume } from '../../../../src/volume/volume.ts';
import { dicomBytes } from '../../../helpers/dicom-bytes.ts';
import { numbersAt, timedFields } from '../../../helpers/dicom-frames.ts';
import type { Scan } from '../../../helpers/dicom-series.ts';
import { openScans } from '../../../helpers/scans-of.ts';

const size = { times: 7, slices: 4, edge: 6 };
const { data, read } = await openScans(dicomBytes(timedFields(size)), '1.dcm');
const first = (await read(0)) as Scan;
/** The middle of the voxel 2, 3 of slice 1. */
const world = transformPoint(first.grid.indexToWorld, [2, 3, 1]);
const place = { world, voxel: [2, 3, 1] as Vector3, radar: null };
const expected = Array.from({ length: size.times }, (_, t) => numbersAt(t, 1, size.edge)[2 + 3 * size.edge]);

/** Reads as a readout does. @param load - in place of reading a scan @param shown - the volume in the picture @param late - comes after three others */
async function readAll(
  load: (index: number) => Promise<Volume>,
  {
    kept = [],
    shown = first,
    stop,
    late,
  }: { kept?: readonly number[]; shown?: Volume; stop?: AbortController; late?: number } = {},
): Promise<{ known: readonly ValuesOverTime[]; opened: readonly number[]; most: number }> {
  const opened: number[] = [];
  let [running, most, done] = [0, 0, 0];
  let haveCome = (): void => undefined;
  const threeOthers = new Promise<void>((resolve) => (haveCome = resolve));
  const scans: ScansOfView = {
    sources: data.map((one, index) => ({ url: 'https://x.test/1.dcm', index, data: one })),
    findKept: (index) => (kept.includes(index) ? first : null),
    async loadAside(index) {
      opened.push(index);
      most = Math.max(most, ++running);
      await (index === late ? threeOthers : new Promise((resolve) => setTimeout(resolve, 2)));
      running--;
      return load(index).finally(() => {
        if (++done === 3) haveCome();
      });
    },
  };
  const view = { user: { loader: { scans } }, volume: shown, settings: { source: null } } as unknown as SocketView;
  const known: ValuesOverTime[] = [];
  await readOverTime(view, place, {
    signal: (stop ?? new AbortController()).signal,
    onValues: (one) => known.push(one),
  });
  return { known, opened, most };
}

describe('the values of a place over times that have to be opened', () => {
  it('are those of each time, three of which are opened at a time', async () => {
    const { known, opened, most } = await readAll(read, { late: 1 });
    expect(known.at(-1)).to.deep.equal({ values: expected, done: 1, failed: 0 });
    expect(opened).to.deep.equal([0, 1, 2, 3, 4, 5, 6]);
    expect(most).to.equal(3);
    expect(known.map(({ done }) => Math.round(done * size.times))).to.deep.equal([0, 1, 2, 3, 4, 5, 6, 7]);
    // The slow one comes late, and the others do not wait for it.
    expect(known[3].values[1]).to.equal(undefined);
    expect(known[3].values.filter((value) => value !== undefined)).to.have.length(3);
  });

  it('take those that are in memory first', async () => {
    const { known, opened } = await readAll(read, { kept: [4, 2] });
    expect(opened).to.have.members([0, 1, 3, 5, 6]);
    expect(known[2].values.map((value) => value !== undefined)).to.deep.equal([
      false,
      false,
      true,
      false,
      true,
      false,
      false,
    ]);
  });

  it('are opened one by one where memory has no room for three', async () => {
    const large = { ...first, samples: { byteLength: 2 ** 28 } } as unknown as Volume;
    const { most, known } = await readAll(read, { shown: large });
    expect(most).to.equal(1);
    expect(known.at(-1)!.values).to.deep.equal(expected);
  });

  it('leave out times that can not be read, and are an error where none can', async () => {
    const { known } = await readAll(async (index) => {
      if (index % 2 === 1) throw new TypeError('damaged');
      return read(index);
    });
    expect(known.at(-1)).to.deep.include({ done: 1, failed: 3 });
    expect(known.at(-1)!.values.map((value) => value === undefined)).to.deep.equal(expected.map((_, i) => i % 2 === 1));
    const failed = await readAll(async () => Promise.reject(new TypeError('damaged'))).catch((error: Error) => error);
    expect((failed as Error).message).to.equal('damaged');
  });

  it('are not read any longer after the place has changed', async () => {
    const stop = new AbortController();
    let loads = 0;
    const done = await readAll(
      async (index) => {
        loads++;
        if (index === 2) stop.abort();
        stop.signal.throwIfAborted();
        return read(index);
      },
      { stop },
    ).catch((error: Error) => error);
    expect((done as Error).name).to.equal('AbortError');
    await new Promise((resolve) => setTimeout(resolve, 30));
    expect(loads).to.be.at.most(5);
  });
});
