// What came of the cases of one format.

/** @typedef {import('./verdict.ts').Verdict} Verdict */

export class Tally {
  cases = 0;
  volumes = 0;
  /** @type {Map<string, number>} by code */
  errors = new Map();
  /** @type {Map<string, number>} by kind */
  findings = new Map();
  slowest = { ms: 0, index: -1 };
  /** Bytes that were held for each byte of the files, beyond what is free. */
  ratio = { max: 0, index: -1 };
  maxPeak = 0;

  /** @param {string} format */
  constructor(format) {
    this.format = format;
  }

  /**
   * @param {number} index
   * @param {Verdict} verdict
   * @returns {boolean} whether it is a finding of a new kind
   */
  add(index, { outcome, finding, ms, peak, size }) {
    this.cases++;
    if (outcome === 'volume' || outcome === 'value') this.volumes++;
    else this.errors.set(outcome, (this.errors.get(outcome) ?? 0) + 1);
    if (ms > this.slowest.ms) this.slowest = { ms, index };
    const ratio = Math.max(0, peak - 2 ** 26) / Math.max(1, size);
    if (ratio > this.ratio.max) this.ratio = { max: ratio, index };
    this.maxPeak = Math.max(this.maxPeak, peak);
    if (!finding) return false;
    const count = this.findings.get(finding.kind) ?? 0;
    this.findings.set(finding.kind, count + 1);
    return count === 0;
  }
}

/**
 * A table in Markdown.
 * @param {readonly Tally[]} tallies
 */
export function formatTable(tallies) {
  const rows = tallies.map(({ format, cases, volumes, errors, findings, slowest, ratio, maxPeak }) => [
    format,
    cases.toLocaleString('en'),
    volumes.toLocaleString('en'),
    sortByCount(errors)
      .map(([code, count]) => `${code} ${count.toLocaleString('en')}`)
      .join(', '),
    [...findings.values()].reduce((sum, count) => sum + count, 0).toLocaleString('en'),
    `${Math.round(slowest.ms)} ms`,
    `${(maxPeak / 2 ** 20).toFixed(0)} MB`,
    ratio.max > 0 ? ratio.max.toFixed(0) : 'none',
  ]);
  const head = [
    'format',
    'cases',
    'volumes',
    'errors by code',
    'findings',
    'slowest',
    'most memory',
    'bytes per byte beyond 64 MB',
  ];
  return [head, head.map(() => '---'), ...rows].map((cells) => `| ${cells.join(' | ')} |`).join('\n');
}

/** @param {ReadonlyMap<string, number>} counts */
function sortByCount(counts) {
  const list = [...counts];
  list.sort((a, b) => b[1] - a[1]);
  return list;
}
