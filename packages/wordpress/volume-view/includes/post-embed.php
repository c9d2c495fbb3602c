<?php
/**
 * Posts that other sites show in a frame (oEmbed): the frame has the poster of the first volume, with a link to the post. The frame has no
 * origin, so that no data could be read in it.
 *
 * @package VolumeView
 * @license MIT
 */

defined( 'ABSPATH' ) || exit;

/**
 * Finds the first volume of a text.
 *
 * @param string $content Of a post.
 * @return array<string, string|true>|null Its attributes; null where there is none.
 */
function volume_view_find_first( $content ) {
	$found = volume_view_find_in_blocks( parse_blocks( $content ) );
	if ( null === $found && preg_match( '/' . get_shortcode_regex( array( 'volume-view' ) ) . '/', $content, $match ) ) {
		$found = volume_view_read_shortcode( shortcode_parse_atts( $match[3] ) );
	}
	$attributes = null === $found ? array() : volume_view_read_attributes( $found );
	return isset( $attributes['src'] ) ? $attributes : null;
}

/**
 * Finds the first volume among blocks and the blocks in them.
 *
 * @param array[] $blocks As WordPress parses them.
 * @return array|null What the author wrote.
 */
function volume_view_find_in_blocks( $blocks ) {
	foreach ( $blocks as $block ) {
		$found = 'volume-view/volume' === $block['blockName'] ? $block['attrs'] : volume_view_find_in_blocks( $block['innerBlocks'] );
		if ( null !== $found ) {
			return $found;
		}
	}
	return null;
}

/** Writes the poster into the frame. */
function volume_view_show_in_embed() {
	$post  = get_post();
	$first = $post && ! post_password_required( $post ) ? volume_view_find_first( $post->post_content ) : null;
	if ( $first ) {
		echo '<p>' . wp_kses_post( volume_view_write_poster( $first, (string) get_permalink( $post ) ) ) . '</p>';
	}
}
add_action( 'embed_content', 'volume_view_show_in_embed' );

/**
 * Gives sites that show links with a picture the poster, where the post has no picture of its own and the poster is in the media library.
 *
 * @param array   $data What WordPress says of the post.
 * @param WP_Post $post The post.
 * @return array
 */
function volume_view_add_thumbnail( $data, $post ) {
	if ( isset( $data['thumbnail_url'] ) || post_password_required( $post ) ) {
		return $data;
	}
	$first = volume_view_find_first( $post->post_content );
	$image = isset( $first['poster'] ) ? attachment_url_to_postid( $first['poster'] ) : 0;
	$size  = $image ? wp_get_attachment_image_src( $image, 'large' ) : false;
	if ( $size ) {
		list( $data['thumbnail_url'], $data['thumbnail_width'], $data['thumbnail_height'] ) = $size;
	}
	return $data;
}
add_filter( 'oembed_response_data', 'volume_view_add_thumbnail', 20, 2 );
