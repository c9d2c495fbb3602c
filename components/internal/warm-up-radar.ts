// Loads, one beside the other, what the picture of a radar needs, while its file is read: it would come one after the other then.
import { fieldProviders } from './field-providers.ts';

const parts = [
  import('../../src/optics/transfer/presets.ts').then(({ readTransferFunction }) => readTransferFunction('radar-dbz', [0, 1])),
  import('../../src/viewer/cuts/read-cuts.ts'),
  import('../../src/viewer/view/rehearse.ts'),
  import('../../src/renderer/ray/modules/classifiers.ts'),
  import('../../src/x3d/other-shapes.ts'),
  fieldProviders.polar!(),
];

for (const part of parts) part.catch(() => {}); // Told when it is needed.
