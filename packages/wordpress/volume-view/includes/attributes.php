<?php
/**
 * The attributes of the element that a post may have, each with its kind: flag, flag-or-text, text, choice, address, or addresses.
 *
 * Written by `npm run docs` of the project of the element; edit the element, not this file.
 *
 * @package VolumeView
 * @license MIT
 */

defined( 'ABSPATH' ) || exit;

/**
 * The attributes of the element that a post may have, each with its kind: flag, flag-or-text, text, choice, address, or addresses.
 *
 * @return array<string, string> Kinds by names.
 */
function volume_view_attributes() {
	return array(
		'src'                   => 'addresses',
		'stack'                 => 'flag',
		'mosaic'                => 'text',
		'slices'                => 'text',
		'spacing'               => 'text',
		'coordinates'           => 'text',
		'elevations'            => 'text',
		'range'                 => 'text',
		'azimuth'               => 'text',
		'series'                => 'text',
		'max-bytes'             => 'text',
		'max-gpu-bytes'         => 'text',
		'clean'                 => 'flag-or-text',
		'moment'                => 'text',
		'color-moment'          => 'text',
		'beam-model'            => 'text',
		'vertical-exaggeration' => 'text',
		'time'                  => 'text',
		'autoplay'              => 'flag',
		'play-speed'            => 'text',
		'look'                  => 'text',
		'transfer-function'     => 'text',
		'projection'            => 'choice',
		'shading'               => 'choice',
		'surface-values'        => 'text',
		'gradient-opacity'      => 'text',
		'transfer-function-2d'  => 'text',
		'value-window'          => 'text',
		'reference-length'      => 'text',
		'opacity-factor'        => 'text',
		'light-factor'          => 'text',
		'steps'                 => 'text',
		'max-error'             => 'text',
		'detail'                => 'choice',
		'target-fps'            => 'text',
		'region'                => 'text',
		'cutout'                => 'text',
		'rings'                 => 'flag-or-text',
		'camera-orbit'          => 'text',
		'camera-target'         => 'text',
		'field-of-view'         => 'text',
		'min-camera-orbit'      => 'text',
		'max-camera-orbit'      => 'text',
		'interpolation-decay'   => 'text',
		'auto-rotate'           => 'flag',
		'auto-rotate-delay'     => 'text',
		'rotation-per-second'   => 'text',
		'orientation-marker'    => 'flag',
		'interaction'           => 'text',
		'controls'              => 'flag',
		'controlslist'          => 'text',
		'pickable'              => 'flag',
		'self-check'            => 'flag',
		'width'                 => 'text',
		'height'                => 'text',
		'alt'                   => 'text',
		'poster'                => 'address',
		'loading'               => 'text',
	);
}
