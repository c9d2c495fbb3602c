import { brickSide } from '../../bricks/brick-data.ts';
import { slotSide } from '../../bricks/brick-layout.ts';
import type { ResidentBrick, ResidentBricks } from '../../bricks/resident-bricks.ts';
import type { Samples } from '../../volume/volume.ts';
import type { ProgramInputs } from '../device/inputs.ts';
import { textureUnit } from '../device/texture-unit.ts';
import { pixelsOf, prepareUpload } from './fill-texture.ts';
import type { Texels } from './fill-texture.ts';

/** Slots of the atlas along x and y; along z it grows. */
export const slotColumns = 16;
export const slotRows = 8;

/** The atlas grows by whole layers of slots. */
export const slotsOfLayer = slotColumns * slotRows;

/** A larger atlas is so many times as large, if there may be so many slots: all bricks have to be written again. */
const growth = 4;

const layersOf = (slots: number): number => Math.ceil(slots / slotsOfLayer);

/** Cells in a row of the page table. */
export const pageColumns = 1024;

/** The options that the shader of the textures needs. Twin: shaders/chunks/field/bricks-3d.glsl */
export const brickDefines = {
  BRICKS: 1,
  BRICK_SIDE: brickSide.toFixed(1),
  BRICK_HALO: ((slotSide - brickSide) / 2).toFixed(1),
  SLOT_SIDE: slotSide.toFixed(1),
  SLOT_COLUMNS: slotColumns,
  SLOT_ROWS: slotRows,
  PAGE_COLUMNS: pageColumns,
};

/** How samples become texels. */
export interface BrickPacking {
  readonly texels: Texels;
  readonly filter: number;
  pack(samples: Samples): Samples;
}

/** Bricks on the GPU: an atlas of slots as a 3D texture, and the page table of their cells as a 2D one. WebGL 2 only. */
export class BrickTextures {
  #atlas: WebGLTexture | null = null;
  #layers = 0;
  readonly #pages: WebGLTexture;
  readonly #levels: WebGLTexture;
  /** What is in the textures now. */
  readonly #written: (ResidentBrick | undefined)[] = [];
  #changes = -1;

  constructor(
    readonly gl: WebGL2RenderingContext,
    readonly bricks: ResidentBricks,
    readonly packing: BrickPacking,
  ) {
    this.#pages = gl.createTexture();
    this.#levels = gl.createTexture();
    this.#writeLevels();
    this.#resize(1);
  }

  get bytes(): number {
    return this.#layers * slotsOfLayer * slotSide ** 3 * this.packing.texels.bytes + this.bricks.pages.length;
  }

  /** What programs read, with the bricks that came since. */
  inputs(): ProgramInputs {
    this.#update();
    const { gl, bricks } = this;
    const unit = (type: number, texture: WebGLTexture, samplerName: string, filter: number = gl.NEAREST) =>
      textureUnit(gl, { type, texture, filter, samplerName });
    return {
      uniforms: {
        uBrickCells: bricks.layout.cells,
        uFinestVoxels: bricks.finest.dimensions,
        uPlaneVoxels: bricks.grid.dimensions,
      },
      units: [
        unit(gl.TEXTURE_3D, this.#atlas!, 'uBricks', this.packing.filter),
        unit(gl.TEXTURE_2D, this.#pages, 'uBrickPages'),
        unit(gl.TEXTURE_2D, this.#levels, 'uBrickLevels'),
      ],
    };
  }

  dispose(): void {
    for (const texture of [this.#atlas, this.#pages, this.#levels]) this.gl.deleteTexture(texture);
    this.#atlas = null;
  }

  #update(): void {
    const { bricks } = this;
    if (this.#changes === bricks.changes.pages) return;
    this.#changes = bricks.changes.pages;
    const layers = layersOf(bricks.slots);
    const most = layersOf(bricks.capacity);
    if (layers > this.#layers) this.#resize(Math.max(layers, Math.min(growth * this.#layers, most)));
    else if (this.#layers > most) this.#resize(Math.max(1, most));
    for (let slot = 0; slot < bricks.slots; slot++) {
      const brick = bricks.inSlot(slot);
      if (brick && brick !== this.#written[slot]) this.#write(brick);
    }
    this.#writePages();
  }

  /** An atlas of another size is filled again: WebGL has no quick way to copy a 3D texture, and the samples are kept for picks anyway. */
  #resize(layers: number): void {
    const before = this.#layers;
    if (this.#allocate(layers) || before === 0) return;
    // The GPU has no memory for more: what no longer fits goes.
    this.#allocate(before);
    this.bricks.maxSlots = before * slotsOfLayer;
    this.bricks.fit(this.bricks.maxSlots);
  }

  /** @returns whether there was memory for it */
  #allocate(layers: number): boolean {
    const { gl } = this;
    gl.deleteTexture(this.#atlas);
    this.#atlas = gl.createTexture();
    this.#written.length = 0;
    this.#layers = layers;
    gl.bindTexture(gl.TEXTURE_3D, this.#atlas);
    const [width, height] = [slotColumns * slotSide, slotRows * slotSide];
    gl.texStorage3D(gl.TEXTURE_3D, 1, this.packing.texels.internal, width, height, layers * slotSide);
    return gl.getError() !== gl.OUT_OF_MEMORY;
  }

  #write(brick: ResidentBrick): void {
    const { gl } = this;
    const { slot, samples } = brick;
    const { format, type } = this.packing.texels;
    const place = [slot % slotColumns, Math.floor(slot / slotColumns) % slotRows, Math.floor(slot / slotsOfLayer)].map(
      (n) => n * slotSide,
    );
    gl.bindTexture(gl.TEXTURE_3D, this.#atlas);
    prepareUpload(gl);
    const pixels = pixelsOf(this.packing.pack(samples));
    gl.texSubImage3D(
      gl.TEXTURE_3D,
      0,
      place[0],
      place[1],
      place[2],
      slotSide,
      slotSide,
      slotSide,
      format,
      type,
      pixels,
    );
    this.#written[slot] = brick;
  }

  #writePages(): void {
    const { gl } = this;
    const { pages } = this.bricks;
    const rows = Math.ceil(pages.length / (4 * pageColumns));
    const texels = new Uint8Array(4 * pageColumns * rows);
    texels.set(pages);
    gl.bindTexture(gl.TEXTURE_2D, this.#pages);
    prepareUpload(gl);
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA8, pageColumns, rows, 0, gl.RGBA, gl.UNSIGNED_BYTE, texels);
  }

  #writeLevels(): void {
    const { gl } = this;
    const { levels } = this.bricks.layout;
    const texels = Float32Array.from(
      levels.flatMap(({ scale, shift, dimensions, factors }) =>
        [scale, shift, dimensions, factors].flatMap((vector) => [...vector, 0]),
      ),
    );
    gl.bindTexture(gl.TEXTURE_2D, this.#levels);
    prepareUpload(gl);
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA32F, 4 * levels.length, 1, 0, gl.RGBA, gl.FLOAT, texels);
  }
}
