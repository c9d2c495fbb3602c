// Larger real data sets are in ../shared/data, next to the checkout, on machines that have them. The dev server, the test runner and the
// end-to-end server all serve that folder at /shared-data/.
import { existsSync, statSync } from 'node:fs';
import { dirname, join, normalize, resolve, sep } from 'node:path';
import { fileURLToPath } from 'node:url';

export const projectRoot = resolve(dirname(fileURLToPath(import.meta.url)), '..');
export const sharedDataPrefix = '/shared-data/';
export const sharedDataFolder = resolve(projectRoot, process.env.VOLUME_VIEW_DATA ?? '../shared/data');

/**
 * The file under `folder` that a URL path names, or null where there is none or the path leaves the folder.
 * @param {string} folder - absolute
 * @param {string} urlPath - percent-encoded, without query
 * @returns {string | null}
 */
export function findFile(folder, urlPath) {
  let decoded;
  try {
    decoded = decodeURIComponent(urlPath);
  } catch {
    return null;
  }
  if (decoded.includes('\0')) return null;
  const file = normalize(join(folder, decoded));
  if (!file.startsWith(folder + sep)) return null;
  return existsSync(file) && statSync(file).isFile() ? file : null;
}

/**
 * The shared data file that a URL path such as `/shared-data/medical/x.nii.gz` names, else null.
 * @param {string} urlPath
 */
export function findSharedData(urlPath) {
  return urlPath.startsWith(sharedDataPrefix)
    ? findFile(sharedDataFolder, urlPath.slice(sharedDataPrefix.length))
    : null;
}
