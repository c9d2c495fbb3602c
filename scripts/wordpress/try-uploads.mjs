// Uploads: refused until an administrator allows them, then checked by their content.
import assert from 'node:assert/strict';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { enter } from './trial.mjs';

/** @param {import('./trial.mjs').Trial} trial */
export async function tryUploads(trial) {
  const { site, data } = trial;
  const work = mkdtempSync(join(tmpdir(), 'volume-view-files-'));
  const author = await enter(trial, 'author');
  /** Uploads a file by the form of the media library. @param {string} path @returns {Promise<string>} what WordPress says of it; empty if it has it */
  const upload = async (path) => {
    await author.goto(`${site.url}/wp-admin/media-new.php?browser-uploader`);
    await author.setInputFiles('#async-upload', path);
    await author.click('#html-upload');
    await author.waitForLoadState('networkidle');
    const problem = author.locator('.wp-die-message, .error-div, #media-upload-error, .notice-error');
    return (await problem.count()) > 0 ? (await problem.first().innerText()).trim() : '';
  };
  const make = (/** @type {string} */ name, /** @type {string | Uint8Array} */ bytes) => {
    writeFileSync(join(work, name), bytes);
    return join(work, name);
  };
  try {
    const head = make('head.nii.gz', readFileSync(join(data, 'mni152-t1.nii.gz')));
    const times = make('times.nii', readFileSync(join(data, 'functional.nii')));
    assert.notEqual(await upload(times), '', 'without the setting, WordPress takes no volume');

    const admin = await enter(trial, 'admin');
    await admin.goto(`${site.url}/wp-admin/options-media.php`);
    await admin.check('#volume_view_uploads');
    await trial.look(admin, 'setting');
    await admin.click('#submit');
    await admin.waitForLoadState('networkidle');
    assert.equal(site.run(`echo get_option( 'volume_view_uploads' );`), '1');
    await author.goto(`${site.url}/wp-admin/options-media.php`);
    assert.match(await author.innerText('body'), /not allowed|allowed to/i);
    await admin.context().close();

    for (const path of [head, times, make('storm.json', readFileSync(join(data, 'mni152-t1.json')))])
      assert.equal(await upload(path), '', path);
    const html = '<!doctype html><script>alert(1)</script>';
    const refused = ['page.nii', 'page.nii.gz', 'page.json', 'page.nrrd', 'page.html', 'page.svg', 'page.nii.php'];
    for (const name of refused) assert.notEqual(await upload(make(name, html)), '', name);
    assert.match(await upload(make('page.nii', html)), /does not begin like a file of NIfTI/);
    await trial.look(author, 'refused');
    // An image above 2,560 pixels, of which WordPress makes a smaller copy: a mosaic of 8 × 8 slices. Of PNG it makes none.
    const jpeg = await author.evaluate(async () => {
      const canvas = new OffscreenCanvas(3200, 3200);
      const context = canvas.getContext('2d');
      for (let i = 0; i < 64; i++) {
        if (context) context.fillStyle = `rgb(${4 * i} ${4 * i} ${4 * i})`;
        context?.fillRect(400 * (i % 8) + 80, 400 * Math.floor(i / 8) + 80, 240, 240);
      }
      const blob = await canvas.convertToBlob({ type: 'image/jpeg', quality: 0.9 });
      return [...new Uint8Array(await blob.arrayBuffer())];
    });
    assert.equal(await upload(make('mosaic.jpg', new Uint8Array(jpeg))), '');
    const listed = JSON.parse(
      site.run(
        `echo wp_json_encode( array_map( 'basename', array_map( 'get_attached_file', get_posts( array( 'post_type' => 'attachment', 'numberposts' => -1, 'fields' => 'ids' ) ) ) ) );`,
      ),
    );
    console.log(`uploads: ${listed.join(', ')}; ${refused.length} files refused`);
    const names = listed.map((/** @type {string} */ name) => name.replace('-scaled', ''));
    for (const name of ['head.nii.gz', 'times.nii', 'storm.json', 'mosaic.jpg']) assert.ok(names.includes(name), name);
    assert.equal(listed.length, 4);
  } finally {
    await author.context().close();
    rmSync(work, { recursive: true, force: true });
  }
}
