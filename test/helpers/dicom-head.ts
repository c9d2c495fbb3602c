import { ctSlice, dicomBytes, pixelFields } from './dicom-bytes.ts';

/** A word that is in every name, date and identifier of the files: it must not be anywhere else. */
export const dicomSecret = 'Geheim';

/** Pixels along each edge. */
const size = 32;

/**
 * A CT of a head as simple as can be: a sphere of soft tissue with a shell of bone and a hole, 32 slices of 32 x 32 pixels of 2 mm. What names a patient has
 * the secret word, and so have the paths.
 * @returns the files by their paths
 */
export function dicomHead(): Record<string, Uint8Array> {
  return Object.fromEntries(
    Array.from({ length: size }, (_, k) => {
      const fields = {
        ...ctSlice(2 * k, {
          SOPInstanceUID: `1.2.840.99999.${k + 1}`,
          SeriesInstanceUID: '1.2.840.99999.77',
          PatientName: `${dicomSecret}^Anna`,
          PatientID: `${dicomSecret}-123`,
          StudyDate: '19870605',
          SeriesDescription: `Skull of ${dicomSecret}`,
        }),
        ...pixelFields(sliceOf(k)),
        Rows: [size],
        Columns: [size],
        PixelSpacing: [2, 2],
        SliceThickness: [2],
      };
      return [`${dicomSecret}/IM${String(k).padStart(4, '0')}`, dicomBytes(fields)];
    }),
  );
}

/** Stored numbers, 1024 above HU. */
function sliceOf(k: number): Uint16Array {
  const middle = (size - 1) / 2;
  return Uint16Array.from({ length: size * size }, (_, at) => {
    const [x, y, z] = [(at % size) - middle, Math.floor(at / size) - middle, k - middle];
    const radius = Math.hypot(x, y, z);
    if (radius > 13) return 24;
    if (Math.hypot(x - 6, y, z) < 4) return 1024;
    return radius > 10.5 ? 1024 + 900 : 1024 + 40;
  });
}
