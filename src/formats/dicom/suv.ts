// Standardized uptake values of PET: how many times as much of the tracer is in a place as if all of it were spread evenly over the body.
import type { DataSet } from './data-set.ts';
import { wholeSecondsOf } from './date-time.ts';
import { sequences, tags } from './tags.ts';

const secondsPerDay = 86_400;

/**
 * The factor from Bq/ml to SUV by body weight, in g/ml; null where the file does not say all that it needs.
 * Source: QIBA Profile FDG-PET/CT, appendix G (vendor-neutral pseudo-code); PS3.3, C.8.9.1 and C.8.9.2
 */
export function findSuvFactor(set: DataSet): number | null {
  const corrected = set.texts(tags.correctedImage).map((one) => one.toUpperCase());
  const [dose] = set.items(sequences.radiopharmaceutical) as readonly (DataSet | undefined)[];
  const [weight, injected] = [set.number(tags.patientWeight) ?? 0, dose?.number(tags.totalDose) ?? 0];
  const isCorrected = corrected.includes('ATTN') && corrected.includes('DECY');
  if (!dose || !isCorrected || !(weight > 0 && injected > 0)) return null;
  const left = findShareLeft(set, dose);
  return left === null ? null : (1000 * weight) / (injected * left);
}

/** The share of the tracer that has not decayed at the time to which the values are corrected. */
function findShareLeft(set: DataSet, dose: DataSet): number | null {
  const correction = set.text(tags.decayCorrection).toUpperCase();
  if (correction === 'ADMIN') return 1;
  const halfLife = dose.number(tags.halfLife) ?? 0;
  if (correction !== 'START' || !(halfLife > 0)) return null;
  const scan = wholeSecondsOf(set.text(tags.seriesDate), set.text(tags.seriesTime));
  const acquired = wholeSecondsOf(
    set.text(tags.acquisitionDate) || set.text(tags.seriesDate),
    set.text(tags.acquisitionTime),
  );
  const start = dose.text(tags.injectionDateTime);
  const isWhole = start !== '';
  const given = isWhole
    ? wholeSecondsOf(start.slice(0, 8), start.slice(8))
    : wholeSecondsOf(set.text(tags.seriesDate), dose.text(tags.injectionTime));
  // A series that was made after its acquisition has another time than that of the scan.
  if (scan === null || given === null || acquired === null || scan > acquired) return null;
  // Without a date of its own, a time after the scan is one of the day before.
  const seconds = scan - given + (!isWhole && given > scan ? secondsPerDay : 0);
  return seconds >= 0 && seconds <= secondsPerDay ? 2 ** (-seconds / halfLife) : null;
}
