package lightning.format.exchange;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.util.List;
import java.util.function.UnaryOperator;
import lightning.base.file.AtomicFile;
import lightning.base.file.TemporaryFolder;
import lightning.format.jen.JenException;
import lightning.format.jen.JenReader;
import lightning.scene.Scene;

/**
 * Replacement of a scene and the files next to it, in steps. After each step the scene file shows either the old scene or the new
 * one, with files that belong to it, because a file system can replace only one file at a time:
 *
 * <ol>
 * <li>Copies all files into a new folder next to the scene.
 * <li>Writes the scene with the files of that folder. From here on it is the new one.
 * <li>Replaces the old files, which no scene file shows now.
 * <li>Writes the scene with the files at their final places.
 * <li>Deletes the folder.
 * </ol>
 *
 * <p>A killed process can leave the folder.
 */
final class SceneReplacement {
    private static final String FOLDER_ENDING = ".import";

    /** Leaves most of a file name's 200 characters to the files in the folder. */
    private static final int MAX_STEM_LENGTH = 24;

    private final Path sceneFile;
    private final Path folder;
    private final List<AssetCopy> copies;
    private final Runnable afterStep;

    /**
     * Creates a replacement.
     *
     * @param sceneFile scene file, which need not exist
     * @param copies files of the scene, in its folder
     * @param afterStep called after each change of a file
     */
    SceneReplacement(Path sceneFile, List<AssetCopy> copies, Runnable afterStep) {
        this.sceneFile = sceneFile;
        this.folder = sceneFile.toAbsolutePath().getParent();
        this.copies = copies;
        this.afterStep = afterStep;
    }

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
        Path staging = unusedFolder();
        try {
            for (AssetCopy copy : copies) {
                stage(copy, staged(staging, copy));
                afterStep.run();
            }
            String stagedText = text.of(new FilePrefix(staging.getFileName() + "/")::applyTo);
            JenReader.read(stagedText, sceneFile.toString(), folder);
            writeScene(stagedText);
        } catch (IOException | JenException | RuntimeException e) {
            TemporaryFolder.delete(staging);
            throw e;
        }
        afterStep.run();
        for (AssetCopy copy : copies) {
            if (!copy.isWritten()) {
                new AssetCopy(copy.target(), staged(staging, copy), null).write();
                afterStep.run();
            }
        }
        writeScene(text.of(UnaryOperator.identity()));
        afterStep.run();
        TemporaryFolder.delete(staging);
    }

    /** Text of a scene file. */
    interface Text {
        /** Returns the text with a change of the scene. */
        String of(UnaryOperator<Scene> change);
    }

    private Path unusedFolder() throws IOException {
        String name = SceneAssembler.sanitize(sceneFile.getFileName().toString().replaceFirst("\\.[^.]*$", ""));
        String start = name.substring(0, name.offsetByCodePoints(0, Math.min(MAX_STEM_LENGTH, name.codePointCount(0, name.length()))));
        for (int i = 1;; i++) {
            Path candidate = folder.resolve(start + FOLDER_ENDING + (i == 1 ? "" : i));
            if (!Files.exists(candidate, LinkOption.NOFOLLOW_LINKS)) {
                return Files.createDirectory(candidate);
            }
        }
    }

    private Path staged(Path staging, AssetCopy copy) {
        return staging.resolve(folder.relativize(copy.target()));
    }

    /** Links a file that is at its place already, or copies it if the file system has no links. */
    private static void stage(AssetCopy copy, Path staged) throws IOException {
        if (copy.isWritten()) {
            try {
                Files.createDirectories(staged.getParent());
                Files.createLink(staged, copy.target().toRealPath());
                return;
            } catch (IOException | UnsupportedOperationException e) {
                // Copied below.
            }
        }
        copy.to(staged).write();
    }

    private void writeScene(String text) throws IOException {
        AtomicFile.of(sceneFile).write(text.getBytes(StandardCharsets.UTF_8));
    }
}
