package lightning.format.jen;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import lightning.base.file.ParentFolder;
import lightning.base.text.Quote;
import lightning.scene.Scene;

/**
 * Files that a command reads. It must not write any of them, whatever path or link leads there: a picture with the name of a texture would
 * destroy the scene.
 */
public record InputFiles(Set<Path> files) {
    public InputFiles {
        files = Set.copyOf(files);
    }

    /** Returns given files. */
    public static InputFiles of(Path... files) {
        return new InputFiles(Set.of(files));
    }

    /**
     * Returns the files that a scene references.
     *
     * @param folder folder of the scene file
     */
    public static InputFiles referencedBy(Scene scene, Path folder) {
        return new InputFiles(ReferencedFiles.existing(List.of(scene), folder));
    }

    /** Returns a scene file with the files that it references, also after edits. */
    public static InputFiles of(Path sceneFile, List<Scene> scenes) {
        Set<Path> files = new HashSet<>(ReferencedFiles.existing(scenes, ParentFolder.of(sceneFile)));
        files.add(sceneFile);
        return new InputFiles(files);
    }

    /** Returns these files and another one. */
    public InputFiles with(Path file) {
        Set<Path> all = new HashSet<>(files);
        all.add(file);
        return new InputFiles(all);
    }

    /**
     * Checks that an output is none of the files.
     *
     * @throws IOException if it is; the message begins with its name
     */
    public void check(Path output) throws IOException {
        if (!Files.exists(output)) {
            return;
        }
        for (Path file : files) {
            if (Files.exists(file) && Files.isSameFile(file, output)) {
                throw new IOException(Quote.path(output) + ": is read by this command and would be replaced; choose another output name");
            }
        }
    }
}
