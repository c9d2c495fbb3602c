import { expect } from '@esm-bundle/chai';
import type { Volume } from '../../src/volume/volume.ts';
import { decodeFile } from '../../src/formats/decode.ts';
import { finishVolume } from '../../src/formats/finish-volume.ts';
import { fetchInOrder } from '../../src/sources/fetch-files.ts';
import { openFiles } from '../../src/sources/open-files.ts';
import { decodeBytes, fetchFixture, roomyLimits } from './decode.ts';
import { compareValues, readExpected } from './expected-file.ts';
import type { ExpectedFile } from './expected-file.ts';

/** What another program says of a file; test/fixtures/make-format-fixtures.py makes the files and asks it. */
export interface FormatFile extends ExpectedFile {
  readonly 'read by': string;
  /** Row-major; null if the file has no place, so that the package chooses one. */
  readonly affine: readonly number[] | null;
  /** Volumes of the file, of which the first is compared. */
  readonly volumes?: number;
}

const files = await readExpected<FormatFile>('format-fixtures.json');

/** The files whose names match. Throws if there are none. */
export function filesLike(name: RegExp): readonly FormatFile[] {
  const found = files.filter(({ path }) => name.test(path));
  if (found.length === 0) throw new Error(`no fixture is called like ${name.source}`);
  return found;
}

export const readFormatFile = async (name: string): Promise<Volume> =>
  decodeBytes(await fetchFixture(`formats/${name}`), `formats/${name}`);

/** Compare a file's values and place with what the other program reads. */
export async function compareFormatFile(expected: FormatFile): Promise<Volume> {
  const volume = await decodeBytes(await fetchFixture(expected.path), expected.path);
  compareValues(volume, expected);
  expected.affine?.forEach((value, i) =>
    // Most headers have directions as 32-bit floats.
    expect(volume.grid.indexToWorld[i], `affine[${i}]`).to.be.closeTo(value, 2e-6 * Math.max(1, Math.abs(value))),
  );
  if (expected.volumes !== undefined)
    expect(volume.format?.includes(`volume 1 of ${expected.volumes}`), volume.format).to.equal(expected.volumes > 1);
  return volume;
}

/** Decode files as if a person had chosen them from the disk. */
export async function decodeChosen(names: readonly string[]): Promise<Volume> {
  const files = await Promise.all(names.map(async (name) => new File([await fetchFixture(`formats/${name}`)], name)));
  const { first, read } = await openFiles({ files, base: 'https://files.invalid/' }, { isStack: false });
  const fetchFile = (url: string): ReturnType<typeof read> => read(url, {});
  const context = {
    onProgress: () => undefined,
    fetchFile,
    fetchFiles: (urls: readonly string[]) => fetchInOrder(urls, fetchFile, () => undefined),
  };
  return finishVolume(await decodeFile(await fetchFile(first), {}, context), roomyLimits);
}
