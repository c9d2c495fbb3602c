// What a curve of values over time is made of: its numbers as text, its axes, its lines and its table.
import { html, nothing } from 'lit';
import type { CurveMessages } from '../../src/messages/curve-messages.ts';
import type { Language } from '../../src/messages/language.ts';
import { describeScan, isClock, scanLabeller } from '../../src/messages/name-scans.ts';
import type { ValuesOverTime } from '../../src/viewer/picking/values-over-time.ts';
import { valueDigits } from '../internal/volume-readout-rows.ts';
import { drawCurve, drawPoints, placeTimes, scaleValues } from './curve-scale.ts';
import type { TimeAxis, ValueAxis } from './curve-scale.ts';

/** Curves of more values are lines without points. */
const maxPoints = 60;

/** The values of a place, with all that is needed to write them. */
export interface WrittenValues extends ValuesOverTime {
  readonly times: readonly (string | null)[];
  /** Of the values. */
  readonly unit: string;
  readonly language: Language;
  readonly messages: CurveMessages;
}

/** A curve in a square of 1. */
export interface DrawnCurve {
  readonly time: TimeAxis;
  /** null where there is no value yet. */
  readonly value: ValueAxis | null;
  readonly line: string;
  readonly points: string;
}

export function draw({ values, times }: Pick<WrittenValues, 'values' | 'times'>): DrawnCurve {
  const time = placeTimes(times);
  const value = scaleValues(values);
  return {
    time,
    value,
    line: value ? drawCurve(time.at, values, value) : '',
    points: value && values.length <= maxPoints ? drawPoints(time.at, values, value) : '',
  };
}

/** A value as text; `no data`, or a dash where it is not known. */
export function writeValue({ values, unit, language, messages }: WrittenValues, index: number): string {
  const value = values[index];
  if (value === undefined) return '–';
  return Number.isNaN(value) ? messages.noData : language.value(value, unit, valueDigits);
}

/** The time of a scan as text: '12 s', '15:10 UTC', 'scan 3 of 8'. */
export function writeTime({ times, language }: WrittenValues, index: number): string {
  const time = times[index];
  if (time === null) return describeScan(times, index, language);
  const label = scanLabeller(times, language)(index);
  return isClock(time) ? `${label} ${language.zone(time)}` : label;
}

/** The curve in words: its smallest and its largest value, and what is missing. */
export function summarize(written: WrittenValues): string {
  const { values, failed, language, messages } = written;
  let [low, high] = [-1, -1];
  let gaps = 0;
  for (const [i, value] of values.entries()) {
    if (value === undefined) continue;
    if (Number.isNaN(value)) gaps++;
    else {
      if (low < 0 || value < values[low]!) low = i;
      if (high < 0 || value > values[high]!) high = i;
    }
  }
  const count = (number: number): string => language.number(number, 6);
  const range =
    low < 0
      ? []
      : [
          messages.curveRange(
            writeValue(written, low),
            writeTime(written, low),
            writeValue(written, high),
            writeTime(written, high),
          ),
        ];
  return [
    ...range,
    ...(gaps > 0 ? [messages.curveGaps(count(gaps))] : []),
    ...(failed > 0 ? [messages.curveFailed(count(failed), count(values.length))] : []),
  ].join(' ');
}

/** The lines of the curve, with marks at the time that is shown and at the one that is pointed at. */
export function renderLines(
  { time, value, line, points }: DrawnCurve,
  { values }: WrittenValues,
  { current, pointed }: { readonly current: number; readonly pointed: number | null },
): unknown {
  const mark = (i: number | null): string => {
    const there = i === null ? undefined : values[i];
    return value && Number.isFinite(there) ? drawPoints([time.at[i!]], [there], value) : '';
  };
  return html`<svg viewBox="0 0 1 1" preserveAspectRatio="none" aria-hidden="true">
    <path class="lines" d=${(value?.ticks ?? []).map(({ at }) => `M0 ${1 - at}h1`).join('')}></path>
    <path class="now" d=${`M${time.at[current]} 0v1`}></path>
    <path class="line" part="curve-line" d=${line}></path>
    <path class="points" d=${points}></path>
    <path class="pointed" d=${mark(pointed)}></path>
    <path class="current" d=${mark(current)}></path>
  </svg>`;
}

/** The numbers next to the curve. */
export function renderValueTicks({ value }: DrawnCurve, { language, unit }: WrittenValues): unknown {
  if (!value) return nothing;
  const { ticks, decimals, low, high } = value;
  const isPlain = decimals <= 6 && Math.max(Math.abs(low), Math.abs(high)) < 1e6;
  const write = (number: number): string =>
    isPlain ? language.fixed(number, decimals) : language.number(number, valueDigits);
  return html`<div class="values" aria-hidden="true">${ticks.map(
    (tick, i) =>
      html`<span .style=${`--at: ${tick.at}`}>${i === ticks.length - 1 && unit ? `${write(tick.value)} ${unit}` : write(tick.value)}</span>`,
  )}</div>`;
}

/** The times below the curve: round numbers, or where scans have clock times or none, the names of some scans. */
export function renderTimeTicks({ time }: DrawnCurve, { times, language }: WrittenValues): unknown {
  const ticks = time.ticks
    ? time.ticks.all.map(({ at, value }) => ({ at, text: language.value(value, time.ticks!.unit, valueDigits) }))
    : nameSome(times, time, language);
  const last = ticks.length - 1;
  return html`<div class="times" aria-hidden="true">${ticks.map(
    ({ at, text }, i) =>
      html`<span class=${i === 0 || i === last ? 'end' : 'between'} .style=${`--at: ${at}`}>${text}</span>`,
  )}</div>`;
}

/** The first and the last scan, and at most three between, by their places. */
function nameSome(
  times: readonly (string | null)[],
  { at }: TimeAxis,
  language: Language,
): { at: number; text: string }[] {
  const label = scanLabeller(times, language);
  const last = times.length - 1;
  const every = Math.max(1, Math.ceil(last / 4));
  return [...times.keys()]
    .filter((i) => i === last || (i % every === 0 && last - i >= every))
    .map((i) => ({ at: at[i], text: label(i) }));
}

/** All values as a table, which has rows while it is open. @param toggled - called when a person opens or closes it */
export function renderTable(
  written: WrittenValues,
  {
    isOpen,
    current,
    toggled,
  }: { readonly isOpen: boolean; readonly current: number; readonly toggled: (isOpen: boolean) => void },
): unknown {
  const { messages, values, language } = written;
  return html`<details @toggle=${(event: Event) => toggled((event.target as HTMLDetailsElement).open)}>
    <summary part="curve-table">${messages.curveTable}</summary>
    ${
      isOpen
        ? html`<div class="scroll" tabindex="0" role="group" aria-label=${messages.curveTable}><table>
            <thead><tr><th scope="col">${language.messages.time}</th><th scope="col">${language.messages.valueIn(written.unit)}</th></tr></thead>
            <tbody>${values.map(
              (_, i) =>
                html`<tr aria-current=${i === current ? 'time' : nothing}><th scope="row"><bdi>${writeTime(written, i)}</bdi></th><td><bdi>${writeValue({ ...written, unit: '' }, i)}</bdi></td></tr>`,
            )}</tbody>
          </table></div>`
        : nothing
    }
  </details>`;
}
