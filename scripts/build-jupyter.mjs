// Builds what the widget for notebooks carries: a page of one file with the element inside, and a mark where the element goes. It is the page
// that volume-view-prepare writes of a lesson, without the lesson. `npm run build` comes before.
import { spawnSync } from 'node:child_process';
import { cpSync, mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { projectRoot } from './shared-data.mjs';

const program = join(projectRoot, 'packages/prepare/dist/volume-view-prepare.js');
const folder = join(projectRoot, 'packages/jupyter/src/volume_view/static');

/** As in page.py. */
const place = '<!--volume-view-->';

const lesson = `<!doctype html><html lang="en"><head><meta charset="utf-8"><title>Volume</title>
<meta name="license" content="none"><meta name="author" content="none"></head>
<body><volume-view alt="Volume" src="volume.nii"></volume-view></body></html>`;

/** Builds the folder. */
export function buildJupyter() {
  const work = mkdtempSync(join(tmpdir(), 'volume-view-jupyter-'));
  try {
    writeFileSync(join(work, 'lesson.html'), lesson);
    writeFileSync(join(work, 'volume.nii'), 'x');
    const { status, stderr } = spawnSync(process.execPath, [program, 'lesson.html', '--as', 'single-file'], {
      cwd: work,
      encoding: 'utf8',
    });
    if (status !== 0) throw new Error(stderr);
    const page = readFileSync(join(work, 'lesson-single.html'), 'utf8')
      .replace(/<volume-view [^>]*><\/volume-view>/, place)
      .replace(/<footer class="credits">.*?<\/footer>\n?/s, '');
    if (page.split(place).length !== 2) throw new Error('the page of a lesson has no element, or several');
    mkdirSync(folder, { recursive: true });
    writeFileSync(join(folder, 'player.html'), page);
    cpSync(join(projectRoot, 'dist/THIRD-PARTY-LICENSES.txt'), join(folder, 'THIRD-PARTY-LICENSES.txt'));
  } finally {
    rmSync(work, { recursive: true, force: true });
  }
}

if (process.argv[1] === fileURLToPath(import.meta.url)) buildJupyter();
