package lightning.editor.document.cue;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import lightning.base.file.SafeFile;
import lightning.base.text.Texts;
import lightning.editor.document.Change;
import lightning.editor.document.LightEdits;
import lightning.format.jen.JenDocument;
import lightning.format.jen.JenException;
import lightning.format.jen.JenReader;
import lightning.scene.Bank;
import lightning.scene.Camera;
import lightning.scene.Light;
import lightning.scene.Picture;
import lightning.scene.Rig;
import lightning.scene.Scene;
import lightning.scene.Stage;
import lightning.scene.World;

/**
 * All that lights a scene, without its shapes and its camera.
 *
 * @param world ambience, background and environment
 * @param rig   lights and banks
 */
public record Lighting(World world, Rig rig) {

    /** How a scene is lit. */
    public static Lighting of(Scene scene) {
        return new Lighting(scene.world(), scene.rig());
    }

    /**
     * The scene lit so: its own shapes, materials and camera stay. Links to shapes that it does not have are left out. Refused where a
     * light has the name of a shape.
     */
    public Change on(Scene scene) {
        return Change.of(() -> scene.withWorld(world).withRig(Rig.of(linked(rig.lights(), scene.stage()), rig.banks())));
    }

    /** The scene with these lights and banks in place of its own; the world stays. Refused as {@link #on}. */
    public Change rigOn(Scene scene) {
        return new Lighting(scene.world(), rig).on(scene);
    }

    /** The scene with these lights and banks beside its own, with free names where theirs are taken. */
    public Change addedTo(Scene scene) {
        return Change.of(() -> {
            Map<String, String> names = new HashMap<>(Map.of("", ""));
            Scene more = scene;
            for (Bank bank : rig.banks()) {
                names.put(bank.name(), LightEdits.freeName(more, bank.name()));
                more = more.withRig(more.rig().plus(bank.withName(names.get(bank.name()))));
            }
            for (Light light : linked(rig.lights(), scene.stage())) {
                more = LightEdits.add(more, light.withBank(names.get(light.bank()))).or(more);
            }
            if (more.lights().size() < scene.lights().size() + rig.lights().size()) {
                throw new IllegalArgumentException(Texts.of("the scene has no room for {0} lights more", rig.lights().size()));
            }
            return more;
        });
    }

    private static List<Light> linked(List<Light> lights, Stage stage) {
        List<Light> all = new ArrayList<>();
        for (Light light : lights) {
            all.add(light.withIlluminates(light.illuminates().within(stage::hasNode))
                    .withShadowedBy(light.shadowedBy().within(stage::hasNode)));
        }
        return all;
    }

    /** Writes it to a file, at once or not at all. */
    public void write(Path file) throws IOException {
        JenDocument.of(new Scene(Picture.DEFAULT, Camera.DEFAULT, world, Stage.EMPTY, rig)).save(SafeFile.at(file));
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
            return of(JenReader.lights(file, folder, stage));
        } catch (JenException e) {
            throw new IOException(e.problems().getFirst().toString(), e);
        }
    }
}
