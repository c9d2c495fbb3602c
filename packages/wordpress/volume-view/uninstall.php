<?php
/**
 * Takes away what the plugin has stored: one option of each site. Posts and files stay.
 *
 * @package VolumeView
 * @license MIT
 */

defined( 'WP_UNINSTALL_PLUGIN' ) || exit;

if ( is_multisite() ) {
	foreach ( get_sites( array( 'number' => 0 ) ) as $volume_view_site ) {
		delete_blog_option( (int) $volume_view_site->blog_id, 'volume_view_uploads' );
	}
} else {
	delete_option( 'volume_view_uploads' );
}
