import { unitToWorld } from '../volume/grid.ts';
import { multiply, scaleAndTranslate } from '../volume/matrix.ts';
import type { VolumeData } from '../volume/volume.ts';
import type { Gl } from '../renderer/device/device.ts';
import type { ProgramInputs } from '../renderer/device/inputs.ts';
import { shaderError } from '../renderer/device/program.ts';
import { composeRay, programKey } from '../renderer/ray/compose-ray.ts';
import type { RayProgram } from '../renderer/ray/compose-ray.ts';
import type { X3dDocument, X3dNode, X3dOwned, X3dShape } from './x3dom-types.ts';

/** The content of every element's scene: a viewpoint of its own, a transparent background, and nothing else. */
export function buildScene(): Element {
  return build('scene', {}, [
    build('environment', { frustumCulling: 'false' }),
    build('viewpoint', {}),
    build('navigationinfo', { type: 'NONE', headlight: 'true' }),
    build('background', { transparency: '1', skyColor: '0 0 0' }),
  ]);
}

/**
 * The X3D shape whose ComposedShader casts the rays. Its box gives the scene the volume's bounds. Its front face is
 * drawn over the whole picture, and the shader computes what each ray meets. So the eye may be inside, the near plane
 * cuts nothing, and the box's edges are not polygon edges. It is drawn after all opaque shapes, and before the
 * translucent ones.
 */
export class VolumeShape {
  readonly #root: X3dOwned;
  readonly #shape: X3dShape;
  readonly #shader: X3dNode & { _id: string };
  readonly #parts: { vertex: X3dNode; fragment: X3dNode };
  readonly #checked = new Set<WebGLProgram>();
  /** The key of its program; empty before `use`. */
  #key = '';

  constructor(
    readonly document: X3dDocument,
    volume: VolumeData,
  ) {
    const vertex = build('shaderpart', { type: 'VERTEX' });
    const fragment = build('shaderpart', { type: 'FRAGMENT' });
    const shader = build('composedshader', {}, [vertex, fragment]);
    const shape = build('shape', { isPickable: 'false' }, [
      build('appearance', { sortType: 'transparent', sortKey: '-2000000000' }, [
        build('blendmode', { srcFactor: 'one', destFactor: 'one_minus_src_alpha' }),
        build('depthmode', { enableDepthTest: 'false', readOnly: 'true' }),
        shader,
      ]),
      build('box', { size: '1 1 1', solid: 'true', useGeoCache: 'false' }),
    ]);
    this.#root = build('matrixtransform', { matrix: boundsMatrix(volume) }, [shape]);
    const scene = document._scene;
    scene._xmlNode!.append(this.#root);
    scene.addChild(scene._nameSpace.setupTree(this.#root)!);
    scene.nodeChanged();
    this.#shape = nodeOf(shape);
    this.#shader = nodeOf(shader);
    this.#parts = { vertex: nodeOf(vertex), fragment: nodeOf(fragment) };
  }

  owns(shape: X3dShape): boolean {
    return shape === this.#shape;
  }

  /** Sets the bounds of another volume. */
  setBounds(volume: VolumeData): void {
    this.#root.setAttribute('matrix', boundsMatrix(volume));
  }

  /** Whether it uses this program. */
  has(program: RayProgram): boolean {
    return programKey(program) === this.#key;
  }

  /**
   * Sets the shader's program.
   * @returns false if the program has changed: then the scene has to be drawn again
   */
  use(program: RayProgram): boolean {
    const key = programKey(program);
    if (key === this.#key) return true;
    this.#key = key;
    const texts = composeRay(program);
    (this.#parts.vertex._vf.url as string[])[0] = texts.vertex;
    (this.#parts.fragment._vf.url as string[])[0] = texts.fragment;
    // x3dom caches programs by this name, so that returning to one compiles nothing.
    this.#shader._id = key;
    this.#shader.fieldChanged('url');
    return false;
  }

  /** Sets the inputs of the next drawing. */
  bind({ uniforms, units }: ProgramInputs): void {
    Object.assign(this.#shader._vf, uniforms);
    units.forEach((unit, i) => {
      this.#shader._vf[unit.samplerName] = i;
    });
    this.#shape._webgl!.texture = [...units];
  }

  /**
   * The program that x3dom made; null if there is none yet. x3dom ignores a program that did not compile.
   * @throws {VolumeViewError} `webgl/shader` with the compiler's own message
   */
  checkedProgram(gl: Gl): WebGLProgram | null {
    const program = this.#shape._webgl?.shader?.program;
    if (!program || gl.isContextLost()) return null;
    if (this.#checked.has(program)) return program;
    if (!gl.getProgramParameter(program, gl.LINK_STATUS)) {
      const logs = (gl.getAttachedShaders(program) ?? []).map((shader) => gl.getShaderInfoLog(shader));
      throw shaderError([gl.getProgramInfoLog(program), ...logs].filter(Boolean).join('\n'));
    }
    this.#checked.add(program);
    return program;
  }
}

/** x3dom wants the matrix of the centred unit box column by column. */
function boundsMatrix(volume: VolumeData): string {
  const m = multiply(unitToWorld(volume.grid), scaleAndTranslate([1, 1, 1], [0.5, 0.5, 0.5]));
  return [0, 1, 2, 3].flatMap((column) => [0, 4, 8, 12].map((row) => m[row + column])).join(' ');
}

function build(name: string, attributes: Record<string, string>, children: readonly (Node | string)[] = []): X3dOwned {
  const element = document.createElement(name);
  for (const [attribute, value] of Object.entries(attributes)) element.setAttribute(attribute, value);
  element.append(...children);
  return element;
}

function nodeOf<T extends X3dNode>(element: X3dOwned): T {
  return element._x3domNode as T;
}
