<?php
/**
 * Answers what the loaded parts of WordPress ask the data base, or a person.
 *
 * @package VolumeView
 */

// phpcs:disable -- A program of the tests; it is no part of the plugin.

add_filter( 'pre_option_blog_charset', function () { return 'UTF-8'; } );

function __( $text ) { return $text; }
function esc_html__( $text ) { return esc_html( $text ); }
function esc_attr__( $text ) { return esc_attr( $text ); }
function is_feed() { return $GLOBALS['is_feed'] ?? false; }
function is_embed() { return false; }
function current_user_can() { return $GLOBALS['may_edit'] ?? false; }
function get_permalink() { return 'https://site.example/post/'; }
function wp_enqueue_script( $handle ) { $GLOBALS['loaded'][] = $handle; }
function wp_enqueue_style() {}
function wp_register_script() {}
function wp_register_style() {}
function plugins_url( $path ) { return "https://site.example/wp-content/plugins/volume-view/$path"; }
function load_plugin_textdomain() {}
function parse_blocks( $content ) { return ( new WP_Block_Parser() )->parse( $content ); }
function attachment_url_to_postid( $url ) { return 'https://site.example/wp-content/uploads/mosaic-scaled.png' === $url ? 7 : 0; }
function wp_get_original_image_url( $id ) { return 7 === $id ? 'https://site.example/wp-content/uploads/mosaic.png' : false; }

function wp_cache_get( $name ) { return 'alloptions' === $name ? array( 'blog_charset' => 'UTF-8' ) : false; }
function add_settings_section() {}
