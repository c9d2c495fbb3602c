// Scenes of tests are drawn without what measures errors, with which this comes.
import { cuttingSteps } from '../../src/renderer/ray/substep-part.ts';
import { provideSubsteps } from '../../src/renderer/ray/substep-provider.ts';

provideSubsteps(cuttingSteps);
