package lightning.document;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.UnaryOperator;
import lightning.base.text.Messages;
import lightning.base.text.Quote;
import lightning.base.text.RefusalException;
import lightning.format.jen.PropertyEdit;
import lightning.scene.Dome;
import lightning.scene.Scene;
import lightning.scene.SceneElement;
import lightning.scene.asset.Environment;

/** Edits of domes. Each is refused if the named dome does not exist. */
public final class DomeEdits {
    private DomeEdits() {}

    /**
     * Reads the image of a new dome.
     *
     * @param file   name of the file for a scene
     * @param folder folder that it is resolved against
     * @throws IllegalArgumentException if it cannot be used
     */
    public static Environment read(Scene scene, String file, Path folder) {
        String name = LightEdits.freeName(scene, "dome");
        Scene added = add(scene, Dome.of(name));
        return PropertyEdit.setFile(added, new SceneElement.OfDome(name), Dome.ENVIRONMENT.name(), file, folder).world().dome(name)
                .flatMap(Dome::image).orElseThrow();
    }

    /** Adds a dome with an image after the others, named after its file. */
    public static EditOutcome add(Scene scene, Environment image) {
        String stem = Path.of(image.file()).getFileName().toString().replaceFirst("\\.[^.]*$", "");
        return EditOutcome.of(() -> add(scene, Dome.of(LightEdits.freeName(scene, stem)).withImage(Optional.of(image))));
    }

    private static Scene add(Scene scene, Dome dome) {
        List<Dome> domes = new ArrayList<>(scene.world().named());
        domes.add(dome);
        return scene.withWorld(scene.world().withNamed(domes));
    }

    /** Edits one dome. */
    public static EditOutcome edit(Scene scene, String name, UnaryOperator<Dome> edit) {
        return EditOutcome.of(() -> scene.withWorld(scene.world().withDome(name, edit.apply(dome(scene, name)))));
    }

    /** Deletes a dome. */
    public static EditOutcome delete(Scene scene, String name) {
        return EditOutcome.of(() -> scene.withWorld(scene.world().withNamed(
                scene.world().named().stream().filter(dome -> dome != dome(scene, name)).toList())));
    }

    /**
     * Returns the dome with that name.
     *
     * @throws IllegalArgumentException if there is none
     */
    static Dome dome(Scene scene, String name) {
        return scene.world().dome(name)
                .orElseThrow(() -> new RefusalException(Messages.tr("dome {0} not found", Quote.of(name))));
    }
}
