package lightning.editor.document.cue;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import lightning.base.file.AtomicFile;
import lightning.base.text.Messages;
import lightning.editor.document.EditOutcome;
import lightning.editor.document.LightEdits;
import lightning.format.jen.JenDocument;
import lightning.format.jen.JenException;
import lightning.format.jen.JenReader;
import lightning.scene.Camera;
import lightning.scene.Light;
import lightning.scene.LightGroup;
import lightning.scene.LightRig;
import lightning.scene.PictureSettings;
import lightning.scene.Scene;
import lightning.scene.Stage;
import lightning.scene.World;

/**
 * All that lights a scene, without its shapes and its camera.
 *
 * @param world ambience, background and environment
 * @param rig   lights and banks
 */
public record Lighting(World world, LightRig rig) {

    /** How a scene is lit. */
    public static Lighting of(Scene scene) {
        return new Lighting(scene.world(), scene.rig());
    }

    /**
     * The scene lit so: its own shapes, materials and camera stay. Links to shapes that it does not have are left out. Refused where a
     * light has the name of a shape.
     */
    public EditOutcome applyTo(Scene scene) {
        return EditOutcome
                .of(() -> scene.withWorld(world).withRig(LightRig.of(withValidLinks(rig.lights(), scene.stage()), rig.lightGroups())));
    }

    /** The scene with these lights and banks in place of its own; the world stays. Refused as {@link #applyTo}. */
    public EditOutcome applyRigTo(Scene scene) {
        return new Lighting(scene.world(), rig).applyTo(scene);
    }

    /** The scene with these lights and banks beside its own, with free names where theirs are taken. */
    public EditOutcome addTo(Scene scene) {
        return EditOutcome.of(() -> {
            Map<String, String> names = new HashMap<>(Map.of("", ""));
            Scene extended = scene;
            for (LightGroup group : rig.lightGroups()) {
                names.put(group.name(), LightEdits.freeName(extended, group.name()));
                extended = extended.withRig(extended.rig().addLightGroup(group.withName(names.get(group.name()))));
            }
            for (Light light : withValidLinks(rig.lights(), scene.stage())) {
                extended = LightEdits.add(extended, light.withLightGroup(names.get(light.lightGroup()))).sceneOr(extended);
            }
            if (extended.lights().size() < scene.lights().size() + rig.lights().size()) {
                throw new IllegalArgumentException(Messages.tr("the scene has no room for {0} more lights", rig.lights().size()));
            }
            return extended;
        });
    }

    private static List<Light> withValidLinks(List<Light> lights, Stage stage) {
        List<Light> all = new ArrayList<>();
        for (Light light : lights) {
            all.add(light.withIlluminates(light.illuminates().retain(stage::hasNode))
                    .withShadowedBy(light.shadowedBy().retain(stage::hasNode)));
        }
        return all;
    }

    /** Writes it to a file, at once or not at all. */
    public void write(Path file) throws IOException {
        JenDocument.of(new Scene(PictureSettings.DEFAULT, Camera.DEFAULT, world, Stage.EMPTY, rig)).save(AtomicFile.of(file));
    }

    /**
     * Reads the lighting of any scene file.
     *
     * @param folder where the scene is for which it is read, beside which files that lights name are looked for
     * @param stage  that scene's
     * @throws IOException if the file cannot be read, or its content is wrong; the message is a sentence with the first problem
     */
    public static Lighting read(Path file, Path folder, Stage stage) throws IOException {
        try {
            return of(JenReader.readLights(file, folder, stage));
        } catch (JenException e) {
            throw new IOException(e.problems().getFirst().toString(), e);
        }
    }
}
