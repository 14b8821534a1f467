package lightning.format.exchange;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import lightning.base.file.OrdinaryFile;
import lightning.base.file.SafeFile;
import lightning.base.text.Quote;
import lightning.format.jen.JenException;
import lightning.format.jen.JenReader;
import lightning.format.jen.JenWriter;
import lightning.scene.Scene;

/**
 * A scene that was read from a file of another program, not written yet.
 *
 * @param asRead  the scene; where the file does not say what the numbers of its lights are, their intensities are these numbers. Black
 *                pixels stand for the pictures of its textures
 * @param restored the lights whose intensities are none of these numbers
 * @param units   what these numbers are taken as; empty where they are intensities already
 * @param remarks lines of comment that the scene's file begins with
 * @param to      where it goes
 * @param copies  the files that must lie beside it
 * @param notes   what was left out or is not the same, each with its number
 */
public record Import(Scene asRead, Set<String> restored, Optional<LightUnits> units, List<String> remarks, Path to, List<Copy> copies,
        Map<String, Integer> notes) {
    private static final String FIRST_LINE = "jen 1\n";
    private static final String EXPECTED = "a file to lie beside the scene";

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
            if (from != null ? Files.isSameFile(from, to) || OrdinaryFile.areSame(from, to, EXPECTED) : Files.size(to) == bytes.length
                    && Arrays.equals(OrdinaryFile.bytes(to, EXPECTED, bytes.length), bytes)) {
                return true;
            }
            throw new IOException(Quote.path(to) + ": is there already and holds something else; import into another folder");
        }

        private void write() throws IOException {
            if (!isThere()) {
                Files.createDirectories(to.toAbsolutePath().getParent());
                SafeFile.write(to, out -> {
                    if (from != null) {
                        try (InputStream in = OrdinaryFile.open(from, EXPECTED)) {
                            in.transferTo(out);
                        }
                    } else {
                        out.write(bytes);
                    }
                });
            }
        }
    }

    /** The same with the lights' numbers taken as others; itself where the file says what they are. */
    public Import in(LightUnits others) {
        return units.isEmpty() ? this : new Import(asRead, restored, Optional.of(others), remarks, to, copies, notes);
    }

    /** What the {@code .jen} file says. */
    public Scene scene() {
        return units.isEmpty() ? asRead : asRead.withLights(asRead.lights().stream()
                .map(light -> restored.contains(light.name()) ? light
                        : light.withIntensity(light.intensity() * units.get().intensityOfOne(light.type())))
                .toList());
    }

    /** The file itself. */
    public String text() {
        var head = new StringBuilder(FIRST_LINE);
        remarks.forEach(line -> head.append("# ").append(line).append('\n'));
        units.ifPresent(taken -> head.append(taken.remark()).append('\n'));
        return head + JenWriter.write(scene()).substring(FIRST_LINE.length());
    }

    /**
     * Puts the files beside the scene, then the scene. Nothing that is there and differs is replaced but the scene itself.
     *
     * @throws IOException  if a file is in the way or cannot be written
     * @throws JenException if the scene could not be read again: a picture of a kind that it cannot show, or beyond its limits
     */
    public void write() throws IOException, JenException {
        String text = text();
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
