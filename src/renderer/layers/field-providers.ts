import type { FieldTaps } from '../ray/modules/field-taps.ts';
import type { FieldProvider } from '../ray/ray-module.ts';

/** Loaders of the code that draws volumes whose grid is not cartesian: the first such volume calls them. */
export interface FieldProviders {
  readonly polar?: () => Promise<FieldProvider>;
  /** Loads the code that lights polar volumes. */
  readonly polarTaps?: () => Promise<FieldTaps>;
}
