<?php
/**
 * Whether an uploaded file is what its name says: by its first bytes and its size. Nothing here asks WordPress, except for words.
 *
 * A file of these kinds never begins like HTML, so that no browser takes it for a page.
 *
 * @package VolumeView
 * @license MIT
 */

defined( 'ABSPATH' ) || exit;

/** Types by the ends of names. */
const VOLUME_VIEW_TYPES = array(
	'nii'    => 'application/x-nifti',
	'nii.gz' => 'application/gzip',
	'nrrd'   => 'application/x-nrrd',
	'mha'    => 'application/x-metaimage',
	'h5'     => 'application/x-hdf5',
	'json'   => 'application/json',
);

/** The largest manifest, in bytes: it is text, which names other files. */
const VOLUME_VIEW_LONGEST_MANIFEST = 1048576;

/**
 * The end of a name, if it is one of ours.
 *
 * @param string $name Of the file.
 * @return string|null Such as `nii.gz`.
 */
function volume_view_ending( $name ) {
	foreach ( array_reverse( VOLUME_VIEW_TYPES ) as $ending => $type ) {
		if ( preg_match( '/.\.' . preg_quote( $ending, '/' ) . '$/iD', $name ) ) {
			return $ending;
		}
	}
	return null;
}

/**
 * Checks a file.
 *
 * @param string $path   On this server.
 * @param string $ending As `volume_view_ending` gives it.
 * @return string What is wrong, for a person; empty where nothing is.
 */
function volume_view_check_file( $path, $ending ) {
	$size = (int) filesize( $path );
	$head = volume_view_read_head( $path, 'nii.gz' === $ending );
	switch ( $ending ) {
		case 'nii':
			return volume_view_check_nifti( $head, $size );
		case 'nii.gz':
			return volume_view_check_nifti( $head, null );
		case 'nrrd':
			return volume_view_check_nrrd( $head );
		case 'mha':
			return volume_view_check_metaimage( $head );
		case 'h5':
			return 0 === strpos( $head, "\x89HDF\r\n\x1a\n" ) ? '' : volume_view_say_other( 'HDF5' );
		default:
			return volume_view_check_manifest( $path, $size );
	}
}

/**
 * The first bytes of a file.
 *
 * @param string $path      On this server.
 * @param bool   $is_packed Whether gzip has packed it.
 * @return string 64 KiB at most, unpacked; empty where it is not packed as it should be.
 */
function volume_view_read_head( $path, $is_packed ) {
	// phpcs:ignore WordPress.WP.AlternativeFunctions.file_get_contents_file_get_contents -- A file of this server, of which a part is read.
	$head = (string) file_get_contents( $path, false, null, 0, 65536 );
	if ( ! $is_packed ) {
		return $head;
	}
	if ( 0 !== strpos( $head, "\x1f\x8b\x08" ) || ! function_exists( 'gzopen' ) ) {
		return '';
	}
	$file = gzopen( $path, 'rb' );
	$head = $file ? gzread( $file, 1024 ) : false;
	if ( $file ) {
		gzclose( $file );
	}
	return (string) $head;
}

/**
 * Says that a file is of another kind than its name.
 *
 * @param string $kind A name that is the same in all languages.
 * @return string
 */
function volume_view_say_other( $kind ) {
	/* translators: %s: name of a file format, such as NIfTI */
	return sprintf( __( 'The file does not begin like a file of %s, so it was not taken.', 'volume-view' ), $kind );
}

/**
 * Checks NIfTI: the mark, the header's own size, the axes, and whether all voxels can be in the file.
 *
 * @param string   $head First bytes, unpacked.
 * @param int|null $size Of the file; null where it is packed.
 * @return string
 */
function volume_view_check_nifti( $head, $size ) {
	if ( strlen( $head ) >= 352 && "n+1\0" === substr( $head, 344, 4 ) ) {
		$is_little = 348 === unpack( 'V', $head )[1];
		$is_header = $is_little || 348 === unpack( 'N', $head )[1];
		$axes      = array_values( unpack( $is_little ? 'v8' : 'n8', $head, 40 ) );
		$bits      = unpack( $is_little ? 'v' : 'n', $head, 72 )[1];
		$offset    = unpack( $is_little ? 'g' : 'G', $head, 108 )[1];
	} elseif ( strlen( $head ) >= 544 && "n+2\0\r\n\x1a\n" === substr( $head, 4, 8 ) ) {
		$is_little = 540 === unpack( 'V', $head )[1];
		$is_header = $is_little || 540 === unpack( 'N', $head )[1];
		$axes      = array_values( unpack( $is_little ? 'P8' : 'J8', $head, 16 ) );
		$bits      = unpack( $is_little ? 'v' : 'n', $head, 14 )[1];
		$offset    = unpack( $is_little ? 'P' : 'J', $head, 168 )[1];
	} else {
		return volume_view_say_other( 'NIfTI' );
	}
	$count = $axes[0];
	if ( ! $is_header || $count < 1 || $count > 7 || ! is_finite( $offset ) || $offset < 0 ) {
		return volume_view_say_other( 'NIfTI' );
	}
	$bytes = $bits / 8;
	foreach ( array_slice( $axes, 1, $count ) as $length ) {
		if ( $length < 1 ) {
			return volume_view_say_other( 'NIfTI' );
		}
		$bytes *= $length;
	}
	return null === $size || $bytes + $offset <= $size ? '' : __( 'The file is shorter than its header says, so it was not taken. Was it cut off?', 'volume-view' );
}

/**
 * Checks NRRD: the mark, and that the voxels are in the same file.
 *
 * @param string $head First bytes.
 * @return string
 */
function volume_view_check_nrrd( $head ) {
	if ( ! preg_match( '/^NRRD000\d\r?\n(?:[^\n]*\S[^\n]*\n)*\r?\n/', $head, $header ) ) {
		return volume_view_say_other( 'NRRD' );
	}
	return preg_match( '/^data ?file:/mi', $header[0] ) ? volume_view_say_detached() : '';
}

/**
 * Checks MetaImage: its lines, and that the voxels are in the same file.
 *
 * @param string $head First bytes.
 * @return string
 */
function volume_view_check_metaimage( $head ) {
	if ( ! preg_match( '/^(?:[A-Za-z]\w*[ \t]*=[^\n]*\n)*?ElementDataFile[ \t]*=[ \t]*(\S+)[ \t]*\r?\n/', $head, $found ) ) {
		return volume_view_say_other( 'MetaImage' );
	}
	if ( ! preg_match( '/^(?:ObjectType[ \t]*=[ \t]*Image|NDims[ \t]*=[ \t]*\d)/m', $found[0] ) ) {
		return volume_view_say_other( 'MetaImage' );
	}
	return 'LOCAL' === strtoupper( $found[1] ) ? '' : volume_view_say_detached();
}

/**
 * Says that the voxels are elsewhere.
 *
 * @return string
 */
function volume_view_say_detached() {
	return __( 'The header names another file for its data. Only files that hold their data are taken.', 'volume-view' );
}

/**
 * Checks the manifest of a mosaic: a JSON object that names images, files or scans.
 *
 * @param string $path On this server.
 * @param int    $size In bytes.
 * @return string
 */
function volume_view_check_manifest( $path, $size ) {
	if ( $size > VOLUME_VIEW_LONGEST_MANIFEST ) {
		return __( 'A manifest may have 1 MB.', 'volume-view' );
	}
	// phpcs:ignore WordPress.WP.AlternativeFunctions.file_get_contents_file_get_contents -- A file of this server.
	$manifest = json_decode( (string) file_get_contents( $path ), true, 32 );
	$ways     = is_array( $manifest ) ? array_intersect( array( 'image', 'files', 'scans' ), array_map( 'strval', array_keys( $manifest ) ) ) : array();
	return 1 === count( $ways ) ? '' : __( 'The JSON file is no manifest of a volume: expected an object with image, files or scans.', 'volume-view' );
}
