<?php
/**
 * Uploads of volumes, where an administrator has allowed them: by those who may upload files, checked by what is in them.
 *
 * @package VolumeView
 * @license MIT
 */

defined( 'ABSPATH' ) || exit;

/**
 * Whether the present person may upload volumes.
 *
 * @return bool
 */
function volume_view_may_upload() {
	return get_option( 'volume_view_uploads', false ) && current_user_can( 'upload_files' );
}

/**
 * Adds the types to those of WordPress.
 *
 * @param array $types Of WordPress.
 * @return array
 */
function volume_view_add_types( $types ) {
	return volume_view_may_upload() ? $types + VOLUME_VIEW_TYPES : $types;
}
add_filter( 'upload_mimes', 'volume_view_add_types' );

/**
 * Refuses a file whose content is not what its name says, in words.
 *
 * @param array $file With its name, its temporary place, and an error if it has one.
 * @return array
 */
function volume_view_check_upload( $file ) {
	$ending = volume_view_may_upload() ? volume_view_ending( (string) $file['name'] ) : null;
	if ( null !== $ending && empty( $file['error'] ) && is_readable( (string) $file['tmp_name'] ) ) {
		$problem = volume_view_check_file( $file['tmp_name'], $ending );
		if ( '' !== $problem ) {
			$file['error'] = $problem;
		}
	}
	return $file;
}
add_filter( 'wp_handle_upload_prefilter', 'volume_view_check_upload' );
add_filter( 'wp_handle_sideload_prefilter', 'volume_view_check_upload' );

/**
 * Says what type a file is. WordPress asks the server, which knows none of these types, and would refuse them all.
 *
 * @param array  $data What WordPress thinks: ext, type, proper_filename.
 * @param string $path Of the file.
 * @param string $name Of the file.
 * @return array
 */
function volume_view_say_type( $data, $path, $name ) {
	$ending = volume_view_may_upload() ? volume_view_ending( (string) $name ) : null;
	if ( null === $ending || ! is_readable( $path ) ) {
		return $data;
	}
	$is_fine                 = '' === volume_view_check_file( $path, $ending );
	$data['ext']             = $is_fine ? $ending : false;
	$data['type']            = $is_fine ? VOLUME_VIEW_TYPES[ $ending ] : false;
	$data['proper_filename'] = false;
	return $data;
}
add_filter( 'wp_check_filetype_and_ext', 'volume_view_say_type', 10, 3 );
