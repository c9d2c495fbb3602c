import { expect } from '@esm-bundle/chai';
import { decodeBytes, expectError, valuesOf } from '../../../helpers/decode.ts';

const bytesOf = (text: string): Uint8Array<ArrayBuffer> => Uint8Array.from(atob(text), (c) => c.charCodeAt(0));

/** A NIfTI of nibabel 5.4.2, packed by the module bz2 of Python: in one stream, in two, and twice. */
const one = bytesOf(
  'QlpoOTFBWSZTWbKAeAkAAD////wJ2IAcCCIAyQAAhABBACBBEAAMAAZAAwABgADAAGAAoAB1EEIAAAA009IAGnqmlNPSNA2kGhoAGJLW85lDvQkgTKNjwGci1N8VmkQaI4tU4Lbu32qEctVpY3ntWxAFWa0gZfMQGpCDxCRGaGgAGtJGjoUj0exOMwaBAAGP39fhj/F3JFOFCQsoB4CQ',
);
const two = bytesOf(
  'QlpoOTFBWSZTWVmFlEEAACL+SHwIQAAQAAAAyABABEAAQAAgAFCmAABJqmoPUyNOsF1Fh45qkOJfN24pCesNJpn0jl27TTD8XckU4UJBZhZRBEJaaDkxQVkmU1nVyZHVAAAC///wAdiADAgyAMEAAIAAQQAgQBAADAAGAAMAAYAAwABgAKAASInpR6gAyAyaeoAMf6pDQGQGgaMgyxrQiIRM8BFIKxc7DHLR8Irz3C1zzj8bJQQCqZcb8dTy9jiSssAACHnv38Ii7kinChIauTI6oA==',
);
const twice = bytesOf(
  'QlpoOTFBWSZTWTtCIv0AACP//+vuQlRdQCwg/QUMOErwEvBuCdQwTQIRAkQgP8DgBygEoACUGTQBpk0aAABoaANDTTQDQMCGho0xohjTUGho0aAAaDIA0AANGjQHogZNDTTTQEic4yoEJVCg9GzCTChnmBGPKIpUZ2XSJqQTVMwNaGHUnpdCYCKAXtb2RCFj9d/OcSMSHgDLMkoqKmiQmjn6VczeY3H6eBc0vnx+lGiOFIWtzS59isIpOWQIigHjI/DUhlU/JYQO8Gf7ekMhDnsJrsWT2nGWHANggAcdCd/i7kinChIHaERfoA==',
);

describe('a file that is packed with bzip2', () => {
  for (const [what, bytes] of Object.entries({ one, two }))
    it(`is read: ${what}`, async () => {
      const volume = await decodeBytes(bytes.slice(), 'head.nii.bz2');
      expect(volume.format).to.equal('NIfTI-1');
      expect(valuesOf(volume)).to.deep.equal(Array.from({ length: 24 }, (_, i) => 17 * i - 100));
    });

  it('in another one, that is damaged or that holds no volume is refused in words', async () => {
    const damaged = one.slice();
    damaged[60] ^= 1;
    for (const [bytes, code, words] of [
      [twice, 'format/unsupported', 'more than once'],
      [damaged, 'format/corrupt', 'bzip2'],
      [one.slice(0, 100), 'format/corrupt', 'bzip2'],
    ] as const) {
      const error = await expectError(decodeBytes(bytes.slice(), 'head.nii.bz2'));
      expect(error.code).to.equal(code);
      expect(error.message).to.contain(words);
    }
  });
});
