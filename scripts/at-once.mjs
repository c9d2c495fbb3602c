/** What an entry imports at once. */
export const atOnce = { name: 'at-once', tags: /** @type {['$initial']} */ (['$initial']) };

/**
 * How a bundle is split: what an entry imports at once is one file, whoever else imports parts of it. That is fewer requests,
 * and it packs better.
 * @type {import('vite').Rolldown.OutputOptions}
 */
export const AT_ONCE = { codeSplitting: { groups: [atOnce] } };
