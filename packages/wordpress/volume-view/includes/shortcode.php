<?php
/**
 * The shortcode: `[volume-view src="https://…" alt="…" controls]a caption[/volume-view]`, with the attributes of the element.
 *
 * @package VolumeView
 * @license MIT
 */

defined( 'ABSPATH' ) || exit;

/**
 * Writes the volume of a shortcode.
 *
 * @param array|string $given   Texts by names; names without a text by numbers.
 * @param string|null  $content The caption.
 * @return string HTML.
 */
function volume_view_render_shortcode( $given, $content = null ) {
	return volume_view_render( volume_view_read_shortcode( $given ), (string) $content );
}
add_shortcode( 'volume-view', 'volume_view_render_shortcode' );

/**
 * Attributes of a shortcode by their names.
 *
 * @param array|string $given As WordPress reads them.
 * @return array<string, string>
 */
function volume_view_read_shortcode( $given ) {
	$attributes = array();
	foreach ( is_array( $given ) ? $given : array() as $name => $value ) {
		if ( is_int( $name ) ) {
			$attributes[ strtolower( $value ) ] = 'true';
		} else {
			$attributes[ $name ] = $value;
		}
	}
	return $attributes;
}
