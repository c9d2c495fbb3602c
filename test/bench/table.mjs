/** @param {readonly number[]} values */
export function median(values) {
  const sorted = [...values];
  sorted.sort((a, b) => a - b);
  const middle = sorted.length >> 1;
  return sorted.length % 2 ? sorted[middle] : (sorted[middle - 1] + sorted[middle]) / 2;
}

/**
 * Rows under their keys, as a Markdown table.
 * @param {readonly Record<string, string | number>[]} rows
 */
export function formatTable(rows) {
  const columns = [...new Set(rows.flatMap((row) => Object.keys(row)))];
  const widths = columns.map((c) => Math.max(c.length, ...rows.map((row) => String(row[c] ?? '').length)));
  const line = (/** @type {readonly (string | number)[]} */ cells) =>
    `| ${cells.map((cell, i) => (i === 0 ? String(cell).padEnd(widths[i]) : String(cell).padStart(widths[i]))).join(' | ')} |`;
  return [
    line(columns),
    `|${widths.map((w, i) => (i === 0 ? '-'.repeat(w + 2) : `${'-'.repeat(w + 1)}:`)).join('|')}|`,
    ...rows.map((row) => line(columns.map((c) => row[c] ?? ''))),
  ].join('\n');
}

/**
 * @param {string} title
 * @param {readonly Record<string, string | number>[]} rows
 */
export function printTable(title, rows) {
  console.log(`${title}\n\n${formatTable(rows)}\n`);
}

/** @param {number} bytes */
export function formatMegabytes(bytes) {
  return (bytes / 1e6).toFixed(1);
}
