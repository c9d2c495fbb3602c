<?php
/**
 * The only setting, under Settings, Media. WordPress' own page checks who may change it, and where the form came from.
 *
 * @package VolumeView
 * @license MIT
 */

defined( 'ABSPATH' ) || exit;

/** Registers the setting and its field. */
function volume_view_register_setting() {
	register_setting(
		'media',
		'volume_view_uploads',
		array(
			'type'              => 'boolean',
			'default'           => false,
			'sanitize_callback' => 'rest_sanitize_boolean',
		)
	);
	add_settings_section( 'volume_view', __( 'Volumes', 'volume-view' ), '__return_null', 'media' );
	add_settings_field(
		'volume_view_uploads',
		__( 'Uploads', 'volume-view' ),
		'volume_view_write_field',
		'media',
		'volume_view',
		array( 'label_for' => 'volume_view_uploads' )
	);
}
add_action( 'admin_init', 'volume_view_register_setting' );

/** Writes the field. */
function volume_view_write_field() {
	?>
	<input type="checkbox" id="volume_view_uploads" name="volume_view_uploads" value="1" <?php checked( (bool) get_option( 'volume_view_uploads', false ) ); ?>>
	<?php esc_html_e( 'People who may upload files may upload volumes, too: NIfTI (.nii, .nii.gz), NRRD (.nrrd), MetaImage (.mha), radar scans in HDF5 (.h5), and manifests (.json).', 'volume-view' ); ?>
	<p class="description"><?php esc_html_e( 'Each file is checked by its content. It is not searched for names of patients: some formats have room for them. DICOM files, which hold such names, are not taken.', 'volume-view' ); ?></p>
	<?php
}

/**
 * Adds a link to the setting in the list of plugins.
 *
 * @param string[] $links Of this plugin.
 * @return string[]
 */
function volume_view_add_link( $links ) {
	$links[] = sprintf( '<a href="%s">%s</a>', esc_url( admin_url( 'options-media.php' ) ), esc_html__( 'Settings', 'volume-view' ) );
	return $links;
}
add_filter( 'plugin_action_links_' . plugin_basename( VOLUME_VIEW_FILE ), 'volume_view_add_link' );
