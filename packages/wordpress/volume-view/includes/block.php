<?php
/**
 * The block "Volume". Its tag is written by the server, each time a page is shown: an author needs no right to write HTML, and a later version of
 * the plugin finds no block that it does not know.
 *
 * @package VolumeView
 * @license MIT
 */

defined( 'ABSPATH' ) || exit;

/** Registers the block, and what its editor loads. */
function volume_view_register_block() {
	$script  = 'block/editor.js';
	$used    = array( 'wp-block-editor', 'wp-blocks', 'wp-components', 'wp-element', 'wp-html-entities', 'wp-i18n' );
	$version = (string) filemtime( dirname( VOLUME_VIEW_FILE ) . '/' . $script );
	wp_register_script( 'volume-view-block', plugins_url( $script, VOLUME_VIEW_FILE ), $used, $version, true );
	wp_set_script_translations( 'volume-view-block', 'volume-view', dirname( VOLUME_VIEW_FILE ) . '/languages' );
	$settings = array( 'render_callback' => 'volume_view_render_block' );
	// The frame of the editor gets the element by this. Older ones write each script into it as a classic one. Elsewhere, WordPress would load the
	// scripts of all blocks in all pages.
	if ( is_admin() && wp_script_is( 'volume-view-classic', 'registered' ) ) {
		$settings['script_handles'] = array( 'volume-view-classic' );
		$settings['style_handles']  = array( 'volume-view' );
	}
	register_block_type( dirname( VOLUME_VIEW_FILE ) . '/block', $settings );
}
add_action( 'init', 'volume_view_register_block', 20 );

/**
 * Writes the volume of a block.
 *
 * @param array $attributes Of the block.
 * @return string HTML.
 */
function volume_view_render_block( $attributes ) {
	return volume_view_render( $attributes, $attributes['caption'] ?? '', get_block_wrapper_attributes() );
}

/** Gives the editor the table of attributes, with words in the language of the author. */
function volume_view_give_table() {
	require_once __DIR__ . '/choices.php';
	require_once __DIR__ . '/descriptions.php';
	$table = array(
		'kinds'        => volume_view_attributes(),
		'choices'      => volume_view_choices(),
		'descriptions' => volume_view_descriptions(),
		'companions'   => array_keys( VOLUME_VIEW_COMPANIONS ),
	);
	wp_add_inline_script( 'volume-view-block', 'window.volumeViewTable = ' . wp_json_encode( $table, JSON_HEX_TAG ) . ';', 'before' );
}
add_action( 'enqueue_block_editor_assets', 'volume_view_give_table' );
