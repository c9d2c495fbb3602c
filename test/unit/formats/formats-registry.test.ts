import { expect } from '@esm-bundle/chai';
import { decodeFile } from '../../../src/formats/decode.ts';
import type { Format, VolumeFormat } from '../../../src/formats/base/format.ts';
import { rareFormats } from '../../../src/formats/rare-formats.ts';
import { allFormats } from '../../../src/formats/registry.ts';
import { sniffFile } from '../../../src/formats/sniff.ts';
import { axialIndexToWorld, cartesianGrid } from '../../../src/volume/grid.ts';
import { expectError, fixtureContext, urlOf } from '../../helpers/decode.ts';

const encode = (text: string): Uint8Array<ArrayBuffer> => new TextEncoder().encode(text);
const inputOf = (bytes: Uint8Array<ArrayBuffer>, name: string) => ({ bytes, url: urlOf(name), contentType: '' });

/** Two letters, and then a voxel a byte along i. */
const toy: VolumeFormat = {
  name: 'Toy',
  words: 'a toy (.toy)',
  endings: ['toy'],
  beginning: 'the letters TY',
  matches: ({ text }) => text.startsWith('TY'),
  load:
    async () =>
    async ({ bytes }) => {
      const samples = bytes.slice(2);
      const dimensions = [samples.length, 1, 1] as const;
      return {
        grid: cartesianGrid(dimensions, axialIndexToWorld(dimensions, [1, 1, 1])),
        samples,
        slope: 1,
        intercept: 0,
        unit: '',
        format: 'Toy',
      };
    },
};
const formats: readonly Format[] = [...allFormats, toy];

describe('the registry of formats', () => {
  it('takes one more by its description alone', async () => {
    const volume = await decodeFile(inputOf(encode('TYabc'), 'x.bin'), {}, { ...fixtureContext(), formats });
    expect(volume.format).to.equal('Toy');
    expect(Array.from(volume.samples)).to.deep.equal([97, 98, 99]);
  });

  it('says of a file without the right beginning what it should be', async () => {
    const error = await expectError(sniffFile(inputOf(encode('ab'), 'x.TOY'), formats));
    expect(error.code).to.equal('format/corrupt');
    expect(error.message).to.contain('the letters TY');
  });

  it('names every format where a file is of none', async () => {
    const error = await expectError(sniffFile(inputOf(encode('just text'), 'x'), formats));
    expect(error.code).to.equal('format/unknown');
    for (const { words } of [...formats, ...rareFormats]) expect(error.message).to.contain(words);
    expect(error.message, 'a list that ends with "or"').to.match(/, [^,]+ or [^,]+(?: \([^)]*\))?$/);
  });

  it('asks formats that others may be of last', async () => {
    const greedy: VolumeFormat = { ...toy, name: 'Greedy', matches: () => true, last: true };
    expect((await sniffFile(inputOf(encode('TY'), 'x'), [greedy, toy])).name).to.equal('Toy');
    expect((await sniffFile(inputOf(encode('XY'), 'x'), [greedy, toy])).name).to.equal('Greedy');
  });

  it('gives no two formats the same ending or name', () => {
    const all = [...allFormats, ...rareFormats];
    const endings = all.flatMap((format) => format.endings);
    expect(endings).to.have.length(new Set(endings).size);
    expect(new Set(all.map(({ name }) => name)).size).to.equal(all.length);
    expect(allFormats.length).to.be.greaterThan(10);
  });
});
