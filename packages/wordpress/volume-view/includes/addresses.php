<?php
/**
 * Addresses of files: which ones a post may name, and which file of the media library is meant.
 *
 * @package VolumeView
 * @license MIT
 */

defined( 'ABSPATH' ) || exit;

/**
 * Reads the address of a file.
 *
 * @param string $text As the author wrote it; WordPress may have written `&amp;` for an author who may write no HTML.
 * @return string The address; empty where it is none of a server.
 */
function volume_view_read_address( $text ) {
	$text = trim( wp_specialchars_decode( $text, ENT_QUOTES ) );
	// Without one of these beginnings, WordPress takes the first word for a server.
	if ( ! preg_match( '#^(?:https?://|/)#i', $text ) ) {
		return '';
	}
	$address = sanitize_url( $text, array( 'http', 'https' ) );
	$parts   = wp_parse_url( $address );
	if ( ! is_array( $parts ) || isset( $parts['user'] ) || isset( $parts['pass'] ) ) {
		return '';
	}
	return $address;
}

/**
 * The file as it was uploaded. WordPress makes a smaller copy of a large image, `name-scaled.png`, and gives the address of the copy; but in a
 * mosaic each pixel is a voxel, and the copy shows other values.
 *
 * @param string $address Of any file.
 * @return string Of the uploaded file; the same address where it is no such copy.
 */
function volume_view_find_original( $address ) {
	if ( ! preg_match( '/-scaled\.\w+$/', (string) wp_parse_url( $address, PHP_URL_PATH ) ) ) {
		return $address;
	}
	$attachment = attachment_url_to_postid( strtok( $address, '?#' ) );
	$original   = $attachment ? wp_get_original_image_url( $attachment ) : false;
	return $original ? $original : $address;
}
