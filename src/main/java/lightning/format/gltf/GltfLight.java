package lightning.format.gltf;

import lightning.base.math.Rgb;
import tools.jackson.databind.JsonNode;

/**
 * A light of a glTF file (KHR_lights_punctual); it shines along −z of its node.
 *
 * @param index     its number in the file
 * @param color     linear
 * @param intensity candela of points and spots, lux of directional ones, if the file keeps to the specification
 * @param innerAngle     radians from the axis, up to which a spot is undimmed
 * @param outerAngle     radians from the axis, where a spot ends
 * @param hasRange    whether it ends at a distance
 * @param settings       what this program wrote into its extras; a missing node where it did not
 */
public record GltfLight(int index, String name, Type type, Rgb color, double intensity, double innerAngle, double outerAngle,
        boolean hasRange,
        JsonNode settings) {
    /** Where it is in the extras. */
    static final String SETTINGS_KEY = "lightning";

    /** As the files name them. */
    public enum Type {
        DIRECTIONAL, POINT, SPOT
    }
}
