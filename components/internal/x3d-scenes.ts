import { fieldProviders } from './field-providers.ts';
import { loadX3dom } from '../../src/x3d/load-x3dom.ts';
import { VolumeScene } from '../../src/x3d/scene.ts';
import type { SceneFactory } from '../../src/viewer/model/scene.ts';

/** The code for light, which would load one file after the other once the volume is there. */
const lightParts = (): Promise<unknown>[] => [
  import('../../src/renderer/ray/styles/styles.ts'),
  import('../../src/renderer/ray/styles/light.ts'),
];

/** Creates scenes that x3dom draws. */
export const x3dScenes: SceneFactory = {
  create: (host, container, needsFrame) => VolumeScene.create(host, container, needsFrame, fieldProviders),
  warmUp: (kind) => {
    const parts =
      kind === 'radar' ? [import('./warm-up-radar.ts')] : [loadX3dom(), ...(kind === 'lit' ? lightParts() : [])];
    for (const part of parts) part.catch(() => {});
  },
};
