// The block in the editor, as Author and as Administrator: inserted, a file chosen from the media library, the view kept, saved, read, and edited again.
import assert from 'node:assert/strict';
import { enter, findCanvas, openEditor, publish, read, readPixels, waitForPicture } from './trial.mjs';

/** @param {import('./trial.mjs').Trial} trial */
export async function tryBlock(trial) {
  for (const role of ['author', 'admin']) await tryAs(trial, role);
}

/** @param {import('./trial.mjs').Trial} trial @param {string} role */
async function tryAs(trial, role) {
  const { site } = trial;
  const page = await enter(trial, role);
  /** @type {string[]} */
  const errors = [];
  page.on('pageerror', (error) => errors.push(String(error)));
  await openEditor(page, `${site.url}/wp-admin/post-new.php`);

  // By its name, as a person inserts it.
  await page
    .getByRole('button', { name: /^(Toggle block inserter|Block Inserter)$/i })
    .first()
    .click();
  await page.waitForTimeout(2000); // The list of blocks comes later than its search field.
  await page.getByRole('searchbox').first().fill('Volume');
  await page.getByRole('option', { name: 'Volume' }).first().click();
  const canvas = () => findCanvas(page);
  await trial.look(page, `${role}-inserted`);

  await canvas().getByRole('button', { name: 'Choose from the media library' }).first().click();
  const library = page.getByRole('dialog');
  await library.getByRole('tab', { name: /media library/i }).click();
  await library.locator('li.attachment[aria-label="head.nii"]').first().click();
  await trial.look(page, `${role}-library`);
  await library.getByRole('button', { name: /^select$/i }).click();
  await canvas().locator('volume-view').waitFor();
  assert.equal(await waitForPicture(canvas()), 'NIfTI-1');

  // The view is turned by dragging, and kept.
  const view = canvas().locator('volume-view');
  const box = await view.boundingBox();
  assert.ok(box);
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 120, y + 20, { steps: 6 });
  await page.mouse.up();
  await page.waitForTimeout(800);
  const keep = page.getByRole('button', { name: 'Start from this view' });
  if (!(await keep.isVisible())) await page.getByRole('button', { name: 'Settings', exact: true }).first().click();
  await keep.click();
  await page.getByLabel('What the picture shows, in words').fill('A brain & "more" <b>');
  await page.getByLabel('Look', { exact: true }).selectOption('skin');
  await canvas()
    .getByRole('textbox', { name: /caption/i })
    .click();
  await page.keyboard.type('Of one person');
  await page.waitForTimeout(1500);
  await waitForPicture(canvas());
  await trial.look(page, `${role}-edited`);
  const id = await publish(page, `A brain, by ${role}`);
  const content = site.run(`echo get_post( ${id} )->post_content;`);
  assert.match(content, /^<!-- wp:volume-view\/volume \{"src":"[^"]+head\.nii\.gz"/);
  assert.match(content, /"camera-orbit":"[^"]+deg/);

  const reader = await read(trial, id);
  assert.equal(await waitForPicture(reader.page), 'NIfTI-1');
  const tag = reader.page.locator('volume-view');
  assert.equal(await tag.getAttribute('alt'), 'A brain & "more" <b>');
  assert.equal(await tag.getAttribute('look'), 'skin');
  assert.equal(await reader.page.locator('figcaption').innerText(), 'Of one person');
  await trial.look(reader.page, `${role}-read`);
  // The same tag in a page without WordPress: pixel for pixel.
  const seen = await readPixels(reader.page);
  const elementUrl = reader.asked.find((url) => url.endsWith('/volume-view.js'));
  const html = await tag.evaluate((one) => one.outerHTML);
  await reader.page.route('**/plain.html', (route) =>
    route.fulfill({
      contentType: 'text/html',
      body: `<!doctype html><script type="module" src="${elementUrl}"></script><div style="width: 640px">${html}</div>`,
    }),
  );
  await reader.page.goto(`${site.url}/plain.html`);
  await waitForPicture(reader.page);
  assert.equal(await readPixels(reader.page), seen);
  assert.deepEqual(
    [...new Set(reader.asked.filter((url) => url.startsWith('http')).map((url) => new URL(url).host))],
    [new URL(site.url).host],
  );
  await reader.page.context().close();

  // Edited again: the block is valid, its fields have what was written, and saving changes nothing.
  await openEditor(page, `${site.url}/wp-admin/post.php?post=${id}&action=edit`);
  await canvas().locator('volume-view').waitFor();
  const blocks = await page.evaluate(() =>
    /** @type {any} */ (window).wp.data
      .select('core/block-editor')
      .getBlocks()
      .map((/** @type {any} */ block) => [block.name, block.isValid]),
  );
  assert.deepEqual(blocks, [['volume-view/volume', true]]);
  assert.equal(await canvas().locator('volume-view').getAttribute('alt'), 'A brain & "more" <b>');
  await waitForPicture(canvas());
  await trial.look(page, `${role}-again`);
  await publish(page, `A brain, by ${role}, again`);
  assert.equal(site.run(`echo get_post( ${id} )->post_content;`), content);
  assert.deepEqual(errors, []);
  await page.context().close();
  console.log(`block, as ${role}: inserted, turned, saved, read, edited again`);
}
