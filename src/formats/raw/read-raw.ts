import { axialIndexToWorld, cartesianGrid } from '../../volume/grid.ts';
import { countSampleBytes } from '../base/count-sample-bytes.ts';
import type { DecodedCartesianVolume, DecodeSettings } from '../base/decoded-volume.ts';
import { corruptFile } from '../base/file-problem.ts';
import type { ReadContext } from '../base/format.ts';
import { listLeft } from '../base/list-left.ts';
import { nameOf } from '../base/name-of.ts';
import { numberTypes } from '../base/number-types.ts';
import { placeVolume } from '../base/place-volume.ts';
import { storeSamples, wholeNumbersOf } from '../base/store-samples.ts';
import { isGzip } from '../codecs/gunzip.ts';
import { shareBytes } from '../grid-files/find-data-files.ts';
import { readSamples } from '../grid-files/read-samples.ts';
import type { RawLayout } from './raw-layout.ts';

/**
 * Reads numbers without a header, from one file or from several that hold equal parts; each may be packed with gzip.
 * @param urls - absolute, in their order
 * @throws {VolumeViewError} `format/corrupt` where the files do not hold as many bytes as the layout says
 */
export async function readRaw(
  { type: typeName, endian = 'little', dimensions, offset = 0 }: RawLayout,
  urls: readonly string[],
  settings: DecodeSettings,
  context: ReadContext,
): Promise<DecodedCartesianVolume> {
  const type = numberTypes[typeName];
  const wanted = countSampleBytes('the manifest\'s "raw"', dimensions, type);
  const perFile = shareBytes('the manifest', wanted, type.bytesPerSample, urls);
  const first = await context.fetchFile(urls[0]);
  const isPacked = isGzip(first.bytes) && first.bytes.length !== offset + perFile;
  const size = first.bytes.length;
  if (!isPacked && size < offset + perFile)
    throw corruptFile(
      nameOf(first.url),
      `got ${size.toLocaleString('en')} bytes; the manifest's "raw" asks for ${(offset + perFile).toLocaleString('en')}: check "type", "dimensions" and "offset"`,
    );
  const bytes = await readSamples(
    listFiles(first.bytes, urls, context),
    {
      what: nameOf(first.url),
      type,
      encoding: isPacked ? 'deflate' : 'raw',
      bytesPerFile: perFile,
      skipBytes: isPacked ? 0 : offset,
      skipUnpacked: isPacked ? offset : 0,
    },
    wanted,
    context,
  );
  const {
    samples,
    scale,
    offset: from,
    indexed,
    rounded,
    unkept,
  } = storeSamples(bytes, type, endian === 'little', {
    slope: 1,
    intercept: 0,
    budget: context.budget,
    chooseWhole: await wholeNumbersOf(type),
  });
  const more = size - offset - perFile;
  return placeVolume(
    {
      grid: cartesianGrid(dimensions, axialIndexToWorld(dimensions, [1, 1, 1])),
      samples,
      slope: scale,
      intercept: from,
      indexed,
      rounded,
      unkept,
      unit: '',
      format: `Raw ${type.name}`,
      ...listLeft(
        1,
        !isPacked && more > 0
          ? `${more.toLocaleString('en')} bytes after the samples: if that is not meant, check "type", "dimensions" and "offset" of the manifest's "raw"`
          : null,
      ),
    },
    settings,
  );
}

async function* listFiles(
  first: Uint8Array<ArrayBuffer>,
  urls: readonly string[],
  { fetchFiles }: ReadContext,
): AsyncGenerator<Uint8Array<ArrayBuffer>> {
  yield first;
  for await (const { bytes } of fetchFiles(urls.slice(1))) yield bytes;
}
