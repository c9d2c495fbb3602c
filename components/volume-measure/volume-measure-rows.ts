// The result of a measure as text.
import type { MeasureResult } from '../../src/viewer/tools/measuring.ts';
import type { Statistics } from '../../src/volume/statistics.ts';
import type { Language } from '../../src/messages/language.ts';
import type { MeasureWordMessages } from '../../src/messages/measure-locale.ts';
import { unitOfLength, unitOfVolume } from '../../src/messages/length-unit.ts';
import type { Row } from '../internal/volume-readout-rows.ts';

/** The language and messages in which a measure is written. */
export interface MeasureLocale {
  readonly language: Language;
  readonly messages: MeasureWordMessages;
}

/** Digits of a value: enough for all values of 16 bits. */
const valueDigits = 6;

/** Of a volume, as the uncertainty of a length is about one of them. */
const voxelsAlong = 1000;

/** The number of a measure with its uncertainty. */
export function writeMeasure(result: MeasureResult, { language, messages }: MeasureLocale): string {
  const { type, value, uncertainty, lengthUnit } = result;
  if (type === 'angle')
    return messages.plusMinus(
      `${writeRounded(value, uncertainty, language)}°`,
      `${writeUncertainty(uncertainty, language)}°`,
    );
  const { factor, unit } =
    type === 'distance'
      ? lengthScale(Math.max(value, uncertainty), lengthUnit, voxelsAlong * uncertainty)
      : volumeScale(value, lengthUnit);
  return `${messages.plusMinus(writeRounded(value / factor, uncertainty / factor, language), writeUncertainty(uncertainty / factor, language))}${unit && ` ${unit}`}`;
}

/** All results of a measure, one row each. @param isRadar - whether it contains gates instead of voxels */
export function listMeasure(result: MeasureResult, isRadar: boolean, locale: MeasureLocale): Row[] {
  const { messages } = locale;
  const { type, lengths, lengthUnit } = result;
  const number = writeMeasure(result, locale);
  if (type === 'distance' || type === 'angle') return [{ name: messages.measure[type], text: number }];
  const { factor, unit } = lengthScale(Math.max(...lengths), lengthUnit, Infinity);
  const written = lengths.map((one) => locale.language.number(one / factor)).join(' × ');
  return [
    { name: type === 'box' ? messages.measureSize : messages.measureRadius, text: `${written}${unit && ` ${unit}`}` },
    { name: messages.measureVolume, text: number },
    ...listStatistics(result, isRadar, locale),
  ];
}

function listStatistics(
  { statistics, unit }: MeasureResult,
  isRadar: boolean,
  { language, messages }: MeasureLocale,
): Row[] {
  const inside = isRadar ? messages.measureGates : messages.measureVoxels;
  if (!statistics) return [{ name: inside, text: messages.measureSummingUp }];
  const rows: Row[] = [{ name: inside, text: writeCount(statistics, { language, messages }) }];
  const { mean, standardError, deviation, least: min, largest } = statistics;
  if (mean === null || min === null || largest === null) return rows;
  const value = (known: number, digits = valueDigits): string =>
    `${language.number(known, digits)}${unit && ` ${unit}`}`;
  rows.unshift({
    name: messages.measureMean,
    text:
      standardError === null
        ? value(mean)
        : messages.measureWithError(
            `${writeRounded(mean, standardError, language)}${unit && ` ${unit}`}`,
            writeUncertainty(standardError, language),
          ),
  });
  if (deviation !== null) rows.splice(1, 0, { name: messages.measureDeviation, text: value(deviation, 4) });
  rows.splice(-1, 0, {
    name: messages.measureRange,
    text: messages.range(language.number(min, valueDigits), value(largest)),
  });
  return rows;
}

function writeCount({ count, withoutData, cut }: Statistics, { language, messages }: MeasureLocale): string {
  if (count === 0 && withoutData === 0) return messages.measureNothing;
  const whole = (number: number): string => language.fixed(number, 0);
  const text = cut === null || count === 0 ? whole(count) : messages.measureCut(whole(count), whole(cut));
  return withoutData > 0 ? messages.measureWithoutData(text, whole(withoutData)) : text;
}

/** What a length is divided by, and the unit it has then. @param extent - of the volume, in the unit */
function lengthScale(
  length: number,
  lengthUnit: MeasureResult['lengthUnit'],
  extent: number,
): { factor: number; unit: string } {
  if (lengthUnit === '') return { factor: 1, unit: '' };
  if (lengthUnit === 'm') return length >= 1000 ? { factor: 1000, unit: 'km' } : { factor: 1, unit: 'm' };
  const { unit, perMillimetre } = unitOfLength(length, extent);
  return { factor: 1 / perMillimetre, unit };
}

function volumeScale(volume: number, lengthUnit: MeasureResult['lengthUnit']): { factor: number; unit: string } {
  if (lengthUnit === '') return { factor: 1, unit: '' };
  if (lengthUnit === 'm') return volume >= 1e8 ? { factor: 1e9, unit: 'km³' } : { factor: 1, unit: 'm³' };
  if (volume >= 1000) return { factor: 1000, unit: 'cm³' };
  const { unit, perMillimetre } = unitOfVolume(volume);
  return { factor: perMillimetre ** -3, unit: `${unit}³` };
}

/** The useful number of decimals: two digits of the uncertainty. */
function decimalsOf(uncertainty: number): number {
  return uncertainty > 0 ? Math.min(9, Math.max(0, 1 - Math.floor(Math.log10(uncertainty)))) : 3;
}

function writeRounded(value: number, uncertainty: number, language: Language): string {
  return language.fixed(value, decimalsOf(uncertainty));
}

function writeUncertainty(uncertainty: number, language: Language): string {
  return language.fixed(uncertainty, decimalsOf(uncertainty));
}
