package lightning.format.gltf;

import java.util.Arrays;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import lightning.format.mesh.MeshException;

/**
 * Property of a glTF file that can have keys.
 *
 * @param index index of its node, light or camera
 */
record AnimatedProperty(Kind kind, int index) {
    /** Kind of a property, with its pointer (KHR_animation_pointer). */
    enum Kind {
        TRANSLATION("/nodes/(\\d{1,9})/translation", "translation", 3),
        ROTATION("/nodes/(\\d{1,9})/rotation", "rotation", 4),
        SCALE("/nodes/(\\d{1,9})/scale", "scale", 3),
        WEIGHTS("/nodes/(\\d{1,9})/weights", "weights", 1),
        INTENSITY("/extensions/KHR_lights_punctual/lights/(\\d{1,9})/intensity", "", 1),
        COLOR("/extensions/KHR_lights_punctual/lights/(\\d{1,9})/color", "", 3),
        FIELD_OF_VIEW("/cameras/(\\d{1,9})/perspective/yfov", "", 1);

        private final Pattern pointer;
        private final String path;
        private final int components;

        Kind(String pointer, String path, int components) {
            this.pointer = Pattern.compile(pointer);
            this.path = path;
            this.components = components;
        }

        int components() {
            return components;
        }

        private JsonValue array(GltfFile file) throws MeshException {
            return switch (this) {
                case TRANSLATION, ROTATION, SCALE, WEIGHTS -> file.array("nodes");
                case INTENSITY, COLOR -> file.root().get("extensions").get("KHR_lights_punctual").get("lights");
                case FIELD_OF_VIEW -> file.array("cameras");
            };
        }
    }

    /** Returns the property that a channel has keys for; empty if it is none of these. */
    static Optional<AnimatedProperty> of(GltfFile file, JsonValue target) throws MeshException {
        String path = target.get("path").text().orElse("");
        if (path.equals("pointer")) {
            return ofPointer(file, target.get("extensions").get("KHR_animation_pointer").get("pointer").text().orElse(""));
        }
        if (!target.get("node").isPresent()) {
            return Optional.empty();
        }
        int node = target.get("node").index(file.array("nodes"));
        return Arrays.stream(Kind.values()).filter(kind -> !path.isEmpty() && kind.path.equals(path)).findFirst()
                .map(kind -> new AnimatedProperty(kind, node));
    }

    private static Optional<AnimatedProperty> ofPointer(GltfFile file, String pointer) throws MeshException {
        for (Kind kind : Kind.values()) {
            Matcher matcher = kind.pointer.matcher(pointer);
            if (matcher.matches()) {
                int index = Integer.parseInt(matcher.group(1));
                return index < kind.array(file).size() ? Optional.of(new AnimatedProperty(kind, index)) : Optional.empty();
            }
        }
        return Optional.empty();
    }
}
