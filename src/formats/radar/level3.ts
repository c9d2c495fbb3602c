import { Budget } from '../base/budget.ts';
import { corruptFile, unsupportedFile } from '../base/file-problem.ts';
import { bunzip2, isBzip2 } from '../codecs/bunzip2.ts';
import { Bunzip2Room } from '../codecs/bunzip2-room.ts';
import { gunzipAll } from '../codecs/gunzip-all.ts';
import { isGzip } from '../codecs/gunzip.ts';
import { isoTime } from './cf-time.ts';
import { level3HeadBytes, readLevel3Message } from './level3-message.ts';
import type { Level3Message } from './level3-message.ts';
import { level3Products, listProducts } from './level3-products.ts';
import type { Level3Product } from './level3-products.ts';
import { readLevel3Radials } from './level3-radials.ts';
import type { Level3Radials } from './level3-radials.ts';
import type { RadarFile, SweepData, SweepGates } from './radar-file.ts';

/** Maximum bytes of a product, unpacked: thirty times as many as the largest one has. */
const maxBytes = 2 ** 25;

/** Degrees, of a WSR-88D: 0.96 at 2.7 GHz and 0.88 at 3 GHz. Source: Federal Meteorological Handbook 11, part B */
const usualBeamWidth = 0.95;

/** Smaller numbers are no values: 0 is below the threshold, 1 is range folded. */
const firstValid = 2;

/**
 * Reads a product of NEXRAD Level III that shows one sweep, plain or with its symbols packed by bzip2, with or without the lines of a
 * bulletin before it.
 * Gates have their length along the beam. What the file says of it, "range scale factor", is their length on the ground, a thousand times
 * the cosine of the elevation, cut to a whole number; Py-ART 2.3 takes that.
 * @throws {VolumeViewError} `format/corrupt`, `format/unsupported`, `format/too-large`
 * Source: Interface Control Document for the RPG to Class 1 User, 2620001 (NOAA/NWS Radar Operations Center)
 */
export async function readLevel3(
  given: Uint8Array<ArrayBuffer>,
  budget = Budget.ofFile(given.length),
): Promise<RadarFile> {
  let bytes = given;
  // A file of an archive may come packed once more.
  for (let layer = 0; layer < 2 && isGzip(bytes); layer++)
    bytes = await gunzipAll(bytes, budget, 'the NEXRAD Level III file');
  const message = readLevel3Message(bytes);
  const product = level3Products.get(message.code);
  if (!product)
    throw unsupportedFile(
      'the NEXRAD Level III file',
      `holds the product ${message.code}, which is no sweep of one elevation that is known here; expected one of ${listProducts()}. NOAA's Weather and Climate Toolkit shows other products, and converts them`,
    );
  const radials = readLevel3Radials(unpackSymbols(bytes.subarray(message.start + level3HeadBytes), budget), budget);
  const { name, kind, numbers, unit, gateLength, beamWidth = usualBeamWidth } = product;
  const grid: SweepGates = { firstGate: (radials.first + 0.5) * gateLength, gateLength, gates: radials.gates };
  const time = isoTime(message.time);
  const { latitude, longitude, height, station, elevation } = message;
  const { azimuths, announced } = radials;
  return {
    format: `NEXRAD Level III, product ${message.code}`,
    site: { ...(station && { name: station }), latitude, longitude, height },
    beamWidth,
    ...(time && { time }),
    moments: [{ name, kind, unit, ...(numbers && { numbers }) }],
    sweeps: [
      {
        elevation,
        azimuths,
        ...(time && { time }),
        moments: [name],
        gridOf: (moment) => (moment === name ? grid : null),
        read: (moment) => (moment === name ? { ...grid, ...valuesOf(radials, message, product) } : null),
      },
    ],
    ...(product.coding === 'classes' && {
      details: [
        'numbers stand for kinds of echo (10 animals, 20 ground, 30 ice crystals, 40 dry snow, 50 wet snow, 60 rain, 70 heavy rain, 80 big drops, 90 graupel, 100, 110, 120 hail, 140 unknown)',
      ],
    }),
    ...(azimuths.length < announced && {
      partial: `the file was cut short: ${azimuths.length} of ${announced} radials are there`,
    }),
  };
}

function unpackSymbols(bytes: Uint8Array<ArrayBuffer>, budget: Budget): Uint8Array<ArrayBuffer> {
  if (!isBzip2(bytes)) return bytes;
  const room = new Bunzip2Room(budget);
  const unpacked = bunzip2(bytes, maxBytes, room);
  room.release();
  budget.take(unpacked.length, 'the NEXRAD Level III product');
  return unpacked;
}

type Values = Pick<SweepData, 'samples' | 'slope' | 'intercept'>;

function valuesOf({ codes }: Level3Radials, { levels }: Level3Message, { coding, factor = 1 }: Level3Product): Values {
  switch (coding) {
    case 'levels': {
      const values = readLevels(levels).map((value) => factor * value);
      return { samples: Float32Array.from(codes, (code) => values[code] ?? NaN), slope: 1, intercept: 0 };
    }
    case 'tenths': {
      const [least, step] = [levels.getInt16(0), levels.getInt16(2)];
      return scaled(codes, step / 10, (least - firstValid * step) / 10);
    }
    case 'widths': {
      const step = levels.getInt16(2);
      return scaled(codes, step / 10, (-zeroWidth * step) / 10);
    }
    case 'floats': {
      const [scale, offset] = [levels.getFloat32(0), levels.getFloat32(4)];
      return scaled(codes, 1 / scale, -offset / scale);
    }
    case 'classes':
      return { samples: codes.map((code) => (code === rangeFolded ? 0 : code)), slope: 1, intercept: 0 };
  }
}

/** The number of a spectrum width of 0. Source: MetPy 1.7, `DigitalSPWMapper`; Py-ART 2.3, which takes halfword 31 for it, -63.5 */
const zeroWidth = 129;

/** Of the kinds of echo of product 165, the one that is none. Source: ICD 2620001, note on product 165; MetPy 1.7, `DigitalHMCMapper` */
const rangeFolded = 150;

/** @throws {VolumeViewError} `format/corrupt` */
function scaled(codes: Uint8Array<ArrayBuffer>, slope: number, intercept: number): Values {
  if (!(Number.isFinite(slope) && slope !== 0 && Number.isFinite(intercept)))
    throw corruptFile(
      'the NEXRAD Level III product',
      `got values that begin at ${intercept} and go in steps of ${slope}; expected finite numbers, the step not 0`,
    );
  return { samples: codes.map((code) => (code < firstValid ? 0 : code)), slope, intercept };
}

/** Bits of a level: its number is a code for no value; below 0; a tenth, a twentieth, a hundredth. */
const [isCode, isNegative, isTenth, isTwentieth, isHundredth] = [0x80, 0x01, 0x10, 0x20, 0x40];

/** The sixteen levels: NaN for those that are no value, such as "range folded". Source: ICD 2620001, figure 3-6, note 1 */
function readLevels(levels: DataView<ArrayBuffer>): number[] {
  return Array.from({ length: 16 }, (_, level) => {
    const [bits, number] = [levels.getUint8(2 * level), levels.getUint8(2 * level + 1)];
    if (bits & isCode) return NaN;
    const parts = bits & isTenth ? 10 : bits & isTwentieth ? 20 : bits & isHundredth ? 100 : 1;
    return ((bits & isNegative ? -1 : 1) * number) / parts;
  });
}
