import { expect } from '@esm-bundle/chai';
import { axialIndexToWorld } from '../../../../src/volume/grid.ts';
import type { Vector3 } from '../../../../src/volume/matrix.ts';
import { rgbOf } from '../../../helpers/channels.ts';
import { decodeBytes } from '../../../helpers/decode.ts';
import { compareValues, readExpected } from '../../../helpers/expected-file.ts';
import type { ExpectedFile } from '../../../helpers/expected-file.ts';

/** What tifffile and numpy read of a file; test/fixtures/make-tiff-fixtures.py makes the files and asks them. */
interface TiffFixture extends ExpectedFile {
  /** Base64. */
  readonly bytes: string;
  /** Millimetres; absent where the file says none. */
  readonly spacing?: Vector3;
  readonly left?: readonly string[];
  /** Red, green and blue of each voxel; absent where the file is gray. */
  readonly rgb?: readonly number[];
}

const fixtures = await readExpected<TiffFixture>('tiff-fixtures.json');
const bytesOf = ({ bytes }: TiffFixture): Uint8Array<ArrayBuffer> =>
  Uint8Array.from(atob(bytes), (sign) => sign.charCodeAt(0));

describe('TIFF files, against tifffile', () => {
  for (const file of fixtures)
    it(file.path, async () => {
      const volume = await decodeBytes(bytesOf(file), file.path);
      compareValues(volume, file);
      expect(volume.left ?? []).to.have.members([
        ...(file.left ?? []),
        ...(/^c\d/.test(file.path) ? ['the phase of complex numbers, whose magnitudes are shown'] : []),
      ]);
      const { dimensions, indexToWorld } = volume.grid;
      axialIndexToWorld(dimensions, file.spacing ?? [1, 1, 1]).forEach((value, i) =>
        expect(indexToWorld[i], `affine[${i}]`).to.be.closeTo(value, 1e-12),
      );
      expect(rgbOf(volume), 'colours').to.deep.equal(file.rgb);
      expect(volume.format).to.match(
        file.path.startsWith('ome') ? /^OME-TIFF/ : file.path.startsWith('imagej') ? /^ImageJ TIFF/ : /^TIFF$/,
      );
      expect(volume.anatomical ?? false).to.equal(false);
    });
});
