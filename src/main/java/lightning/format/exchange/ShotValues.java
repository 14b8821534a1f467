package lightning.format.exchange;

import java.util.List;
import java.util.function.BiConsumer;
import java.util.stream.IntStream;
import lightning.base.text.RefusalException;
import lightning.format.exchange.json.AttributeJson;
import lightning.format.exchange.json.TransformJson;
import lightning.format.mesh.ConversionNotes;
import lightning.scene.Camera;
import lightning.scene.Dome;
import lightning.scene.Scene;
import lightning.scene.light.Light;
import lightning.scene.light.LightAttribute;
import lightning.scene.light.LightGroup;
import lightning.scene.shot.AnimatedScene;
import lightning.scene.shot.Shot;
import lightning.scene.shot.Track;
import lightning.scene.shot.TrackTarget;
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
        shot.tracks().stream().map(Track::target).filter(target -> target.kind() == TrackTarget.Kind.NODE).distinct()
                .forEach(target -> writeMatrices(tracks, target.name(), frames));
    }

    private void write(ArrayNode tracks, Track track, List<Scene> frames) {
        String name = track.target().name();
        String attribute = track.attribute();
        switch (track.target().kind()) {
            case LIGHT -> {
                addValues(tracks.addObject().put("light", name), attribute, frames,
                        (json, scene) -> AttributeJson.write(json, light(scene, name), LightAttribute.ALL));
                if (attribute.equals("intensity")) {
                    String relative = LightExport.RELATIVE_INTENSITY;
                    addValues(tracks.addObject().put("light", name), relative, frames,
                            (json, scene) -> json.put(relative, LightExport.relativeIntensity(light(scene, name), scene)));
                }
            }
            case LIGHT_GROUP -> addValues(tracks.addObject().put("bank", name), attribute, frames,
                    (json, scene) -> AttributeJson.write(json, scene.rig().lightGroup(name).orElseThrow(), LightGroup.ATTRIBUTES));
            case CAMERA -> addValues(tracks.addObject().put("camera", true), attribute, frames,
                    (json, scene) -> AttributeJson.write(json, scene.camera(), Camera.ATTRIBUTES));
            case DOME -> addValues(tracks.addObject().put("dome", name), attribute, frames,
                    (json, scene) -> AttributeJson.write(json, scene.world().dome(name).orElseThrow(), Dome.ATTRIBUTES));
            case NODE -> {
                // A matrix has all attributes of an object.
            }
        }
    }

    private static Light light(Scene scene, String name) {
        return scene.light(name).orElseThrow();
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
