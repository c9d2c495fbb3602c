import type { FieldTaps } from '../ray/modules/lit.ts';
import type { FieldProvider } from '../ray/ray-module.ts';

/** How volumes of other than cartesian grids are drawn: loaded when the first one comes. */
export interface FieldProviders {
  readonly polar?: () => Promise<FieldProvider>;
  /** How they are lit. */
  readonly polarTaps?: () => Promise<FieldTaps>;
}
