// Images of strangers: what they may ask for, and what they get.
import { expect } from '@esm-bundle/chai';
import { zlibSync } from 'fflate';
import { decode } from 'fast-png';
import type { VolumeViewError } from '../../../../src/core/errors.ts';
import { Budget } from '../../../../src/formats/base/budget.ts';
import { readImagePixels } from '../../../../src/formats/images/image-pixels.ts';
import { readImageSize } from '../../../../src/formats/images/image-size.ts';
import { joinSlices } from '../../../../src/formats/images/join-slices.ts';
import type { Slice } from '../../../../src/formats/images/join-slices.ts';
import { readPng } from '../../../../src/formats/images/png.ts';
import { watchAllocations } from '../../../helpers/allocations.ts';
import { decodeBytes, expectError, fetchFixture } from '../../../helpers/decode.ts';
import { grayPng, pngBytes, pngHeader } from '../../../helpers/png-bytes.ts';
import type { PngChunk } from '../../../helpers/png-bytes.ts';
import { randomNumbers } from '../../../helpers/synthetic.ts';

const mosaic = { columns: 1, rows: 1 };
const refuse = async (bytes: Uint8Array<ArrayBuffer>): Promise<VolumeViewError> =>
  expectError(decodeBytes(bytes, 'a.png', { mosaic }));
const zeros = (length: number): Uint8Array<ArrayBuffer> => zlibSync(new Uint8Array(length), { level: 9 });

describe('a PNG of a stranger', () => {
  it('of one pixel makes no more of its data than that pixel', async () => {
    const bomb = pngBytes([pngHeader(1, 1), ['IDAT', zeros(2 ** 25)]]);
    const { sum, error } = await watchAllocations(() => readPng(bomb));
    expect(error).to.equal(null);
    expect(sum).to.be.lessThan(2 ** 17);
  });

  it('has its profile left alone, and other parts that nobody needs', async () => {
    const profile: PngChunk = ['iCCP', Uint8Array.of(0x61, 0, 0, 1, 2, 3, 4, 5, 6)];
    const parts: PngChunk[] = [
      profile,
      ['tEXt', new Uint8Array(9)],
      ['zTXt', new Uint8Array(3)],
      ['tRNS', new Uint8Array(1)],
      ['pHYs', new Uint8Array(2)],
    ];
    for (const part of parts)
      expect(Array.from((await readPng(grayPng(2, 2, [part]))).data), part[0]).to.deep.equal([0, 0, 0, 0]);
  });

  it('of 100 million pixels in one row or column is refused by its header', async () => {
    for (const [width, height] of [
      [1, 1e8],
      [1e8, 1],
    ]) {
      const error = await refuse(pngBytes([pngHeader(width, height), ['IDAT', zeros(1000)]]));
      expect(error.code).to.equal('format/too-large');
      expect(error.message).to.contain('on each edge');
    }
  });

  const palette: PngChunk = ['PLTE', new Uint8Array(6)];
  const refused: [what: string, chunks: PngChunk[], said: string][] = [
    ['a second header', [pngHeader(2, 2), pngHeader(4000, 4000), ['IDAT', zeros(2 ** 24)]], 'two headers'],
    ['a part that must be known', [pngHeader(2, 2), ['ABCD', new Uint8Array(3)], ['IDAT', zeros(6)]], '"ABCD"'],
    [
      'something before its header',
      [['tEXt', new Uint8Array(13)], pngHeader(2, 2), ['IDAT', zeros(6)]],
      'does not begin with its header',
    ],
    ['two palettes', [pngHeader(2, 2, { colorType: 3 }), palette, palette, ['IDAT', zeros(6)]], 'two palettes'],
    [
      'a palette of thousands',
      [pngHeader(2, 2, { colorType: 3 }), ['PLTE', new Uint8Array(3 * 4000)], ['IDAT', zeros(6)]],
      'a palette of 12000 bytes',
    ],
    ['colours of 4 bits', [pngHeader(2, 2, { colorType: 2, depth: 4 }), ['IDAT', zeros(6)]], 'which no PNG has'],
    ['no data', [pngHeader(2, 2)], 'is damaged'],
    ['data that end early', [pngHeader(2, 2), ['IDAT', zeros(5)]], 'ends early'],
  ];
  for (const [what, chunks, said] of refused) {
    it(`with ${what} is refused`, async () => {
      const error = await refuse(pngBytes(chunks));
      expect(error.code).to.equal('format/corrupt');
      expect(error.message).to.contain(said);
    });
  }

  it('asks for no more memory than a file of its size may', async () => {
    // 100 megapixels of colours in 400 bytes, which hold none of them.
    const error = await refuse(pngBytes([pngHeader(10_000, 10_000, { colorType: 2 }), ['IDAT', zeros(2 ** 16)]]));
    expect(error.code).to.equal('format/too-large');
    expect(error.message).to.contain('the PNG asks for').and.contain('is allowed');
  });

  it('of thousands of parts with a byte each is read', async () => {
    const packed = zeros(101 * 100);
    const parts = Array.from(packed, (byte): PngChunk => ['IDAT', Uint8Array.of(byte)]);
    expect(
      (
        await readPng(
          pngBytes([
            pngHeader(100, 100),
            ...parts,
            ...Array.from({ length: 3000 }, (): PngChunk => ['IDAT', new Uint8Array(1)]),
          ]),
        )
      ).data.length,
    ).to.equal(10_000);
  });
});

describe('our rows of a PNG', () => {
  const combinations = [
    [0, 8],
    [0, 16],
    [2, 8],
    [2, 16],
    [4, 8],
    [4, 16],
    [6, 8],
    [6, 16],
  ] as const;
  const channels = new Map([
    [0, 1],
    [2, 3],
    [4, 2],
    [6, 4],
  ]);
  const sizes = [
    [1, 1],
    [13, 7],
    [3, 9],
    [8, 8],
    [17, 2],
  ] as const;

  for (const interlace of [0, 1]) {
    it(`are those of fast-png, with every filter${interlace ? ', interlaced' : ''}`, async () => {
      const random = randomNumbers(11);
      for (const [colorType, depth] of combinations) {
        for (const [width, height] of sizes) {
          const bytes = noise({ width, height, pixel: (channels.get(colorType)! * depth) / 8, interlace }, random);
          const png = pngBytes([pngHeader(width, height, { depth, colorType, interlace }), ['IDAT', zlibSync(bytes)]]);
          const { data } = decode(png);
          const step = channels.get(colorType)!;
          const red = Array.from({ length: width * height }, (_, i) => data[i * step]);
          const grays = Array.from({ length: width * height }, (_, i) =>
            luma(step < 3 ? [red[i], red[i], red[i]] : [red[i], data[i * step + 1], data[i * step + 2]]),
          );
          expect(Array.from((await readPng(png)).data), `${colorType} ${depth} ${width}x${height}`).to.deep.equal(
            grays,
          );
        }
      }
    });
  }

  const luma = ([r, g, b]: number[]): number =>
    r === g && g === b ? r : Math.floor(0.2126 * r + 0.7152 * g + 0.0722 * b + 0.5);

  /** Rows of random bytes, each with a random filter. */
  function noise(
    { width, height, pixel, interlace }: { width: number; height: number; pixel: number; interlace: number },
    random: () => number,
  ): Uint8Array {
    const passes = interlace
      ? [
          [0, 0, 8, 8],
          [4, 0, 8, 8],
          [0, 4, 4, 8],
          [2, 0, 4, 4],
          [0, 2, 2, 4],
          [1, 0, 2, 2],
          [0, 1, 1, 2],
        ]
      : [[0, 0, 1, 1]];
    const rows: number[] = [];
    for (const [x, y, xStep, yStep] of passes) {
      const columns = Math.ceil((width - x) / xStep);
      if (columns < 1) continue;
      for (let row = y; row < height; row += yStep) {
        rows.push(
          Math.floor(random() * 5),
          ...Array.from({ length: columns * pixel }, () => Math.floor(random() * 256)),
        );
      }
    }
    return Uint8Array.from(rows);
  }
});

describe('a JPEG or a WebP of a stranger', () => {
  const budget = (): Budget => Budget.ofFile(1000);

  it('says its size before anybody decodes it', async () => {
    expect(readImageSize(await fetchFixture('mosaic/flat-3x2.jpg'), 'image/jpeg')).to.deep.equal({
      width: 96,
      height: 64,
    });
    expect(readImageSize(await fetchFixture('mosaic/flat-3x2.webp'), 'image/webp')).to.deep.equal({
      width: 96,
      height: 64,
    });
    expect(readImageSize(await fetchFixture('mosaic/lossless-3x2.webp'), 'image/webp')).to.deep.equal({
      width: 12,
      height: 8,
    });
    const extended = new Uint8Array(30);
    extended.set([
      0x52, 0x49, 0x46, 0x46, 0, 0, 0, 0, 0x57, 0x45, 0x42, 0x50, 0x56, 0x50, 0x38, 0x58, 10, 0, 0, 0, 0, 0, 0, 0, 0xff,
      0x03, 0, 0x0f, 0x27, 0,
    ]);
    expect(readImageSize(extended, 'image/webp')).to.deep.equal({ width: 1024, height: 10_000 });
  });

  async function huge(path: string, edge: number): Promise<Uint8Array<ArrayBuffer>> {
    const bytes = await fetchFixture(path);
    const view = new DataView(bytes.buffer);
    if (path.endsWith('jpg')) {
      const at = bytes.findIndex((byte, i) => byte === 0xff && (bytes[i + 1] === 0xc0 || bytes[i + 1] === 0xc2));
      view.setUint16(at + 5, edge);
      view.setUint16(at + 7, edge);
    } else if (path.includes('lossless')) view.setUint32(21, (edge - 1) | ((edge - 1) << 14), true);
    else {
      view.setUint16(26, edge, true);
      view.setUint16(28, edge, true);
    }
    return bytes;
  }

  for (const [path, type] of [
    ['mosaic/flat-3x2.jpg', 'image/jpeg'],
    ['mosaic/flat-3x2.webp', 'image/webp'],
    ['mosaic/lossless-3x2.webp', 'image/webp'],
  ] as const) {
    it(`${path}: what it asks for is paid before the browser is asked`, async () => {
      const bytes = await huge(path, 12_000);
      const own = globalThis.createImageBitmap;
      let asked = 0;
      globalThis.createImageBitmap = ((...given: Parameters<typeof own>) => (asked++, own(...given))) as typeof own;
      try {
        const error = await expectError(readImagePixels(bytes, type, { budget: budget() }));
        expect(error.code).to.equal('format/too-large');
        expect(asked).to.equal(0);
      } finally {
        globalThis.createImageBitmap = own;
      }
    });
  }

  it('of more pixels than a texture has is refused, and one that says no size', async () => {
    const large = await expectError(
      readImagePixels(await huge('mosaic/flat-3x2.jpg', 65_000), 'image/jpeg', { budget: budget() }),
    );
    expect(large.message).to.contain('65000 x 65000 pixels');
    for (const edge of [0])
      expect(
        (
          await expectError(
            readImagePixels(await huge('mosaic/flat-3x2.jpg', edge), 'image/jpeg', { budget: budget() }),
          )
        ).code,
      ).to.equal('format/corrupt');
    const none = new Uint8Array(2 ** 16).fill(0xff);
    expect((await expectError(readImagePixels(none, 'image/jpeg', { budget: budget() }))).message).to.contain(
      'no size',
    );
  });

  it('gives back what the browser held', async () => {
    const own = budget();
    const before = own.leftBytes;
    const { data } = await readImagePixels(await fetchFixture('mosaic/flat-3x2.jpg'), 'image/jpeg', { budget: own });
    expect(before - own.leftBytes).to.equal(data.byteLength);
  });
});

describe('a stack of a stranger', () => {
  async function* slices(count: number, ended: Error | null): AsyncGenerator<Slice> {
    for (let i = 0; i < count; i++)
      yield { name: `${i}.png`, image: { width: 100, height: 100, data: new Uint8Array(10_000).fill(i + 1) } };
    if (ended) throw ended;
  }

  it('takes no room for thousands of slices when one has come', async () => {
    const budget = new Budget();
    budget.take(10_000, 'the first slice');
    const { largest, error } = await watchAllocations(() => joinSlices(slices(1, new Error('gone')), 8192, budget));
    expect(String(error)).to.contain('gone');
    expect(largest).to.be.at.most(10_000);
  });

  it('is joined when its files have come, whatever the first one allowed', async () => {
    const budget = new Budget();
    budget.take(2 ** 26 - 200_000, 'all else');
    async function* growing(): AsyncGenerator<Slice> {
      for await (const slice of slices(100, null)) {
        budget.addFile(100);
        budget.take(10_000, slice.name);
        yield slice;
      }
    }
    const { data } = await joinSlices(growing(), 100, budget);
    expect(Array.from({ length: 100 }, (_, i) => data[i * 10_000 + 9_999])).to.deep.equal(
      Array.from({ length: 100 }, (_, i) => i + 1),
    );
    expect(budget.leftBytes).to.equal(budget.allowedBytes - (2 ** 26 - 200_000) - data.length);
  });

  it('or a mosaic is not cut into millions of rows', async () => {
    const bytes = grayPng(4096, 4096);
    const error = await expectError(decodeBytes(bytes, 'a.png', { mosaic: { columns: 4096, rows: 1 } }));
    expect(error.code).to.equal('format/too-large');
    const line = await expectError(decodeBytes(grayPng(4096, 1024), 'a.png', { mosaic: { columns: 4096, rows: 512 } }));
    expect(line.message).to.contain('1,048,576 along each axis');
  });
});
