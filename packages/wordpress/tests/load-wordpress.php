<?php
/**
 * Loads the parts of a real WordPress that need no data base: those that escape, clean and parse. What asks the data base, or a person, is
 * answered here.
 *
 * @package VolumeView
 */

// phpcs:disable -- A program of the tests; it is no part of the plugin.

$root = rtrim( getenv( 'VOLUME_VIEW_WORDPRESS' ), '/' ) . '/';
define( 'ABSPATH', $root );
define( 'WPINC', 'wp-includes' );
define( 'WP_CONTENT_DIR', $root . 'wp-content' );
define( 'WP_DEBUG', true );
define( 'WP_PLUGIN_DIR', dirname( __DIR__ ) );
define( 'WPMU_PLUGIN_DIR', dirname( __DIR__ ) );
$wp_plugin_paths = array();
error_reporting( E_ALL & ~E_DEPRECATED );
set_error_handler(
	function ( $level, $message, $file, $line ) {
		if ( 0 !== ( $level & error_reporting() ) ) {
			fwrite( STDERR, "$message, $file:$line\n" );
			exit( 1 );
		}
		return false;
	}
);

require ABSPATH . WPINC . '/version.php';
$parts = array( 'compat-utf8', 'compat', 'utf8', 'plugin', 'load', 'functions', 'http', 'formatting', 'html-api/class-wp-html-attribute-token', 'html-api/class-wp-html-span', 'html-api/class-wp-html-text-replacement', 'html-api/class-wp-html-decoder', 'html-api/class-wp-html-doctype-info', 'html-api/class-wp-html-tag-processor', 'class-wp-token-map', 'kses', 'shortcodes', 'class-wp-block-parser-block', 'class-wp-block-parser-frame', 'class-wp-block-parser' );
foreach ( $parts as $part ) {
	$file = ABSPATH . WPINC . "/$part.php";
	if ( is_file( $file ) ) {
		require_once $file;
	}
}
if ( is_file( ABSPATH . WPINC . '/html-api/html5-named-character-references.php' ) ) {
	require_once ABSPATH . WPINC . '/html-api/html5-named-character-references.php';
}
require __DIR__ . '/answers.php';
require __DIR__ . '/../volume-view/volume-view.php';
