package lightning.shot.movie;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;

/**
 * File names of a shot's frames in one folder: {@code bird-0001.png} and so on.
 *
 * @param stem      text before the number
 * @param extension text after the number, with its point
 */
public record FrameFiles(Path folder, String stem, String extension) {
    /**
     * @param output    a file name, whose frames get a number before its extension, or, without an extension, a folder for PNG files
     * @param sceneName the scene's name without an extension, for files in such a folder
     */
    public static FrameFiles of(Path output, String sceneName) {
        String file = output.getFileName() == null ? "" : output.getFileName().toString();
        int dot = file.lastIndexOf('.');
        if (dot <= 0) {
            return new FrameFiles(output, sceneName, ".png");
        }
        Path folder = output.getParent();
        return new FrameFiles(folder == null ? Path.of("") : folder, file.substring(0, dot), file.substring(dot));
    }

    /** Returns the file of one frame, with at least four digits. */
    public Path file(int frame) {
        return folder.resolve(stem + "-" + String.format(Locale.ROOT, "%04d", frame) + extension);
    }

    /** Creates the folder if it is missing; its parent must exist. */
    public void createFolder() throws IOException {
        if (!folder.toString().isEmpty() && !Files.isDirectory(folder)) {
            Files.createDirectory(folder);
        }
    }
}
