package lightning.format.gltf;

import java.util.Optional;

/**
 * Camera of a glTF file.
 *
 * @param fieldOfView vertical field of view in radians; empty for an orthographic camera
 * @param aspectRatio width / height of the image, above 0; empty for any
 */
public record GltfCamera(Optional<Double> fieldOfView, Optional<Double> aspectRatio) {}
