import { badStatus, checkRadial, partOf, timeOf } from './nexrad-radial.ts';
import type { NexradGates, NexradRadial } from './nexrad-radial.ts';

const headerLength = 100;

/** Angles are integers; 32,768 is half a turn. */
const degreesPerUnit = 180 / 32768;

/**
 * Reads a radial of message 1, "digital radar data", which radars sent until 2008: reflectivity (REF, 1 km), velocity
 * and spectrum width (VEL, SW, 250 m), one byte a gate. It does not contain the radar's position.
 * @throws {VolumeViewError} `format/corrupt`
 * Source: Interface Control Document for the RDA/RPG, 2620002G, table III
 */
export function readMessage1(body: DataView<ArrayBuffer>): NexradRadial {
  const header = partOf(body, 0, headerLength, 'a header');
  const surveillance = {
    firstGate: header.getInt16(18),
    gateLength: header.getUint16(22),
    gates: header.getUint16(26),
  };
  const doppler = { firstGate: header.getInt16(20), gateLength: header.getUint16(24), gates: header.getUint16(28) };
  const moments = new Map<string, NexradGates>();
  const addMoment = (
    name: string,
    pointerAt: number,
    grid: typeof doppler,
    packing: { scale: number; offset: number },
  ): void => {
    const pointer = header.getUint16(pointerAt);
    if (pointer === 0 || grid.gates === 0) return;
    const { firstGate, gateLength, gates } = grid;
    moments.set(name, {
      firstGate,
      gateLength,
      ...packing,
      bits: 8,
      codes: partOf(body, pointer, gates, `${gates} gates of ${name}`),
    });
  };
  addMoment('REF', 36, surveillance, { scale: 2, offset: 66 });
  // Velocity has steps of half a metre per second, or of one.
  addMoment('VEL', 38, doppler, { scale: header.getUint16(42) === 4 ? 1 : 2, offset: 129 });
  addMoment('SW', 40, doppler, { scale: 2, offset: 129 });
  const elevation = header.getUint16(14) * degreesPerUnit;
  const nyquist = header.getInt16(60) / 100;
  const status = header.getUint16(12);
  const isBad = (status & badStatus) !== 0;
  return checkRadial({
    azimuth: header.getUint16(8) * degreesPerUnit,
    elevation: elevation > 180 ? elevation - 360 : elevation,
    time: timeOf(header.getUint16(4), header.getUint32(0)),
    cut: header.getUint16(16),
    status: status & ~badStatus,
    ...(isBad ? { isBad } : {}),
    moments: isBad ? new Map<string, NexradGates>() : moments,
    ...(nyquist > 0 ? { nyquist } : {}),
  });
}
