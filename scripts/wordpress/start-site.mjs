// A WordPress of its own for a trial: data base, site, users and the plugin, in a folder that is removed at the end.
import { spawn, spawnSync } from 'node:child_process';
import { cpSync, existsSync, mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { createServer } from 'node:net';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { gatherPlugin } from '../build-wordpress.mjs';

/** @returns {Promise<number>} a port that is free now */
const findPort = () =>
  new Promise((resolve) => {
    const server = createServer().listen(0, '127.0.0.1', () => {
      const address = server.address();
      server.close(() => resolve(typeof address === 'object' && address ? address.port : 0));
    });
  });

const config = (/** @type {string} */ socket, /** @type {string} */ log) => `<?php
define( 'DB_NAME', 'trial' );
define( 'DB_USER', 'root' );
define( 'DB_PASSWORD', '' );
define( 'DB_HOST', 'localhost:${socket}' );
define( 'DB_CHARSET', 'utf8mb4' );
define( 'DB_COLLATE', '' );
define( 'WP_DEBUG', true );
define( 'WP_DEBUG_DISPLAY', false );
define( 'WP_DEBUG_LOG', '${log}' );
define( 'WP_HTTP_BLOCK_EXTERNAL', true );
define( 'WP_ACCESSIBLE_HOSTS', '127.0.0.1' );
define( 'AUTOMATIC_UPDATER_DISABLED', true );
define( 'DISABLE_WP_CRON', true );
$table_prefix = 'wp_';
defined( 'ABSPATH' ) || define( 'ABSPATH', __DIR__ . '/' );
require_once ABSPATH . 'wp-settings.php';
`;

const install = (/** @type {string} */ url) => `<?php
define( 'WP_INSTALLING', true );
$_SERVER['HTTP_HOST'] = '${url.slice(7)}';
require __DIR__ . '/wp-load.php';
require_once ABSPATH . 'wp-admin/includes/upgrade.php';
require_once ABSPATH . 'wp-admin/includes/plugin.php';
wp_install( 'Trial', 'admin', 'admin@site.example', true, '', 'trial' );
wp_insert_user( array( 'user_login' => 'author', 'user_pass' => 'trial', 'user_email' => 'author@site.example', 'role' => 'author' ) );
update_option( 'siteurl', '${url}' );
update_option( 'home', '${url}' );
foreach ( array( 'twentytwentyfive', 'twentytwentyfour', 'twentytwentythree' ) as $theme ) {
	if ( wp_get_theme( $theme )->exists() ) {
		switch_theme( $theme );
		break;
	}
}
`;

const activate = `<?php
require __DIR__ . '/wp-load.php';
require_once ABSPATH . 'wp-admin/includes/plugin.php';
$problem = activate_plugin( 'volume-view/volume-view.php' );
if ( is_wp_error( $problem ) ) {
	echo $problem->get_error_message();
	exit( 1 );
}
`;

/** @param {string} from - a folder with the files of WordPress */
export async function startSite(from) {
  const version = /wp_version = '([^']+)'/.exec(readFileSync(join(from, 'wp-includes/version.php'), 'utf8'))?.[1] ?? '';
  const work = mkdtempSync(join(tmpdir(), 'volume-view-wordpress-'));
  const [root, socket, log] = [join(work, 'site'), join(work, 'db.sock'), join(work, 'errors.log')];
  cpSync(from, root, { recursive: true, dereference: true });
  writeFileSync(join(root, 'wp-config.php'), config(socket, log));
  for (const [name, bytes] of gatherPlugin()) {
    const path = join(root, 'wp-content/plugins/volume-view', name);
    mkdirSync(dirname(path), { recursive: true });
    writeFileSync(path, bytes);
  }
  const data = join(work, 'db');
  spawnSync('mariadb-install-db', [
    '--no-defaults',
    `--datadir=${data}`,
    '--auth-root-authentication-method=normal',
    '--skip-test-db',
    '--user=root',
  ]);
  const base = spawn(
    'mariadbd',
    ['--no-defaults', '--user=root', `--datadir=${data}`, `--socket=${socket}`, '--skip-networking'],
    { stdio: 'ignore' },
  );
  while (!existsSync(socket)) await new Promise((resolve) => setTimeout(resolve, 200));
  spawnSync('mariadb', ['--no-defaults', `--socket=${socket}`, '-uroot', '-e', 'create database trial']);
  const port = await findPort();
  const url = `http://127.0.0.1:${port}`;

  /** Runs a program inside WordPress. @param {string} program @returns {string} what it printed */
  const run = (program) => {
    writeFileSync(join(root, 'trial.php'), program);
    const { status, stdout, stderr } = spawnSync('php', [join(root, 'trial.php')], { encoding: 'utf8', cwd: root });
    rmSync(join(root, 'trial.php'));
    if (status !== 0) throw new Error(stdout + stderr);
    return stdout;
  };
  run(install(url));
  run(activate);
  const server = spawn(
    'php',
    ['-d', 'upload_max_filesize=64M', '-d', 'post_max_size=64M', '-S', `127.0.0.1:${port}`, '-t', root],
    {
      stdio: 'ignore',
      detached: true, // A group of its own, which ends with its workers.
      env: { ...process.env, PHP_CLI_SERVER_WORKERS: '6' },
    },
  );
  return {
    version,
    url,
    root,
    /** @param {string} body - after WordPress is loaded */
    run: (body) => run(`<?php\nrequire __DIR__ . '/wp-load.php';\n${body}`),
    /** Errors and warnings of PHP that name the plugin. */
    listErrors: () =>
      existsSync(log)
        ? readFileSync(log, 'utf8')
            .split('\n')
            .filter((line) => /volume.view/.test(line.replaceAll(work, '')))
        : [],
    async stop() {
      if (server.pid) process.kill(-server.pid);
      base.kill();
      await new Promise((resolve) => base.once('exit', resolve));
      rmSync(work, { recursive: true, force: true, maxRetries: 5, retryDelay: 300 });
    },
  };
}
