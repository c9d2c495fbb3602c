<?php
/**
 * Reads cases as JSON, and writes what the plugin makes of each as JSON. The text of a post is one of an author who may write no HTML.
 *
 * @package VolumeView
 */

// phpcs:disable -- A program of the tests; it is no part of the plugin.

require __DIR__ . '/load-wordpress.php';

$answers = array();
foreach ( json_decode( stream_get_contents( STDIN ), true ) as $case ) {
	$GLOBALS['loaded']   = array();
	$GLOBALS['is_feed']  = $case['feed'] ?? false;
	$GLOBALS['may_edit'] = $case['mayEdit'] ?? false;
	$answers[] = array(
		'html'   => isset( $case['content'] ) ? do_shortcode( wp_kses_post( $case['content'] ) ) : volume_view_render( $case['given'], $case['caption'] ?? '' ),
		'first'  => isset( $case['content'] ) ? volume_view_find_first( $case['content'] ) : null,
		'loaded' => $GLOBALS['loaded'],
	);
}
echo json_encode( $answers, JSON_INVALID_UTF8_SUBSTITUTE );
