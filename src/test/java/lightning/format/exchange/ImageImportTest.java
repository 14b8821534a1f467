package lightning.format.exchange;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Base64;
import javax.imageio.ImageIO;
import lightning.base.math.SrgbCurve;
import lightning.base.work.Progress;
import lightning.format.exchange.assembly.ImportedScene;
import lightning.format.exchange.assembly.LightUnits;
import lightning.format.gltf.GltfFixtures;
import lightning.format.jen.JenReader;
import lightning.format.mesh.MeshException;
import lightning.sample.Nightly;
import lightning.scene.asset.Texture;
import lightning.scene.asset.TextureMap;
import lightning.scene.material.Material;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Images of imported scenes: none refuses a scene. */
class ImageImportTest {
    private static final String WEBP = "UklGRh4AAABXRUJQVlA4TBEAAAAvAQAAAA8wgPMf8x8cMqL/AQA=";

    @TempDir
    private Path folder;
    private Path from;

    @BeforeEach
    void makeFolder() throws IOException {
        from = Files.createDirectory(folder.resolve("from"));
    }

    private static byte[] png(int width, int height) throws IOException {
        var image = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
        image.setRGB(0, 0, 0xFF8000);
        var out = new ByteArrayOutputStream();
        ImageIO.write(image, "png", out);
        return out.toByteArray();
    }

    private ImportedScene read(String... uris) throws IOException, MeshException {
        var images = new StringBuilder();
        var textures = new StringBuilder();
        var materials = new StringBuilder();
        for (int i = 0; i < uris.length; i++) {
            String comma = i == 0 ? "" : ", ";
            images.append(comma).append("{'uri': '").append(uris[i].replace("\\", "\\\\")).append("'}");
            textures.append(comma).append("{'source': ").append(i).append('}');
            materials.append(comma).append("{'pbrMetallicRoughness': {'baseColorTexture': {'index': ").append(i).append("}}}");
        }
        String json = GltfFixtures.SQUARE_JSON.replace("'buffers': [",
                "'images': [" + images + "], 'textures': [" + textures + "], 'materials': [" + materials + "], 'buffers': [");
        return SceneImporter.read(Files.write(from.resolve("a.gltf"), GltfFixtures.text(json, GltfFixtures.SQUARE)),
                folder.resolve("scene/a.jen"), LightUnits.CANDELA, Progress.NONE);
    }

    private Material written(ImportedScene imported) throws Exception {
        Files.createDirectories(folder.resolve("scene"));
        imported.write();
        return JenReader.read(folder.resolve("scene/a.jen")).scene().materials().getFirst();
    }

    @ParameterizedTest
    @ValueSource(strings = {"tex/wood 1%.png", "tex/wood%201%25.png", "tex\\wood 1%.png", "TEX/Wood 1%.PNG", "wood 1%.png",
        "C:\\models\\tex\\wood 1%.png", "../elsewhere/wood 1%.png"})
    void nameOfAnotherSystem_isFound(String uri) throws Exception {
        // A path that leads elsewhere is looked for by its last name in the folder itself.
        String place = uri.startsWith("tex") || uri.startsWith("TEX") ? "tex/wood 1%.png" : "wood 1%.png";
        Files.createDirectories(from.resolve(place).getParent());
        Files.write(from.resolve(place), png(2, 2));
        ImportedScene imported = read(uri);
        assertThat(written(imported).texture()).as("%s", imported.notes()).isPresent();
        assertThat(imported.notes().keySet()).noneMatch(note -> note.startsWith("textures"));
    }

    @Test
    void missingImage_isReplacedByItsFactor() throws Exception {
        ImportedScene imported = read("missing.png");
        assertThat(written(imported).texture()).isEmpty();
        assertThat(imported.notes()).containsEntry("textures that are missing", 1);
    }

    @Test
    void damagedImage_isReplacedByItsFactor() throws Exception {
        byte[] whole = png(64, 64);
        Files.write(from.resolve("cut.png"), Arrays.copyOf(whole, whole.length - 40));
        ImportedScene imported = read("cut.png", "data:image/png;base64," + Base64.getEncoder().encodeToString(Arrays.copyOf(whole, 50)));
        assertThat(written(imported).texture()).isEmpty();
        assertThat(imported.notes()).containsEntry("textures that are damaged, or wider than 16384 pixels", 2);
    }

    @Test
    void imageOfAnotherFormat_isReplacedByItsFactor() throws Exception {
        Files.writeString(from.resolve("a.png"), "GIF89a");
        Files.writeString(from.resolve("b.png"), "no image");
        ImportedScene imported = read("a.png", "b.png");
        assertThat(written(imported).texture()).isEmpty();
        assertThat(imported.notes()).containsEntry("textures of unknown formats, or damaged", 2);
    }

    /** Two pixels of (255, 128, 0) and black: a lossless WebP file, a TGA, and what Java writes. */
    @ParameterizedTest
    @ValueSource(strings = {"webp", "tga", "bmp", "gif", "tiff"})
    void imageOfAKnownFormat_isConverted(String format) throws Exception {
        var image = new BufferedImage(2, 1, BufferedImage.TYPE_INT_RGB);
        image.setRGB(0, 0, 0xFF8000);
        var out = new ByteArrayOutputStream();
        ImageIO.write(image, format, out);
        byte[] bytes = switch (format) {
            case "webp" -> Base64.getDecoder().decode(WEBP);
            // Padded: the reader looks for a footer of 26 bytes.
            case "tga" -> Arrays.copyOf(new byte[] {0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 2, 0, 1, 0, 24, 0, 0, (byte) 128, -1, 0, 0, 0}, 60);
            default -> out.toByteArray();
        };
        Files.write(from.resolve("wood." + format), bytes);
        ImportedScene imported = read("wood." + format);
        TextureMap map = written(imported).texture().orElseThrow();
        assertThat(map.file()).isEqualTo("wood.png");
        assertThat(map.image().channel(0, 0, 0)).isEqualTo(1);
        assertThat(map.image().channel(0, 0, 1)).isEqualTo((float) SrgbCurve.toLinear(128 / 255.0));
        assertThat(map.image().channel(1, 0, 0)).isZero();
    }

    /** 5000 × 4000 pixels are more than a texture may have; each remaining pixel is the mean of four. */
    @Test
    @Nightly
    void largeImage_isReduced() throws Exception {
        Files.write(from.resolve("large.png"), png(5000, 4000));
        ImportedScene imported = read("large.png");
        Texture texture = written(imported).texture().orElseThrow().image();
        assertThat(texture.width()).isEqualTo(2500);
        assertThat(texture.height()).isEqualTo(2000);
        assertThat(imported.notes()).containsEntry("textures reduced to fit into a scene", 1);
    }
}
