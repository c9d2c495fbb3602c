import { fieldProviders } from '../../components/internal/field-providers.ts';
import { VolumeLayer } from '../../src/renderer/layers/volume-layer.ts';
import { createSceneDepth } from '../../src/renderer/ray/modules/scene-depth.ts';

/** What a context says that is well. */
const answers: Record<string, unknown> = { getError: 0, isContextLost: false };

/** A WebGL 2 context that takes everything and draws nothing: for lists of modules of which no picture is wanted. */
export function quietGl(): WebGL2RenderingContext {
  return new Proxy(Object.create(WebGL2RenderingContext.prototype) as WebGL2RenderingContext, {
    get: (_, name) => {
      const constant: unknown = Reflect.get(WebGL2RenderingContext, name);
      return typeof constant === 'number' ? constant : () => answers[String(name)] ?? {};
    },
  });
}

/** A layer that draws nothing, on a device that can do all: its list of modules is that of any. */
export function createQuietLayer(): VolumeLayer {
  const gl = quietGl();
  const layer = new VolumeLayer(gl, { webgl2: true, maxTextureSize: 2 ** 14, max3dTextureSize: 2 ** 14, floatLinear: true, quadPoints: true, twoByteLinear: true }, fieldProviders);
  layer.surfacesModule = createSceneDepth(gl);
  return layer;
}
