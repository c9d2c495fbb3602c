/**
 * Make one manifest from several: fields that are the same in all of them are written once, the others with each scan. Times of
 * single sweeps are left out.
 * @param {readonly Record<string, unknown>[]} manifests - in the order of time
 */
export function joinScans(manifests) {
  const [{ sweeps: _, ...first }] = manifests;
  const isShared = (/** @type {string} */ name) =>
    manifests.every((one) => JSON.stringify(one[name]) === JSON.stringify(first[name]));
  const shared = Object.keys(first).filter(isShared);
  const own = Object.keys(first).filter((name) => !isShared(name));
  const pick = (/** @type {Record<string, unknown>} */ from, /** @type {string[]} */ names) =>
    Object.fromEntries(names.map((name) => [name, from[name]]));
  return { ...pick(first, shared), scans: manifests.map((one) => pick(one, own)) };
}
