package lightning.shot.movie;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;

/**
 * The files of a shot's frames: {@code bird-0001.png} and so on, in one folder.
 *
 * @param stem   what stands before the number
 * @param extension what stands behind it, with its point
 */
public record FrameFiles(Path folder, String stem, String extension) {
    /**
     * @param output a file's name, which gets the numbers before its ending, or, without an ending, a folder for PNG files
     * @param sceneName  the scene's name without an ending, which the files in such a folder have
     */
    public static FrameFiles of(Path output, String sceneName) {
        String file = output.getFileName() == null ? "" : output.getFileName().toString();
        int dot = file.lastIndexOf('.');
        if (dot <= 0) {
            return new FrameFiles(output, sceneName, ".png");
        }
        Path folder = output.toAbsolutePath().getParent();
        return new FrameFiles(output.getParent() == null ? Path.of("") : folder == null ? output : output.getParent(),
                file.substring(0, dot), file.substring(dot));
    }

    /** The file of one frame; four digits at least. */
    public Path file(int frame) {
        return folder.resolve(stem + "-" + String.format(Locale.ROOT, "%04d", frame) + extension);
    }

    /** Makes the folder where it is missing; the one around it must be there. */
    public void createFolder() throws IOException {
        if (!folder.toString().isEmpty() && !Files.isDirectory(folder)) {
            Files.createDirectory(folder);
        }
    }
}
