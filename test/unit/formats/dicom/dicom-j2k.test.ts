import { expect } from '@esm-bundle/chai';
import { VolumeViewError } from '../../../../src/core/errors.ts';
import { dicomBytes } from '../../../helpers/dicom-bytes.ts';
import type { DicomFields } from '../../../helpers/dicom-bytes.ts';
import { packedSlice } from '../../../helpers/dicom-frames.ts';
import { decodeSeries } from '../../../helpers/dicom-series.ts';
import type { Scan } from '../../../helpers/dicom-series.ts';
import { expectError, valuesOf } from '../../../helpers/decode.ts';
import { j2kStreams } from '../../../helpers/j2k-streams.ts';
import type { J2kStream } from '../../../helpers/j2k-streams.ts';
import { withoutWasm } from '../../../helpers/without-wasm.ts';

const bytesOf = (stream: string): Uint8Array<ArrayBuffer> => Uint8Array.from(atob(stream), (c) => c.charCodeAt(0));

/** A file with the streams as its frames. */
function fileOf(
  { bits, isSigned, isHt }: Omit<J2kStream, 'values'>,
  fragments: readonly Uint8Array[],
  fields: DicomFields = {},
): Uint8Array<ArrayBuffer> {
  const all: DicomFields = {
    ...packedSlice,
    BitsAllocated: [bits > 8 ? 16 : 8],
    BitsStored: [bits],
    HighBit: [bits - 1],
    PixelRepresentation: [isSigned ? 1 : 0],
    NumberOfFrames: String(fragments.length),
    ...fields,
  };
  return dicomBytes(all, { syntax: `1.2.840.10008.1.2.4.${isHt ? 203 : 91}`, fragments });
}

const decode = (...file: Parameters<typeof fileOf>): Promise<Scan> => decodeSeries([fileOf(...file)]);

describe('JPEG 2000 and HTJ2K', () => {
  for (const one of j2kStreams) {
    // Of lossy ones the sums of floats may be rounded up or down.
    const within = one.name.endsWith('lossy') ? 1 : 0;
    const check = (values: readonly number[]): void => {
      expect(values).to.have.length(180);
      for (const [i, value] of [...one.values, ...one.values].entries())
        expect(values[i], `pixel ${i}`).to.be.closeTo(value, within);
    };
    const stream = bytesOf(one.stream);
    it(`${one.name} (${one.by})`, async () => check(valuesOf(await decode(one, [stream, stream]))));

    it(`${one.name}, without WebAssembly`, async () =>
      check(valuesOf(await withoutWasm(() => decode(one, [stream, stream])))));
  }

  it('whose frames lie in several pieces each are found by the marks with which they begin', async () => {
    for (const one of j2kStreams.filter(({ name }) => !name.endsWith('lossy'))) {
      const whole = bytesOf(one.stream);
      const pieces = [whole.slice(0, 50), whole.slice(50, 72), whole.slice(72)];
      const values = valuesOf(await decode(one, [...pieces, ...pieces], { NumberOfFrames: '2' }));
      expect(values, one.name).to.deep.equal([...one.values, ...one.values]);
    }
  });

  it('a damaged one among others does not spoil those after it', async () => {
    const one = j2kStreams.find(({ name }) => name === 'JPEG 2000 of 12 bits, lossless')!;
    const whole = bytesOf(one.stream);
    const noisy = whole.map((byte, i) => (i > 120 && i % 3 === 0 ? byte ^ 0x55 : byte));
    for (const damaged of [whole.slice(0, 100), noisy]) {
      const files = Array.from({ length: 5 }, (_, k) =>
        fileOf(one, [k === 1 ? damaged : whole], { ImagePositionPatient: `0\\0\\${k}` }),
      );
      const values = valuesOf(await decodeSeries(files));
      for (const k of [0, 2, 3, 4]) expect(values.slice(90 * k, 90 * (k + 1)), `slice ${k}`).to.deep.equal(one.values);
    }
  });

  it('damaged ones give a volume or an error in words', async () => {
    let errors = 0;
    for (const one of j2kStreams.slice(0, 7)) {
      const whole = bytesOf(one.stream);
      for (let at = 2; at < whole.length; at += 61) {
        const changed = whole.slice();
        changed[at] ^= 0x55;
        for (const damaged of [whole.slice(0, at), changed]) {
          const error = await decode(one, [damaged]).then(
            () => null,
            (thrown: unknown) => thrown,
          );
          if (error === null) continue;
          errors++;
          expect(error).to.be.instanceOf(VolumeViewError);
          expect((error as VolumeViewError).code).to.match(/^format\/(corrupt|unsupported)$/);
        }
      }
    }
    expect(errors).to.be.above(20);
  });

  const [first] = j2kStreams;
  const refused: readonly (readonly [string, J2kStream, Uint8Array, DicomFields, string])[] = [
    ['of another size', first, bytesOf(first.stream), { Columns: [9] }, '10 x 9 with 8 bits; expected 9 x 9'],
    ['of more bits than a number has', { ...j2kStreams[1], bits: 8 }, bytesOf(j2kStreams[1].stream), {}, '12 bits'],
    ['that is none', first, new Uint8Array(100), {}, 'damaged'],
  ];
  for (const [what, stream, bytes, fields, words] of refused) {
    it(`${what} is refused in words`, async () => {
      const error = await expectError(decode(stream, [bytes], fields));
      expect(error.code).to.equal('format/corrupt');
      expect(error.message).to.contain('the DICOM file').and.to.contain(words);
    });
  }
});

it('says what the policy lacks in an app of a bundler whose page has no library in plain JavaScript', async () => {
  const { startOpenJpeg } = await import('../../../../src/formats/codecs/openjpeg-js-for-bundlers.ts');
  const error = await expectError(startOpenJpeg());
  expect(error).to.have.property('code', 'format/unsupported');
  expect(error.message).to.contain("'wasm-unsafe-eval' to script-src");
});
