import type { Vector3 } from '../../volume/matrix.ts';
import { fogFlat, fogMaterial } from './lights.ts';

/** How a shaded volume takes light, as X3D's Material says it; colours are shares of what the transfer function gives. */
export interface StyleMaterial {
  readonly ambient: number;
  readonly diffuse: Vector3;
  readonly specular: Vector3;
  readonly emissive: Vector3;
  readonly shininess: number;
}

/** A change of values, and the factor that it gives opacities. */
export type GradientStop = readonly [steepness: number, factor: number];

/** One of X3D's styles that compose, by what its formula reads. */
export type VolumeStyle =
  | { readonly kind: 'boundary'; readonly retained: number; readonly boundary: number; readonly power: number }
  /** The attribute `gradient-opacity`: |grad f|, in data units per world unit, and factors, straight lines between stops. Ascending. */
  | { readonly kind: 'gradient'; readonly stops: readonly GradientStop[] }
  | { readonly kind: 'silhouette'; readonly retained: number; readonly boundary: number; readonly sharpness: number }
  | { readonly kind: 'edge'; readonly color: Vector3; readonly threshold: number }
  | { readonly kind: 'cartoon'; readonly parallel: Vector3; readonly orthogonal: Vector3; readonly steps: number }
  | { readonly kind: 'tone'; readonly cool: Vector3; readonly warm: Vector3 }
  /** A material of null leaves what faces the headlight its own colour. */
  | { readonly kind: 'shaded'; readonly material: StyleMaterial | null };

const gray = (x: number): Vector3 => [x, x, x];

/** That of `shading="lit"`, as X3D would say it. */
const fog: StyleMaterial = { ambient: fogMaterial.ambient / fogMaterial.diffuse, diffuse: gray(fogMaterial.diffuse), specular: gray(fogMaterial.specular), emissive: gray(0), shininess: fogMaterial.shininess };

/** Styles that act one after the other, and what share of the picture they are. */
export interface StyleChain {
  readonly weight: number;
  readonly styles: readonly VolumeStyle[];
}

/** A view that is lit is lit last, where no style of its own lights it. */
export function withLight(chains: readonly StyleChain[]): readonly StyleChain[] {
  const isLit = chains.some(({ styles }) => styles.some(({ kind }) => kind === 'shaded'));
  return isLit ? chains : chains.map(({ weight, styles }) => ({ weight, styles: [...styles, { kind: 'shaded', material: fog }] }));
}

/** Of a flat change, what counts as flat: where only the opacity is changed beside it, light is that of lit fog. */
export function flatOf(chains: readonly StyleChain[]): number {
  const isFog = chains.every(({ styles }) => styles.every((one) => one.kind === 'gradient' || one.kind === 'boundary' || (one.kind === 'shaded' && one.material === fog)));
  return isFog ? fogFlat : 1;
}

/** Chains that are added: two where styles are blended. */
export const maxChains = 2;

/** What styles do at a place: to a colour, c' = gain c + more, and to the opacity of a reference length. */
export interface Styled {
  readonly gain: Vector3;
  readonly more: Vector3;
  readonly opacity: number;
}

/** What the formulas read of a place. */
export interface StyledPlace {
  /** |n . v| */
  readonly facing: number;
  /** n . l, the mean of all lights. */
  readonly towards: number;
  /** |grad f|: change along a reference length, as a share of what the transfer function spans. */
  readonly change: number;
  /** How much of a surface it is: 0 where the field is flat, or next to a cut. */
  readonly weight: number;
}

/** Entries of a row of the table, and rows of a chain. */
export const styleColumns = 256;
export const styleRows = 4;

/** The largest change that the table tells from larger ones. */
const mostChange = 16;

/** Cosines over which an edge of a colour is drawn, on either side. */
const softEdge = 0.02;

const ofOpacity: readonly string[] = ['boundary', 'silhouette', 'gradient'];

type OfFacing = Extract<VolumeStyle, { kind: 'edge' | 'cartoon' }>;

/**
 * All styles of a chain as functions of one number each, in four rows: what comes of a colour by n . l (-1 to 1), then by |n . v| (0 to 1)
 * before and after light, each as colour to add and share to keep; and the factors of the opacity: by |n . v|, by the change, and by the
 * change as a share of `gradientReach`.
 * What stands before a style that sets the colour anew says nothing.
 */
export function buildStyleTable(styles: readonly VolumeStyle[]): Float64Array {
  const ofColor = styles.filter(({ kind }) => !ofOpacity.includes(kind));
  const toneAt = lastTone(ofColor);
  const tone = ofColor[toneAt] as Extract<VolumeStyle, { kind: 'tone' }> | undefined;
  const rest = ofColor.slice(toneAt + 1);
  const shadedAt = rest.findIndex(({ kind }) => kind === 'shaded');
  const [before, after] = shadedAt < 0 ? [rest, []] : [rest.slice(0, shadedAt), rest.slice(shadedAt + 1)];
  const table = new Float64Array(4 * styleColumns * styleRows);
  for (let i = 0; i < styleColumns; i++) {
    const x = i / (styleColumns - 1);
    const rows = [
      tone ? [...mix(tone.cool, tone.warm, x), 0] : [0, 0, 0, 1],
      chainColors(before as OfFacing[], x),
      chainColors(after as OfFacing[], x),
      [silhouetteFactor(styles, x), boundaryFactor(styles, changeOf(x)), gradientFactor(styles, x * gradientReach(styles)), 0],
    ];
    rows.forEach((row, y) => table.set(row, 4 * (y * styleColumns + i)));
  }
  return table;
}

/** The light on a chain that counts: that after which no style sets the colour anew; undefined where there is none. */
export function shadedOf(styles: readonly VolumeStyle[]): Extract<VolumeStyle, { kind: 'shaded' }> | undefined {
  return styles.slice(lastTone(styles) + 1).find((one) => one.kind === 'shaded');
}

/** -1 where there is none. */
function lastTone(styles: readonly VolumeStyle[]): number {
  return styles.map(({ kind }) => kind).lastIndexOf('tone');
}

/** Factor of the opacity where nothing faces anywhere. */
export function flatFactor(styles: readonly VolumeStyle[]): number {
  return styles.reduce((product, one) => (one.kind === 'silhouette' ? product * one.retained : product), 1);
}

/** Whether a colour has edges, at which a ray's picture is known to a part of a step. */
export function hasEdges(styles: readonly VolumeStyle[]): boolean {
  return styles.some(({ kind }) => kind === 'edge' || kind === 'cartoon');
}

/** Where in its row a change stands: half of it is below one. */
export function shareOfChange(change: number): number {
  return Math.min(1, ((1 + mostChange) / mostChange) * (change / (1 + change)));
}

function changeOf(share: number): number {
  const x = (share * mostChange) / (1 + mostChange);
  return x / (1 - x);
}

/** O' = O (r + b (1 - |n . v|)^s). Source: ISO/IEC 19775-1, 41.4 */
function silhouetteFactor(styles: readonly VolumeStyle[], facing: number): number {
  return styles.reduce((product, one) => (one.kind === 'silhouette' ? product * (one.retained + one.boundary * (1 - facing) ** one.sharpness) : product), 1);
}

/** O' = O (r + b |grad f|^e) */
function boundaryFactor(styles: readonly VolumeStyle[], change: number): number {
  return styles.reduce((product, one) => (one.kind === 'boundary' ? product * (one.retained + one.boundary * change ** one.power) : product), 1);
}

/** The steepness from which on factors stay the same, in data units per world unit; 0 where no style asks for it. */
export function gradientReach(styles: readonly VolumeStyle[]): number {
  return styles.reduce((reach, one) => Math.max(reach, one.kind === 'gradient' ? reachOfStops(one.stops) : 0), 0);
}

function reachOfStops(stops: readonly GradientStop[]): number {
  const [, last] = stops[stops.length - 1];
  const [at] = stops.find((_, i) => stops.slice(i).every(([, factor]) => factor === last))!;
  // Of a factor that is everywhere the same any reach will do.
  return at || 1;
}

/** O' = O a(|grad f|). Source: Levoy 1988 */
function gradientFactor(styles: readonly VolumeStyle[], steepness: number): number {
  return styles.reduce((product, one) => (one.kind === 'gradient' ? product * factorAt(one.stops, steepness) : product), 1);
}

/** Linear between stops, the same before the first and from the last on. */
function factorAt(stops: readonly GradientStop[], steepness: number): number {
  const next = stops.findIndex(([at]) => at > steepness);
  if (next <= 0) return stops[next === 0 ? 0 : stops.length - 1][1];
  const [[from, low], [to, high]] = [stops[next - 1], stops[next]];
  return low + ((steepness - from) / (to - from)) * (high - low);
}

/** What several styles make of a colour: what is added, and the share that stays. */
function chainColors(styles: readonly OfFacing[], facing: number): readonly number[] {
  return styles.reduce<readonly number[]>((sum, one) => {
    const [red, green, blue, kept] = one.kind === 'edge' ? edgeColors(one, facing) : [...cartoonColor(one, facing), 0];
    return [kept * sum[0] + red, kept * sum[1] + green, kept * sum[2] + blue, kept * sum[3]];
  }, [0, 0, 0, 1]);
}

/** The edge's colour where a surface is turned away from the eye by more than the threshold. */
function edgeColors({ color, threshold }: Extract<VolumeStyle, { kind: 'edge' }>, facing: number): readonly number[] {
  const share = Math.min(1, Math.max(0, 0.5 + (Math.cos(threshold) - facing) / (2 * softEdge)));
  return [...color.map((x) => share * x), 1 - share];
}

/** Places of a step's edge at which it is looked up, so that it is as soft as that of an edge. */
const edgePlaces = Array.from({ length: 9 }, (_, i) => (softEdge * (i - 4)) / 4);

/** So many colours from that of what faces the eye to that of what is seen from the side, by even angles. */
function cartoonColor({ parallel, orthogonal, steps }: Extract<VolumeStyle, { kind: 'cartoon' }>, facing: number): Vector3 {
  const ends = alignHues(toHsv(parallel), toHsv(orthogonal));
  const sum = [0, 0, 0];
  for (const place of edgePlaces) {
    const angle = Math.acos(Math.min(1, Math.max(0, facing + place)));
    const step = Math.min(steps - 1, Math.floor((2 * steps * angle) / Math.PI));
    const color = fromHsv(mix(...ends, steps > 1 ? step / (steps - 1) : 1));
    color.forEach((x, c) => (sum[c] += x / edgePlaces.length));
  }
  return sum as unknown as Vector3;
}

/** A gray has the hue of the other colour, black its saturation too; hues run the shorter way. */
function alignHues([h0, s0, v0]: Vector3, [h1, s1, v1]: Vector3): [Vector3, Vector3] {
  const [first, second] = [s0 === 0 ? h1 : h0, s1 === 0 ? h0 : h1];
  const turn = second - first > 0.5 ? -1 : second - first < -0.5 ? 1 : 0;
  return [[first, v0 === 0 ? s1 : s0, v0], [second + turn, v1 === 0 ? s0 : s1, v1]];
}

function mix(a: Vector3, b: Vector3, share: number): Vector3 {
  return a.map((x, i) => x + share * (b[i] - x)) as unknown as Vector3;
}

/** Hue, saturation and value, 0 to 1 each. */
export function toHsv([red, green, blue]: Vector3): Vector3 {
  const most = Math.max(red, green, blue);
  const range = most - Math.min(red, green, blue);
  if (range === 0) return [0, 0, most];
  const sixth = most === red ? (green - blue) / range : most === green ? 2 + (blue - red) / range : 4 + (red - green) / range;
  return [(((sixth / 6) % 1) + 1) % 1, range / most, most];
}

export function fromHsv([hue, saturation, value]: Vector3): Vector3 {
  return [0, 4, 2].map((shift) => {
    const along = Math.abs(((((hue * 6 + shift) % 6) + 6) % 6) - 3) - 1;
    return value * (1 - saturation + saturation * Math.min(1, Math.max(0, along)));
  }) as unknown as Vector3;
}
