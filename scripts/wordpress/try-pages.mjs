// Shortcodes, hostile attributes, pages without a volume, feeds, and the frames of other sites.
import assert from 'node:assert/strict';
import { read, readPixels, waitForPicture } from './trial.mjs';

/** @param {import('./trial.mjs').Trial} trial */
export async function tryPages(trial) {
  const { site } = trial;
  const urlOf = (/** @type {string} */ name) =>
    site.run(
      `foreach ( get_posts( array( 'post_type' => 'attachment', 'numberposts' => -1 ) ) as $one ) { if ( str_contains( $one->guid, '${name}' ) ) { echo wp_get_attachment_url( $one->ID ); } }`,
    );
  const [head, mosaic] = [urlOf('head.nii'), urlOf('mosaic')];

  /** Writes a post as the author would. @param {string} content @returns {number} */
  const write = (content) =>
    Number(
      site.run(
        `wp_set_current_user( get_user_by( 'login', 'author' )->ID ); kses_init(); echo wp_insert_post( wp_slash( array( 'post_title' => 'Trial', 'post_status' => 'publish', 'post_content' => base64_decode( '${Buffer.from(content).toString('base64')}' ) ) ) );`,
      ),
    );

  // A shortcode and a block show the same.
  const shortcode = await read(
    trial,
    write(`[volume-view src="${head}" alt="Brain" look="skin" controls legend]One[/volume-view]`),
  );
  await waitForPicture(shortcode.page);
  await trial.look(shortcode.page, 'shortcode');
  assert.equal(await shortcode.page.locator('volume-legend').count(), 1);
  const block = { src: head, alt: 'Brain', look: 'skin', controls: true, legend: true, caption: 'One' };
  const same = await read(trial, write(`<!-- wp:volume-view/volume ${JSON.stringify(block)} /-->`));
  await waitForPicture(same.page);
  assert.equal(await readPixels(same.page), await readPixels(shortcode.page));
  console.log('a shortcode shows what a block shows');
  await Promise.all([shortcode, same].map(({ page }) => page.context().close()));

  // A mosaic of the media library is the uploaded image.
  assert.match(mosaic, /-scaled\.jpg$/);
  const large = await read(trial, write(`[volume-view src="${mosaic}" mosaic="8x8" alt="Slope"]`));
  await waitForPicture(large.page);
  const size = await large.page.evaluate(
    () => /** @type {any} */ (document.querySelector('volume-view')).volume.dimensions,
  );
  assert.deepEqual([...size], [400, 400, 64]);
  await large.page.context().close();
  console.log('a mosaic above 2,560 pixels keeps its voxels');

  // A page without a volume loads nothing of the plugin.
  const empty = await read(trial, write('Only words.'));
  assert.deepEqual(
    empty.asked.filter((url) => url.includes('/plugins/volume-view/')),
    [],
  );
  await empty.page.context().close();

  // Hostile attributes, in blocks and in shortcodes, as an author can save them.
  const texts = [
    '"><script>window.hit=1</script>',
    '" onload="window.hit=1',
    "' onerror='window.hit=1",
    'javascript:window.hit=1',
    '</volume-view><img src=x onerror=window.hit=1>',
  ];
  const names = ['src', 'alt', 'poster', 'look', 'camera-orbit', 'width', 'caption', 'className', 'align', 'rings'];
  const posts = texts.flatMap((text) =>
    names.flatMap((name) => [
      `<!-- wp:volume-view/volume ${JSON.stringify({ src: head, [name]: text })
        .replaceAll('--', '\\u002d\\u002d')
        .replaceAll('<', '\\u003c')
        .replaceAll('>', '\\u003e')} /-->`,
      `[volume-view src="${head}" ${name}="${text}"]`,
      `[volume-view src='${head}' ${name}='${text}' ${text}]`,
      `<!-- wp:volume-view/volume ${JSON.stringify({ [name]: text, src: head, onload: text, style: text })} /-->`,
    ]),
  );
  const hostile = await read(trial, write(posts.join('\n\n')));
  await hostile.page.waitForTimeout(1500);
  const found = await hostile.page.evaluate(() => ({
    hit: /** @type {any} */ (window).hit,
    views: document.querySelectorAll('volume-view').length,
    handlers: [...document.querySelectorAll('*')]
      .flatMap((one) => [...one.attributes])
      .filter(
        ({ name, value }) =>
          name.startsWith('on') || (/^(?:src|href|poster|action)$/.test(name) && /^\s*javascript:/i.test(value)),
      )
      .map(({ name, value, ownerElement }) => `${ownerElement?.localName} ${name}="${value}"`),
  }));
  assert.equal(found.hit, undefined);
  assert.deepEqual(found.handlers, []);
  assert.ok(found.views >= 100, String(found.views));
  console.log(`${posts.length} hostile blocks and shortcodes: ${found.views} volumes, no script, no handler`);
  await hostile.page.context().close();

  // Other sites: WordPress' own frame of a post has the poster.
  const shown = write(`[volume-view src="${head}" alt="Brain" poster="${mosaic}"]`);
  const frame = await read(trial, shown, '&embed=true');
  const picture = frame.page.locator('.wp-embed img[alt="Brain"]');
  assert.equal(await picture.getAttribute('src'), mosaic);
  await trial.look(frame.page, 'embed');
  assert.deepEqual(
    frame.asked.filter((url) => url.includes('/volume-view/element/')),
    [],
  );
  const link = encodeURIComponent(`${site.url}/?p=${shown}`);
  const answer = await frame.page.request.get(`${site.url}/?rest_route=/oembed/1.0/embed&url=${link}`);
  assert.match((await answer.json()).thumbnail_url, /mosaic/);
  const feed = await (await frame.page.request.get(`${site.url}/?feed=rss2`)).text();
  assert.match(feed, /Show in 3D/);
  assert.doesNotMatch(feed, /<volume-view/);
  await frame.page.context().close();
  console.log('the frame for other sites and the feed have the poster');
}
