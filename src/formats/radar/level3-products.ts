import type { MomentKind } from './radar-file.ts';

/** How the numbers of a product become values. */
export type Level3Coding =
  /** Sixteen levels, each with a value of its own: the lower end of a range. */
  | 'levels'
  /** Value = (least + step * (number - 2)) / 10, from halfwords 31 and 32. */
  | 'tenths'
  /** Value = step * (number - 129) / 10. Halfword 31 is 0 or -63.5 times ten: a width has no levels below 0. */
  | 'widths'
  /** Value = (number - offset) / scale, floats in halfwords 31 to 34. */
  | 'floats'
  /** The number itself, which stands for a kind of echo. */
  | 'classes';

/** A product that shows one sweep. */
export interface Level3Product {
  /** What the quantity is called here, as in NEXRAD Level II where it has it. */
  readonly name: string;
  readonly kind: MomentKind;
  /** Of kinds of echo, see RadarMoment. */
  readonly numbers?: readonly [number, number];
  readonly unit: string;
  /** Metres along the beam. */
  readonly gateLength: number;
  readonly coding: Level3Coding;
  /** Factor from the file's unit to `unit`; 1 if undefined. */
  readonly factor?: number;
  /** Of the radar, degrees; that of a WSR-88D if undefined. */
  readonly beamWidth?: number;
}

/** Metres per second. Older products of velocities count in knots. */
const knot = 1852 / 3600;

const reflectivity = { name: 'REF', kind: 'reflectivity', unit: 'dBZ' } as const;
const velocity = { name: 'VEL', kind: 'velocity', unit: 'm/s' } as const;
const width = { name: 'SW', kind: 'spectrum-width', unit: 'm/s' } as const;
/** Velocities less the motion of the storms: they do not fold where the others do. */
const relative = { name: 'SRM', kind: 'other', unit: 'm/s' } as const;
const old = { coding: 'levels', factor: knot } as const;
/** A TDWR, the radar of an airport. Source: Michelson, Shrader and Wieler, Terminal Doppler Weather Radar, 1990 */
const airport = { beamWidth: 0.55 } as const;

/**
 * Products of one elevation, by their codes.
 * Source: Interface Control Document for the RPG to Class 1 User, 2620001 (NOAA/NWS Radar Operations Center), table III
 */
export const level3Products: ReadonlyMap<number, Level3Product> = new Map<number, Level3Product>([
  [19, { ...reflectivity, gateLength: 1000, coding: 'levels' }],
  [20, { ...reflectivity, gateLength: 2000, coding: 'levels' }],
  [25, { ...velocity, gateLength: 250, ...old }],
  [27, { ...velocity, gateLength: 1000, ...old }],
  [28, { ...width, gateLength: 250, ...old }],
  [30, { ...width, gateLength: 1000, ...old }],
  [56, { ...relative, gateLength: 1000, ...old }],
  [94, { ...reflectivity, gateLength: 1000, coding: 'tenths' }],
  [99, { ...velocity, gateLength: 250, coding: 'tenths' }],
  [153, { ...reflectivity, gateLength: 250, coding: 'tenths' }],
  [154, { ...velocity, gateLength: 250, coding: 'tenths' }],
  [155, { ...width, gateLength: 250, coding: 'widths' }],
  [159, { name: 'ZDR', kind: 'differential-reflectivity', unit: 'dB', gateLength: 250, coding: 'floats' }],
  [161, { name: 'RHO', kind: 'correlation', unit: '', gateLength: 250, coding: 'floats' }],
  [163, { name: 'KDP', kind: 'other', unit: 'degrees/km', gateLength: 250, coding: 'floats' }],
  [165, { name: 'HCA', kind: 'kinds', numbers: [10, 140], unit: '', gateLength: 250, coding: 'classes' }],
  [167, { name: 'RHO', kind: 'correlation', unit: '', gateLength: 250, coding: 'floats' }],
  [168, { name: 'PHI', kind: 'differential-phase', unit: 'degrees', gateLength: 250, coding: 'floats' }],
  [180, { ...reflectivity, gateLength: 150, coding: 'tenths', ...airport }],
  [181, { ...reflectivity, gateLength: 150, coding: 'levels', ...airport }],
  [182, { ...velocity, gateLength: 150, coding: 'tenths', ...airport }],
  [186, { ...reflectivity, gateLength: 300, coding: 'tenths', ...airport }],
]);

/** Their codes, for messages. */
export const listProducts = (): string => [...level3Products.keys()].join(', ');
