import type { Color, TransferFunction } from './transfer-function.ts';

/**
 * Writes stops as the text of an attribute that parseTransferFunction reads: values to a ten-thousandth of the stops'
 * span (or finer), colours to 1/255, opacities to four digits.
 */
export function writeTransferFunction(stops: TransferFunction): string {
  const digits = decimalsFor(stops[stops.length - 1].value - stops[0].value);
  const written = stops.map(({ value, color, opacity }) => {
    const number = digits === null ? Number(value.toPrecision(9)) : Number(value.toFixed(digits));
    return `${number} ${writeColor(color)} ${Number((opacity * 100).toPrecision(4))}%`;
  });
  return written.join(', ');
}

/** `#rrggbb`. */
export function writeColor(color: Color): string {
  return `#${color
    .map((channel) =>
      Math.round(channel * 255)
        .toString(16)
        .padStart(2, '0'),
    )
    .join('')}`;
}

/** Number of decimals that distinguish ten thousand values of a span; null if the span is 0. */
function decimalsFor(span: number): number | null {
  return span > 0 ? Math.min(20, Math.max(0, 4 - Math.floor(Math.log10(span)))) : null;
}
