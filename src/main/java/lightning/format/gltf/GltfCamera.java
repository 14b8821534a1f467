package lightning.format.gltf;

import java.util.Optional;

/**
 * A camera of a glTF file.
 *
 * @param fieldOfView the vertical opening angle, radians; empty where the camera has no perspective
 * @param aspectRatio width / height of its picture, above 0; empty where any will do
 */
public record GltfCamera(Optional<Double> fieldOfView, Optional<Double> aspectRatio) {}
