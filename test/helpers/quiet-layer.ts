import { fieldProviders } from '../../components/internal/field-providers.ts';
import { VolumeLayer } from '../../src/renderer/layers/volume-layer.ts';
import { createSceneDepth } from '../../src/renderer/ray/modules/scene-depth.ts';

/** The answers of a context without errors. */
const answers: Record<string, unknown> = { getError: 0, isContextLost: false };

// Node has no WebGL: there another class has its name, by which a context of version 2 is known.
globalThis.WebGL2RenderingContext ??= class {
  isContextLost = (): boolean => false;
} as unknown as typeof WebGL2RenderingContext;

/** Constants that no class has, each a number of its own. */
const constants = new Map<string, number>();

/**
 * A WebGL 2 context that accepts every call and draws nothing: for tests that need a list of modules, or the numbers of their twins, but no
 * picture. It works in Node, too.
 */
export function quietGl(): WebGL2RenderingContext {
  return new Proxy(Object.create(WebGL2RenderingContext.prototype) as WebGL2RenderingContext, {
    get: (_, name) => {
      const constant: unknown = Reflect.get(WebGL2RenderingContext, name);
      if (typeof constant === 'number') return constant;
      if (typeof name === 'string' && /^[A-Z][A-Z0-9_]*$/.test(name)) {
        if (!constants.has(name)) constants.set(name, 0x10000 + constants.size);
        return constants.get(name);
      }
      return () => answers[String(name)] ?? {};
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
