<?php
/**
 * The scripts of the element, which come with the plugin.
 *
 * @package VolumeView
 * @license MIT
 */

defined( 'ABSPATH' ) || exit;

/**
 * Where the built element is.
 *
 * @return string The address of its folder, which has another name for each build, so that no browser mixes files of two; empty where it was not
 *                built.
 */
function volume_view_element_url() {
	$file = dirname( VOLUME_VIEW_FILE ) . '/element/folder.php';
	return is_readable( $file ) ? plugins_url( 'element/' . include $file, VOLUME_VIEW_FILE ) : '';
}

/** Registers what a page with a volume loads. */
function volume_view_register_scripts() {
	$element = volume_view_element_url();
	if ( '' === $element ) {
		return;
	}
	// Without a version in the address: parts of the element import this file by its name.
	// phpcs:disable WordPress.WP.EnqueuedResourceParameters.MissingVersion
	wp_register_script( 'volume-view', $element . '/volume-view.js', array(), null, true );
	wp_register_script( 'volume-view-classic', $element . '/volume-view.iife.js', array(), null, true );
	wp_register_style( 'volume-view', $element . '/volume-view.css', array(), null );
	// phpcs:enable
}
add_action( 'init', 'volume_view_register_scripts' );

/** Loads the element in this page. */
function volume_view_enqueue() {
	wp_enqueue_script( 'volume-view' );
	wp_enqueue_style( 'volume-view' );
}

/**
 * Makes the tag of the element's script one of a module.
 *
 * @param string $tag    As WordPress writes it.
 * @param string $handle Of the script.
 * @param string $src    Its address.
 * @return string
 */
function volume_view_write_module_tag( $tag, $handle, $src ) {
	if ( 'volume-view' !== $handle ) {
		return $tag;
	}
	return wp_get_script_tag(
		array(
			'type' => 'module',
			'src'  => $src,
			'id'   => 'volume-view-js',
		)
	);
}
add_filter( 'script_loader_tag', 'volume_view_write_module_tag', 10, 3 );
