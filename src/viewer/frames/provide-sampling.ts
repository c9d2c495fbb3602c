// What the renderer gets with the code that chooses steps: coarse pictures at once, cut steps where they are needed.
import { loadPart } from '../../core/load-part.ts';
import { AdaptivePicture } from '../../renderer/pictures/adaptive-picture.ts';
import { provideCoarsePictures } from '../../renderer/pictures/adaptive-provider.ts';
import { provideSubsteps } from '../../renderer/ray/substep-provider.ts';

provideCoarsePictures((gl) => new AdaptivePicture(gl));

/**
 * Load the code that cuts steps by the values at their ends: only a few levels, and steps that an author gives, need it.
 * @throws {VolumeViewError} `format/unsupported`
 */
export async function loadSubsteps(): Promise<void> {
  const { cuttingSteps } = await loadPart(import('../../renderer/ray/substep-part.ts'), 'cuts steps');
  provideSubsteps(cuttingSteps);
}
