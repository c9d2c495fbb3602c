// Scenes of tests are drawn without what measures errors, with which this comes.
import { AdaptivePicture } from '../../src/renderer/pictures/adaptive-picture.ts';
import { provideCoarsePictures } from '../../src/renderer/pictures/adaptive-provider.ts';
import { cuttingSteps } from '../../src/renderer/ray/substep-part.ts';
import { provideSubsteps } from '../../src/renderer/ray/substep-provider.ts';

provideSubsteps(cuttingSteps);
provideCoarsePictures((gl) => new AdaptivePicture(gl));
