import type { TextureUnit } from '../renderer/device/texture-unit.ts';

/** The parts of x3dom 1.8.3 that this module uses. It ships no types of its own. */

/** Row-major, `_rc` for row r and column c, in float64. */
export interface X3dMatrix {
  _00: number;
  _01: number;
  _02: number;
  _03: number;
  _10: number;
  _11: number;
  _12: number;
  _13: number;
  _20: number;
  _21: number;
  _22: number;
  _23: number;
  _30: number;
  _31: number;
  _32: number;
  _33: number;
}

export interface X3dVector {
  x: number;
  y: number;
  z: number;
}

export interface X3dNode {
  _vf: Record<string, unknown>;
  _xmlNode: Element | null;
  _nameSpace: { setupTree(element: Element): X3dNode | null };
  addChild(node: X3dNode): void;
  removeChild(node: X3dNode): void;
  nodeChanged(): void;
  fieldChanged(name: string): void;
  updateField(name: string, value: string): void;
}

/** A node type of which only one node is bound at a time. */
export interface X3dBindable extends X3dNode {
  bind(active: boolean): void;
}

export interface X3dViewpoint extends X3dBindable {
  _projMatrix: X3dMatrix | null;
  setView(matrix: X3dMatrix): void;
  resetView(): void;
  getFieldOfView(): number;
  /** In its own coordinates, not the world's. */
  getCenterOfRotation(): X3dVector;
  /** From its own coordinates to the world's. */
  getCurrentTransform(): X3dMatrix;
}

/** A directional, a point or a spot light: fields of the other types are absent. */
export interface X3dLight extends X3dNode {
  _vf: {
    on: boolean;
    color: { r: number; g: number; b: number };
    intensity: number;
    ambientIntensity: number;
    direction?: X3dVector;
    location?: X3dVector;
    attenuation?: X3dVector;
    radius?: number;
    beamWidth?: number;
    cutOffAngle?: number;
  };
  getCurrentTransform(): X3dMatrix;
}

export interface X3dScene extends X3dNode {
  getViewpoint(): X3dViewpoint;
  updateVolume(): void;
}

export interface X3dAppearance {
  _shader?: X3dNode | null;
  _cf: Partial<Record<'blendMode' | 'depthMode' | 'colorMaskMode', { node: Pick<X3dNode, '_vf'> | null }>>;
}

export interface X3dShape extends X3dNode {
  _webgl?: { texture: TextureUnit[]; shader?: { program: WebGLProgram }; primType?: number | number[] };
  _cf: { appearance?: { node: X3dAppearance | null }; geometry?: { node: X3dGeometry } };
  /** In its own coordinates. */
  getVolume(): X3dBox;
  setAllDirty(): void;
}

export interface X3dBox {
  min: X3dVector;
  max: X3dVector;
  isValid(): boolean;
}

/** A geometry's data for the GPU, in parts: `toGL()` of its vectors, or typed arrays. */
export interface X3dGeometry extends X3dNode {
  _mesh: Record<'_positions' | '_normals' | '_colors' | '_texCoords' | '_indices', ArrayLike<number>[]> & {
    _numColComponents: number;
    _numFaces: number;
    _numCoords: number;
    getVolume(): X3dBox;
  };
}

export interface X3dDrawable {
  shape: X3dShape;
  /** To world coordinates. */
  transform: X3dMatrix;
  sortType: string;
}

/** `renderShape(drawable, viewArea, lights, lightCount, viewMatrix, ...)`. */
export type RenderShape = (drawable: X3dDrawable, ...rest: unknown[]) => void;

export interface X3dContext {
  ctx3d: WebGLRenderingContext | WebGL2RenderingContext;
  renderShape: RenderShape;
  stateManager: {
    bindFramebuffer(target: number, framebuffer: WebGLFramebuffer | null): void;
    viewport(x: number, y: number, width: number, height: number): void;
    enable(capability: number): void;
    disable(capability: number): void;
    unsetProgram(): void;
  };
}

export interface X3dDocument {
  _scene: X3dScene & { drawableCollection: { length: number; get(index: number): X3dDrawable } | null };
  _viewarea: {
    _width: number;
    _height: number;
    getProjectionMatrix(): X3dMatrix;
    getWCtoCCMatrix(): X3dMatrix;
    _mixer: { reset(): void };
    animateTo: () => void;
    resetNavHelpers(): void;
  };
  needRender: boolean | number;
  mutationObserver: MutationObserver;
  X3DMutationObserver: MutationObserver;
  onNodeAdded(node: Node, parent: Node): void;
  onNodeRemoved(node: Node, parent: Node): void;
  removeX3DOMBackendGraph(element: Element): void;
  shutdown(gl: X3dContext): void;
  isAnimating(): boolean;
  _nodeBag: { timer: X3dNode[] };
}

export interface X3dRuntime {
  initialize(element: Element, canvas: X3dCanvas): void;
  viewMatrix(): X3dMatrix;
  projectionMatrix(): X3dMatrix;
}

export interface X3dCanvas {
  canvas: HTMLCanvasElement;
  gl: X3dContext | null;
  doc: X3dDocument;
  stateViewer: { updateMethodID: number };
  load(element: Element, index: number, properties: unknown): void;
  tick(time: number): void;
  checkForVRSupport(): void;
}

export interface X3dElement extends HTMLElement {
  hasRuntime?: boolean;
  runtime?: X3dRuntime;
}

export interface X3dom {
  X3DCanvas: {
    new (element: Element, index: number): X3dCanvas;
    prototype: { _createHTMLCanvas(element: Element): HTMLCanvasElement };
  };
  Runtime: new (element: Element, canvas: X3dCanvas) => X3dRuntime;
  Properties: new () => { setProperty(name: string, value: string): void };
  fields: {
    SFMatrix4f: new (...rowMajor: number[]) => X3dMatrix;
    SFVec3f: new (x: number, y: number, z: number) => X3dVector;
    BoxVolume: new (min: X3dVector, max: X3dVector) => X3dBox;
  };
  nodeTypes: Record<string, unknown>;
  debug: { maxLinesToLog: number };
  Utils: { isWebGL2Enabled(): boolean };
  VRControllerManager: { prototype: { _addInlines(): void } };
  isX3DElement(node: Node): boolean;
}

/** The properties that x3dom adds to the elements it knows. */
export interface X3dOwned extends Element {
  _x3domNode?: X3dNode;
}
