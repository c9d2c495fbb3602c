<?php
/**
 * Plugin Name:       Volume View
 * Description:       Shows volumes - CT, MRI, weather radar - that readers can turn: a block and a shortcode. Nothing is loaded from other servers.
 * Version:           0.1.0
 * Requires at least: 6.1
 * Requires PHP:      7.4
 * Author:            The volume-view authors
 * License:           MIT
 * License URI:       https://opensource.org/licenses/MIT
 * Text Domain:       volume-view
 * Domain Path:       /languages
 *
 * @package VolumeView
 * @license MIT
 */

defined( 'ABSPATH' ) || exit;

define( 'VOLUME_VIEW_FILE', __FILE__ );

require __DIR__ . '/includes/attributes.php';
require __DIR__ . '/includes/addresses.php';
require __DIR__ . '/includes/render.php';
require __DIR__ . '/includes/scripts.php';
require __DIR__ . '/includes/block.php';
require __DIR__ . '/includes/shortcode.php';
require __DIR__ . '/includes/post-embed.php';
require __DIR__ . '/includes/check-file.php';
require __DIR__ . '/includes/uploads.php';
require __DIR__ . '/includes/settings.php';

add_action(
	'init',
	function () {
		// WordPress looks for languages by itself only where it has fetched the plugin itself.
		load_plugin_textdomain( 'volume-view', false, dirname( plugin_basename( __FILE__ ) ) . '/languages' );
	},
	5
);
