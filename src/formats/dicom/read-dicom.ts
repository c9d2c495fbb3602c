import { corruptFile } from '../base/file-problem.ts';
import type { FormatReader } from '../base/format.ts';
import { loadReader } from '../base/load-reader.ts';
import { placeVolume } from '../base/place-volume.ts';
import { minSlices } from './coarse-part.ts';
import { describeSeries } from './describe-series.ts';
import { chooseFrames } from './group-frames.ts';
import { joinFrames } from './join-frames.ts';
import { joinPhases, listUrls } from './join-phases.ts';
import { nameAll, readFrames } from './read-frames.ts';

/** Of few files the starts are read first where each has so many bytes: it has several frames, mostly, of which few may be needed. */
const manyBytes = 2 ** 20;

/**
 * Reads the files of a DICOM series as one volume. Nothing of a file leaves this module but its values with their unit,
 * their place, their kind (such as CT) and their window: no name, no number of a patient, no date. Messages say 'file 12
 * of 300', because names of files may be those of patients.
 */
export const readDicom: FormatReader = async (input, settings, given) => {
  const urls = [input.url, ...given.further];
  const files = urls.length;
  try {
    // Of a list that is read at once, files are fetched but once.
    const isLong = files >= minSlices || (files > 1 && input.bytes.length >= manyBytes);
    const folder = given.folder ?? (isLong ? await given.openList?.(input, urls) : undefined);
    const context = { ...given, folder };
    const { frames, left, labels } = await readFrames(input, context, files);
    if (labels) {
      const { readLabels } = await loadReader(() => import('./read-labels.ts'));
      return placeVolume(await readLabels(labels, context), settings);
    }
    const chosen = chooseFrames(frames, context.budget, { wanted: settings.series, before: context.before });
    const phases = settings.scan && !context.isPart ? chosen.phases : undefined;
    folder?.expect(listUrls(phases ? phases.frames.flat() : chosen.frames));
    const series = chosen.series.length > 1 || context.before ? await describeSeries(chosen, context) : undefined;
    const scans = phases && (await joinPhases({ ...phases, left: [...left, ...phases.left] }, settings, context));
    const volume =
      scans ?? (await joinFrames({ frames: chosen.frames, left: [...left, ...chosen.left] }, settings, context));
    return { ...volume, series };
  } catch (cause) {
    // The usual words for such an error have the name of the file.
    if (!(cause instanceof RangeError || cause instanceof TypeError)) throw cause;
    throw corruptFile(nameAll(files), `can not be decoded (${cause.message}): damaged, or too large for this browser`);
  }
};
