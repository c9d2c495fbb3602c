<?php
/**
 * From attributes to HTML: the only place that writes the tag, for the block and for the shortcode.
 *
 * @package VolumeView
 * @license MIT
 */

defined( 'ABSPATH' ) || exit;

/** The longest text of an attribute, in bytes: `src` may name many scans. */
const VOLUME_VIEW_LONGEST_TEXT = 16000;

/** Elements below the picture, by the words that an author writes. */
const VOLUME_VIEW_COMPANIONS = array(
	'legend'   => 'volume-legend',
	'readout'  => 'volume-readout',
	'timeline' => 'volume-timeline',
);

/**
 * Writes a volume.
 *
 * @param array  $given   What the author wrote, texts and flags by names; others are left out.
 * @param string $caption HTML of the author; what a caption may not have is taken away.
 * @param string $wrapper Attributes of the figure, escaped.
 * @return string HTML.
 */
function volume_view_render( $given, $caption = '', $wrapper = 'class="wp-block-volume-view-volume"' ) {
	$attributes = volume_view_read_attributes( $given );
	$figure     = '<figure ' . $wrapper . '>%s</figure>';
	$caption    = volume_view_write_caption( $caption );
	if ( ! isset( $attributes['src'] ) ) {
		return volume_view_explain_source( $given );
	}
	// A reader of feeds runs no scripts, and in a post that another site shows in a sandbox, no data can be read.
	if ( is_feed() || is_embed() ) {
		return sprintf( $figure, volume_view_write_poster( $attributes, (string) get_permalink() ) . $caption );
	}
	volume_view_enqueue();
	$companions = '';
	foreach ( VOLUME_VIEW_COMPANIONS as $word => $tag ) {
		if ( isset( $given[ $word ] ) && volume_view_is_on( $given[ $word ] ) ) {
			$attributes['id'] = $attributes['id'] ?? wp_unique_id( 'volume-view-' );
			$companions      .= sprintf( '<%1$s for="%2$s"></%1$s>', $tag, esc_attr( $attributes['id'] ) );
		}
	}
	return sprintf( $figure, volume_view_write_tag( $attributes ) . $companions . $caption );
}

/**
 * Reads what the author wrote by the table of the element.
 *
 * @param array $given Texts and flags by names.
 * @return array<string, string|true> Texts by names, not escaped; true for a name without a text. Without `src` where an address of it can not
 *                                    be taken: some of its files would be another volume.
 */
function volume_view_read_attributes( $given ) {
	$attributes = array();
	foreach ( volume_view_attributes() as $name => $kind ) {
		$value = $given[ $name ] ?? null;
		if ( ! is_scalar( $value ) || ( is_string( $value ) && strlen( $value ) > VOLUME_VIEW_LONGEST_TEXT ) ) {
			continue;
		}
		$read = 'flag' === $kind ? volume_view_is_on( $value ) : volume_view_read_text( $kind, trim( (string) $value ) );
		if ( false !== $read && '' !== $read ) {
			$attributes[ $name ] = $read;
		}
	}
	return $attributes;
}

/**
 * Reads a text.
 *
 * @param string $kind As in the table.
 * @param string $text As the author wrote it.
 * @return string|bool Empty or false where the attribute is not written.
 */
function volume_view_read_text( $kind, $text ) {
	if ( 'address' === $kind ) {
		return volume_view_read_address( $text );
	}
	if ( 'addresses' === $kind ) {
		$addresses = array_map( 'volume_view_read_address', preg_split( '/\s+/', $text, -1, PREG_SPLIT_NO_EMPTY ) );
		return in_array( '', $addresses, true ) ? '' : implode( ' ', array_map( 'volume_view_find_original', $addresses ) );
	}
	if ( 'flag-or-text' === $kind && in_array( strtolower( $text ), array( 'true', 'false' ), true ) ) {
		return 'true' === strtolower( $text );
	}
	return $text;
}

/**
 * Whether a flag is set: `true` of a block; any text but a "no" of a shortcode, as `controls=""` sets it in HTML.
 *
 * @param mixed $value Of the author.
 * @return bool
 */
function volume_view_is_on( $value ) {
	if ( is_bool( $value ) ) {
		return $value;
	}
	return is_scalar( $value ) && ! in_array( strtolower( trim( (string) $value ) ), array( 'false', 'no', 'off', '0' ), true );
}

/**
 * Writes the tag.
 *
 * @param array<string, string|true> $attributes Not escaped.
 * @return string HTML.
 */
function volume_view_write_tag( $attributes ) {
	$written = '';
	foreach ( $attributes as $name => $value ) {
		$written .= true === $value ? " $name" : sprintf( ' %s="%s"', $name, esc_attr( $value ) );
	}
	return "<volume-view$written></volume-view>";
}

/**
 * Writes the caption, with what HTML a caption may have.
 *
 * @param string $caption HTML of the author.
 * @return string HTML.
 */
function volume_view_write_caption( $caption ) {
	$link    = array(
		'href'   => true,
		'rel'    => true,
		'target' => true,
	);
	$allowed = array_fill_keys( array( 'em', 'strong', 'sub', 'sup', 'code', 's', 'br' ), array() ) + array( 'a' => $link );
	$clean   = trim( wp_kses( (string) $caption, $allowed, array( 'http', 'https', 'mailto' ) ) );
	return '' === $clean ? '' : '<figcaption class="wp-element-caption">' . $clean . '</figcaption>';
}

/**
 * Writes the poster with a link to the post, for where the volume itself can not be shown.
 *
 * @param array<string, string|true> $attributes Not escaped.
 * @param string                     $link       The address of the post.
 * @return string HTML.
 */
function volume_view_write_poster( $attributes, $link ) {
	$alt     = $attributes['alt'] ?? __( 'Volume', 'volume-view' );
	$content = esc_html( $alt );
	if ( isset( $attributes['poster'] ) ) {
		$content = sprintf( '<img src="%s" alt="%s" style="max-width:100%%;height:auto"><br>%s', esc_url( $attributes['poster'] ), esc_attr( $alt ), esc_html__( 'Show in 3D', 'volume-view' ) );
	}
	return sprintf( '<a href="%s" target="_top">%s</a>', esc_url( $link ), $content );
}

/**
 * Says what is wrong with the source, to those who may mend it. A reader sees nothing.
 *
 * @param array $given What the author wrote.
 * @return string HTML.
 */
function volume_view_explain_source( $given ) {
	if ( ! current_user_can( 'edit_posts' ) ) {
		return '';
	}
	$words = empty( $given['src'] )
		? __( 'Volume: no file is chosen. Readers do not see this line.', 'volume-view' )
		: __( 'Volume: the address of the file is not taken. It has to begin with https://, http:// or /. Readers do not see this line.', 'volume-view' );
	return '<p class="volume-view-problem"><em>' . esc_html( $words ) . '</em></p>';
}
