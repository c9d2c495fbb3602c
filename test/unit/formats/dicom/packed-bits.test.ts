import { expect } from '@esm-bundle/chai';
import { PackedBits } from '../../../../src/formats/dicom/packed-bits.ts';

const read = (bytes: readonly number[], stuffed: 1 | 8, count: number): number[] => {
  const bits = new PackedBits(Uint8Array.from(bytes), 0, stuffed, 'the file');
  const values = Array.from({ length: count }, () => bits.read(8));
  bits.check();
  return values;
};

describe('bits of a packed stream', () => {
  it('leaves out what is stuffed after a byte of 255', () => {
    expect(read([1, 0xff, 0, 2, 0xff, 0, 3], 8, 5)).to.deep.equal([1, 255, 2, 255, 3]);
    // 7 bits of 0x15, then 0x80: 0010101 1, then 0000000.
    expect(read([1, 0xff, 0x15, 0x80, 0], 1, 4)).to.deep.equal([1, 255, 0b00101011, 0]);
  });

  it('ends at a mark, and says so', () => {
    for (const [stuffed, words] of [
      [8, '(JPEG) that end early'],
      [1, '(JPEG-LS) that end early'],
    ] as const) {
      expect(read([7, 8, 0xff, 0xd9, 1, 2], stuffed, 2)).to.deep.equal([7, 8]);
      expect(() => read([7, 8, 0xff, 0xd9, 1, 2], stuffed, 3)).to.throw(words);
      expect(() => read([7], stuffed, 2)).to.throw(words);
    }
  });

  it('ends after a last byte of 255', () => {
    for (const stuffed of [1, 8] as const) expect(() => read([0xff], stuffed, 3)).to.throw('end early');
  });
});
