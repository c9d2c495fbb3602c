import type { Vector3 } from '../../volume/matrix.ts';
import { fogFlat, fogMaterial } from './lights.ts';

/** How a shaded volume reflects light, with the fields of X3D's Material. Colours are factors of the transfer function's colours. */
export interface StyleMaterial {
  readonly ambient: number;
  readonly diffuse: Vector3;
  readonly specular: Vector3;
  readonly emissive: Vector3;
  readonly shininess: number;
}

/** A steepness of the change of values, and the factor of the opacity there. */
export type GradientStop = readonly [steepness: number, factor: number];

/** One of X3D's composable styles, with the fields that its formula needs. */
export type VolumeStyle =
  | { readonly kind: 'boundary'; readonly retained: number; readonly boundary: number; readonly power: number }
  /** The attribute `gradient-opacity`: |grad f|, in data units per world unit, and factors; linear between stops. Ascending. */
  | { readonly kind: 'gradient'; readonly stops: readonly GradientStop[] }
  | { readonly kind: 'silhouette'; readonly retained: number; readonly boundary: number; readonly sharpness: number }
  | { readonly kind: 'edge'; readonly color: Vector3; readonly threshold: number }
  | { readonly kind: 'cartoon'; readonly parallel: Vector3; readonly orthogonal: Vector3; readonly steps: number }
  | { readonly kind: 'tone'; readonly cool: Vector3; readonly warm: Vector3 }
  /** If the material is null, what faces the headlight keeps its own colour. */
  | { readonly kind: 'shaded'; readonly material: StyleMaterial | null };

const gray = (x: number): Vector3 => [x, x, x];

/** The material of `shading="lit"`, in X3D's fields. */
const fog: StyleMaterial = {
  ambient: fogMaterial.ambient / fogMaterial.diffuse,
  diffuse: gray(fogMaterial.diffuse),
  specular: gray(fogMaterial.specular),
  emissive: gray(0),
  shininess: fogMaterial.shininess,
};

/** Styles that act one after the other, and their share of the picture. */
export interface StyleChain {
  readonly weight: number;
  readonly styles: readonly VolumeStyle[];
}

/** Adds the light of a lit view at the end of each chain, unless a style already adds light. */
export function withLight(chains: readonly StyleChain[]): readonly StyleChain[] {
  const isLit = chains.some(({ styles }) => styles.some(({ kind }) => kind === 'shaded'));
  return isLit
    ? chains
    : chains.map(({ weight, styles }) => ({ weight, styles: [...styles, { kind: 'shaded', material: fog }] }));
}

/** Factor of the change that counts as flat. If other styles change only the opacity, light is that of lit fog. */
export function flatOf(chains: readonly StyleChain[]): number {
  const isFog = chains.every(({ styles }) =>
    styles.every(
      (one) => one.kind === 'gradient' || one.kind === 'boundary' || (one.kind === 'shaded' && one.material === fog),
    ),
  );
  return isFog ? fogFlat : 1;
}

/** The largest number of chains, which are added: two if styles are blended. */
export const maxChains = 2;

/** The effect of styles at a place: on a colour, c' = gain c + more; and on the opacity of a reference length. */
export interface Styled {
  readonly gain: Vector3;
  readonly more: Vector3;
  readonly opacity: number;
}

/** What the formulas need to know of a place. */
export interface StyledPlace {
  /** |n . v| */
  readonly facing: number;
  /** The mean of n . l over all lights. */
  readonly towards: number;
  /** |grad f|: the change along a reference length, as a share of the transfer function's span. */
  readonly change: number;
  /** How much the place counts as a surface: 0 where the field is flat, or next to a cut. */
  readonly weight: number;
}

/** Number of entries in a row of the table, and of rows for a chain. */
export const styleColumns = 256;
export const styleRows = 4;

/** The largest change that the table distinguishes; larger ones count as this. */
const maxChange = 16;

/** The range of cosines on either side over which a colour's edge is blended. */
const softEdge = 0.02;

const ofOpacity: readonly string[] = ['boundary', 'silhouette', 'gradient'];

type OfFacing = Extract<VolumeStyle, { kind: 'edge' | 'cartoon' }>;

/**
 * All styles of a chain as functions of one number each, in four rows. Three rows change the colour: by n . l (-1 to 1), then by |n . v| (0
 * to 1) before and after light; each entry has a colour to add and the share to keep. One row has the factors of the opacity: by |n . v|,
 * by the change, and by the change as a share of `gradientReach`. Styles before one that replaces the colour have no effect.
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
      [
        silhouetteFactor(styles, x),
        boundaryFactor(styles, changeOf(x)),
        gradientFactor(styles, x * gradientReach(styles)),
        0,
      ],
    ];
    rows.forEach((row, y) => table.set(row, 4 * (y * styleColumns + i)));
  }
  return table;
}

/** The light of a chain that counts: no style after it replaces the colour. Undefined if there is none. */
export function shadedOf(styles: readonly VolumeStyle[]): Extract<VolumeStyle, { kind: 'shaded' }> | undefined {
  return styles.slice(lastTone(styles) + 1).find((one) => one.kind === 'shaded');
}

/** -1 if there is none. */
function lastTone(styles: readonly VolumeStyle[]): number {
  return styles.map(({ kind }) => kind).lastIndexOf('tone');
}

/** Factor of the opacity where the field is flat and has no direction. */
export function flatFactor(styles: readonly VolumeStyle[]): number {
  return styles.reduce((product, one) => (one.kind === 'silhouette' ? product * one.retained : product), 1);
}

/** Whether the colour has edges. With edges, a ray's picture is exact only to a part of a step. */
export function hasEdges(styles: readonly VolumeStyle[]): boolean {
  return styles.some(({ kind }) => kind === 'edge' || kind === 'cartoon');
}

/** The place of a change in its row of the table. About half of the row is for changes below 1. */
export function shareOfChange(change: number): number {
  return Math.min(1, ((1 + maxChange) / maxChange) * (change / (1 + change)));
}

function changeOf(share: number): number {
  const x = (share * maxChange) / (1 + maxChange);
  return x / (1 - x);
}

/** O' = O (r + b (1 - |n . v|)^s). Source: ISO/IEC 19775-1, 41.4 */
function silhouetteFactor(styles: readonly VolumeStyle[], facing: number): number {
  return styles.reduce(
    (product, one) =>
      one.kind === 'silhouette' ? product * (one.retained + one.boundary * (1 - facing) ** one.sharpness) : product,
    1,
  );
}

/** O' = O (r + b |grad f|^e) */
function boundaryFactor(styles: readonly VolumeStyle[], change: number): number {
  return styles.reduce(
    (product, one) =>
      one.kind === 'boundary' ? product * (one.retained + one.boundary * change ** one.power) : product,
    1,
  );
}

/** The steepness from which on factors are constant, in data units per world unit; 0 if no style uses it. */
export function gradientReach(styles: readonly VolumeStyle[]): number {
  return styles.reduce((reach, one) => Math.max(reach, one.kind === 'gradient' ? reachOfStops(one.stops) : 0), 0);
}

function reachOfStops(stops: readonly GradientStop[]): number {
  const [, last] = stops[stops.length - 1];
  const [at] = stops.find((_, i) => stops.slice(i).every(([, factor]) => factor === last))!;
  // If a factor is the same everywhere, any reach will do.
  return at || 1;
}

/** O' = O a(|grad f|). Source: Levoy 1988 */
function gradientFactor(styles: readonly VolumeStyle[], steepness: number): number {
  return styles.reduce(
    (product, one) => (one.kind === 'gradient' ? product * factorAt(one.stops, steepness) : product),
    1,
  );
}

/** Linear between stops; constant before the first and from the last on. */
function factorAt(stops: readonly GradientStop[], steepness: number): number {
  const next = stops.findIndex(([at]) => at > steepness);
  if (next <= 0) return stops[next === 0 ? 0 : stops.length - 1][1];
  const [[from, low], [to, high]] = [stops[next - 1], stops[next]];
  return low + ((steepness - from) / (to - from)) * (high - low);
}

/** The joint effect of several styles on a colour: what is added, and the share that stays. */
function chainColors(styles: readonly OfFacing[], facing: number): readonly number[] {
  return styles.reduce<readonly number[]>(
    (sum, one) => {
      const [red, green, blue, kept] =
        one.kind === 'edge' ? edgeColors(one, facing) : [...cartoonColor(one, facing), 0];
      return [kept * sum[0] + red, kept * sum[1] + green, kept * sum[2] + blue, kept * sum[3]];
    },
    [0, 0, 0, 1],
  );
}

/** The edge's colour where a surface is turned away from the eye by more than the threshold. */
function edgeColors({ color, threshold }: Extract<VolumeStyle, { kind: 'edge' }>, facing: number): readonly number[] {
  const share = Math.min(1, Math.max(0, 0.5 + (Math.cos(threshold) - facing) / (2 * softEdge)));
  return [...color.map((x) => share * x), 1 - share];
}

/** Places around a step's edge whose colours are averaged, so that it is as soft as the edge of an edge style. */
const edgePlaces = Array.from({ length: 9 }, (_, i) => (softEdge * (i - 4)) / 4);

/** A number of colours from that of surfaces facing the eye to that of surfaces seen from the side, at equal steps of the angle. */
function cartoonColor(
  { parallel, orthogonal, steps }: Extract<VolumeStyle, { kind: 'cartoon' }>,
  facing: number,
): Vector3 {
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

/** A gray gets the hue of the other colour, and black also its saturation. Hues change along the shorter way. */
function alignHues([h0, s0, v0]: Vector3, [h1, s1, v1]: Vector3): [Vector3, Vector3] {
  const [first, second] = [s0 === 0 ? h1 : h0, s1 === 0 ? h0 : h1];
  const turn = second - first > 0.5 ? -1 : second - first < -0.5 ? 1 : 0;
  return [
    [first, v0 === 0 ? s1 : s0, v0],
    [second + turn, v1 === 0 ? s0 : s1, v1],
  ];
}

function mix(a: Vector3, b: Vector3, share: number): Vector3 {
  return a.map((x, i) => x + share * (b[i] - x)) as unknown as Vector3;
}

/** Hue, saturation and value, each 0 to 1. */
export function toHsv([red, green, blue]: Vector3): Vector3 {
  const max = Math.max(red, green, blue);
  const range = max - Math.min(red, green, blue);
  if (range === 0) return [0, 0, max];
  const sixth =
    max === red ? (green - blue) / range : max === green ? 2 + (blue - red) / range : 4 + (red - green) / range;
  return [(((sixth / 6) % 1) + 1) % 1, range / max, max];
}

export function fromHsv([hue, saturation, value]: Vector3): Vector3 {
  return [0, 4, 2].map((shift) => {
    const along = Math.abs(((((hue * 6 + shift) % 6) + 6) % 6) - 3) - 1;
    return value * (1 - saturation + saturation * Math.min(1, Math.max(0, along)));
  }) as unknown as Vector3;
}
