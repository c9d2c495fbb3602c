import { VolumeViewError } from '../../core/errors.ts';

/** One radial as a message holds it. */
export interface NexradRadial {
  /** Degrees clockwise from north, and above the horizon, of the radial's middle. */
  readonly azimuth: number;
  readonly elevation: number;
  /** Milliseconds since 1970, UTC. */
  readonly time: number;
  /** Number of the cut, from 1: an elevation that is scanned twice has two cuts. */
  readonly cut: number;
  readonly status: number;
  /** Marked as bad data, or its transmitter was off: it has no moments. */
  readonly isBad?: boolean;
  /** m/s; absent if the cut measures no velocity. */
  readonly nyquist?: number;
  readonly moments: ReadonlyMap<string, NexradGates>;
  readonly site?: NexradSite;
}

/** Degrees north, degrees east, metres of the antenna above sea level. */
export interface NexradSite {
  readonly latitude: number;
  readonly longitude: number;
  readonly height: number;
}

/** One moment of one radial: (code - offset) / scale is a value. */
export interface NexradGates {
  /** Metres to the middle of the first gate. */
  readonly firstGate: number;
  readonly gateLength: number;
  readonly scale: number;
  readonly offset: number;
  readonly bits: 8 | 16;
  /** Big-endian. */
  readonly codes: DataView<ArrayBuffer>;
}

/** The radial's place in the volume, from its status. Source: ICD 2620002, tables III and XVII-A */
export const radialStatus = { cutStarts: 0, volumeStarts: 3, volumeEnds: 4, lastCutStarts: 5 } as const;

/** A status bit: the radial's data are bad. Source: ICD 2620002, tables III and XVII-A */
export const badStatus = 0x80;

/**
 * @param days - from 1, which is the first of January 1970
 * @param milliseconds - since midnight
 */
export function timeOf(days: number, milliseconds: number): number {
  return (days - 1) * 86_400_000 + milliseconds;
}

/** @throws {VolumeViewError} `format/corrupt` for a direction or a grid that no radar has */
export function checkRadial(radial: NexradRadial): NexradRadial {
  const { azimuth, elevation, moments } = radial;
  if (!(azimuth >= 0 && azimuth <= 360 && elevation >= -90 && elevation <= 90)) {
    throw corruptRadial(`azimuth ${azimuth} and elevation ${elevation}`, 'degrees from 0 to 360 and from -90 to 90');
  }
  for (const [name, { gateLength, firstGate, scale, offset }] of moments) {
    if (!(gateLength > 0)) throw corruptRadial(`gates of ${gateLength} m for ${name}`, 'a length above 0');
    if (!(Number.isFinite(scale) && scale > 0 && Number.isFinite(offset) && Number.isFinite(1 / scale))) {
      throw corruptRadial(
        `scale ${scale} and offset ${offset} for ${name}, its gates from ${firstGate} m`,
        'numbers, the scale above 0',
      );
    }
  }
  return radial;
}

export function corruptRadial(got: string, expected: string): VolumeViewError {
  return new VolumeViewError(
    'format/corrupt',
    `a radial of the NEXRAD file got ${got}; expected ${expected}. The file is damaged`,
  );
}

/**
 * A part of a message.
 * @throws {VolumeViewError} `format/corrupt` if the message is too short
 */
export function partOf(
  body: DataView<ArrayBuffer>,
  start: number,
  length: number,
  what: string,
): DataView<ArrayBuffer> {
  if (start + length > body.byteLength)
    throw corruptRadial(`${what} to byte ${start + length}`, `at most ${body.byteLength}, the length of its message`);
  return new DataView(body.buffer, body.byteOffset + start, length);
}
