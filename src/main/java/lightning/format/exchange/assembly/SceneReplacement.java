package lightning.format.exchange.assembly;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.function.UnaryOperator;
import java.util.stream.Collectors;
import lightning.base.file.AtomicFile;
import lightning.base.file.ParentFolder;
import lightning.format.jen.JenException;
import lightning.format.jen.JenReader;
import lightning.scene.Scene;

/**
 * Replacement of a scene and the files next to it, in steps. After each step the scene file shows either the old scene or the new
 * one, with files that belong to it, because a file system can replace only one file at a time:
 *
 * <ol>
 * <li>Copies all files, and the scene as it will be, into a new folder next to the scene.
 * <li>Writes the scene with the files of that folder. From here on it is the new one.
 * <li>Replaces the old files, which no scene file shows now, by links to the new ones.
 * <li>Replaces the scene by the one with the files at their final places, by a link too.
 * <li>Deletes the folder.
 * </ol>
 *
 * <p>Links need no space, so a full disk stops the replacement in the first two steps, and the folder is deleted. On file systems without
 * links, later steps copy. A failure there leaves the folder, which the scene file shows then; so does a killed process.
 * The next replacement of the scene deletes it.
 *
 * @param sceneFile scene file, which need not exist
 * @param copies    files of the scene, in its folder
 */
record SceneReplacement(Path sceneFile, List<AssetCopy> copies, Observer observer) {
    /**
     * Runs all steps.
     *
     * @param text returns the scene file's text with a change of its scene
     * @throws IOException if a file cannot be written
     * @throws JenException if the scene could not be read back; nothing is changed then
     */
    void run(Text text) throws IOException, JenException {
        AtomicFile.of(sceneFile).check();
        for (AssetCopy copy : copies) {
            if (copy.isDifferent()) {
                AtomicFile.of(copy.target()).check();
            }
        }
        try (var staging = StagingFolder.createNextTo(sceneFile)) {
            replaceBy(staging, text);
        }
        StagingFolder.removeStale(sceneFile);
    }

    private void replaceBy(StagingFolder stagingFolder, Text text) throws IOException, JenException {
        Path staging = stagingFolder.path();
        Path finalScene = staging.resolve(sceneFile.getFileName());
        try {
            for (AssetCopy copy : copies) {
                stage(copy, staged(staging, copy));
                observer.afterStep();
            }
            String stagedText = text.of(FileRenaming.into(staging.getFileName().toString(), names())::applyTo);
            JenReader.read(stagedText, sceneFile.toString(), folder()).requireAllFiles();
            write(finalScene, text.of(UnaryOperator.identity()));
            write(sceneFile, stagedText);
        } catch (IOException | JenException | RuntimeException e) {
            stagingFolder.delete();
            throw e;
        }
        observer.afterStep();
        for (AssetCopy copy : copies) {
            if (!copy.isWritten()) {
                replace(copy.target(), staged(staging, copy));
                observer.afterStep();
            }
        }
        replace(sceneFile, finalScene);
        observer.afterStep();
        stagingFolder.delete();
    }

    /** Calls between the changes of files. */
    interface Observer {
        Observer NONE = new Observer() {};

        /** Called before content is written into a new file; linking is none. */
        default void beforeWrite(Path file) throws IOException {}

        /** Called after each change of a file. */
        default void afterStep() {}
    }

    private Path folder() {
        return ParentFolder.of(sceneFile);
    }

    /** Text of a scene file. */
    interface Text {
        /** Returns the text with a change of the scene. */
        String of(UnaryOperator<Scene> change);
    }

    private Set<String> names() {
        return copies.stream().map(copy -> FileNaming.nameIn(folder(), copy.target())).collect(Collectors.toSet());
    }

    private Path staged(Path staging, AssetCopy copy) {
        return staging.resolve(folder().relativize(copy.target()));
    }

    /** Links a file that is at its place already, or copies it. */
    private void stage(AssetCopy copy, Path staged) throws IOException {
        Files.createDirectories(staged.getParent());
        if (!copy.isWritten() || !link(staged, copy.target().toRealPath())) {
            observer.beforeWrite(staged);
            copy.to(staged).write();
        }
    }

    /** Replaces a file by a link to a staged one, or by a copy. */
    private void replace(Path file, Path staged) throws IOException {
        Files.createDirectories(ParentFolder.of(file));
        try {
            AtomicFile.of(file).writeToPath(temporary -> {
                Files.delete(temporary);
                Files.createLink(temporary, staged);
            });
        } catch (IOException | UnsupportedOperationException e) {
            observer.beforeWrite(file);
            new AssetCopy(file, staged, null).write();
        }
    }

    /** Returns whether a link could be created; not all file systems have links. */
    private static boolean link(Path link, Path existing) {
        try {
            Files.createLink(link, existing);
            return true;
        } catch (IOException | UnsupportedOperationException e) {
            return false;
        }
    }

    private void write(Path file, String text) throws IOException {
        observer.beforeWrite(file);
        AtomicFile.of(file).write(text.getBytes(StandardCharsets.UTF_8));
    }
}
