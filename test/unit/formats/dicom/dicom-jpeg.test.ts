import { expect } from '@esm-bundle/chai';
import { VolumeViewError } from '../../../../src/core/errors.ts';
import { dicomBytes } from '../../../helpers/dicom-bytes.ts';
import type { DicomFields } from '../../../helpers/dicom-bytes.ts';
import { packedSlice } from '../../../helpers/dicom-frames.ts';
import { decodeSeries } from '../../../helpers/dicom-series.ts';
import type { Scan } from '../../../helpers/dicom-series.ts';
import { expectError, valuesOf } from '../../../helpers/decode.ts';
import { jpegStreams } from '../../../helpers/jpeg-streams.ts';
import type { JpegStream } from '../../../helpers/jpeg-streams.ts';
import { withoutWasm } from '../../../helpers/without-wasm.ts';

const bytesOf = (stream: string): Uint8Array<ArrayBuffer> => Uint8Array.from(atob(stream), (c) => c.charCodeAt(0));
const change = (bytes: Uint8Array<ArrayBuffer>, at: number, byte: number): Uint8Array<ArrayBuffer> =>
  bytes.map((before, i) => (i === at ? byte : before));
const syntaxOf = (name: string): string =>
  `1.2.840.10008.1.2.4.${name.startsWith('lossless') ? 57 : name.startsWith('JPEG-LS') ? 81 : 51}`;

/** A file with the streams as its frames. */
function fileOf(
  { name, bits }: JpegStream,
  fragments: readonly Uint8Array[],
  fields: DicomFields = {},
): Uint8Array<ArrayBuffer> {
  const allocated = bits > 8 ? 16 : 8;
  const all: DicomFields = {
    ...packedSlice,
    BitsAllocated: [allocated],
    BitsStored: [bits],
    HighBit: [bits - 1],
    NumberOfFrames: String(fragments.length),
    ...fields,
  };
  return dicomBytes(all, { syntax: syntaxOf(name), fragments });
}

const decode = (...file: Parameters<typeof fileOf>): Promise<Scan> => decodeSeries([fileOf(...file)]);

describe('pixels packed by other programs', () => {
  for (const one of jpegStreams) {
    // Of the lossy ones, decoders may round the sum of cosines up or down.
    const within = one.name.startsWith('JPEG of') ? 1 : 0;
    const check = (volume: Scan): void => {
      const values = valuesOf(volume);
      expect(values).to.have.length(180);
      for (const [i, value] of [...one.values, ...one.values].entries())
        expect(values[i], `pixel ${i}`).to.be.closeTo(value, within);
    };
    const stream = bytesOf(one.stream);
    it(`${one.name} (${one.by})`, async () => check(await decode(one, [stream, stream])));
    if (one.name.startsWith('JPEG-LS'))
      it(`${one.name}, where the page's policy refuses WebAssembly`, async () =>
        check(await withoutWasm(() => decode(one, [stream, stream]))));
  }

  it('whose frames lie in several pieces each are found by the marks with which they begin', async () => {
    for (const one of jpegStreams) {
      const whole = bytesOf(one.stream);
      const pieces = [whole.slice(0, 20), whole.slice(20, 42), whole.slice(42)];
      const two = { NumberOfFrames: '2' };
      const expected = valuesOf(await decode(one, [whole, whole]));
      for (const apart of [
        [...pieces, ...pieces],
        [...pieces, whole],
        [whole, ...pieces],
      ])
        expect(valuesOf(await decode(one, apart, two)), one.name).to.deep.equal(expected);
      const { code, message } = await expectError(decode(one, [...pieces.slice(1), ...pieces], two));
      expect(code).to.equal('format/corrupt');
      expect(message).to.contain('has 5 pieces of packed pixels for 2 frames, and does not say where each begins');
    }
  });

  it('that are damaged give a volume or an error in words', async () => {
    let errors = 0;
    for (const one of jpegStreams) {
      const whole = bytesOf(one.stream);
      for (let at = 2; at < whole.length; at += 7) {
        for (const damaged of [whole.slice(0, at), change(whole, at, whole[at] ^ 0x55), change(whole, at, 0xff)]) {
          const error = await (at % 5 === 0 ? decode(one, [damaged]) : withoutWasm(() => decode(one, [damaged]))).then(
            () => null,
            (thrown: unknown) => thrown,
          );
          if (error === null) continue;
          errors++;
          expect(error, `${one.name} at ${at}`).to.be.instanceOf(VolumeViewError);
          expect((error as VolumeViewError).code).to.match(/^format\/(corrupt|unsupported)$/);
        }
      }
    }
    expect(errors).to.be.greaterThan(100);
  });

  it('a damaged one among others is no data, and does not spoil those after it', async () => {
    for (const one of jpegStreams) {
      const whole = bytesOf(one.stream);
      const files = Array.from({ length: 5 }, (_, k) =>
        fileOf(one, [k === 1 ? whole.slice(0, -24) : whole], { ImagePositionPatient: `0\\0\\${k}` }),
      );
      const values = valuesOf(await decodeSeries(files));
      expect(values.slice(90, 180).every(Number.isNaN), one.name).to.equal(true);
      const good = values.slice(0, 90);
      for (const k of [2, 3, 4]) expect(values.slice(90 * k, 90 * (k + 1)), one.name).to.deep.equal(good);
    }
  });

  it('that end early, without the mark of the end, are refused soon', async () => {
    // Without that mark, CharLS searched its memory for minutes.
    const start = performance.now();
    for (const one of jpegStreams.filter(({ name }) => name.startsWith('JPEG-LS')))
      for (const cut of [60, 80, 24]) await expectError(decode(one, [bytesOf(one.stream).slice(0, -cut)]));
    expect(performance.now() - start).to.be.below(10_000);
  });

  it('that end early are refused', async () => {
    for (const one of jpegStreams) {
      const whole = bytesOf(one.stream);
      const error = await expectError(decode(one, [whole.slice(0, whole.length - 24)]));
      expect(error.message, one.name).to.contain('the DICOM file has packed pixels');
    }
  });

  it('of another size than the file says are refused', async () => {
    const [first] = jpegStreams;
    const error = await expectError(decode(first, [bytesOf(first.stream)], { Rows: [8] }));
    expect(error.message).to.contain('10 x 9 with 8 bits; expected 10 x 8');
  });

  it('progressive ones are refused with a program that helps', async () => {
    const [first] = jpegStreams;
    const bytes = bytesOf(first.stream);
    const frame = bytes.findIndex((byte, i) => byte === 0xff && bytes[i + 1] === 0xc0);
    bytes[frame + 1] = 0xc2;
    const error = await expectError(decode(first, [bytes]));
    expect(error.code).to.equal('format/unsupported');
    expect(error.message).to.contain('progressive').and.to.contain('dcmdjpeg');
  });
});
