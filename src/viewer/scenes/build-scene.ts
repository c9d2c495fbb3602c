import { VolumeViewError } from '../../core/errors.ts';
import type { Volume } from '../../volume/volume.ts';
import type { Scene } from '../model/scene.ts';
import type { ViewSocket } from '../model/view-socket.ts';
import { styleOf } from '../model/volume-info.ts';
import type { VolumeOptics } from '../model/volume-info.ts';

/** What a scene must contain; it may change while the scene is built. */
export interface SceneContents {
  /** Not null as long as a scene is needed. */
  readonly volume: Volume | null;
  /** Not null as long as a scene is needed. */
  readonly optics: VolumeOptics | null;
  /** The parts that also belong in the scene. */
  readonly socket: Pick<ViewSocket, 'version' | 'applyTo'>;
  /** Whether a scene is no longer needed. */
  readonly givenUp: boolean;
}

/** The number of contexts that may be lost while a volume is put into them; after that, building is given up. */
const maxLost = 3;

/**
 * Make a scene and put the volume into it. If the context is lost meanwhile, make another scene.
 * @param comes - resolves with whether the volume, which may still be loading, has come; it may use the scene meanwhile
 * @param put - gets the scene as soon as it is complete; never called if the scene is no longer needed
 * @throws {VolumeViewError} `webgl/context-lost`, and what making a scene throws
 */
export async function buildScene(
  create: () => Promise<Scene>,
  contents: SceneContents,
  comes: (scene: Scene) => Promise<boolean>,
  put: (scene: Scene) => void,
): Promise<void> {
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

/** @returns whether `put` got the scene, with the latest volume and what its optics need; false where the context was lost */
async function fillScene(scene: Scene, contents: SceneContents, put: (scene: Scene) => void): Promise<boolean> {
  const { socket } = contents;
  for (;;) {
    const [volume, optics, version] = [contents.volume!, contents.optics!, socket.version];
    await scene.prepare(volume, optics);
    await scene.setAppearance({ optics, style: styleOf(optics) });
    await socket.applyTo(scene);
    const isThere = await scene.bringVolume(volume, () => contents.givenUp || volume !== contents.volume);
    const isSame = volume === contents.volume && optics === contents.optics && version === socket.version;
    if (!contents.givenUp && !isSame) continue;
    const isReady = isThere && !contents.givenUp;
    if (isReady) put(scene); // At once: a moment later there may be another volume, and nobody would report it to the scene.
    return isReady;
  }
}

/** The error of a context that was lost and did not come back. */
export function contextLost(cause?: unknown): VolumeViewError {
  return new VolumeViewError('webgl/context-lost', 'the graphics driver stopped; reload the page', { cause });
}
