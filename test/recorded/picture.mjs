// Pictures as this program keeps them: their hashes, their files, and how two of them differ.
import { createHash } from 'node:crypto';
import { decode, encode } from 'fast-png';

/**
 * @typedef {object} Picture
 * @property {string} name
 * @property {string} family - pictures of one family may be the same, as the same scene in WebGL 1 and 2 is
 * @property {number} width
 * @property {number} height
 * @property {'bytes' | 'floats'} kind - RGBA, premultiplied, top row first in bytes; a probe's floats as they were drawn
 * @property {Uint8Array} data
 */

/** @param {Picture} picture */
export const hashOf = ({ data }) => createHash('sha256').update(data).digest('hex');

/**
 * RGBA with colours times opacity, as canvases hold it: nothing is lost from one form to the other.
 * @param {Uint8Array} png - 8 bits, with or without opacity
 * @returns {{ width: number, height: number, data: Uint8Array }}
 */
export function readPng(png) {
  const { width, height, channels, depth, data: samples } = decode(png);
  if (depth !== 8 || (channels !== 3 && channels !== 4))
    throw new Error(`a picture got ${channels} channels of ${depth} bits; expected 3 or 4 of 8 bits`);
  const data = new Uint8Array(width * height * 4);
  for (let pixel = 0; pixel < width * height; pixel++) {
    const alpha = channels === 4 ? samples[pixel * 4 + 3] : 255;
    for (let c = 0; c < 3; c++) data[pixel * 4 + c] = Math.round((samples[pixel * channels + c] * alpha) / 255);
    data[pixel * 4 + 3] = alpha;
  }
  return { width, height, data };
}

/** @param {string} name */
export const fileName = (name) => name.toLowerCase().replace(/[^a-z0-9.]+/g, '-');

/**
 * A picture's file: a PNG of the colours on black, with the opacity in gray below; floats as they are.
 * @param {Picture} picture
 * @returns {{ file: string, bytes: Uint8Array }}
 */
export function toFile({ name, kind, width, height, data }) {
  if (kind === 'floats') return { file: `${fileName(name)}.f32`, bytes: data };
  const rgb = new Uint8Array(width * height * 2 * 3);
  for (let pixel = 0; pixel < width * height; pixel++) {
    rgb.set(data.subarray(pixel * 4, pixel * 4 + 3), pixel * 3);
    rgb.fill(data[pixel * 4 + 3], (width * height + pixel) * 3, (width * height + pixel + 1) * 3);
  }
  return {
    file: `${fileName(name)}.png`,
    bytes: encode({ width, height: 2 * height, channels: 3, depth: 8, data: rgb }),
  };
}

/**
 * @param {Uint8Array} bytes - of a file that `toFile` wrote
 * @param {'bytes' | 'floats'} kind
 * @returns {Uint8Array} the picture's data
 */
export function fromFile(bytes, kind) {
  if (kind === 'floats') return bytes;
  const { width, height, data: rgb } = decode(bytes);
  const pixels = (width * height) / 2;
  const data = new Uint8Array(pixels * 4);
  for (let pixel = 0; pixel < pixels; pixel++) {
    for (let c = 0; c < 3; c++) data[pixel * 4 + c] = rgb[pixel * 3 + c];
    data[pixel * 4 + 3] = rgb[(pixels + pixel) * 3];
  }
  return data;
}

/**
 * Numbers of a picture, 0..255.
 * @param {Uint8Array} data
 * @param {'bytes' | 'floats'} kind
 * @returns {ArrayLike<number>}
 */
function numbersOf(data, kind) {
  if (kind === 'bytes') return data;
  return new Float32Array(Uint8Array.from(data).buffer).map((x) => x * 255);
}

/**
 * How two pictures differ, in 1/255 of the colours times opacity and the opacity; Infinity where sizes do.
 * @param {Uint8Array} a
 * @param {Uint8Array} b
 * @param {'bytes' | 'floats'} kind
 */
export function difference(a, b, kind) {
  if (a.length !== b.length) return { max: Infinity, rms: Infinity, share: 1 };
  const [x, y] = [numbersOf(a, kind), numbersOf(b, kind)];
  let [max, sum, count] = [0, 0, 0];
  for (let i = 0; i < x.length; i++) {
    const d = Math.abs(x[i] - y[i]);
    max = Math.max(max, d);
    sum += d * d;
    if (d !== 0) count++;
  }
  return { max, rms: Math.sqrt(sum / x.length), share: count / x.length };
}

/** Of the pixels, the share that has to differ from the most frequent one. */
const minShown = 0.01;

/**
 * @param {Picture} picture
 * @returns {boolean} whether (nearly) all of its pixels are the same, or one is no number
 */
export function isBlank({ data, kind }) {
  const numbers = numbersOf(data, kind);
  /** @type {Map<string, number>} */
  const counts = new Map();
  for (let i = 0; i < numbers.length; i += 4) {
    const pixel = [0, 1, 2, 3].map((c) => numbers[i + c]).join(' ');
    if (pixel.includes('NaN')) return true;
    counts.set(pixel, (counts.get(pixel) ?? 0) + 1);
  }
  return Math.max(...counts.values()) > (1 - minShown) * (numbers.length / 4);
}

/**
 * @param {readonly Picture[]} pictures
 * @returns {string[]} what is wrong with them: blank, the same as one of another family, or in the same file
 */
export function findFaults(pictures) {
  /** @type {Map<string, Picture>} */
  const seen = new Map();
  /** @type {Set<string>} */
  const files = new Set();
  return pictures.flatMap((picture) => {
    const faults = isBlank(picture) ? [`${picture.name}: the picture is blank`] : [];
    const hash = hashOf(picture);
    const twin = seen.get(hash);
    if (twin && twin.family !== picture.family)
      faults.push(`${picture.name}: the same picture as that of ${twin.name}`);
    if (!twin) seen.set(hash, picture);
    if (files.has(fileName(picture.name))) faults.push(`${picture.name}: another picture has the same file`);
    files.add(fileName(picture.name));
    return faults;
  });
}
