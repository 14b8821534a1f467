package lightning.format.exchange.json;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import lightning.base.math.Transform;
import lightning.base.math.Vec3;
import lightning.format.exchange.assembly.KeyframeReduction;
import lightning.format.exchange.assembly.NearestAngles;
import lightning.format.exchange.assembly.TransformDecomposition;
import lightning.format.mesh.ConversionNotes;
import lightning.scene.SceneElement;
import lightning.scene.shot.Interpolation;
import lightning.scene.shot.Keyframe;
import lightning.scene.shot.KeyframeValue;
import lightning.scene.shot.Shot;
import lightning.scene.shot.Track;
import lightning.scene.value.Placement;
import tools.jackson.databind.JsonNode;

/** Animation in the extras of a glTF file. Objects have keyed matrices relative to their parents, as glTF's nodes have. */
final class ShotExtras {
    /** Values below 1 have the tolerance of 1: those of a matrix that should be 0 are rounded like the others. */
    private static final KeyframeReduction REDUCTION = new KeyframeReduction(1);

    private final JsonNode json;
    private final Map<String, String> nodeNames;
    private final ConversionNotes notes;
    private final List<Track> tracks = new ArrayList<>();

    /**
     * Creates a reader.
     *
     * @param nodeNames names in the scene of the file's nodes
     * @param notes receives what cannot be used
     */
    ShotExtras(JsonNode json, Map<String, String> nodeNames, ConversionNotes notes) {
        this.json = json;
        this.nodeNames = nodeNames;
        this.notes = notes;
    }

    /** Returns the shot; empty if its frames or keys are invalid. */
    Optional<Shot> read() {
        try {
            JsonNode frames = json.path("frames");
            for (JsonNode track : json.path("tracks")) {
                readTrack(track);
            }
            return Optional.of(new Shot(frames.path(0).asInt(), frames.path(1).asInt(), json.path("rate").asDouble(), tracks));
        } catch (RuntimeException e) {
            // Jackson's conversions and the scene's checks have different exceptions.
            notes.add("animation that cannot be used");
            return Optional.empty();
        }
    }

    private void readTrack(JsonNode track) {
        String name = track.path("name").asString("");
        switch (track.path("target").asString("")) {
            case "camera" -> addTrack(SceneElement.CAMERA, track);
            case "light" -> addTrack(new SceneElement.OfLight(name), track);
            case "node" -> addPlacements(new SceneElement.OfNode(nodeNames.getOrDefault(name, name)), track.path("matrices"));
            default -> notes.add("animated properties that cannot be used");
        }
    }

    private void addTrack(SceneElement<?> target, JsonNode track) {
        List<Keyframe> keys = new ArrayList<>();
        for (JsonNode key : track.path("keys")) {
            JsonNode value = key.get(1);
            KeyframeValue setting = value.isBoolean() ? new KeyframeValue.Word(value.asBoolean() ? "yes" : "no")
                    : value.isString() ? new KeyframeValue.Word(value.asString()) : new KeyframeValue.Numbers(numbers(value));
            keys.add(new Keyframe(key.get(0).asInt(), setting,
                    setting instanceof KeyframeValue.Word ? Interpolation.STEPPED : Interpolation.LINEAR));
        }
        String attribute = track.path("attribute").asString();
        // Between two directions, Lightning rotates.
        boolean isLinear = !attribute.equals("direction") && !attribute.equals("up");
        tracks.add(new Track(target, attribute, REDUCTION.reduce(keys, isLinear)));
    }

    private static List<Double> numbers(JsonNode value) {
        List<Double> numbers = new ArrayList<>();
        for (JsonNode number : value.isArray() ? value : List.of(value)) {
            numbers.add(number.asDouble());
        }
        return numbers;
    }

    /** Adds the keys of an object's position, rotation and scale, each only if it changes. */
    private void addPlacements(SceneElement<?> target, JsonNode matrices) {
        List<Integer> frames = new ArrayList<>();
        List<Vec3> positions = new ArrayList<>();
        List<Vec3> rotations = new ArrayList<>();
        List<Vec3> scales = new ArrayList<>();
        for (JsonNode key : matrices) {
            List<Double> m = numbers(key.get(1));
            // Column-major, as in glTF.
            List<Placement> placements = TransformDecomposition.decompose(new Transform(m.get(0), m.get(4), m.get(8), m.get(12), m.get(1),
                    m.get(5), m.get(9), m.get(13), m.get(2), m.get(6), m.get(10), m.get(14)));
            if (placements.size() != 1) {
                notes.add("animated objects that are sheared or flat, imported without their animation");
                return;
            }
            Placement placement = placements.getFirst();
            frames.add(key.get(0).asInt());
            positions.add(placement.position());
            rotations.add(rotations.isEmpty() ? placement.rotation() : NearestAngles.of(placement.rotation(), rotations.getLast(), v -> v));
            scales.add(placement.scale());
        }
        addVectors(target, "at", frames, positions);
        addVectors(target, "rotate", frames, rotations);
        addVectors(target, "scale", frames, scales);
    }

    private void addVectors(SceneElement<?> target, String attribute, List<Integer> frames, List<Vec3> values) {
        double size = values.stream().mapToDouble(Vec3::maxAbs).max().orElse(0);
        if (values.stream().anyMatch(v -> v.minus(values.getFirst()).maxAbs() > KeyframeReduction.TOLERANCE * Math.max(1, size))) {
            List<Keyframe> keys = new ArrayList<>();
            for (int i = 0; i < frames.size(); i++) {
                Vec3 v = values.get(i);
                keys.add(new Keyframe(frames.get(i), new KeyframeValue.Numbers(List.of(v.x(), v.y(), v.z())), Interpolation.LINEAR));
            }
            tracks.add(new Track(target, attribute, REDUCTION.reduce(keys, true)));
        }
    }
}
