package lightning.exchange;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import lightning.file.SafeFile;
import lightning.jen.JenException;
import lightning.jen.JenReader;
import lightning.scene.Scene;
import lightning.text.Quote;

/**
 * A scene that was read from a file of another program, not written yet.
 *
 * @param scene  what the {@code .jen} file says; its textures' pictures stand for those of the files
 * @param text   the file itself
 * @param to     where it goes
 * @param copies the files that must lie beside it
 * @param notes  what was left out or is not the same, each with its number
 */
public record Import(Scene scene, String text, Path to, List<Copy> copies, Map<String, Integer> notes) {

    /**
     * A file that goes beside the scene.
     *
     * @param from  the file that it is; null where its bytes are given
     * @param bytes what it holds; null where it is a file
     */
    public record Copy(Path to, Path from, byte[] bytes) {
        private boolean isThere() throws IOException {
            if (!Files.exists(to)) {
                return false;
            }
            if (from != null ? Files.isSameFile(from, to) || Files.mismatch(from, to) < 0 : Files.size(to) == bytes.length
                    && Arrays.equals(Files.readAllBytes(to), bytes)) {
                return true;
            }
            throw new IOException(Quote.path(to) + ": is there already and holds something else; import into another folder");
        }

        private void write() throws IOException {
            if (!isThere()) {
                Files.createDirectories(to.toAbsolutePath().getParent());
                SafeFile.write(to, out -> {
                    if (from != null) {
                        Files.copy(from, out);
                    } else {
                        out.write(bytes);
                    }
                });
            }
        }
    }

    /**
     * Puts the files beside the scene, then the scene. Nothing that is there and differs is replaced but the scene itself.
     *
     * @throws IOException  if a file is in the way or cannot be written
     * @throws JenException if the scene could not be read again: a picture of a kind that it cannot show, or beyond its limits
     */
    public void write() throws IOException, JenException {
        for (Copy copy : copies) {
            copy.isThere();
        }
        for (Copy copy : copies) {
            copy.write();
        }
        JenReader.read(text, to.toString(), to.toAbsolutePath().getParent());
        SafeFile.write(to, out -> out.write(text.getBytes(StandardCharsets.UTF_8)));
    }
}
