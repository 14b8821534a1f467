package lightning.format.gltf;

import lightning.base.math.Rgb;
import tools.jackson.databind.JsonNode;

/**
 * A light of a glTF file (KHR_lights_punctual); it shines along −z of its node.
 *
 * @param index     its number in the file
 * @param color     linear
 * @param intensity candela of points and spots, lux of directional ones, if the file keeps to the specification
 * @param inner     radians from the axis, up to which a spot is undimmed
 * @param outer     radians from the axis, where a spot ends
 * @param ranged    whether it ends at a distance
 * @param own       what this program wrote into its extras; a missing node where it did not
 */
public record GltfLight(int index, String name, Type type, Rgb color, double intensity, double inner, double outer, boolean ranged,
        JsonNode own) {
    /** Where it is in the extras. */
    static final String OWN = "lightning";

    /** As the files name them. */
    public enum Type {
        DIRECTIONAL, POINT, SPOT
    }
}
