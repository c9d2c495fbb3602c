<?php
/**
 * Words that attributes take, for the side panel of the editor.
 *
 * Written by `npm run docs` of the project of the element; edit the element, not this file.
 *
 * @package VolumeView
 * @license MIT
 */

defined( 'ABSPATH' ) || exit;

/**
 * Words that attributes take, for the side panel of the editor.
 *
 * @return array<string, string[]> By the names of attributes.
 */
function volume_view_choices() {
	return array(
		'look'              => array( 'textbook', 'flat', 'mip', 'xray', 'skin', 'bone', 'vessels' ),
		'transfer-function' => array( 'gray', 'ct-bone', 'ct-soft-tissue', 'ct-angio', 'ct-lung', 'radar-dbz', 'radar-velocity', 'diverging', 'viridis', 'inferno', 'magma', 'plasma', 'cividis', 'turbo' ),
		'projection'        => array( 'max', 'min', 'average' ),
		'shading'           => array( 'lit', 'ambient-occlusion', 'unlit' ),
		'detail'            => array( 'keep', 'free' ),
	);
}
