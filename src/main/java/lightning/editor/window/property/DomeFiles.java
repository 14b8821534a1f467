package lightning.editor.window.property;

import java.io.File;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.function.BiFunction;
import lightning.document.DomeEdits;
import lightning.document.EditOutcome;
import lightning.editor.window.model.EditorModel;
import lightning.editor.window.model.ErrorMessage;
import lightning.editor.window.model.SceneEditor;
import lightning.format.jen.asset.FileKind;
import lightning.scene.Scene;
import lightning.scene.World;
import lightning.scene.asset.Environment;

/** Adds environments from files, which are read in the background. */
public final class DomeFiles {
    private DomeFiles() {}

    /** Returns whether a file can be an environment, by its name. */
    public static boolean canAdd(File file) {
        return FileKind.ENVIRONMENT.isNamed(file.getName());
    }

    /** Copies the first environment among files to the scene's folder, and adds it. Returns whether one of them is an environment. */
    public static boolean addFirst(EditorModel model, List<File> files) {
        Optional<File> image = files.stream().filter(DomeFiles::canAdd).findFirst();
        image.ifPresent(
                file -> model.fileImporter().importFile(FileKind.ENVIRONMENT, file.toPath(), name -> add(model, name, DomeFiles::added),
                        model.editor().message()::show));
        return image.isPresent();
    }

    /** Returns the scene with an image as its environment if it has none, otherwise as a dome. */
    private static EditOutcome added(Scene scene, Environment image) {
        return scene.world().hasEnvironment() ? DomeEdits.add(scene, image)
                : EditOutcome.of(() -> scene.withWorld(World.ENVIRONMENT.with(scene.world(), Optional.of(image))));
    }

    /**
     * Adds an image of the scene's folder.
     *
     * @param add returns the scene with the image
     */
    static void add(EditorModel model, String file, BiFunction<Scene, Environment, EditOutcome> add) {
        SceneEditor editor = model.editor();
        Path folder = model.fileImporter().folder();
        Scene requestScene = editor.scene();
        model.fileImporter().files().runConcurrently(() -> DomeEdits.read(requestScene, file, folder),
                image -> editor.editOrReport(scene -> add.apply(scene, image)),
                e -> editor.message().show(ErrorMessage.of(e)));
    }
}
