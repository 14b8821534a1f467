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
import lightning.base.file.AtomicFile;
import lightning.base.file.RegularFile;
import lightning.base.text.Quote;
import lightning.format.jen.JenException;
import lightning.format.jen.JenReader;
import lightning.format.jen.JenWriter;
import lightning.scene.Scene;

/**
 * A scene that was read from a file of another program, not written yet.
 *
 * @param unscaledScene  the scene; where the file does not say what the numbers of its lights are, their intensities are these numbers. Black
 *                pixels stand for the pictures of its textures
 * @param restored the lights whose intensities are none of these numbers
 * @param units   what these numbers are taken as; empty where they are intensities already
 * @param comments lines of comment that the scene's file begins with
 * @param sceneFile      where it goes
 * @param copies  the files that must lie beside it
 * @param notes   what was left out or is not the same, each with its number
 */
public record ImportedScene(Scene unscaledScene, Set<String> restored, Optional<LightUnits> units, List<String> comments, Path sceneFile,
        List<AssetCopy> copies,
        Map<String, Integer> notes) {
    private static final String FORMAT_LINE = "jen 1\n";
    private static final String EXPECTED_FILE = "a file to lie beside the scene";

    /**
     * A file that goes beside the scene.
     *
     * @param source  the file that it is; null where its bytes are given
     * @param bytes what it holds; null where it is a file
     */
    public record AssetCopy(Path target, Path source, byte[] bytes) {
        private boolean isAlreadyWritten() throws IOException {
            if (!Files.exists(target)) {
                return false;
            }
            if (source != null ? Files.isSameFile(source, target) || RegularFile.haveSameContent(source, target, EXPECTED_FILE)
                    : Files.size(target) == bytes.length
                            && Arrays.equals(RegularFile.readBytes(target, EXPECTED_FILE, bytes.length), bytes)) {
                return true;
            }
            throw new IOException(Quote.path(target) + ": is there already and holds something else; import into another folder");
        }

        private void write() throws IOException {
            if (!isAlreadyWritten()) {
                Files.createDirectories(target.toAbsolutePath().getParent());
                AtomicFile.write(target, out -> {
                    if (source != null) {
                        try (InputStream in = RegularFile.open(source, EXPECTED_FILE)) {
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
    public ImportedScene inUnits(LightUnits newUnits) {
        return units.isEmpty() ? this
                : new ImportedScene(unscaledScene, restored, Optional.of(newUnits), comments, sceneFile, copies, notes);
    }

    /** What the {@code .jen} file says. */
    public Scene scene() {
        return units.isEmpty() ? unscaledScene : unscaledScene.withLights(unscaledScene.lights().stream()
                .map(light -> restored.contains(light.name()) ? light
                        : light.withIntensity(light.intensity() * units.get().intensityOfOneUnit(light.type())))
                .toList());
    }

    /** The file itself. */
    public String text() {
        var header = new StringBuilder(FORMAT_LINE);
        comments.forEach(line -> header.append("# ").append(line).append('\n'));
        units.ifPresent(chosenUnits -> header.append(chosenUnits.comment()).append('\n'));
        return header + JenWriter.write(scene()).substring(FORMAT_LINE.length());
    }

    /**
     * Puts the files beside the scene, then the scene. Nothing that is there and differs is replaced but the scene itself.
     *
     * @throws IOException  if a file is in the way or cannot be written
     * @throws JenException if the scene could not be read again: a picture of a kind that it cannot show, or beyond its limits
     */
    public void write() throws IOException, JenException {
        String text = text();
        for (AssetCopy copy : copies) {
            copy.isAlreadyWritten();
        }
        for (AssetCopy copy : copies) {
            copy.write();
        }
        JenReader.read(text, sceneFile.toString(), sceneFile.toAbsolutePath().getParent());
        AtomicFile.write(sceneFile, out -> out.write(text.getBytes(StandardCharsets.UTF_8)));
    }
}
