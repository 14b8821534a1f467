package lightning.document.look;

import java.io.IOException;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;
import lightning.base.file.AtomicFile;
import lightning.base.text.Messages;
import lightning.base.text.RefusalException;
import lightning.document.EditOutcome;
import lightning.document.LightEdits;
import lightning.format.jen.JenDocument;
import lightning.format.jen.JenException;
import lightning.format.jen.JenReader;
import lightning.scene.Camera;
import lightning.scene.PictureSettings;
import lightning.scene.Scene;
import lightning.scene.Stage;
import lightning.scene.World;
import lightning.scene.light.Light;
import lightning.scene.light.LightGroup;
import lightning.scene.light.LightRig;

/**
 * Lighting of a scene, without its shapes and camera.
 *
 * @param world ambience, background, environment and domes
 * @param rig   lights and light groups
 */
public record Lighting(World world, LightRig rig) {

    /** Returns the lighting of a scene. */
    public static Lighting of(Scene scene) {
        return new Lighting(scene.world(), scene.rig());
    }

    /**
     * Applies this lighting to a scene, keeping its shapes, materials and camera. Drops links to missing shapes. Refused if a light has the
     * name of a shape.
     */
    public EditOutcome applyTo(Scene scene) {
        return EditOutcome
                .of(() -> scene.withWorld(world).withRig(rig.forShapes(scene.stage()::hasNode)));
    }

    /** Replaces the scene's lights and light groups, keeping its world. Refused as {@link #applyTo}. */
    public EditOutcome applyRigTo(Scene scene) {
        return new Lighting(scene.world(), rig).applyTo(scene);
    }

    /** Adds these lights and light groups to the scene, renaming them if their names are taken. */
    public EditOutcome addTo(Scene scene) {
        return EditOutcome.of(() -> {
            Map<String, String> names = new HashMap<>(Map.of("", ""));
            Scene extended = scene;
            for (LightGroup group : rig.lightGroups()) {
                names.put(group.name(), LightEdits.freeName(extended, group.name()));
                extended = extended.withRig(extended.rig().addLightGroup(group.withName(names.get(group.name()))));
            }
            for (Light light : rig.forShapes(scene.stage()::hasNode).lights()) {
                extended = LightEdits.add(extended, light.withLightGroup(names.get(light.lightGroup()))).sceneOr(extended);
            }
            if (extended.lights().size() < scene.lights().size() + rig.lights().size()) {
                throw new RefusalException(Messages.tr("the scene has no room for {0} more lights", rig.lights().size()));
            }
            return extended;
        });
    }

    /** Writes it to a file atomically. */
    public void write(Path file) throws IOException {
        JenDocument.of(new Scene(PictureSettings.DEFAULT, Camera.DEFAULT, world, Stage.EMPTY, rig)).save(AtomicFile.of(file));
    }

    /**
     * Reads the lighting of any scene file.
     *
     * @param folder folder of the target scene, where files of the lights are searched
     * @param stage  stage of the target scene
     * @throws IOException if the file cannot be read or its content is invalid; the message is a sentence with the first problem
     */
    public static Lighting read(Path file, Path folder, Stage stage) throws IOException {
        try {
            return of(JenReader.readLights(file, folder, stage));
        } catch (JenException e) {
            throw new IOException(e.problems().getFirst().toString(), e);
        }
    }
}
