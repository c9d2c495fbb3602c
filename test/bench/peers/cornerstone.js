// Cornerstone's loader of DICOM, as its viewers use it: each file becomes an image, decoded in workers, of which all are asked for at once.
import { imageLoader, metaData } from '@cornerstonejs/core';
import { init, wadouri } from '@cornerstonejs/dicom-image-loader';

/**
 * All slices in one array, in the order of their places.
 * @param {FileList} files
 */
export async function openFolder(files) {
  init();
  const found = await Promise.all(
    Array.from(files, async (file) => {
      const id = wadouri.fileManager.add(file);
      const image = await imageLoader.loadAndCacheImage(id);
      const { imagePositionPatient } = metaData.get('imagePlaneModule', id);
      return { z: imagePositionPatient[2], numbers: image.getPixelData() };
    }),
  );
  found.sort((a, b) => a.z - b.z);
  const size = found[0].numbers.length;
  const all = new found[0].numbers.constructor(size * found.length);
  found.forEach(({ numbers }, k) => all.set(numbers, k * size));
  return all;
}
