// Makes two pictures of one slice, as DICOM: an X-ray picture of the synthetic torso, and a film of a slice through the synthetic heart. Nobody's body.
import { deflateRawSync } from 'node:zlib';
import { contractionAt, frames, step, valueAt } from './demo-heart.mjs';
import { seededRandom } from './demo-painter.mjs';

/** The root of our identifiers: one of a UUID, which needs no registration (PS3.5, B.2). */
const root = '2.25.8216402911873540097614';

/** @typedef {readonly [group: number, element: number, vr: string, value: string | number | Uint8Array]} Element */

/** One element, explicit VR little endian (PS3.5, 7.1). @param {Element} element */
function writeElement([group, element, vr, value]) {
  const isLong = vr === 'OW' || vr === 'OB';
  const bytes =
    value instanceof Uint8Array
      ? Buffer.from(value)
      : vr === 'US'
        ? Buffer.from(Uint16Array.of(Number(value)).buffer)
        : vr === 'UL'
          ? Buffer.from(Uint32Array.of(Number(value)).buffer)
          : Buffer.from(String(value), 'latin1');
  const padded = bytes.length % 2 ? Buffer.concat([bytes, Buffer.from(vr === 'UI' ? '\0' : ' ')]) : bytes;
  const head = Buffer.alloc(isLong ? 12 : 8);
  head.writeUInt16LE(group, 0);
  head.writeUInt16LE(element, 2);
  head.write(vr, 4, 'latin1');
  if (isLong) head.writeUInt32LE(padded.length, 8);
  else head.writeUInt16LE(padded.length, 6);
  return Buffer.concat([head, padded]);
}

/**
 * A DICOM file whose data set is deflated (PS3.5, A.5).
 * @param {string} sopClass @param {string} name - of the instance @param {readonly Element[]} elements - in the order of their tags
 */
function writeDicomFile(sopClass, name, elements) {
  const instance = `${root}.${name}`;
  const meta = Buffer.concat(
    /** @type {Element[]} */ ([
      [2, 1, 'OB', Uint8Array.of(0, 1)],
      [2, 2, 'UI', sopClass],
      [2, 3, 'UI', instance],
      [2, 0x10, 'UI', '1.2.840.10008.1.2.1.99'],
      [2, 0x12, 'UI', `${root}.1`],
    ]).map(writeElement),
  );
  const data = Buffer.concat(
    [
      /** @type {Element} */ ([8, 0x16, 'UI', sopClass]),
      /** @type {Element} */ ([8, 0x18, 'UI', instance]),
      ...elements,
    ].map(writeElement),
  );
  const packed = deflateRawSync(data, { level: 9 });
  const even = packed.length % 2 ? Buffer.concat([packed, Buffer.alloc(1)]) : packed;
  return Buffer.concat([Buffer.alloc(128), Buffer.from('DICM'), writeElement([2, 0, 'UL', meta.length]), meta, even]);
}

/** How much of its rays a millimetre takes away, by the value in Hounsfield units: that of water is about 0.02 at 70 keV. @param {number} hu */
const attenuationOf = (hu) => Math.max(0, 0.02 * (1 + hu / 1000));

/** Pixels of the X-ray picture along each side, and their edge in mm, on the film behind the body. */
const film = { edge: 320, spacing: 1.25, behind: 150, source: -1650 };

/**
 * An X-ray picture of the torso, from the back to the front: what is left of each ray from a point source, as its logarithm.
 * @param {import('./demo-painter.mjs').Painter} torso
 */
export function writeRadiograph({ dimensions: [nx, ny, nz], spacing, origin, values }) {
  const valueOf = (/** @type {number} */ x, /** @type {number} */ y, /** @type {number} */ z) => {
    const at = [x, y, z].map((n, axis) => (n - origin[axis]) / spacing[axis]);
    const [i, j, k] = at.map(Math.floor);
    if (i < 0 || j < 0 || k < 0 || i + 1 >= nx || j + 1 >= ny || k + 1 >= nz) return -1000;
    const [u, v, w] = [at[0] - i, at[1] - j, at[2] - k];
    const read = (/** @type {number} */ b, /** @type {number} */ c) => {
      const first = i + nx * (j + b + ny * (k + c));
      return values[first] + u * (values[first + 1] - values[first]);
    };
    const low = read(0, 0) + v * (read(1, 0) - read(0, 0));
    return low + w * (read(0, 1) + v * (read(1, 1) - read(0, 1)) - low);
  };
  const { edge, spacing: pixel, behind, source } = film;
  const random = seededRandom(7);
  const pixels = new Uint16Array(edge * edge);
  for (let row = 0; row < edge; row++)
    for (let column = 0; column < edge; column++) {
      // The patient's right is at the left of the picture.
      const to = [(column - (edge - 1) / 2) * -pixel, behind, ((edge - 1) / 2 - row) * pixel];
      const length = Math.hypot(to[0], behind - source, to[2]);
      const perY = length / (behind - source);
      let sum = 0;
      for (let y = origin[1]; y < behind; y += 1.5) {
        const share = (y - source) / (behind - source);
        sum += 1.5 * perY * attenuationOf(valueOf(share * to[0], y, share * to[2]));
      }
      const noise = (random() + random() + random() - 1.5) * 12;
      pixels[edge * row + column] = Math.min(4095, Math.max(0, Math.round(500 * sum + 60 + noise)));
    }
  return writeDicomFile('1.2.840.10008.5.1.4.1.1.1.1', '2', [
    [8, 0x60, 'CS', 'DX'],
    [8, 0x68, 'CS', 'FOR PRESENTATION'],
    [8, 0x103e, 'LO', 'Chest (synthetic), from back to front'],
    [0x10, 0x10, 'PN', 'Nobody'],
    [0x18, 0x1164, 'DS', `${pixel}\\${pixel}`],
    [0x18, 0x5101, 'CS', 'PA'],
    [0x20, 0xd, 'UI', `${root}.3`],
    [0x20, 0xe, 'UI', `${root}.4`],
    [0x20, 0x20, 'CS', 'L\\F'],
    [0x28, 2, 'US', 1],
    [0x28, 4, 'CS', 'MONOCHROME2'],
    [0x28, 0x10, 'US', edge],
    [0x28, 0x11, 'US', edge],
    [0x28, 0x30, 'DS', `${pixel}\\${pixel}`],
    [0x28, 0x100, 'US', 16],
    [0x28, 0x101, 'US', 12],
    [0x28, 0x102, 'US', 11],
    [0x28, 0x103, 'US', 0],
    [0x28, 0x1050, 'DS', '1450.5'], // Black at 300, white at 2600 (PS3.3, C.11.2.1.2)
    [0x28, 0x1051, 'DS', '2301'],
    [0x7fe0, 0x10, 'OW', new Uint8Array(pixels.buffer)],
  ]);
}

/** Pixels of the film along each side, and their edge in mm. */
const slice = { edge: 96, spacing: 1.4 };

/** What is around the heart: skin, muscles, lungs and the spine, 0 to 255. @param {number} x @param {number} y - mm from the middle */
function chestAt(x, y) {
  const inside = (/** @type {number} */ depth) => Math.min(1, Math.max(0, 0.5 + depth / 3));
  const depth = 60 - Math.hypot(x / 1.05, y);
  const [skin, muscle, lung] = [0, 4, 12].map((from) => inside(depth - from));
  const spine = inside(9 - Math.hypot(x, y - 41));
  return 150 * (skin - muscle) + 70 * (muscle - lung) + 14 * lung + 156 * spine;
}

/** A film of a slice through the heart, across its long axis: the frames of one beat. */
export function writeHeartFilm() {
  const { edge, spacing } = slice;
  const random = seededRandom(11);
  const pixels = new Uint8Array(frames * edge * edge);
  for (let frame = 0, at = 0; frame < frames; frame++) {
    const contraction = contractionAt(frame / frames);
    for (let j = 0; j < edge; j++)
      for (let i = 0; i < edge; i++) {
        const [x, y] = [i, j].map((n) => (n - (edge - 1) / 2) * spacing);
        const heart = valueAt([-x - 6, y, 2], contraction);
        const value = Math.max(heart, chestAt(x, y)) + (random() + random() - 1) * 5;
        pixels[at++] = Math.min(255, Math.max(0, Math.round(value)));
      }
  }
  return writeDicomFile('1.2.840.10008.5.1.4.1.1.7.2', '5', [
    [8, 0x60, 'CS', 'OT'],
    [8, 0x64, 'CS', 'SYN'],
    [8, 0x103e, 'LO', 'Beating heart (synthetic), one slice'],
    [0x10, 0x10, 'PN', 'Nobody'],
    [0x18, 0x1063, 'DS', String(1000 * step)],
    [0x20, 0xd, 'UI', `${root}.6`],
    [0x20, 0xe, 'UI', `${root}.7`],
    [0x28, 2, 'US', 1],
    [0x28, 4, 'CS', 'MONOCHROME2'],
    [0x28, 8, 'IS', frames],
    [0x28, 9, 'AT', Uint8Array.of(0x18, 0, 0x63, 0x10)],
    [0x28, 0x10, 'US', edge],
    [0x28, 0x11, 'US', edge],
    [0x28, 0x30, 'DS', `${spacing}\\${spacing}`],
    [0x28, 0x100, 'US', 8],
    [0x28, 0x101, 'US', 8],
    [0x28, 0x102, 'US', 7],
    [0x28, 0x103, 'US', 0],
    [0x7fe0, 0x10, 'OB', pixels],
  ]);
}
