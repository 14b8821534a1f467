package lightning.format.exchange;

import java.util.List;
import java.util.function.BiConsumer;
import java.util.stream.IntStream;
import lightning.base.text.RefusalException;
import lightning.format.exchange.json.AttributeJson;
import lightning.format.exchange.json.TransformJson;
import lightning.format.mesh.ConversionNotes;
import lightning.scene.Scene;
import lightning.scene.SceneElement;
import lightning.scene.shot.AnimatedScene;
import lightning.scene.shot.Shot;
import lightning.scene.shot.Track;
import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.ObjectNode;

/**
 * Values of a shot at each of its frames, as JSON: each animated attribute of lights, light groups and the camera, and the transforms of
 * animated objects.
 *
 * @param notes receives what is left out
 */
record ShotValues(AnimatedScene animated, Shot shot, ConversionNotes notes) {
    /** Most frames of a shot whose values are written. */
    private static final int MAX_FRAMES = 100_000;
    private static final JsonMapper JSON = JsonMapper.builder().build();

    void write(ObjectNode out) {
        out.putArray("frames").add(shot.first()).add(shot.last());
        out.put("rate", shot.rate());
        ArrayNode tracks = out.putArray("tracks");
        if (shot.tracks().isEmpty()) {
            return;
        }
        if (shot.last() - shot.first() >= MAX_FRAMES) {
            notes.add("animation of more than " + MAX_FRAMES + " frames");
            return;
        }
        List<Scene> frames;
        try {
            frames = IntStream.rangeClosed(shot.first(), shot.last()).mapToObj(animated::sceneAt).toList();
        } catch (RefusalException e) {
            notes.add("animation of frames that cannot be shown");
            return;
        }
        for (Track track : shot.tracks()) {
            write(tracks, track, frames);
        }
        shot.tracks().stream().map(Track::target).filter(target -> target instanceof SceneElement.OfNode).distinct()
                .forEach(target -> writeMatrices(tracks, target.name(), frames));
    }

    private void write(ArrayNode tracks, Track track, List<Scene> frames) {
        switch (track.target()) {
            case SceneElement.OfLight light -> {
                addValues(tracks.addObject().put("light", light.name()), track, frames);
                if (track.attribute().equals("intensity")) {
                    String relative = LightExport.RELATIVE_INTENSITY;
                    addValues(tracks.addObject().put("light", light.name()), relative, frames,
                            (json, scene) -> json.put(relative, LightExport.relativeIntensity(light.get(scene), scene)));
                }
            }
            case SceneElement.OfLightGroup(String name) -> addValues(tracks.addObject().put("bank", name), track, frames);
            case SceneElement.OfCamera _ -> addValues(tracks.addObject().put("camera", true), track, frames);
            case SceneElement.OfWorld _ -> addValues(tracks.addObject().put("world", true), track, frames);
            case SceneElement.OfDome(String name) -> addValues(tracks.addObject().put("dome", name), track, frames);
            default -> {
                // A matrix has all attributes of an object.
            }
        }
    }

    private static void addValues(ObjectNode out, Track track, List<Scene> frames) {
        addValues(out, track.attribute(), frames, (json, scene) -> write(json, scene, track.target()));
    }

    private static <T> void write(ObjectNode json, Scene scene, SceneElement<T> element) {
        AttributeJson.write(json, element.get(scene), element.attributes(scene));
    }

    private static void addValues(ObjectNode track, String attribute, List<Scene> frames, BiConsumer<ObjectNode, Scene> writer) {
        ArrayNode values = track.put("attribute", attribute).putArray("values");
        for (Scene frame : frames) {
            ObjectNode json = JSON.createObjectNode();
            writer.accept(json, frame);
            values.add(json.get(attribute));
        }
    }

    /** Writes the transforms of an object from its coordinates to the scene's, column by column as in glTF. */
    private void writeMatrices(ArrayNode tracks, String name, List<Scene> frames) {
        if (animated.base().stage().nodes().stream().noneMatch(node -> node.name().equals(name))) {
            notes.add("animated objects inside of groups");
            return;
        }
        ArrayNode matrices = tracks.addObject().put("node", name).putArray("matrices");
        for (Scene frame : frames) {
            TransformJson.write(matrices.addArray(), frame.stage().node(name).orElseThrow());
        }
    }
}
