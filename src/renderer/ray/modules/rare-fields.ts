import type { FieldProvider } from '../ray-module.ts';
import { channelsProvider } from './channels.ts';
import { discreteProvider } from './discrete-field.ts';

/** Uploads volumes of labels, and volumes of several channels. */
export const rareProvider: FieldProvider = {
  upload: (gl, volume, device) => (volume.channels ? channelsProvider : discreteProvider).upload(gl, volume, device),
};
