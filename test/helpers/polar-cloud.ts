import { orbitCamera } from '../../src/optics/rays/camera.ts';
import type { TransferFunction } from '../../src/optics/transfer/transfer-function.ts';
import { beamToLocal } from '../../src/radar/polar-geometry.ts';
import type { Vector3 } from '../../src/volume/matrix.ts';
import type { PolarVolume } from '../../src/volume/volume.ts';
import { evenAzimuths, radarVolume } from './synthetic-radar.ts';

const reach = 40_000;

/** A cloud that ends far inside of the radar's range: at the end of data, pictures converge only with first order. */
const center: Vector3 = beamToLocal({ range: 20_000, azimuth: 70, elevation: 28 }, Infinity);

/** The density of the cloud, 0..1. @param place - metres east, north and up of the radar */
export const cloudField = ([x, y, z]: Vector3): number =>
  Math.exp(-((x - center[0]) ** 2 + (y - center[1]) ** 2 + 2 * (z - center[2]) ** 2) / 6000 ** 2);

/** A transfer function without visible kinks. */
export const cloudColors: TransferFunction = Array.from({ length: 129 }, (_, i) => {
  const value = i / 128;
  return { value, color: [value, 0.5, 1 - value], opacity: 0.5 * value * value };
});

/** A camera outside of the box, which looks at the cloud. */
export const cloudCamera = orbitCamera({ theta: 0.5, phi: 1.2, radius: 150_000 }, center, 0.16);

/** The cloud as a radar sees it. @param fineness - 1: 12 sweeps, 40 radials, 20 gates */
export function cloudVolume(fineness: number): PolarVolume {
  const [sweeps, rays, gates] = [12, 40, 20].map((n) => Math.round(n * fineness));
  const gateLength = reach / gates;
  const firstGate = gateLength / 2;
  return radarVolume(
    {
      beamWidth: 1,
      sweeps: Array.from({ length: sweeps }, (_, i) => {
        const elevation = (i / (sweeps - 1)) * 60;
        return {
          elevation,
          azimuths: evenAzimuths(rays),
          gates,
          gateLength,
          firstGate,
          kind: 'float32',
          slope: 1,
          intercept: 0,
          stored: (azimuth, gate) =>
            cloudField(beamToLocal({ range: firstGate + gate * gateLength, azimuth, elevation }, Infinity)),
        };
      }),
    },
    { beamModel: 'straight', verticalExaggeration: 1 },
  );
}
