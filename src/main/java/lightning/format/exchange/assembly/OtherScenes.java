package lightning.format.exchange.assembly;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.DirectoryIteratorException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import lightning.base.file.ParentFolder;
import lightning.base.file.RegularFile;
import lightning.format.jen.JenFile;

/**
 * Texts of the scene files in a folder, to find out which files they use.
 *
 * @param isIncomplete true if a scene file cannot be read, so that it may use any file
 */
record OtherScenes(List<String> texts, boolean isIncomplete) {
    private static final int MAX_BYTES = 64 << 20;

    /** Reads the scene files of a folder. */
    static OtherScenes in(Path folder) {
        return read(folder, Optional.empty());
    }

    /** Reads the scene files next to one. */
    static OtherScenes nextTo(Path sceneFile) {
        return read(ParentFolder.of(sceneFile), Optional.of(sceneFile.getFileName()));
    }

    private static OtherScenes read(Path folder, Optional<Path> except) {
        List<String> texts = new ArrayList<>();
        boolean isIncomplete = false;
        try (DirectoryStream<Path> files = Files.newDirectoryStream(folder, "*" + JenFile.EXTENSION)) {
            for (Path file : files) {
                try {
                    if (Files.isRegularFile(file) && !except.equals(Optional.of(file.getFileName()))) {
                        texts.add(new String(RegularFile.readBytes(file, "a scene", MAX_BYTES), StandardCharsets.UTF_8));
                    }
                } catch (IOException e) {
                    isIncomplete = true;
                }
            }
        } catch (IOException | DirectoryIteratorException e) {
            isIncomplete = true;
        }
        return new OtherScenes(texts, isIncomplete);
    }

    /** Returns whether one of the scenes may use a file. */
    boolean mayUse(String name) {
        return isIncomplete || texts.stream().anyMatch(text -> text.contains(name));
    }
}
