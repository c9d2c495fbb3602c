// A made-up weather radar that scans made-up weather (demo-weather.mjs): 14 elevations of 360 rays of 400 gates, as in the
// paper of 2011, three times, ten minutes apart. What makes it a radar's picture and no model's:
//   - beams are bent by the standard atmosphere (4/3 Earth) and a degree wide: far away they see thick layers;
//   - a sweep takes 20 seconds, and the weather moves on between sweeps;
//   - the farther, the stronger an echo must be to be seen; what is weaker is no data, and so is its velocity;
//   - velocity is what moves along the beam, the fall of rain and hail included, and folds at the Nyquist velocity; VRADDH is
//     the same as a perfect program would unfold it;
//   - both are noisy.
// It leaves out: attenuation, ground clutter, side lobes, second trips.
import { seededRandom } from './demo-painter.mjs';
import { fallSpeed, weatherAt } from './demo-weather.mjs';

/** As of the radar at Captains Flat (shared data, odim_au40), whose scan is the nearest to the paper's. */
const elevations = [0.5, 0.9, 1.3, 1.8, 2.4, 3.1, 4.2, 5.6, 7.4, 10, 13.3, 17.9, 23.9, 32];
const [rays, gates, firstGate, gateLength] = [360, 400, 250, 500];
const beamWidth = 1;
const nyquist = 16;
const secondsPerSweep = 20;

/** When the scans begin: three, ten minutes apart. */
export const scanTimes = ['2011-06-20T15:00:00Z', '2011-06-20T15:10:00Z', '2011-06-20T15:20:00Z'];

/** dBZ that is just seen at 1 km; the threshold grows with the square of the range. */
const sensitivity = -36;

/** Parts of a beam, degrees above its middle, and how much of the echo is theirs (Gaussian, 3 dB width, there and back). */
const beamParts = [-0.5, -0.25, 0, 0.25, 0.5].map((above) => ({ above, share: 0.5 ** (2 * (2 * above / beamWidth) ** 2) }));

/** Pixels are half a dBZ; the velocities share the other 255 values. */
const packing = {
  DBZH: { slope: 0.5, intercept: -32.5 },
  VRADH: { slope: (2 * nyquist) / 254, intercept: -nyquist - (2 * nyquist) / 254 },
  VRADDH: { slope: 0.5, intercept: -64 },
};

/**
 * @param {number} scan - 0, 1 or 2
 * @param {typeof import('../src/radar/polar-geometry.ts')} geometry
 * @returns {import('../src/formats/radar/radar-file.ts').RadarFile}
 */
export function scanStorm(scan, geometry) {
  const start = Date.parse(scanTimes[scan]);
  const random = seededRandom(1000 + scan);
  return {
    format: 'synthetic radar',
    site: { name: 'Nowhere (synthetic)' },
    time: scanTimes[scan],
    beamWidth,
    moments: [{ name: 'DBZH', unit: 'dBZ', kind: 'reflectivity' }, { name: 'VRADH', unit: 'm/s', kind: 'velocity' }, { name: 'VRADDH', unit: 'm/s', kind: 'velocity' }],
    sweeps: elevations.map((elevation, i) => {
      const seconds = (start - Date.parse(scanTimes[0])) / 1000 + i * secondsPerSweep;
      const samples = sweep(elevation, weatherAt(seconds), { geometry, random });
      return {
        elevation,
        azimuths: Float64Array.from({ length: rays }, (_, ray) => ray + 0.5),
        time: new Date(start + 1000 * i * secondsPerSweep).toISOString().replace('.000Z', 'Z'),
        nyquist,
        moments: Object.keys(packing),
        gridOf: (moment) => (isMoment(moment) ? { firstGate, gateLength, gates } : null),
        read: (moment) => (isMoment(moment) ? { firstGate, gateLength, gates, samples: samples[moment], ...packing[moment] } : null),
      };
    }),
  };
}

/** @param {string} name @returns {name is keyof typeof packing} */
const isMoment = (name) => Object.hasOwn(packing, name);

/**
 * @param {number} elevation - degrees
 * @param {ReturnType<typeof weatherAt>} weather
 * @param {{ geometry: typeof import('../src/radar/polar-geometry.ts'), random: () => number }} tools
 */
function sweep(elevation, weather, { geometry, random }) {
  const samples = { DBZH: new Uint8Array(rays * gates), VRADH: new Uint8Array(rays * gates), VRADDH: new Uint8Array(rays * gates) };
  for (let ray = 0; ray < rays; ray++) {
    for (let gate = 0; gate < gates; gate++) {
      const beam = { range: firstGate + gate * gateLength, azimuth: ray + 0.5, elevation };
      const echo = receive(beam, weather, geometry);
      const dbz = 10 * Math.log10(echo.reflectivity) + 0.6 * normal(random);
      if (!(dbz >= sensitivity + 20 * Math.log10(beam.range / 1000))) continue;
      samples.DBZH[ray * gates + gate] = pack(dbz, packing.DBZH);
      const velocity = echo.velocity + 0.4 * normal(random);
      samples.VRADH[ray * gates + gate] = pack(fold(velocity), packing.VRADH);
      samples.VRADDH[ray * gates + gate] = pack(velocity, packing.VRADDH);
    }
  }
  return samples;
}

/**
 * What comes back from a gate: reflectivity over the beam's width, and velocity away from the radar, weighted by it.
 * @param {{ range: number, azimuth: number, elevation: number }} beam
 * @param {ReturnType<typeof weatherAt>} weather
 * @param {typeof import('../src/radar/polar-geometry.ts')} geometry
 */
function receive(beam, weather, { beamToLocal, standardEarthRadius }) {
  let [echo, shares, momentum] = [0, 0, 0];
  const azimuth = (beam.azimuth * Math.PI) / 180;
  for (const { above, share } of beamParts) {
    const elevation = beam.elevation + above;
    const [x, y, z] = beamToLocal({ ...beam, elevation }, standardEarthRadius);
    shares += share;
    if (z < 0) continue; // Below the horizon is the ground.
    const reflectivity = weather.reflectivity(x, y, z);
    echo += share * reflectivity;
    if (reflectivity < 1e-3) continue;
    const [u, v, w] = weather.wind(x, y, z);
    // The horizon turns away along the ground, so the beam climbs more steeply there than here.
    const slope = (elevation * Math.PI) / 180 + Math.hypot(x, y) / standardEarthRadius;
    const away = (u * Math.sin(azimuth) + v * Math.cos(azimuth)) * Math.cos(slope) + (w - fallSpeed(z, reflectivity)) * Math.sin(slope);
    momentum += share * reflectivity * away;
  }
  return { reflectivity: echo / shares, velocity: momentum / echo };
}

/** Speeds beyond the Nyquist velocity come out at the other end. @param {number} velocity */
function fold(velocity) {
  return velocity - 2 * nyquist * Math.round(velocity / (2 * nyquist));
}

/** A pixel from 1 up: 0 is no data. @param {number} value @param {{ slope: number, intercept: number }} scale */
function pack(value, { slope, intercept }) {
  return Math.min(255, Math.max(1, Math.round((value - intercept) / slope)));
}

/** Numbers around 0 with a deviation of 1. Source: Box and Muller 1958 @param {() => number} random */
function normal(random) {
  return Math.sqrt(-2 * Math.log(1 - random())) * Math.cos(2 * Math.PI * random());
}
