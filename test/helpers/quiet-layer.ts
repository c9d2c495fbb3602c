import { fieldProviders } from '../../components/internal/field-providers.ts';
import { VolumeLayer } from '../../src/renderer/layers/volume-layer.ts';
import { createSceneDepth } from '../../src/renderer/ray/modules/scene-depth.ts';

/** The answers of a context without errors. */
const answers: Record<string, unknown> = { getError: 0, isContextLost: false };

/** A WebGL 2 context that accepts every call and draws nothing: for tests that need a list of modules, but no picture. */
export function quietGl(): WebGL2RenderingContext {
  return new Proxy(Object.create(WebGL2RenderingContext.prototype) as WebGL2RenderingContext, {
    get: (_, name) => {
      const constant: unknown = Reflect.get(WebGL2RenderingContext, name);
      return typeof constant === 'number' ? constant : () => answers[String(name)] ?? {};
    },
  });
}

/** A layer that draws nothing, on a device with all abilities. Its list of modules is the same as for a real layer. */
export function createQuietLayer(): VolumeLayer {
  const gl = quietGl();
  const layer = new VolumeLayer(
    gl,
    {
      webgl2: true,
      maxTextureSize: 2 ** 14,
      max3dTextureSize: 2 ** 14,
      floatLinear: true,
      quadPoints: true,
      twoByteLinear: true,
    },
    fieldProviders,
  );
  layer.surfacesModule = createSceneDepth(gl);
  return layer;
}
