// Deactivated and deleted, the plugin leaves nothing but posts and files.
import assert from 'node:assert/strict';

/** @param {import('./trial.mjs').Trial} trial */
export function tryRemoval({ site }) {
  assert.match(site.run(`var_export( get_option( 'volume_view_uploads' ) );`), /1|true/);
  site.run(
    `require_once ABSPATH . 'wp-admin/includes/plugin.php'; deactivate_plugins( 'volume-view/volume-view.php' ); uninstall_plugin( 'volume-view/volume-view.php' );`,
  );
  assert.equal(site.run(`var_export( get_option( 'volume_view_uploads', 'gone' ) );`), "'gone'");
  console.log('the plugin takes its option away');
}
