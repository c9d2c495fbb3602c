import type { Volume } from '../../src/volume/volume.ts';
import { comparePictures } from './compare-pictures.ts';
import type { PaperFactors, StudyGl, StudyPicture } from './study-gl.ts';

/** Pixels along each side, steps of the paper's method, and tries of the search. */
const search = { size: 64, steps: 200, coarse: 20, fine: 10 } as const;

/** Tried from this to its inverse, times a factor that would be about right. */
const min = 1 / 50;

/**
 * The paper's opacity and light factors have no unit and know no length, so a person sets them by eye. Here those are
 * taken that come closest to the limit: the paper's method at its best. O_f is searched by steps over decades, then by
 * the golden section; for each the best L_f is known.
 * @param limit - the limit's picture; it is drawn again, smaller
 */
export async function fitPaperFactors(
  gl: StudyGl,
  limit: StudyPicture,
  eightBits: Volume,
  signal: AbortSignal,
): Promise<PaperFactors> {
  const { size, steps, coarse, fine } = search;
  const wanted = await gl.draw(limit, size, signal);
  const max = Math.max(...limit.transferFunction.map((stop) => stop.opacity));
  const guess = (0.5 * limit.rays.diameter * max) / limit.referenceLength;
  const errorAt = async (exponent: number): Promise<{ error: number; paper: PaperFactors }> => {
    const opacity = guess * Math.exp(exponent);
    const paper = { opacity, light: 1 };
    const picture = await gl.draw({ ...limit, volume: eightBits, method: 'printed', steps, paper }, size, signal);
    const light = brighten(picture, wanted);
    return { error: comparePictures(picture, wanted).rms, paper: { opacity, light } };
  };
  const stride = (-2 * Math.log(min)) / coarse;
  let center = 0;
  let best = { error: Infinity, paper: { opacity: guess, light: 1 } };
  const attempt = async (exponent: number): Promise<number> => {
    const result = await errorAt(exponent);
    if (result.error < best.error) [best, center] = [result, exponent];
    return result.error;
  };
  for (let i = 0; i <= coarse; i++) await attempt(Math.log(min) + i * stride);
  const ratio = (Math.sqrt(5) - 1) / 2;
  let [low, high] = [center - stride, center + stride];
  for (let i = 0; i < fine; i++) {
    const left = high - ratio * (high - low);
    const right = low + ratio * (high - low);
    if ((await attempt(left)) < (await attempt(right))) high = right;
    else low = left;
  }
  return best.paper;
}

/** Multiply a picture's colours by what brings them closest to those wanted; returns that factor. */
function brighten(picture: Float32Array, wanted: Float32Array): number {
  let product = 0;
  let square = 0;
  for (let i = 0; i < picture.length; i++) {
    if (i % 4 === 3) continue;
    product += picture[i] * wanted[i];
    square += picture[i] ** 2;
  }
  const light = square > 0 ? product / square : 1;
  for (let i = 0; i < picture.length; i++) if (i % 4 < 3) picture[i] = Math.min(1, picture[i] * light);
  return light;
}
