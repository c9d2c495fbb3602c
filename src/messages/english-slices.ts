import type { SliceMessages } from './messages.ts';

/** English messages of panes with slices. The file is loaded where a page has such panes. */
export const english: SliceMessages = {
  slice: { axial: 'Axial slice', coronal: 'Coronal slice', sagittal: 'Sagittal slice', oblique: 'Oblique slice' },
  sliceAt: (slice, place) => `${slice}, ${place}`,
  millimetres: (length) => `${length} mm`,
  micrometres: (length) => `${length} µm`,
  nanometres: (length) => `${length} nm`,
  slab: {
    average: (thickness) => `average of ${thickness}`,
    max: (thickness) => `maximum of ${thickness}`,
    min: (thickness) => `minimum of ${thickness}`,
  },
  window: (width, level) => `W ${width}  L ${level}`,
  windowWords: ({ width, level, black, white }) =>
    `Window ${width}, level ${level}: black up to ${black}, white from ${white}`,
  windowChoice: 'Window',
  windowNames: {
    abdomen: 'Abdomen',
    bone: 'Bone',
    brain: 'Brain',
    chest: 'Chest',
    head: 'Head',
    liver: 'Liver',
    lung: 'Lung',
    mediastinum: 'Mediastinum',
    neck: 'Neck',
    pelvis: 'Pelvis',
    'soft tissue': 'Soft tissue',
    spine: 'Spine',
    vessels: 'Vessels',
    normal: 'Normal',
    harder: 'Harder',
    softer: 'Softer',
  },
  windowNumber: (number) => `Window ${number}`,
  otherWindow: 'Other',
  sliceKeys:
    'Page up and Page down go from slice to slice, arrow keys move the crosshair, plus and minus zoom, 0 shows all.',
  noValue: 'no value here',
  loading: 'Loading the volume …',
};
