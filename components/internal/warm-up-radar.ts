// Loads the code for the picture of a radar in parallel, while the radar's file is read. Without this, the modules would load one after the
// other.
import { fieldProviders } from './field-providers.ts';

const parts = [
  import('../../src/optics/transfer/presets.ts').then(({ readTransferFunction }) =>
    readTransferFunction('radar-dbz', [0, 1]),
  ),
  import('../../src/viewer/cuts/read-cuts.ts'),
  import('../../src/viewer/view/precompile.ts'),
  import('../../src/renderer/ray/modules/classifiers.ts'),
  import('../../src/x3d/other-shapes.ts'),
  fieldProviders.polar!(),
];

for (const part of parts) part.catch(() => {}); // The error is reported when the module is needed.
