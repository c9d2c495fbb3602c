// Numbers that lossy packing makes larger than the bits of the file allow, as next to metal in a CT.
import { expect } from '@esm-bundle/chai';
import { dicomBytes } from '../../../helpers/dicom-bytes.ts';
import type { DicomFields } from '../../../helpers/dicom-bytes.ts';
import { packedSlice } from '../../../helpers/dicom-frames.ts';
import { decodeSeries } from '../../../helpers/dicom-series.ts';
import { valuesOf } from '../../../helpers/decode.ts';
import { jpegStreams } from '../../../helpers/jpeg-streams.ts';
import { withoutWasm } from '../../../helpers/without-wasm.ts';

/** 10 x 9 numbers, none above 4095, packed as numbers of 16 bits: by OpenJPEG 2.5.4, and by CharLS 2.4.3 with errors up to 9. */
const streams = {
  j2k: '/0//UQApAAAAAAAKAAAACQAAAAAAAAAAAAAACgAAAAkAAAAAAAAAAAABDwEB/1IADAAAAAEAAgQEAAD/XAARQp9SkAWQBZBHl9OX05di/2QAJQABQ3JlYXRlZCBieSBPcGVuSlBFRyB2ZXJzaW9uIDIuNS40/5AACgAAAAAAVgAB/5PH2BII7IrORTyrDiDAeEgI4D4AwBPzBCwLsqYEbjHA+A2A8VAeLAc5F4FvTGO5JBInxEQCyNpBoAMrRe1bAtPtf4ZHXx/ZWPb/2Q==',
  ls: '/9j/6AAgU1BJRkYAAgAAAQAAAAkAAAAKChAGAQAAASwAAAEs/+gACAAAAAH/2P/3AAsQAAkACgEBEQD/+AANAf//AC0AcAFTAED/2gAIAQEACQAAX4EMEYEM0IQoUCKWBAgwYIksAAFsWBAgAAvgiQwoHkGMYIcKErHWcYUECBZIYkoIIILGMcCAABPAgQiQIIpQqsEJiv/Z',
};

/** What pydicom 3.0.2 reads of them in a file of 12 bits. */
const pydicom = {
  j2k: [
    3948, 51, 270, 0, 4077, 3841, 4275, 4161, 4169, 4099, 4416, 0, 4277, 264, 4012, 484, 4150, 4480, 69, 0, 537, 356,
    4556, 4043, 4259, 512, 4067, 4381, 3897, 3948, 3910, 0, 472, 4527, 4478, 189, 231, 3569, 3801, 698, 4312, 0, 3659,
    0, 0, 4519, 363, 4175, 521, 4498, 4255, 82, 4205, 692, 201, 395, 278, 4174, 306, 837, 97, 241, 65, 4174, 74, 4205,
    143, 4064, 0, 8, 3632, 4450, 75, 4342, 230, 629, 3992, 3930, 4207, 68, 4340, 46, 3394, 3817, 149, 4136, 3723, 3945,
    1105, 4380,
  ],
  ls: [
    304, 304, 323, 324, 344, 344, 363, 307, 309, 311, 323, 342, 342, 362, 305, 305, 324, 326, 345, 346, 361, 303, 303,
    4104, 4104, 4104, 4104, 4104, 304, 304, 323, 323, 342, 4104, 4104, 4104, 4104, 4104, 323, 343, 344, 346, 308, 4089,
    4087, 4104, 4104, 4104, 361, 301, 302, 321, 327, 4089, 4087, 4104, 4104, 4104, 323, 322, 340, 354, 355, 4089, 4087,
    4104, 4104, 4104, 342, 361, 303, 317, 318, 329, 329, 346, 346, 308, 308, 327, 323, 338, 339, 355, 299, 316, 316,
    329, 329, 345,
  ],
};

/** The numbers of a file of 12 bits. @param syntax - the last number of its transfer syntax */
async function read(stream: string, syntax: number, fields: DicomFields = {}): Promise<number[]> {
  const all: DicomFields = {
    ...packedSlice,
    BitsStored: [12],
    HighBit: [11],
    ...fields,
  };
  const bytes = Uint8Array.from(atob(stream), (c) => c.charCodeAt(0));
  const file = dicomBytes(all, { syntax: `1.2.840.10008.1.2.4.${syntax}`, fragments: [bytes] });
  return valuesOf(await decodeSeries([file]));
}

describe('lossy numbers above the bits of a DICOM file', () => {
  it('of JPEG 2000 stay large', async () => {
    const values = await read(streams.j2k, 91);
    expect(Math.max(...pydicom.j2k)).to.be.above(4095);
    // Sums of floats may be rounded up or down.
    for (const [i, value] of pydicom.j2k.entries()) expect(values[i], `pixel ${i}`).to.be.closeTo(value, 1);
  });

  it('of near-lossless JPEG-LS stay large, also where our own code unpacks them', async () => {
    expect(await read(streams.ls, 81)).to.deep.equal(pydicom.ls);
    expect(await withoutWasm(() => read(streams.ls, 81))).to.deep.equal(pydicom.ls);
  });

  it('have their sign where the packing knows none', async () => {
    const { stream, values } = jpegStreams.find(({ name }) => name === 'JPEG-LS of 12 bits, near-lossless')!;
    // pydicom 3.0.2 reads the same: bit 11 is the sign.
    const signed = values.map((value) => (value > 2047 ? value - 4096 : value));
    expect(await read(stream, 81, { PixelRepresentation: [1] })).to.deep.equal(signed);
  });

  it('of lossless packing are bits of something else, such as overlays', async () => {
    const { stream, values } = jpegStreams.find(({ name }) => name === 'JPEG-LS of 16 bits')!;
    expect(await read(stream, 80)).to.deep.equal(values.map((value) => value & 0xfff));
  });
});
