import { fieldProviders } from './field-providers.ts';
import { loadX3dom } from '../../src/x3d/load-x3dom.ts';
import { VolumeScene } from '../../src/x3d/scene.ts';
import type { SceneFactory } from '../../src/viewer/model/scene.ts';

/** Creates scenes that x3dom draws. */
export const x3dScenes: SceneFactory = {
  create: (host, container, needsFrame) => VolumeScene.create(host, container, needsFrame, fieldProviders),
  warmUp: (isRadar) => void (isRadar ? import('./warm-up-radar.ts') : loadX3dom()).catch(() => {}),
};
