import { brickHalo, brickSide, slotSide } from '../../bricks/brick-data.ts';
import { halvingsOf, placeOfSlot } from '../../bricks/brick-layout.ts';
import type { AtlasShape } from '../../bricks/brick-layout.ts';
import {
  bytesOfCell,
  layersOfTable,
  mostLayersOfTable,
  placeOfBlock,
  shapeTable,
  tableBytes,
  tableDepth,
} from '../../bricks/page-table.ts';
import type { TableShape } from '../../bricks/page-table.ts';
import type { ResidentBrick, ResidentBricks } from '../../bricks/resident-bricks.ts';
import type { Vector3 } from '../../volume/matrix.ts';
import { allocateLike } from '../../volume/samples.ts';
import type { Samples, VolumeData } from '../../volume/volume.ts';
import type { ProgramInputs } from '../device/inputs.ts';
import { textureUnit } from '../device/texture-unit.ts';
import { finishUpload, pieceBytes, pixelsOf, prepareUpload } from './fill-texture.ts';
import type { Texels, Upload } from './fill-texture.ts';

/** A larger atlas is so many times as large, if there may be so many slots: all bricks have to be written again. */
const growth = 4;

/** Floats of a cell in the page table. */
const cellFloats = bytesOfCell / 4;

/** What the page table adds to a scale. Twin: shaders/chunks/field/bricks-3d.glsl, LACKING */
const lacking = ({ hasNoData }: Pick<VolumeData, 'hasNoData'>): number => (hasNoData ? 4096 : 0);

/** How the page table says halvings along x, y and z. Twin: shaders/chunks/field/bricks-3d.glsl, scaleOf */
const packHalvings = ([x, y, z]: Vector3): number => x + 16 * y + 256 * z;

/** How samples become texels. */
export interface BrickPacking {
  readonly texels: Texels;
  readonly filter: number;
  pack(samples: Samples): Samples;
}

/** A volume and its bricks on the GPU: an atlas, and the page table of their cells, both 3D textures. WebGL 2 only. Call `fill` first. */
export class BrickTextures {
  readonly #shape: AtlasShape;
  #atlas: WebGLTexture | null = null;
  #layers = 0;
  readonly #table: TableShape;
  /** How the page table says which scale a brick of a level has; the last one is that of the volume. */
  readonly #scaleCodes: readonly number[];
  #pages: WebGLTexture | null = null;
  #blockLayers = 0;
  /** The bricks that are in the atlas, by slot; and the last changes that the atlas and the table have. */
  readonly #written: (ResidentBrick | undefined)[] = [];
  #changes = -1;
  #tableChanges = -1;

  constructor(
    readonly gl: WebGL2RenderingContext,
    readonly volume: Pick<VolumeData, 'samples' | 'grid'>,
    readonly bricks: ResidentBricks,
    readonly packing: BrickPacking,
  ) {
    this.#shape = bricks.atlas;
    this.#table = shapeTable(bricks.layout);
    const { levels } = bricks.layout;
    this.#scaleCodes =
      halvingsOf(bricks.layout, volume.grid.dimensions)?.map(packHalvings) ??
      Array.from({ length: levels.length + 1 }, (_, level) => level);
    bricks.fitted.add(this.#shrink);
  }

  get bytes(): number {
    const { width, height, depth } = this.#shape;
    const texels = width * height * (depth + this.#layers * slotSide);
    return texels * this.packing.texels.bytes + this.#bytesOfTable;
  }

  /** Writes the volume piece by piece. @returns whether there was memory for it */
  *fill(): Upload<boolean> {
    this.#allocateTable(layersOfTable(this.#table, this.bricks.pages.blockCount));
    if (!this.#allocate(Math.min(1, this.#layersOf(this.bricks.capacity)))) return false;
    yield* this.#writeVolume();
    return true;
  }

  /** What programs read, with the bricks that came since. */
  inputs(): ProgramInputs {
    this.#update();
    const { gl, bricks } = this;
    const {
      cells,
      levels: [{ scale, shift, dimensions }],
    } = bricks.layout;
    const { width, height, depth } = this.#shape;
    const unit = (texture: WebGLTexture, samplerName: string, filter: number) =>
      textureUnit(gl, { type: gl.TEXTURE_3D, texture, filter, samplerName });
    return {
      uniforms: {
        uCellScale: scale.map((n) => n / brickSide),
        uCellShift: shift.map((n) => n / brickSide),
        uLastCell: cells.map((n) => n - 0.5),
        uPerGroup: 1 / this.#table.side,
        uFinestLow: shift.map((n, axis) => -n / scale[axis]),
        uFinestHigh: shift.map((n, axis) => (dimensions[axis] - n) / scale[axis]),
        uPerTexel: [1 / width, 1 / height, 1 / (depth + this.#layers * slotSide)],
        uLevelScales: [...bricks.layout.levels.flatMap((level) => level.scale), ...this.volume.grid.dimensions],
        uFinestVoxels: bricks.finest.dimensions,
        uPlaneVoxels: bricks.grid.dimensions,
      },
      units: [unit(this.#atlas!, 'uVolume', this.packing.filter), unit(this.#pages!, 'uBrickPages', gl.NEAREST)],
    };
  }

  /** What the view may no longer have is given back before its next picture. */
  readonly #shrink = (): void => {
    const most = this.#layersOf(this.bricks.capacity);
    if (this.#atlas && this.#layers > most) this.#resize(most);
  };

  dispose(): void {
    this.bricks.fitted.delete(this.#shrink);
    for (const texture of [this.#atlas, this.#pages]) this.gl.deleteTexture(texture);
    [this.#atlas, this.#pages] = [null, null];
  }

  #layersOf(slots: number): number {
    return Math.ceil(slots / this.#shape.slotsOfLayer);
  }

  #update(): void {
    const { bricks } = this;
    if (this.#changes === bricks.changes) return;
    const layers = this.#layersOf(bricks.slots);
    const most = this.#layersOf(bricks.capacity);
    if (layers > this.#layers) this.#resize(Math.max(layers, Math.min(growth * this.#layers, most)));
    for (let slot = 0; slot < bricks.slots; slot++) {
      const brick = bricks.inSlot(slot);
      if (brick && brick !== this.#written[slot]) this.#write(brick);
    }
    this.#writeTable();
    this.#changes = bricks.changes;
  }

  get #bytesOfTable(): number {
    return tableBytes(this.#table, this.#blockLayers);
  }

  /** A table of another size is written again. @param layers - of blocks */
  #allocateTable(layers: number): void {
    const { gl } = this;
    const { width, height } = this.#table;
    this.#blockLayers = layers;
    gl.deleteTexture(this.#pages);
    this.#pages = gl.createTexture();
    gl.bindTexture(gl.TEXTURE_3D, this.#pages);
    gl.texStorage3D(gl.TEXTURE_3D, 1, gl.RGBA32F, width, height, tableDepth(this.#table, layers));
    this.#tableChanges = -1;
    this.bricks.bytesOnGpu = this.bytes;
  }

  /** An atlas of another size is filled again: WebGL has no quick way to copy a 3D texture, and the samples are kept for picks anyway. */
  #resize(layers: number): void {
    const before = this.#layers;
    if (!this.#allocate(layers)) {
      // The GPU has no memory for more: what no longer fits goes.
      this.#allocate(before);
      this.bricks.maxSlots = before * this.#shape.slotsOfLayer;
      this.bricks.fit(this.bricks.maxSlots);
    }
    finishUpload(this.#writeVolume());
    // No brick is in it.
    this.#changes = -1;
  }

  /** @returns whether there was memory for it */
  #allocate(layers: number): boolean {
    const { gl } = this;
    const { width, height, depth } = this.#shape;
    gl.deleteTexture(this.#atlas);
    this.#atlas = gl.createTexture();
    this.#written.length = 0;
    this.#layers = layers;
    this.bricks.bytesOnGpu = this.bytes;
    gl.bindTexture(gl.TEXTURE_3D, this.#atlas);
    gl.texStorage3D(gl.TEXTURE_3D, 1, this.packing.texels.internal, width, height, depth + layers * slotSide);
    return gl.getError() !== gl.OUT_OF_MEMORY;
  }

  /** The volume with its halo: voxels outside have the value of the nearest one inside. */
  *#writeVolume(): Upload<void> {
    const {
      samples,
      grid: {
        dimensions: [nx, ny, nz],
      },
    } = this.volume;
    const [width, height] = [nx + 2 * brickHalo, ny + 2 * brickHalo];
    const inside = (n: number, size: number): number => Math.min(size - 1, Math.max(0, n - brickHalo));
    const atOnce = Math.max(1, Math.floor(pieceBytes / (width * height * samples.BYTES_PER_ELEMENT)));
    const { depth } = this.#shape;
    for (let first = 0; first < depth; first += atOnce) {
      const slices = Math.min(atOnce, depth - first);
      const piece = allocateLike(samples, width * height * slices);
      for (let k = 0, to = 0; k < slices; k++)
        for (let j = 0; j < height; j++, to += width) {
          const from = nx * (inside(j, ny) + ny * inside(first + k, nz));
          piece.set(samples.subarray(from, from + nx), to + brickHalo);
          piece.fill(samples[from], to, to + brickHalo);
          piece.fill(samples[from + nx - 1], to + brickHalo + nx, to + width);
        }
      this.#writeBlock([0, 0, first], [width, height, slices], piece);
      yield piece.byteLength;
    }
  }

  #write(brick: ResidentBrick): void {
    this.#writeBlock(placeOfSlot(this.#shape, brick.slot), [slotSide, slotSide, slotSide], brick.samples);
    this.#written[brick.slot] = brick;
  }

  #writeBlock([x, y, z]: readonly number[], [nx, ny, nz]: readonly number[], samples: Samples): void {
    const { gl } = this;
    const { format, type } = this.packing.texels;
    const pixels = pixelsOf(this.packing.pack(samples));
    gl.bindTexture(gl.TEXTURE_3D, this.#atlas);
    prepareUpload(gl);
    gl.texSubImage3D(gl.TEXTURE_3D, 0, x, y, z, nx, ny, nz, format, type, pixels);
  }

  /** What has changed of the table: layers of groups, and blocks. */
  #writeTable(): void {
    const { pages } = this.bricks;
    const needed = layersOfTable(this.#table, pages.blockCount);
    const most = mostLayersOfTable(this.bricks.layout, this.bricks.capacity);
    if (needed > this.#blockLayers) this.#allocateTable(Math.max(needed, Math.min(growth * this.#blockLayers, most)));
    const seen = this.#tableChanges;
    const [gx, gy, gz] = pages.groups;
    const perLayer = gx * gy;
    for (let k = 0; k < gz; k++) {
      if (pages.changesOfLayers[k] <= seen) continue;
      const layer = pages.directory.subarray(perLayer * k, perLayer * (k + 1));
      this.#writeTexels([0, 0, k], [gx, gy, 1], layer);
    }
    const { side } = pages;
    for (let block = 0; block < pages.blockCount; block++)
      if (pages.changesOfBlocks[block] > seen)
        this.#writeTexels(placeOfBlock(this.#table, block), [side, side, side], pages.block(block));
    this.#tableChanges = pages.changes;
  }

  #writeTexels([x, y, z]: Vector3, [nx, ny, nz]: Vector3, numbers: Int32Array): void {
    const { gl } = this;
    const texels = new Float32Array(cellFloats * numbers.length);
    numbers.forEach((number, n) => this.#describe(number, texels.subarray(cellFloats * n, cellFloats * (n + 1))));
    gl.bindTexture(gl.TEXTURE_3D, this.#pages);
    prepareUpload(gl);
    gl.texSubImage3D(gl.TEXTURE_3D, 0, x, y, z, nx, ny, nz, gl.RGBA, gl.FLOAT, texels);
  }

  /** A texel of the table. @param number - as the directory of `CellNumbers` has it */
  #describe(number: number, into: Float32Array): void {
    const { layout, pages } = this.bricks;
    if (number < 0) {
      const block = -1 - number;
      const [gx, gy] = pages.groups;
      const group = pages.groupsOfBlocks[block];
      const at = [group % gx, Math.floor(group / gx) % gy, Math.floor(group / (gx * gy))];
      placeOfBlock(this.#table, block).forEach((n, axis) => (into[axis] = n - pages.side * at[axis]));
      into[3] = -1;
      return;
    }
    const brick = this.bricks.inSlot(number - 1);
    if (!brick) {
      into.fill(brickHalo, 0, 3);
      into[3] = this.#scaleCodes[layout.levels.length] + lacking(this.bricks.volume);
      return;
    }
    const { level, at, slot } = brick;
    const { shift } = layout.levels[level];
    const place = placeOfSlot(this.#shape, slot);
    for (let axis = 0; axis < 3; axis++) into[axis] = place[axis] + brickHalo - brickSide * at[axis] + shift[axis];
    into[3] = this.#scaleCodes[level] + lacking(brick);
  }
}
