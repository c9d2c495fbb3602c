import type { ImageFormat } from '../base/format.ts';
import { startsWith } from '../base/starts-with.ts';

const words = 'a mosaic (.png, .jpg, .webp)';
const beginning = 'the signature of such an image';

export const png: ImageFormat = {
  name: 'PNG',
  words,
  endings: ['png'],
  beginning,
  matches: ({ bytes }) => startsWith(bytes, '\x89PNG\r\n\x1a\n'),
  loadImage: async () => {
    const { readPng } = await import('#rare/formats/images/png.ts');
    return (bytes, { channels, budget }) => readPng(bytes, channels, budget);
  },
};

export const jpeg: ImageFormat = {
  name: 'JPEG',
  words,
  endings: ['jpg', 'jpeg'],
  beginning,
  matches: ({ bytes }) => startsWith(bytes, '\xff\xd8\xff'),
  loadImage: async () => {
    const { readImagePixels } = await import('#rare/formats/images/image-pixels.ts');
    return (bytes, settings) => readImagePixels(bytes, 'image/jpeg', settings);
  },
};

export const webp: ImageFormat = {
  name: 'WebP',
  words,
  endings: ['webp'],
  beginning,
  matches: ({ bytes }) => startsWith(bytes, 'RIFF') && startsWith(bytes.subarray(8), 'WEBP'),
  loadImage: async () => {
    const { readImagePixels } = await import('#rare/formats/images/image-pixels.ts');
    return (bytes, settings) => readImagePixels(bytes, 'image/webp', settings);
  },
};
