// What OME-XML says of the pixels. Source: the OME data model, 2016-06, https://docs.openmicroscopy.org/ome-model
import { corruptFile, unsupportedFile } from '../base/file-problem.ts';
import { readXml } from '../base/read-xml.ts';
import { what } from './tiff-file.ts';

/** Pages that a TiffData element names. */
export interface OmePart {
  /** The first page; undefined for that of the part before, and one more. */
  readonly page: number | undefined;
  /** Where it belongs: channel, slice and time. */
  readonly c: number;
  readonly z: number;
  readonly t: number;
  readonly count: number | undefined;
}

/** The first image of a file. */
export interface OmePixels {
  readonly sizes: Readonly<Record<'C' | 'Z' | 'T', number>>;
  /** 'XYZCT': which of them changes first from page to page. */
  readonly order: string;
  /** Numbers of a pixel that lie in one page, for each channel. */
  readonly samples: readonly number[];
  readonly parts: readonly OmePart[];
  /** Lengths as they stand in the file, with their units. */
  readonly lengths: readonly (readonly [length: number, unit: string])[];
  readonly increment: readonly [time: number, unit: string];
  /** The number of images in the file. */
  readonly images: number;
}

export const isOme = (description: string): boolean =>
  /^\s*(<\?xml[^>]*>\s*)?(<!--[^]*?-->\s*)?<(\w+:)?OME[\s>]/.test(description.slice(0, 4096));

/** More planes than any file has. */
const maxSize = 2 ** 24;

/** @throws {VolumeViewError} `format/corrupt`, `format/unsupported` */
export function readOmePixels(xml: string): OmePixels {
  const reader = new PixelsReader();
  try {
    readXml(xml, reader);
  } catch (cause) {
    if (!(cause instanceof SyntaxError)) throw cause;
    throw corruptFile(what, `has a description (OME-XML) that can not be read: ${cause.message}`);
  }
  return reader.finish();
}

type Attributes = ReadonlyMap<string, string>;

const number = (attributes: Attributes, name: string): number | undefined =>
  attributes.has(name) ? Number(attributes.get(name)) : undefined;

class PixelsReader {
  #images = 0;
  #pixels: Attributes | null = null;
  #isOpen = false;
  #uuid: string | null = null;
  #inUuid = false;
  #others = false;
  readonly #samples: number[] = [];
  readonly #parts: OmePart[] = [];

  open(prefixed: string, attributes: Attributes): void {
    const name = prefixed.slice(prefixed.indexOf(':') + 1);
    if (name === 'OME') this.#uuid = attributes.get('UUID') ?? null;
    if (name === 'BinaryOnly')
      throw unsupportedFile(
        what,
        'says that another file describes it (BinaryOnly); join the files: bfconvert in.companion.ome out.ome.tif',
      );
    if (name === 'Image') this.#images++;
    if (this.#images !== 1) return;
    if (name === 'Pixels' && !this.#pixels) {
      this.#pixels = attributes;
      this.#isOpen = true;
    }
    if (!this.#isOpen) return;
    if (name === 'Channel') this.#samples.push(number(attributes, 'SamplesPerPixel') ?? 1);
    if (name === 'TiffData')
      this.#parts.push({
        page: number(attributes, 'IFD'),
        c: number(attributes, 'FirstC') ?? 0,
        z: number(attributes, 'FirstZ') ?? 0,
        t: number(attributes, 'FirstT') ?? 0,
        count: number(attributes, 'PlaneCount'),
      });
    this.#inUuid = name === 'UUID';
  }

  text(text: string): void {
    if (this.#inUuid && this.#uuid !== null && text.trim() !== '' && text.trim() !== this.#uuid) this.#others = true;
  }

  close(prefixed: string): void {
    this.#inUuid = false;
    if (prefixed.endsWith('Pixels')) this.#isOpen = false;
  }

  finish(): OmePixels {
    const pixels = this.#pixels;
    if (!pixels) throw corruptFile(what, 'has a description (OME-XML) without Pixels');
    if (this.#others)
      throw unsupportedFile(
        what,
        'names pages in other files (OME-TIFF of several files); join them: bfconvert in.ome.tif out.ome.tif',
      );
    const size = (name: string): number => number(pixels, name) ?? NaN;
    const sizes = { C: size('SizeC'), Z: size('SizeZ'), T: size('SizeT') };
    if (
      !Object.values(sizes).every((n) => Number.isSafeInteger(n) && n >= 1 && n <= maxSize) ||
      sizes.C * sizes.Z * sizes.T > maxSize
    )
      throw corruptFile(
        what,
        `got ${sizes.C} channels, ${sizes.Z} slices and ${sizes.T} times in its description (OME-XML); expected whole numbers from 1`,
      );
    const order = pixels.get('DimensionOrder') ?? '';
    if (!/^XY(ZCT|ZTC|CZT|CTZ|TZC|TCZ)$/.test(order))
      throw corruptFile(
        what,
        'has a DimensionOrder in its description (OME-XML) that is none; expected one like XYZCT',
      );
    return {
      sizes,
      order,
      samples: this.#samples,
      parts: this.#parts,
      lengths: ['X', 'Y', 'Z'].map((axis) => [
        size(`PhysicalSize${axis}`),
        pixels.get(`PhysicalSize${axis}Unit`) ?? '\u00b5m',
      ]),
      increment: [size('TimeIncrement'), pixels.get('TimeIncrementUnit') ?? 's'],
      images: this.#images,
    };
  }
}
