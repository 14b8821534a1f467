package lightning.format.gltf;

import lightning.base.math.Rgb;
import tools.jackson.databind.JsonNode;

/**
 * Light of a glTF file (KHR_lights_punctual), along −z of its node.
 *
 * @param index index in the file
 * @param color linear
 * @param intensity candela for points and spots, lux for directional lights, if the file follows the specification
 * @param innerAngle angle from the axis up to which a spot has full intensity, in radians
 * @param outerAngle angle from the axis where a spot ends, in radians
 * @param hasRange true if it has a maximum distance
 * @param settings this program's settings from its extras; a missing node if absent
 */
public record GltfLight(int index, String name, Type type, Rgb color, double intensity, double innerAngle, double outerAngle,
        boolean hasRange,
        JsonNode settings) {
    /** Key of the settings in the extras. */
    static final String SETTINGS_KEY = "lightning";

    /** Light types as named in files. */
    public enum Type {
        DIRECTIONAL, POINT, SPOT
    }
}
