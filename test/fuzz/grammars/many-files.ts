import { zipSync } from 'fflate';
import { ctSlice, dicomBytes } from '../../helpers/dicom-bytes.ts';
import { damage } from '../fuzz-case.ts';
import type { FilesCase, FuzzFile, Grammar } from '../fuzz-case.ts';
import type { Random } from '../random.ts';
import { dicom, dicomFolder } from './dicom.ts';
import { nrrd } from './grid-files.ts';
import { manifest } from './manifest.ts';
import { nifti } from './nifti.ts';
import { png } from './png.ts';
import { tiff } from './tiff.ts';
import { zarr } from './zarr.ts';

const filesOf = (random: Random, grammar: Grammar): readonly FuzzFile[] => (grammar(random) as FilesCase).files;

const under = (folder: string, files: readonly FuzzFile[]): FuzzFile[] =>
  files.map(({ name, bytes }) => ({ name: folder + name, bytes }));

/** A folder with volumes of several formats, and archives of them, also in each other. */
export const mixture: Grammar = (random) => {
  const files = writeParts(random, random.int(1, 3));
  for (let n = random.int(0, 2); n > 0; n--) files.push(archiveOf(random, writeParts(random, random.int(1, 2)), n));
  const given = random.chance(0.3) ? [archiveOf(random, files, 9)] : files;
  return {
    folder: true,
    files: given,
    ...(random.chance(0.5) && { settings: { series: random.int(1, 5) } }),
  };
};

function writeParts(random: Random, count: number): FuzzFile[] {
  const kinds = [nifti, nrrd, tiff, png, dicom, dicomFolder, zarr, manifest] as const;
  return Array.from({ length: count }, (_, i) => {
    const kind = random.isSound && i > 0 ? nifti : random.pick(kinds);
    const folder = kind === zarr ? `${i}.zarr/` : random.or('', `part ${i}/`);
    return under(folder, filesOf(random, kind));
  }).flat();
}

/** @param depth - by which archives have other names */
function archiveOf(random: Random, files: readonly FuzzFile[], depth: number): FuzzFile {
  const archive = random.chance(0.2) && depth < 9 ? [archiveOf(random, files, depth + 4)] : files;
  const packed = zipSync(Object.fromEntries(archive.map(({ name, bytes }) => [name, bytes])), {
    level: random.pick([0, 6] as const),
    mtime: '2001-01-01',
  });
  return {
    name: random.or(`${depth}.zip`, `${depth}.ozx`, `${depth}`),
    bytes: damage(random, packed.slice()),
  };
}

/** A series of several times, in a folder or in an archive, of which each is shown. */
export const dicomTimes: Grammar = (random) => {
  const [times, slices] = [random.int(2, 4), random.int(1, 4)];
  const files = Array.from({ length: times * slices }, (_, i): FuzzFile => {
    const [t, k] = [Math.floor(i / slices), i % slices];
    const fields = ctSlice(
      random.number(5 * k),
      {
        TriggerTime: String(random.number(100 * t)),
        InstanceNumber: String(random.size(i)),
        RescaleSlope: String(random.number(1 + t)),
        ...(random.isWild() && { Rows: [random.size(3) & 0xffff] }),
      },
      t,
    );
    return { name: `${i}.dcm`, bytes: damage(random, dicomBytes(fields, { isDeflated: random.chance(0.1) })) };
  });
  const given = random.chance(0.6) ? [archiveOf(random, files, 9)] : files;
  return { folder: true, times: true, files: given };
};

/** A list of files on a server that may not send parts, hides how long files are, lies about it, breaks off, or lacks some. */
export const serverList: Grammar = (random) => {
  const count = random.chance(0.7) ? random.int(32, 36) : random.int(2, 6);
  const files = Array.from({ length: count }, (_, k): FuzzFile => ({
    name: `${k}.dcm`,
    bytes: damage(random, dicomBytes(ctSlice(random.number(5 * k), {}, k))),
  }));
  const odd = random.chance(0.2) ? filesOf(random, random.pick([dicom, nifti])) : [];
  const all = [...files, ...under('other ', odd)];
  return {
    files: all,
    stack: true,
    server: {
      sendsParts: random.chance(0.7),
      hidesSizes: random.chance(0.3),
      liesBy: random.isWild() ? random.int(-100, 100) : 0,
      lacks: random.isWild() ? random.int(0, all.length - 1) : null,
      cuts: random.isWild() ? random.int(0, all.length - 1) : null,
    },
  };
};
