// Which uploaded files the plugin for WordPress takes: called by wordpress.mjs, where there is PHP.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { gzipSync } from 'node:zlib';
import { projectRoot } from '../../scripts/shared-data.mjs';
import { check } from './checks.mjs';

const program = join(projectRoot, 'packages/wordpress/tests/check-file.php');
const data = join(projectRoot, 'demos/data');
const html = Buffer.from('<!doctype html><script>alert(1)</script>');

/** NIfTI-1 of 4 × 3 × 2 voxels of 16 bits. @param {(header: Buffer) => void} change */
function nifti(change = () => {}) {
  const file = Buffer.alloc(352 + 48);
  file.writeInt32LE(348, 0);
  [3, 4, 3, 2, 1, 1, 1, 1].forEach((length, i) => file.writeInt16LE(length, 40 + 2 * i));
  file.writeInt16LE(4, 70);
  file.writeInt16LE(16, 72);
  file.writeFloatLE(352, 108);
  file.write('n+1\0', 344, 'latin1');
  change(file);
  return file;
}

/** NIfTI-2 of as many voxels, big-endian. */
function nifti2() {
  const file = Buffer.alloc(544 + 48);
  file.writeInt32BE(540, 0);
  file.write('n+2\0\r\n\x1a\n', 4, 'latin1');
  file.writeInt16BE(16, 14);
  [3, 4, 3, 2, 1, 1, 1, 1].forEach((length, i) => file.writeBigInt64BE(BigInt(length), 16 + 8 * i));
  file.writeBigInt64BE(544n, 168);
  return file;
}

const nrrd = (/** @type {string} */ more) => Buffer.from(`NRRD0004\ntype: uchar\ndimension: 3\n${more}\nx`);
const metaImage = (/** @type {string} */ place) =>
  Buffer.from(`ObjectType = Image\nNDims = 3\nDimSize = 1 1 1\nElementDataFile = ${place}\nx`);

/** @type {[name: string, bytes: Buffer][]} */
const good = [
  ['small.nii', nifti()],
  ['SMALL.NII', nifti()],
  ['big-endian.nii', nifti2()],
  ['small.nii.gz', gzipSync(nifti())],
  ['head.nii.gz', readFileSync(join(data, 'mni152-t1.nii.gz'))],
  ['times.nii', readFileSync(join(data, 'functional.nii'))],
  ['storm.json', readFileSync(join(data, 'storm-radar.json'))],
  ['head.json', readFileSync(join(data, 'mni152-t1.json'))],
  ['scan.nrrd', nrrd('encoding: raw\n')],
  ['scan.mha', metaImage('LOCAL')],
  ['radar.h5', Buffer.from('\x89HDF\r\n\x1a\n and more', 'latin1')],
];

/** Each with a part of what is said of it. @type {[name: string, bytes: Buffer, said: RegExp][]} */
const bad = [
  ...['nii', 'nii.gz', 'nrrd', 'mha', 'h5', 'json'].flatMap((ending) =>
    [html, Buffer.alloc(0), Buffer.from('<?php echo 1;'), Buffer.from('<svg xmlns="http://www.w3.org/2000/svg"/>')].map(
      (bytes) => /** @type {[string, Buffer, RegExp]} */ ([`other.${ending}`, bytes, /does not begin|no manifest/]),
    ),
  ),
  ['page.nii.gz', gzipSync(html), /does not begin/],
  ['not-packed.nii.gz', nifti(), /does not begin/],
  ['packed.nii', gzipSync(nifti()), /does not begin/],
  ['cut.nii', nifti().subarray(0, 380), /shorter/],
  ['head-only.nii.gz', gzipSync(nifti().subarray(0, 200)), /does not begin/],
  ['huge.nii', nifti((file) => file.writeInt16LE(32767, 42)), /shorter/],
  ['minus.nii', nifti((file) => file.writeInt16LE(-4, 42)), /shorter/],
  ['no-axes.nii', nifti((file) => file.writeInt16LE(0, 40)), /does not begin/],
  ['nine-axes.nii', nifti((file) => file.writeInt16LE(9, 40)), /does not begin/],
  ['far.nii', nifti((file) => file.writeFloatLE(1e30, 108)), /shorter/],
  ['nowhere.nii', nifti((file) => file.writeFloatLE(NaN, 108)), /does not begin/],
  ['size.nii', nifti((file) => file.writeInt32LE(349, 0)), /does not begin/],
  ['two-files.nii', nifti((file) => file.write('ni1\0', 344, 'latin1')), /does not begin/],
  ['no-end.nrrd', Buffer.from('NRRD0004\ntype: uchar'), /does not begin/],
  ['other-file.nrrd', nrrd('data file: https://a.example/x.raw\n'), /another file/],
  ['other-file.mha', metaImage('other.raw'), /another file/],
  ['list.mha', metaImage('LIST'), /another file/],
  ['list.json', Buffer.from('["image"]'), /no manifest/],
  ['both.json', Buffer.from('{"image": "a.png", "files": []}'), /no manifest/],
  ['page.json', Buffer.from('"<script>"'), /no manifest/],
  ['deep.json', Buffer.from(`${'{"image":'.repeat(100)}1${'}'.repeat(100)}`), /no manifest/],
  ['long.json', Buffer.from(`{"image": "a.png", "x": "${'x'.repeat(1 << 20)}"}`), /1 MB/],
];

/** Names that are not for the plugin: WordPress alone decides. */
const others = [
  'page.html',
  'a.svg',
  'a.nii.php',
  'a.json.phtml',
  'nii',
  '.nii',
  'a.niix',
  'scan.nrrd\n',
  'scan.dcm',
  'a.gz',
];

/** @param {string} php */
export async function checkUploads(php) {
  const work = mkdtempSync(join(tmpdir(), 'volume-view-uploads-'));
  try {
    /** What is said of files. @param {[name: string, bytes: Buffer, ...rest: unknown[]][]} files @returns {(string | null)[]} */
    const say = (files) => {
      const cases = files.map(([name, bytes], i) => {
        const path = join(work, `file-${i}`);
        writeFileSync(path, bytes);
        return { path, name };
      });
      const { status, stdout, stderr } = spawnSync(php, [program], { input: JSON.stringify(cases), encoding: 'utf8' });
      assert.equal(status, 0, stderr + stdout);
      return JSON.parse(stdout);
    };

    await check('uploads: files are taken whose content is what the name says', () => {
      say(good).forEach((said, i) => assert.equal(said, '', good[i][0]));
      return `${good.length} files`;
    });

    await check('uploads: files are refused whose content is another one, cut off, or elsewhere', () => {
      say(bad).forEach((said, i) => assert.match(String(said), bad[i][2], bad[i][0]));
      return `${bad.length} files`;
    });

    await check('uploads: the plugin adds no other names', () => {
      say(others.map((name) => [name, nifti()])).forEach((said, i) => assert.equal(said, null, others[i]));
    });

    await check('uploads: a damaged header makes no error of PHP', () => {
      let seed = 7;
      const draw = (/** @type {number} */ below) => {
        seed = (seed * 48271) % 2147483647;
        return Math.floor(seed / 7) % below;
      };
      const files = Array.from({ length: 600 }, (_, i) => {
        const [name, bytes] = [good[0], good[2], good[3], good[8], good[9], good[7]][i % 6];
        const damaged = Buffer.from(bytes.subarray(0, draw(2) ? bytes.length : draw(bytes.length + 1)));
        for (let k = 0; k < 4 && damaged.length > 0; k++) damaged[draw(damaged.length)] = draw(256);
        return /** @type {[string, Buffer]} */ ([name, damaged]);
      });
      const said = say(files);
      assert.ok(said.every((one) => typeof one === 'string'));
      return `${said.filter(Boolean).length} of ${files.length} refused`;
    });
  } finally {
    rmSync(work, { recursive: true, force: true });
  }
}
