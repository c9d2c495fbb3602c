// Frames between sites: a second WordPress with the plugin shows a post of the first one, and a folder for frames, from their addresses alone.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { copyFileSync, mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { projectRoot } from '../shared-data.mjs';
import { startStaticServer } from '../static-server.mjs';
import { startSite } from './start-site.mjs';
import { enter, openEditor, publish, read, waitForPicture } from './trial.mjs';

/** WordPress asks no server of its own machine by itself; in this trial the other sites are there. */
const allowOwnMachine = `<?php
add_filter( 'http_request_host_is_external', '__return_true' );
add_filter( 'http_allowed_safe_ports', fn( $ports, $host, $url ) => array_merge( $ports, array( wp_parse_url( $url, PHP_URL_PORT ) ) ), 10, 3 );
`;

const lesson = `<!doctype html><html lang="en"><head><title>A torso</title><meta name="license" content="CC0 1.0"><meta name="author" content="Made by a program"></head>
<body><h1>A torso</h1><volume-view id="v" src="torso.nii.gz" poster="torso.webp" alt="A torso"></volume-view>
<volume-tour for="v" duration="0"><volume-step><h2>First</h2></volume-step><volume-step camera-orbit="90deg 90deg auto"><h2>Second</h2></volume-step></volume-tour></body></html>`;

/** A folder for frames on a server of its own, with the address of its page. @param {string} work */
async function serveLesson(work) {
  const server = await startStaticServer({ root: work });
  writeFileSync(join(work, 'lesson.html'), lesson);
  copyFileSync(join(projectRoot, 'demos/data/ct-phantom.nii.gz'), join(work, 'torso.nii.gz'));
  copyFileSync(join(projectRoot, 'demos/images/preset-ct-bone.webp'), join(work, 'torso.webp'));
  const program = join(projectRoot, 'packages/prepare/dist/volume-view-prepare.js');
  const args = ['lesson.html', '--as', 'embed', '--address', `${server.url}/out/`, '--out', 'out'];
  const { status, stderr } = spawnSync(process.execPath, [program, ...args], { cwd: work, encoding: 'utf8' });
  assert.equal(status, 0, stderr);
  return { server, address: `${server.url}/out/index.html` };
}

/** The frame of another site in a page, when its picture is there. @param {import('./trial.mjs').Page} page @param {string} origin */
async function frameOf(page, origin) {
  const handle = await page.locator(`iframe[src^="${origin}"]`).elementHandle();
  assert.equal(await handle?.getAttribute('sandbox').then((words) => words?.includes('allow-same-origin')), false);
  const frame = await handle?.contentFrame();
  assert.ok(frame);
  await frame
    .locator('img')
    .first()
    .evaluate((/** @type {HTMLImageElement} */ image) => image.decode());
  return frame;
}

/** @param {import('./trial.mjs').Trial} trial @param {string} from - a folder with the files of WordPress */
export async function tryEmbeds(trial, from) {
  const { site } = trial;
  const work = mkdtempSync(join(tmpdir(), 'volume-view-embeds-'));
  const other = await startSite(from);
  const { server, address } = await serveLesson(work);
  try {
    const folder = join(other.root, 'wp-content/mu-plugins');
    mkdirSync(folder);
    writeFileSync(join(folder, 'allow-own-machine.php'), allowOwnMachine);
    const [head, mosaic] = ['head.nii', 'mosaic'].map((name) =>
      site.run(
        `foreach ( get_posts( array( 'post_type' => 'attachment', 'numberposts' => -1 ) ) as $one ) { if ( str_contains( $one->guid, '${name}' ) ) { echo wp_get_attachment_url( $one->ID ); } }`,
      ),
    );
    const shown = site.run(
      `echo get_permalink( wp_insert_post( array( 'post_title' => 'A brain of the first site', 'post_status' => 'publish', 'post_content' => '[volume-view src="${head}" alt="Brain" poster="${mosaic}" look="skin"]' ) ) );`,
    );

    // In the editor of the other site, as its Author: two blocks "Embed" and a volume of its own, whose file it reads from nowhere else.
    const own = `${other.url}/wp-content/own.nii.gz`;
    copyFileSync(join(trial.data, 'ct-phantom.nii.gz'), join(other.root, 'wp-content/own.nii.gz'));
    const second = { ...trial, site: other };
    const author = await enter(second, 'author');
    await openEditor(author, `${other.url}/wp-admin/post-new.php`);
    await author.evaluate(
      ([...urls]) => {
        const { blocks, data } = /** @type {any} */ (window).wp;
        const src = urls.pop();
        data
          .dispatch('core/block-editor')
          .insertBlocks([
            ...urls.map((url) => blocks.createBlock('core/embed', { url })),
            blocks.createBlock('volume-view/volume', { src, alt: 'Torso' }),
          ]);
      },
      [shown, address, own],
    );
    await author.waitForFunction(
      ([post, page]) => {
        const select = /** @type {any} */ (window).wp.data.select('core');
        return [post, page].every((url) => select.getEmbedPreview(url)?.html);
      },
      [shown, address],
      { timeout: 60_000 },
    );
    await author.waitForTimeout(1500);
    await trial.look(author, 'embeds-in-editor');
    const id = await publish(author, 'From other sites');
    await author.context().close();
    console.log('the editor of another site shows the frames of a post and of a folder for frames');

    // A reader: both frames have no origin, and the volume of the site itself is drawn next to them.
    const { page, asked } = await read(second, id);
    /** @type {string[]} */
    const errors = [];
    page.on('pageerror', (error) => errors.push(String(error)));
    await waitForPicture(page);
    const post = await frameOf(page, site.url);
    assert.equal(await post.locator('.wp-embed img[alt="Brain"]').getAttribute('src'), mosaic);
    assert.equal(await post.locator('volume-view').count(), 0);
    assert.deepEqual(
      asked.filter((url) => url.startsWith(site.url) && url.includes('/volume-view/element/')),
      [],
    );
    const torso = await frameOf(page, server.url);
    await trial.look(page, 'embeds');
    await torso.getByRole('link', { name: 'Show in 3D' }).click();
    const inFrame = () => page.frames().find((one) => one.url().includes('embed-lesson.html'));
    while (!inFrame()) await page.waitForTimeout(200);
    const frame = /** @type {import('@playwright/test').Frame} */ (inFrame());
    await frame.waitForFunction(() => document.querySelector('volume-view'));
    assert.ok(await waitForPicture(frame));
    await trial.look(page, 'embeds-in-3d');
    assert.deepEqual(errors, []);
    console.log('a reader sees both frames, without an origin, next to a volume of the site itself');

    // The poster in the frame of a post leads to the post, as WordPress opens links of such frames.
    await post.locator('img[alt="Brain"]').click();
    await page.waitForURL(`${site.url}/**`);
    await waitForPicture(page);
    console.log('the poster of a post leads to the post, with its volume');
    await page.context().close();
    assert.deepEqual(other.listErrors(), []);
  } finally {
    server.close();
    await other.stop();
    rmSync(work, { recursive: true, force: true });
  }
}
