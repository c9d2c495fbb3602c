// In the package, the code that measures errors loads these parts. Tests draw scenes without that code, so they load them here.
import { AdaptivePicture } from '../../src/renderer/pictures/adaptive-picture.ts';
import { provideCoarsePictures } from '../../src/renderer/pictures/adaptive-provider.ts';
import { cuttingSteps } from '../../src/renderer/ray/substep-part.ts';
import { provideSubsteps } from '../../src/renderer/ray/substep-provider.ts';

provideSubsteps(cuttingSteps);
provideCoarsePictures((gl) => new AdaptivePicture(gl));
