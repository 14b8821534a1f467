package lightning.format.jen;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.awt.image.BufferedImage;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import javax.imageio.ImageIO;
import lightning.base.math.Rgb;
import lightning.scene.Scene;
import lightning.scene.asset.Texture;
import lightning.scene.light.Light;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests images on the faces of lights in scene files. */
class LightTextureTest {
    @TempDir
    Path folder;

    private Scene read(String light) throws Exception {
        return JenReader.read("jen 1\nlight screen rect { " + light + " }\n", "a.jen", folder).requireAllFiles().scene();
    }

    private Light screen(String file) throws Exception {
        return read("texture \"" + file + "\"").lights().getFirst();
    }

    @Test
    void pngIsDecodedToLinear_andRoundTrips() throws Exception {
        var image = new BufferedImage(2, 1, BufferedImage.TYPE_INT_RGB);
        image.setRGB(0, 0, 0xff0000);
        ImageIO.write(image, "png", folder.resolve("film.png").toFile());
        Light light = screen("film.png");
        Texture decoded = light.texture().orElseThrow().image();
        assertThat(new float[] {decoded.channel(0, 0, 0), decoded.channel(0, 0, 1), decoded.channel(1, 0, 0)}).containsExactly(1, 0, 0);
        Scene scene = read("texture \"film.png\"");
        assertThat(JenReader.read(JenWriter.write(scene), "b.jen", folder).scene()).isEqualTo(scene);
        assertThat(ReferencedFiles.of(scene, folder)).containsOnlyKeys("film.png");
        assertThat(PropertyEdit.set(scene, "screen", "texture", "none").lights().getFirst().texture()).isEmpty();
    }

    @Test
    void radianceHdr_keepsValuesAboveOne() throws Exception {
        byte[] header = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 1\n".getBytes(StandardCharsets.ISO_8859_1);
        byte[] file = java.util.Arrays.copyOf(header, header.length + 4);
        file[header.length] = (byte) 128;
        file[header.length + 3] = (byte) (128 + 3);
        Files.write(folder.resolve("lamp.hdr"), file);
        Light light = screen("lamp.hdr");
        assertThat(light.texture().orElseThrow().image().channel(0, 0, 0)).isEqualTo(4);
        assertThat(light.texture().orElseThrow().image().channel(0, 0, 1)).isZero();
    }

    @Test
    void openExr_isLimited() throws Exception {
        var film = lightning.render.image.Film.ofScanlines(2, 1, new float[] {2e7f, 0.5f, -1, 3, Float.NaN, 0});
        lightning.format.image.ImageFile.writeExr(folder.resolve("lamp.exr"), film, 32, java.util.Map.of());
        Texture image = screen("lamp.exr").texture().orElseThrow().image();
        assertThat(new Rgb(image.channel(0, 0, 0), image.channel(0, 0, 1), image.channel(0, 0, 2))).isEqualTo(new Rgb(1e6, 0.5, 0));
        assertThat(new Rgb(image.channel(1, 0, 0), image.channel(1, 0, 1), image.channel(1, 0, 2))).isEqualTo(new Rgb(3, 0, 0));
    }

    @Test
    void missingAndDamagedFiles_areReported() throws Exception {
        assertThatExceptionOfType(JenException.class).isThrownBy(() -> screen("none.png"))
                .withMessageContaining("light 'screen': there is no texture 'none.png' in the folder");
        for (String name : List.of("torn.hdr", "torn.exr", "torn.png")) {
            Files.writeString(folder.resolve(name), "no image");
            assertThatExceptionOfType(JenException.class).isThrownBy(() -> screen(name)).withMessageContaining("light 'screen'")
                    .withMessageContaining(name);
        }
    }

    @Test
    void brightTexture_limitsTheIntensity() throws Exception {
        var film = lightning.render.image.Film.ofScanlines(1, 1, new float[] {1e6f, 1, 1});
        lightning.format.image.ImageFile.writeExr(folder.resolve("lamp.exr"), film, 32, java.util.Map.of());
        Scene scene = read("intensity 1e30  texture \"lamp.exr\"");
        assertThat(scene.rig().effectiveLight(scene.lights().getFirst()).intensity()).isEqualTo(1e24);
    }
}
