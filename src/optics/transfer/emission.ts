import { extinction } from './opacity.ts';
import { evaluate, mix } from './transfer-function.ts';
import type { Premultiplied, Stop, TransferFunction } from './transfer-function.ts';

/**
 * The extinction per reference length that stands for opacity 1. With it, even a hundredth of a reference length lets no
 * light through, and half floats can hold it.
 */
export const opaqueExtinction = 2000;

/** Means of a transfer function over spans of data values: exact, or from a table. */
export interface SpanMeans {
  /** The range of data values outside of which the transfer function is constant. */
  readonly low: number;
  readonly high: number;
  /** Mean of extinction times colour, and of extinction, per reference length, over the values between two. */
  mean(from: number, to: number): Premultiplied;
}

/** Extinction times colour, and extinction, per reference length, at a data value. */
export function emission(transferFunction: TransferFunction, value: number): Premultiplied {
  return emissionOf(evaluate(transferFunction, value));
}

function emissionOf(seen: Premultiplied): Premultiplied {
  const alpha = seen[3];
  if (!(alpha > 0)) return [0, 0, 0, 0];
  const density = densityOf(alpha);
  const scale = density / alpha;
  return [seen[0] * scale, seen[1] * scale, seen[2] * scale, density];
}

/** From the first to the last stop, slightly widened if they are equal. */
export function domainOf(transferFunction: TransferFunction): [number, number] {
  const low = transferFunction[0].value;
  const high = transferFunction[transferFunction.length - 1].value;
  if (high > low) return [low, high];
  const margin = Math.max(Math.abs(low) * 1e-6, 1e-9);
  return [low - margin, high + margin];
}

/** Nodes of the Gauss-Legendre rule on [0, 1]. None is at an end, so jumps need no special case. */
const nodes = [
  0.5 - 0.5 * 0.906179845938664,
  0.5 - 0.5 * 0.5384693101056831,
  0.5,
  0.5 + 0.5 * 0.5384693101056831,
  0.5 + 0.5 * 0.906179845938664,
] as const;

/** Their weights. */
const weights = [
  0.11846344252809454, 0.23931433524968324, 0.28444444444444444, 0.23931433524968324, 0.11846344252809454,
] as const;

/**
 * Mean emission over the data values between two, in any order. If both are equal, the emission there.
 * The span is divided at the stops; between them the emission is smooth.
 */
export function meanOverSpan(transferFunction: TransferFunction, from: number, to: number): Premultiplied {
  const isUpwards = from < to;
  const low = isUpwards ? from : to;
  const high = isUpwards ? to : from;
  if (!(high > low)) return emission(transferFunction, low);
  const mean: Premultiplied = [0, 0, 0, 0];
  let start = low;
  for (let next = firstStopAbove(transferFunction, low); start < high; next++) {
    const isLast = next === transferFunction.length;
    const end = isLast ? high : Math.min(high, transferFunction[next].value);
    const share = (end - start) / (high - low);
    if (end > start && (next === 0 || isLast)) addWeighted(mean, emission(transferFunction, start), share);
    else if (end > start)
      addPiece(mean, { from: transferFunction[next - 1], to: transferFunction[next], start, end, share });
    start = end;
  }
  return mean;
}

/** If extinctions per reference length differ by more than this within a piece, it is bisected. */
const smoothDifference = 1;

/** The largest number of bisections towards opacity 1, where extinction has a logarithmic pole: at most 3e-5 of the mean is lost there. */
const maxHalvings = 10;

/** A part of a span between two stops: where it begins and ends, and its share of the mean. */
interface Piece {
  readonly from: Stop;
  readonly to: Stop;
  readonly start: number;
  readonly end: number;
  readonly share: number;
}

/** Most pages integrate one transfer function, before the browser has optimised this code: so it makes no lists, and few calls. */
function addPiece(mean: Premultiplied, piece: Piece, halvings = 0): void {
  const { from, to, start, end, share } = piece;
  const length = end - start;
  const width = to.value - from.value;
  const difference =
    densityOf(mix(from.opacity, to.opacity, (start + nodes[4] * length - from.value) / width)) -
    densityOf(mix(from.opacity, to.opacity, (start + nodes[0] * length - from.value) / width));
  if (Math.abs(difference) > smoothDifference && halvings < maxHalvings) {
    const middle = (start + end) / 2;
    addPiece(mean, { ...piece, end: middle, share: share / 2 }, halvings + 1);
    addPiece(mean, { ...piece, start: middle, share: share / 2 }, halvings + 1);
    return;
  }
  for (let i = 0; i < nodes.length; i++) {
    const t = (start + nodes[i] * length - from.value) / width;
    const alpha = mix(from.opacity, to.opacity, t);
    if (!(alpha > 0)) continue;
    const weight = share * weights[i];
    const density = densityOf(alpha);
    const scale = density / alpha;
    for (let c = 0; c < 3; c++)
      mean[c] += weight * (mix(from.color[c] * from.opacity, to.color[c] * to.opacity, t) * scale);
    mean[3] += weight * density;
  }
}

function densityOf(alpha: number): number {
  return alpha > 0 ? Math.min(opaqueExtinction, extinction(Math.min(alpha, 1))) : 0;
}

function addWeighted(sum: Premultiplied, summand: Premultiplied, weight: number): void {
  sum[0] += weight * summand[0];
  sum[1] += weight * summand[1];
  sum[2] += weight * summand[2];
  sum[3] += weight * summand[3];
}

function firstStopAbove(transferFunction: TransferFunction, value: number): number {
  let low = 0;
  let high = transferFunction.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (transferFunction[middle].value <= value) low = middle + 1;
    else high = middle;
  }
  return low;
}
