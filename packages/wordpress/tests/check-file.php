<?php
/**
 * Reads names of files as JSON, and writes what the plugin says of each as JSON: null where the name is none of ours, an empty text where the file
 * is taken. It needs no WordPress.
 *
 * @package VolumeView
 */

// phpcs:disable -- A program of the tests; it is no part of the plugin.

define( 'ABSPATH', __DIR__ );
error_reporting( E_ALL );
set_error_handler(
	function ( $level, $message, $file, $line ) {
		fwrite( STDERR, "$message, $file:$line\n" );
		exit( 1 );
	}
);

function __( $text ) { return $text; }

require __DIR__ . '/../volume-view/includes/check-file.php';

$answers = array();
foreach ( json_decode( stream_get_contents( STDIN ), true ) as $case ) {
	$ending    = volume_view_ending( $case['name'] );
	$answers[] = null === $ending ? null : volume_view_check_file( $case['path'], $ending );
}
echo json_encode( $answers );
