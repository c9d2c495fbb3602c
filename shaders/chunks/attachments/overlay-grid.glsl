/// Voxels of the layer along i, j and k.
uniform vec3 uOverlayDimensions;

/// The volume's unit cube to the layer's.
uniform mat4 uToOverlay;
