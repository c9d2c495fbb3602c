import { expect } from '@esm-bundle/chai';
import { decodeFile } from '../../../src/formats/decode.ts';
import type { FormatReader, VolumeFormat } from '../../../src/formats/base/format.ts';
import { loadVolume } from '../../../src/worker/load.ts';
import type { LoadRequest } from '../../../src/worker/load.ts';
import { expectError, fixtureContext, urlOf } from '../../helpers/decode.ts';

/** Decode a file of ten bytes with a reader that fails. */
function decodeWith(fail: (bytes: Uint8Array<ArrayBuffer>) => unknown) {
  const read: FormatReader = async ({ bytes }) => {
    fail(bytes);
    throw new Error('the reader was to fail');
  };
  const toy: VolumeFormat = {
    name: 'Toy',
    words: 'a toy',
    endings: [],
    beginning: null,
    matches: () => true,
    load: async () => read,
  };
  const input = { bytes: new Uint8Array(10), url: `${urlOf('scan.toy')}?key=1`, contentType: '' };
  return expectError(decodeFile(input, {}, { ...fixtureContext(), formats: [toy] }));
}

const nothing = undefined as unknown as { length: number };

describe('what a reader does not expect', () => {
  for (const [what, fail] of [
    ['a field', (bytes) => new DataView(bytes.buffer).getUint32(8)],
    ['a range', (bytes) => new Uint8Array(4).set(bytes)],
    ['the start of a range', (bytes) => new Uint8Array(bytes.buffer, 11)],
  ] satisfies [string, (bytes: Uint8Array<ArrayBuffer>) => unknown][]) {
    it(`${what} beyond the file's end: the file is damaged`, async () => {
      const { code, message, cause } = await decodeWith(fail);
      expect(code).to.equal('format/corrupt');
      expect(message).to.contain('scan.toy can not be decoded').and.to.contain('damaged');
      expect(cause).to.be.instanceOf(RangeError);
    });
  }

  for (const length of [2 ** 52, 2 ** 60]) {
    it(`a buffer of ${length} bytes: the file is too large`, async () => {
      const { code, message } = await decodeWith(() => new Uint8Array(length));
      expect(code).to.equal('format/too-large');
      expect(message).to.contain('scan.toy needs more memory');
    });
  }

  for (const [what, fail] of [
    ['TypeError', () => nothing.length],
    [
      'Error',
      () => {
        throw new Error('no such case');
      },
    ],
  ] satisfies [string, () => unknown][]) {
    it(`${what}: a mistake of this package, and the file is named`, async () => {
      const { code, message, cause } = await decodeWith(fail);
      expect(code).to.equal('internal');
      expect(message).to.contain('the file scan.toy:').and.to.contain(what);
      expect(cause).to.be.instanceOf(Error);
    });
  }
});

describe('a mistake after decoding', () => {
  // A request whose limits are none: what makes the volume fit fails.
  const request = {
    url: '/test/fixtures/nifti/v1-le-i2.nii',
    limits: Promise.resolve(undefined as never),
  } satisfies LoadRequest;
  const load = () =>
    expectError(loadVolume(request, { signal: new AbortController().signal, onProgress: () => undefined }));

  it('in the worker is reported as one, and the file is named', async () => {
    const { code, message, cause } = await load();
    expect(code).to.equal('internal');
    expect(message).to.contain('the file v1-le-i2.nii:').and.to.contain('TypeError');
    expect(cause).to.match(/^TypeError/);
  });

  it('on the main thread too', async () => {
    const native = globalThis.Worker;
    globalThis.Worker = function refuse() {
      throw new DOMException('no workers', 'SecurityError');
    } as unknown as typeof Worker;
    try {
      const { code, message } = await load();
      expect(code).to.equal('internal');
      expect(message).to.contain('the file v1-le-i2.nii:').and.to.contain('TypeError');
    } finally {
      globalThis.Worker = native;
    }
  });
});
