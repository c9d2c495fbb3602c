import { nameLengths, unitOfLength } from './length-unit.ts';
import type { LengthMessages } from './length-unit.ts';
import type { CompanionMessages } from './messages.ts';

/** Numbers smaller or larger than these are written with an exponent. */
const [tiny, huge] = [1e-6, 1e15];

/**
 * The smallest normal number. Numbers below it have fewer significant digits the smaller they are: only the digits of the shortest text of
 * such a number are exact.
 */
const minNormal = 2 ** -1022;

/** Maximum number of significant digits of a 64-bit float. */
export const maxDigits = 17;

/** Creating a format takes longer than using it a hundred times. */
const numberFormats = new Map<string, Intl.NumberFormat>();

/** One language for the companions: its messages, and its formats of numbers and times. */
export class Language {
  /**
   * @param code - BCP 47, like `en` or `de-AT`
   * @param timeZone - the zone in which times are written, as `Intl` names zones
   */
  constructor(
    readonly code: string,
    readonly messages: CompanionMessages,
    readonly timeZone = 'UTC',
  ) {}

  /** A number with at most this number of significant digits, without grouping, and with the minus sign that is as wide as a plus. */
  number(value: number, digits = 4): string {
    const size = Math.abs(value);
    const notation = size !== 0 && (size < tiny || size >= huge) ? 'scientific' : 'standard';
    return this.#write(value, { maximumSignificantDigits: digits, notation });
  }

  /** A number with exactly this number of decimals, zeros too: a number that changes keeps its width. */
  fixed(value: number, decimals: number): string {
    return this.#write(Number(value.toFixed(decimals)), {
      minimumFractionDigits: decimals,
      maximumFractionDigits: decimals,
    });
  }

  /** A number with its unit, if it has one. */
  value(value: number, unit: string, digits?: number): string {
    return unit ? `${this.number(value, digits)} ${unit}` : this.number(value, digits);
  }

  /** A length in the unit that suits it. @param length - mm @param extent - the largest side of the volume, mm */
  length(length: number, extent: number, messages: LengthMessages): string {
    const unit = unitOfLength(length, extent);
    return nameLengths(this.number(unit.perMillimetre * length), unit, messages);
  }

  /** Two values of one unit, with enough digits to differ. */
  range(low: number, high: number, unit: string): string {
    const digits = this.digitsToDistinguish(low, high);
    return this.messages.range(this.number(low, digits), this.value(high, unit, digits));
  }

  /** The number of significant digits by which two numbers differ: the usual number, or more. */
  digitsToDistinguish(low: number, high: number, usual = 4): number {
    if (low === high) return usual;
    for (let digits = usual; digits < maxDigits; digits++)
      if (this.number(low, digits) !== this.number(high, digits)) return digits;
    return maxDigits;
  }

  /** A share of 0 to 1 in per cent, with at most this number of significant digits. */
  percent(share: number, digits = 4): string {
    return this.#write(share, { style: 'percent', maximumSignificantDigits: digits });
  }

  /** An opacity of 0 to 1 in per cent: three digits, at most two of them decimals. */
  opacity(opacity: number): string {
    if (opacity > 0 && opacity < 0.0001) return `< ${this.percent(0.0001)}`;
    return this.percent(Number(opacity.toFixed(4)), 3);
  }

  /** Name of the zone of a time: `UTC`, `AEDT`, `GMT+1`. */
  zone(time: string): string {
    if (this.timeZone === 'UTC') return this.messages.utc;
    const parts = new Intl.DateTimeFormat(this.code, { timeZone: this.timeZone, timeZoneName: 'short' }).formatToParts(
      new Date(time),
    );
    return parts.find(({ type }) => type === 'timeZoneName')!.value;
  }

  /** The day of a time in UTC, ISO 8601, converted to the zone of the language: `20 Dec 2018` in British English. */
  day(time: string): string {
    return this.#date(time, { day: 'numeric', month: 'short', year: 'numeric' });
  }

  /** The clock time of a time in UTC, ISO 8601, converted to the zone of the language, with 24 hours as in weather and radiology. */
  clock(time: string, withSeconds: boolean): string {
    return this.#date(time, {
      hour: '2-digit',
      minute: '2-digit',
      second: withSeconds ? '2-digit' : undefined,
      hourCycle: 'h23',
    });
  }

  #write(value: number, options: Intl.NumberFormatOptions): string {
    const key = `${this.code} ${Object.entries(options).join(' ')}`;
    let format = numberFormats.get(key);
    if (!format)
      numberFormats.set(key, (format = new Intl.NumberFormat(this.code, { useGrouping: false, ...options })));
    const digits = value !== 0 && Math.abs(value) < minNormal ? (String(value) as unknown as number) : value + 0; // Browsers accept decimal texts too; older browsers convert them to numbers.
    return format.format(digits).replaceAll('-', '−'); // + 0: a scale has no minus zero
  }

  #date(time: string, options: Intl.DateTimeFormatOptions): string {
    return new Intl.DateTimeFormat(this.code, { ...options, timeZone: this.timeZone }).format(new Date(time));
  }
}
