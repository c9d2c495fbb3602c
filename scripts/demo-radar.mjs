// Makes the scans of a synthetic weather radar that scans synthetic weather (demo-weather.mjs): 14 elevations of 360 rays of 400 gates,
// as in the paper of 2011, three times, ten minutes apart. These effects of a real radar are simulated:
//   - beams are bent by the standard atmosphere (4/3 Earth) and a degree wide: far away they average over thick layers;
//   - a sweep takes 20 seconds, and the weather moves on between sweeps;
//   - the farther away, the stronger an echo must be to be detected; weaker echoes, and their velocities, become no data;
//   - velocity is the component along the beam, the fall of rain and hail included, and folds at the Nyquist velocity; VRADDH is
//     the same velocity without folding, as from a perfect unfolding program;
//   - both are noisy.
// These are not simulated: attenuation, ground clutter, side lobes, second trips.
import { seededRandom } from './demo-painter.mjs';
import { fallSpeed, weatherAt } from './demo-weather.mjs';

/** As at the radar in Captains Flat (shared data, odim_au40), whose scan is the most similar to that of the paper. */
const elevations = [0.5, 0.9, 1.3, 1.8, 2.4, 3.1, 4.2, 5.6, 7.4, 10, 13.3, 17.9, 23.9, 32];
const [rays, gates, firstGate, gateLength] = [360, 400, 250, 500];
const beamWidth = 1;
const nyquist = 16;
const secondsPerSweep = 20;

/** Start times of the scans: three, ten minutes apart. */
export const scanTimes = ['2011-06-20T15:00:00Z', '2011-06-20T15:10:00Z', '2011-06-20T15:20:00Z'];

/** The weakest echo, in dBZ, that is detected at 1 km; the threshold grows with the square of the range. */
const sensitivity = -36;

/** Parts of a beam: degrees above its middle, and share of the echo (Gaussian, 3 dB width, in both directions). */
const beamParts = [-0.5, -0.25, 0, 0.25, 0.5].map((above) => ({
  above,
  share: 0.5 ** (2 * ((2 * above) / beamWidth) ** 2),
}));

/** A pixel step is half a dBZ; the velocities are spread over the other 255 values. */
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
    moments: [
      { name: 'DBZH', unit: 'dBZ', kind: 'reflectivity' },
      { name: 'VRADH', unit: 'm/s', kind: 'velocity' },
      { name: 'VRADDH', unit: 'm/s', kind: 'velocity' },
    ],
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
        read: (moment) =>
          isMoment(moment) ? { firstGate, gateLength, gates, samples: samples[moment], ...packing[moment] } : null,
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
  const samples = {
    DBZH: new Uint8Array(rays * gates),
    VRADH: new Uint8Array(rays * gates),
    VRADDH: new Uint8Array(rays * gates),
  };
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
 * The signal from a gate: reflectivity over the width of the beam, and velocity away from the radar, weighted by it.
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
    if (z < 0) continue; // Below the horizon there is the ground.
    const reflectivity = weather.reflectivity(x, y, z);
    echo += share * reflectivity;
    if (reflectivity < 1e-3) continue;
    const [u, v, w] = weather.wind(x, y, z);
    // Due to the curved Earth, the beam climbs more steeply over the ground there than at the radar.
    const slope = (elevation * Math.PI) / 180 + Math.hypot(x, y) / standardEarthRadius;
    const away =
      (u * Math.sin(azimuth) + v * Math.cos(azimuth)) * Math.cos(slope) +
      (w - fallSpeed(z, reflectivity)) * Math.sin(slope);
    momentum += share * reflectivity * away;
  }
  return { reflectivity: echo / shares, velocity: momentum / echo };
}

/** Speeds beyond the Nyquist velocity wrap around to the other end. @param {number} velocity */
function fold(velocity) {
  return velocity - 2 * nyquist * Math.round(velocity / (2 * nyquist));
}

/** A pixel from 1 up: 0 means no data. @param {number} value @param {{ slope: number, intercept: number }} scale */
function pack(value, { slope, intercept }) {
  return Math.min(255, Math.max(1, Math.round((value - intercept) / slope)));
}

/** Random numbers around 0 with a standard deviation of 1. Source: Box and Muller 1958 @param {() => number} random */
function normal(random) {
  return Math.sqrt(-2 * Math.log(1 - random())) * Math.cos(2 * Math.PI * random());
}
