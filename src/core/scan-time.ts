/** When a scan was measured, as a number. */
export interface ScanTime {
  /** Of a time in UTC, milliseconds since 1970. */
  readonly value: number;
  /** 'UTC', or the unit in which a file counts from some start: 's'. */
  readonly unit: string;
}

/**
 * Reads the time of a scan: ISO 8601 in UTC, or a number with its unit, '12.5 s'. Milliseconds become seconds.
 * @returns null where it is neither
 */
export function readScanTime(text: string): ScanTime | null {
  if (/^\d{4}-\d\d-/.test(text)) return { value: Date.parse(text), unit: 'UTC' };
  const [, number, unit] = /^(-?[\d.]+(?:e[-+]?\d+)?) *([^\d\s]\S*)$/i.exec(text) ?? [];
  if (!unit) return null;
  return unit === 'ms' ? { value: Number(number) / 1000, unit: 's' } : { value: Number(number), unit };
}
