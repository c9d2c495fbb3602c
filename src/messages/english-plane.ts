import type { PlaneMessages } from './plane-messages.ts';

export const english: PlaneMessages = {
  valuesAndGradients: 'Values across, gradients upwards',
  noGradients: 'Labels have no gradients.',
  boxOf: (number, count) => `Box, ${number} of ${count}`,
  gaussianOf: (number, count) => `Gaussian, ${number} of ${count}`,
  sizeOf: (name) => `Size of ${name}`,
  patchState: (values, gradients, opacity, color) =>
    `values ${values}, gradients ${gradients}, opacity ${opacity}, ${color}`,
  patchKeys: 'Arrow keys move it, with Shift ten times as far. Insert adds one, Delete removes this one.',
  drawBox: 'Draw a box in the chart, or add one below.',
  valueFrom: 'Value from',
  valueTo: 'Value to',
  gradientFrom: 'Gradient from',
  gradientTo: 'Gradient to',
  middleValue: 'Value',
  middleGradient: 'Gradient',
  valueWidth: 'Width, values',
  gradientWidth: 'Width, gradients',
  colorOfPatch: 'Colour of this part',
  addBox: 'Add a box',
  addGaussian: 'Add a Gaussian',
  removePatchTip: 'Delete this part (Delete)',
};
