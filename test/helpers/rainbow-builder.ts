// Volumes of Rainbow 5: a header of XML, then numbers packed by zlib. Laid out as the files of wradlib-data are.
import { zlibSync } from 'fflate';

export interface BuiltSlice {
  /** Degrees. */
  readonly elevation: number;
  /** Starts of the radials, and their ends where the file has them, of 65,536 parts of a circle. */
  readonly starts: readonly number[];
  readonly stops?: readonly number[];
  readonly parts: readonly {
    readonly type: string;
    readonly depth: 8 | 16;
    readonly min: number;
    readonly max: number;
    /** [radials][gates]. */
    readonly numbers: readonly (readonly number[])[];
  }[];
}

export interface BuiltVolume {
  readonly slices: readonly BuiltSlice[];
  readonly type?: string;
  /** Kilometres. */
  readonly rangestep?: number;
  readonly start?: number;
  readonly anglestep?: number;
  /** Changes the header, or the number that a blob says of its bytes. */
  readonly change?: (header: string) => string;
  readonly size?: (bytes: number) => number;
  readonly isPacked?: boolean;
  /** Packs as zlib does, where another one is quicker. */
  readonly pack?: (bytes: Uint8Array) => Uint8Array;
}

const bigEndian = (numbers: readonly number[], depth: 8 | 16): Uint8Array =>
  Uint8Array.from(depth === 8 ? numbers : numbers.flatMap((number) => [number >> 8, number & 255]));

export function buildRainbow({
  slices,
  type = 'vol',
  rangestep = 0.25,
  start = 0,
  anglestep = 1,
  change = (header) => header,
  size = (bytes) => bytes,
  isPacked = true,
  pack = zlibSync,
}: BuiltVolume): Uint8Array<ArrayBuffer> {
  const blobs: Uint8Array[] = [];
  const add = (bytes: Uint8Array): number => blobs.push(bytes) - 1;
  const written = slices.map(({ elevation, starts, stops, parts }, i) => {
    const angles = [['startangle', starts] as const, ...(stops ? [['stopangle', stops] as const] : [])].map(
      ([refid, list]) =>
        `<rayinfo refid="${refid}" blobid="${add(bigEndian(list, 16))}" rays="${list.length}" depth="16"/>`,
    );
    const raw = parts.map(
      ({ type, depth, min, max, numbers }) =>
        `<rawdata blobid="${add(bigEndian(numbers.flat(), depth))}" rays="${numbers.length}" type="${type}" bins="${numbers[0].length}" min="${min}" max="${max}" depth="${depth}"/>`,
    );
    return `<slice refid="${i}"><dynv min="-15.95" max="15.95"/><posangle>${elevation}</posangle>
<slicedata time="00:0${i % 10}:06" date="2013-05-10">${[...angles, ...raw].join('\n')}</slicedata></slice>`;
  });
  const bins = slices[0]?.parts[0]?.numbers[0]?.length ?? 0;
  const header = change(`<volume version="5.36.5" datetime="2013-05-10T00:03:17" type="${type}" owner="">
<scan name="a.vol" time="00:00:06" date="2013-05-10"><pargroup refid="sdfbase"><startrange>${start}</startrange><stoprange>${start + bins * rangestep}</stoprange><rangestep>${rangestep}</rangestep><anglestep>${anglestep}</anglestep><antspeed>33</antspeed></pargroup>
${written.join('\n')}</scan>
<sensorinfo type="gdrx" id="1" name="Here"><lon>6.379967</lon><lat>50.856633</lat><alt>116.7</alt><wavelen>0.0319</wavelen><beamwidth>1.326</beamwidth></sensorinfo>
</volume>
<!-- END XML -->
`);
  const encode = (text: string): Uint8Array => new TextEncoder().encode(text);
  const all = [
    encode(header),
    ...blobs.flatMap((bytes, id) => {
      const length = new Uint8Array(4);
      new DataView(length.buffer).setUint32(0, bytes.length);
      const packed = isPacked ? Uint8Array.from([...length, ...pack(bytes)]) : bytes;
      const tag = `<BLOB blobid="${id}" size="${size(packed.length)}" compression="${isPacked ? 'qt' : 'none'}">\n`;
      return [encode(tag), packed, encode('\n</BLOB>\n')];
    }),
  ];
  const bytes = new Uint8Array(all.reduce((sum, { length }) => sum + length, 0));
  let at = 0;
  for (const part of all) {
    bytes.set(part, at);
    at += part.length;
  }
  return bytes;
}

const degrees = (angle: number): number => Math.round((angle * 65536) / 360);
const rows = (numbers: readonly number[]): number[][] =>
  [0, 1, 2, 3].map((radial) => [0, 1, 2].map((gate) => numbers[(radial * 3 + gate) % numbers.length]));

/** Two sweeps: reflectivity of 8 bits, velocity of 16. */
export const builtVolume: BuiltVolume = {
  start: 2,
  slices: [
    {
      elevation: 0.6,
      starts: [358.5, 359.5, 0.5, 1.5].map(degrees),
      parts: [{ type: 'dBZ', depth: 8, min: -31.5, max: 95.5, numbers: rows([0, 1, 2, 64, 128, 254, 255]) }],
    },
    {
      elevation: 1.4,
      starts: [10, 11, 12, 13].map(degrees),
      parts: [{ type: 'dBZ', depth: 16, min: -31.5, max: 95.5, numbers: rows([0, 1, 2, 300, 40000, 65534, 65535]) }],
    },
  ],
};

/** One sweep of velocities, with the ends of its radials. */
export const builtSweep: BuiltVolume = {
  type: 'azi',
  slices: [
    {
      elevation: 2.5,
      starts: [357, 358, 359, 0].map(degrees),
      stops: [358, 359, 0.5, 1].map(degrees),
      parts: [{ type: 'V', depth: 8, min: -15.95, max: 15.95, numbers: rows([0, 1, 127, 128, 129, 255]) }],
    },
  ],
};
