import type { BlankMessages } from './blank-messages.ts';

/** English messages for pictures in which nothing is visible. The file is loaded with the first such picture. */
export const english: BlankMessages = {
  blankPicture: 'Nothing to see here.',
  blankCauses: {
    noData: 'The file has no values: all of its voxels are marked as having no data.',
    transparent:
      'The transfer function is transparent everywhere: its opacities have to be above 0 (transfer-function).',
    values: (low, high) =>
      `All values, from ${low} to ${high}, are transparent. Another value-window or transfer-function would show them.`,
    labels: 'All labels are hidden.',
    cut: 'All that would show is cut away (region, slices, clips).',
    sight: 'The volume is out of sight (camera-orbit, camera-target).',
    faint: 'The volume is too faint to see. A larger opacity-factor would show it.',
    noEchoes: 'The scan has no echoes.',
    weakEchoes: (value) => `No echoes from ${value} on, where the colours begin.`,
  },
};
