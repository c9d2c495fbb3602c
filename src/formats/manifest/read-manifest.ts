import { isPolar } from '../../volume/volume.ts';
import { VolumeViewError } from '../../core/errors.ts';
import { checkFileCount } from '../base/check-file-count.ts';
import { chooseScan } from '../base/choose-scan.ts';
import { isRadar } from '../base/decoded-volume.ts';
import type { DecodedVolume, DecodeSettings } from '../base/decoded-volume.ts';
import type { FormatReader, ReadContext } from '../base/format.ts';
import { loadReader } from '../base/load-reader.ts';
import { readManifest } from './manifest.ts';
import type { Manifest } from './manifest.ts';
import { applyPrepared } from './manifest-prepared.ts';
import type { RawLayout } from '../raw/raw-layout.ts';
import { nameOf } from '../base/name-of.ts';
import { describeVolume, mergeSettings, resolveFile } from './use-manifest.ts';

/** Memory per character while a manifest is parsed: in `[[],[],` every three characters make a list. */
const bytesPerCharacter = 32;

/**
 * Reads a manifest and the files that it names. Its fields are used where the attributes, which are `settings`, set
 * nothing.
 */
export const readManifestVolume: FormatReader = async (input, settings, context) => {
  if (context.isPart) {
    throw new VolumeViewError(
      'manifest/invalid',
      `the manifest's "image" got another manifest, ${nameOf(input.url)}; expected an image or a NIfTI file`,
    );
  }
  // Objects and lists of JSON take a few tens of bytes for each character.
  context.budget.take(input.bytes.length * bytesPerCharacter, 'the manifest');
  const { scans, ...single } = readManifest(input.bytes);
  context.budget.giveBack(input.bytes.length * bytesPerCharacter);
  if (single.video !== undefined) {
    const { openFrames } = await loadReader(() => import('./read-frames.ts'));
    return openFrames(scans ?? single, input.url, settings, context);
  }
  if (scans) context.onScans?.(scans.map(({ time }) => time));
  const manifest = scans
    ? scans[
        chooseScan(
          scans.map(({ time }) => time),
          settings.scan ?? { index: 0 },
        ).index
      ]
    : single;
  const urls = resolveFiles(manifest, input.url);
  const merged = mergeSettings(settings, manifest);
  if (isRadar(merged)) context.onRadar?.();
  const volume = manifest.raw
    ? await readRawFiles(manifest.raw, urls, merged, context)
    : await context.decode(
        await context.fetchFile(urls[0]),
        manifest.files && urls,
        merged,
        openDescribed(context, manifest),
      );
  // The reader of a radar's mosaic has applied slope and intercept already.
  const described = describeVolume(volume, isPolar(volume) ? { ...manifest, slope: 1, intercept: 0 } : manifest);
  return applyPrepared(described, manifest, context.budget);
};

async function readRawFiles(
  raw: RawLayout,
  urls: readonly string[],
  settings: DecodeSettings,
  context: ReadContext,
): Promise<DecodedVolume> {
  if (isRadar(settings))
    throw new VolumeViewError(
      'manifest/invalid',
      'the manifest\'s "raw" got the numbers of a radar, with "elevations"; expected a mosaic image there, or none of the radar\'s fields',
    );
  return (await loadReader(() => import('../raw/read-raw.ts'))).readRaw(raw, urls, settings, context);
}

function resolveFiles({ image, files }: Manifest, base: string): string[] {
  if (!files) return [resolveFile('image', image ?? '', base)];
  checkFileCount('the manifest\'s "files"', files.length);
  return files.map((file) => resolveFile('files', file, base));
}

/** A part of the data looks as the whole will. */
function openDescribed({ openList }: ReadContext, manifest: Manifest): ReadContext['openList'] {
  return (
    openList &&
    (async (first, urls) => {
      const folder = await openList(first, urls);
      return {
        readStart: (url, bytes) => folder.readStart(url, bytes),
        readWhole: (url) => folder.readWhole(url),
        sourceOf: (url) => folder.sourceOf(url),
        plan: (order) => folder.plan(order),
        parts: folder.parts,
        expect: (expected, bytes) => folder.expect(expected, bytes),
        showPart: (part, grid) => folder.showPart(describeVolume(part, manifest), grid),
      };
    })
  );
}
