import { brickSide } from '../../bricks/brick-data.ts';
import { brickHalo, bytesOfCell, pageBytes, placeOfSlot, slotSide } from '../../bricks/brick-layout.ts';
import type { AtlasShape } from '../../bricks/brick-layout.ts';
import type { ResidentBrick, ResidentBricks } from '../../bricks/resident-bricks.ts';
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
  readonly #pages: WebGLTexture;
  /** The bricks that are in the atlas, by slot; and the pages that are in the page table. */
  readonly #written: (ResidentBrick | undefined)[] = [];
  #pagesWritten: Uint8Array | null = null;
  #changes = -1;

  constructor(
    readonly gl: WebGL2RenderingContext,
    readonly volume: Pick<VolumeData, 'samples' | 'grid'>,
    readonly bricks: ResidentBricks,
    readonly packing: BrickPacking,
  ) {
    this.#shape = bricks.atlas;
    this.#pages = gl.createTexture();
  }

  get bytes(): number {
    const { width, height, depth } = this.#shape;
    const texels = width * height * (depth + this.#layers * slotSide);
    return texels * this.packing.texels.bytes + pageBytes(this.bricks.layout.cells);
  }

  /** Writes the volume piece by piece. @returns whether there was memory for it */
  *fill(): Upload<boolean> {
    const { gl } = this;
    const [cx, cy, cz] = this.bricks.layout.cells;
    gl.bindTexture(gl.TEXTURE_3D, this.#pages);
    gl.texStorage3D(gl.TEXTURE_3D, 1, gl.RGBA32F, cx, cy, cz);
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
        uFinestLow: shift.map((n, axis) => -n / scale[axis]),
        uFinestHigh: shift.map((n, axis) => (dimensions[axis] - n) / scale[axis]),
        uPerTexel: [1 / width, 1 / height, 1 / (depth + this.#layers * slotSide)],
        uLevelScales: [...bricks.layout.levels.flatMap((level) => level.scale), ...this.volume.grid.dimensions],
        uFinestVoxels: bricks.finest.dimensions,
        uPlaneVoxels: bricks.grid.dimensions,
      },
      units: [unit(this.#atlas!, 'uVolume', this.packing.filter), unit(this.#pages, 'uBrickPages', gl.NEAREST)],
    };
  }

  dispose(): void {
    for (const texture of [this.#atlas, this.#pages]) this.gl.deleteTexture(texture);
    this.#atlas = null;
  }

  #layersOf(slots: number): number {
    return Math.ceil(slots / this.#shape.slotsOfLayer);
  }

  #update(): void {
    const { bricks } = this;
    if (this.#changes === bricks.changes.pages) return;
    this.#changes = bricks.changes.pages;
    const layers = this.#layersOf(bricks.slots);
    const most = this.#layersOf(bricks.capacity);
    if (layers > this.#layers) this.#resize(Math.max(layers, Math.min(growth * this.#layers, most)));
    else if (this.#layers > most) this.#resize(most);
    for (let slot = 0; slot < bricks.slots; slot++) {
      const brick = bricks.inSlot(slot);
      if (brick && brick !== this.#written[slot]) this.#write(brick);
    }
    this.#writePages();
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

  /** The slices of the page table in which something has changed. */
  #writePages(): void {
    const { gl, bricks } = this;
    const { pages } = bricks;
    const [cx, cy, cz] = bricks.layout.cells;
    const before = this.#pagesWritten;
    const texels = new Float32Array(cellFloats * cx * cy);
    gl.bindTexture(gl.TEXTURE_3D, this.#pages);
    prepareUpload(gl);
    for (let k = 0; k < cz; k++) {
      const [first, end] = [k * cx * cy, (k + 1) * cx * cy];
      let changes = !before;
      for (let byte = 4 * first; byte < 4 * end && !changes; byte++) changes = pages[byte] !== before![byte];
      if (!changes) continue;
      for (let cell = first; cell < end; cell++)
        this.#describeCell(cell, texels.subarray(cellFloats * (cell - first), cellFloats * (cell - first + 1)));
      gl.texSubImage3D(gl.TEXTURE_3D, 0, 0, 0, k, cx, cy, 1, gl.RGBA, gl.FLOAT, texels);
    }
    this.#pagesWritten = pages.slice();
  }

  #describeCell(cell: number, into: Float32Array): void {
    const { bricks } = this;
    const { levels } = bricks.layout;
    const slot = bricks.slotOf(cell);
    if (slot < 0) {
      into.fill(brickHalo, 0, 3);
      into[3] = levels.length;
      return;
    }
    const { level, at } = bricks.inSlot(slot)!;
    const { shift } = levels[level];
    const place = placeOfSlot(this.#shape, slot);
    for (let axis = 0; axis < 3; axis++) into[axis] = place[axis] + brickHalo - brickSide * at[axis] + shift[axis];
    into[3] = level;
  }
}
