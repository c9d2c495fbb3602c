/** The modules that an entry imports statically. */
export const atOnce = { name: 'at-once', tags: /** @type {['$initial']} */ (['$initial']) };

/**
 * How a bundle is split: all modules that an entry imports statically are one file, even if other entries import some of them. This needs
 * fewer requests, and compresses better. Comments for other bundlers are left out.
 * @type {import('vite').Rolldown.OutputOptions}
 */
export const AT_ONCE = { codeSplitting: { groups: [atOnce] }, comments: { annotation: false } };
