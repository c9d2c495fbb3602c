import type { StudyMethod } from '../../src/renderer/study.ts';
import { StudyPictures } from './pictures.ts';

const gap = 8;

/**
 * The limit and three methods side by side, and below each method its amplified difference from the limit.
 * @param size - pixels along each side of a picture
 */
export async function drawSheet(what: {
  scene: string;
  fn: string;
  steps: number;
  size: number;
}): Promise<HTMLCanvasElement> {
  const { size } = what;
  const canvas = document.createElement('canvas');
  canvas.width = 4 * size + 3 * gap;
  canvas.height = 2 * size + gap;
  const context = canvas.getContext('2d')!;
  const pictures = new StudyPictures(size);
  try {
    for (const [i, method] of (['printed', 'plain', 'shipped'] satisfies StudyMethod[]).entries()) {
      const { picture, limit, difference } = await pictures.draw({ ...what, method }, new AbortController().signal);
      if (i === 0) context.putImageData(limit, 0, 0);
      const left = (i + 1) * (size + gap);
      context.putImageData(picture, left, 0);
      context.putImageData(difference, left, size + gap);
    }
  } finally {
    pictures.dispose();
  }
  return canvas;
}
