import { VolumeViewError } from '../../core/errors.ts';
import type { Volume } from '../../volume/volume.ts';
import type { Scene } from '../model/scene.ts';
import type { ViewSocket } from '../model/view-socket.ts';
import { styleOf } from '../model/volume-info.ts';
import type { VolumeOptics } from '../model/volume-info.ts';

/** What is to be in a scene; it may change while the scene is built. */
export interface SceneContents {
  /** There is one as long as a scene is wanted. */
  readonly volume: Volume | null;
  /** As the volume. */
  readonly optics: VolumeOptics | null;
  /** What else is in it. */
  readonly socket: Pick<ViewSocket, 'version' | 'applyTo'>;
  /** Whether no scene is wanted any more. */
  readonly givenUp: boolean;
}

/** Contexts that may be lost while a volume is on its way into them, until it is given up. */
const maxLost = 3;

/**
 * Make a scene and bring the volume into it. Where the context is lost meanwhile, another one is made.
 * @param comes - whether the volume, which may be on its way, comes after all; it may do something with the scene meanwhile
 * @param put - takes the scene as soon as all is in it; never called where it is no longer wanted
 * @throws {VolumeViewError} `webgl/context-lost`, and what making a scene throws
 */
export async function buildScene(create: () => Promise<Scene>, contents: SceneContents, comes: (scene: Scene) => Promise<boolean>, put: (scene: Scene) => void): Promise<void> {
  for (let lost = 0; lost < maxLost; lost++) {
    const scene = await create();
    let isReady = false;
    try {
      if (!(await comes(scene))) return;
      isReady = await fillScene(scene, contents, put);
    } finally {
      if (!isReady) scene.dispose();
    }
    if (isReady || contents.givenUp) return;
  }
  throw contextLost();
}

/** @returns whether the scene was put, with the volume and what its optics need, whichever they are in the end; not where the context was lost */
async function fillScene(scene: Scene, contents: SceneContents, put: (scene: Scene) => void): Promise<boolean> {
  const { socket } = contents;
  for (;;) {
    const [volume, optics, version] = [contents.volume!, contents.optics!, socket.version];
    await scene.prepare(volume, optics);
    await scene.setStyle(styleOf(optics));
    await socket.applyTo(scene);
    const isThere = await scene.bringVolume(volume, () => contents.givenUp || volume !== contents.volume);
    const isSame = volume === contents.volume && optics === contents.optics && version === socket.version;
    if (!contents.givenUp && !isSame) continue;
    const isReady = isThere && !contents.givenUp;
    if (isReady) put(scene); // At once: a moment later there may be another volume, of which nobody would tell it.
    return isReady;
  }
}

/** The error for a context that went away and did not come back. */
export function contextLost(cause?: unknown): VolumeViewError {
  return new VolumeViewError('webgl/context-lost', 'The graphics driver stopped and did not come back. Reload the page.', { cause });
}
