package lightning.format.jen.asset;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import lightning.format.image.ImageFile;
import lightning.format.jen.JenDocument;
import lightning.format.jen.JenReader;
import lightning.render.image.Film;
import lightning.scene.asset.EnvironmentMap;
import lightning.scene.asset.Texture;
import lightning.scene.value.DomeRotation;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Environments and textures from Radiance HDR and OpenEXR files. */
class LinearImagesTest {
    @TempDir
    Path folder;

    private void exr(String name, int width, int height, float... rgb) throws IOException {
        ImageFile.writeExr(folder.resolve(name), Film.ofScanlines(width, height, rgb), 32, Map.of());
    }

    private JenDocument read(String text) throws Exception {
        return JenReader.read("jen 1 " + text, "s.jen", folder);
    }

    private static List<Float> values(Texture texture) {
        List<Float> values = new ArrayList<>();
        for (int i = 0; i < 3 * texture.pixels(); i++) {
            values.add(texture.channel(i / 3 % texture.width(), i / 3 / texture.width(), i % 3));
        }
        return values;
    }

    @Test
    void environmentOfOpenExr_keepsItsFloats() throws Exception {
        exr("sky.exr", 2, 1, 1e-5f, 3, 70_000, 0.1f, -1, Float.NaN);
        JenDocument document = read("world { environment \"sky.exr\" }");
        EnvironmentMap map = document.scene().world().environment().orElseThrow().map();
        assertThat(document.notes()).singleElement().asString().contains("values of the environment that are not finite: 1;");
        assertThat(
                new float[] {map.channel(0, 0, 0), map.channel(0, 0, 1), map.channel(0, 0, 2), map.channel(1, 0, 0), map.channel(1, 0, 1),
                    map.channel(1, 0, 2)})
                .containsExactly(1e-5f, 3, 70_000, 0.1f, 0, 0);
    }

    /** Rec. 709 has no color for a pure green of ACEScg: its red and blue are below 0. */
    @Test
    void textureWithAcescgInItsName_isConverted() throws Exception {
        exr("sky_acescg.exr", 2, 1, 0.5f, 0.5f, 0.5f, 0, 1, 0);
        EnvironmentMap map = read("world { environment \"sky_acescg.exr\" }").scene().world().environment().orElseThrow().map();
        assertThat(map.channel(0, 0, 0)).isCloseTo(0.5f, org.assertj.core.api.Assertions.within(1e-6f));
        assertThat(map.channel(1, 0, 0)).isZero();
        assertThat(map.channel(1, 0, 1)).isCloseTo(1.1408f, org.assertj.core.api.Assertions.within(1e-4f));
    }

    /** The data of 2×1 pixels are the right half of the second line of a window of 4×2 pixels. */
    @Test
    void environmentOfCroppedOpenExr_fillsItsDisplayWindowWithBlack() throws Exception {
        exr("sky.exr", 2, 1, 1, 2, 3, 4, 5, 6);
        Path file = folder.resolve("sky.exr");
        byte[] bytes = Files.readAllBytes(file);
        String text = new String(bytes, StandardCharsets.ISO_8859_1);
        String attribute = "displayWindow\0box2i\0";
        ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN)
                .position(text.indexOf(attribute) + attribute.length() + Integer.BYTES)
                .putInt(-2).putInt(-1).putInt(1).putInt(0);
        Files.write(file, bytes);
        EnvironmentMap map = read("world { environment \"sky.exr\" }").scene().world().environment().orElseThrow().map();
        assertThat(map.width()).isEqualTo(4);
        assertThat(map.height()).isEqualTo(2);
        float[] red = new float[8];
        for (int i = 0; i < red.length; i++) {
            red[i] = map.channel(i % 4, i / 4, 0);
        }
        assertThat(red).containsExactly(0, 0, 0, 0, 0, 0, 1, 4);
    }

    @Test
    void textureOfOpenExr_isLinear_andLimitedTo1() throws Exception {
        exr("a.exr", 2, 1, 0.1f, 0.2f, 0.3f, 4, 0.5f, 0);
        JenDocument document = read("material m { texture \"a.exr\" }");
        assertThat(values(document.scene().materials().getFirst().texture().orElseThrow().image()))
                .containsExactly(0.1f, 0.2f, 0.3f, 1f, 0.5f, 0f);
        assertThat(document.notes()).singleElement().asString().endsWith("texture 'a.exr' has values above 1; limited to 1");
    }

    /** Heights and normals have no color space: a conversion would bend them. */
    @Test
    void numbersInAFileWithAcescgInItsName_areNotConverted() throws Exception {
        exr("n_acescg.exr", 1, 1, 0.5f, 0.25f, 1);
        JenDocument document = read("material m { normal_map \"n_acescg.exr\" }");
        assertThat(values(document.scene().materials().getFirst().bumpMapping().normalMap().orElseThrow().image()))
                .containsExactly(0.5f, 0.25f, 1f);
    }

    @Test
    void textureOfTooManyLinearPixels_isReduced() throws Exception {
        Files.write(folder.resolve("a.hdr"), wideHdr(2000));
        JenDocument document = read("material m { texture \"a.hdr\" }");
        Texture texture = document.scene().materials().getFirst().texture().orElseThrow().image();
        assertThat(texture.width()).isEqualTo(4500);
        assertThat(texture.height()).isEqualTo(1000);
        assertThat(texture.channel(2249, 0, 0)).isEqualTo(1);
        assertThat(texture.channel(2250, 0, 0)).isZero();
        assertThat(document.notes().getFirst().toString()).endsWith("has 18000000 pixels; reduced to 4500×1000");
    }

    @Test
    void faceOfALight_isNotLimitedTo1() throws Exception {
        exr("a.exr", 1, 1, 4, 5, 6);
        JenDocument document = read("light l rect { texture \"a.exr\" }");
        assertThat(values(document.scene().lights().getFirst().texture().orElseThrow().image())).containsExactly(4f, 5f, 6f);
        assertThat(document.notes()).isEmpty();
    }

    /** Rows of 9000 pixels, the left half of each with radiance 2 in red, the rest black: runs of the old kind. */
    private static byte[] wideHdr(int height) throws IOException {
        var out = new ByteArrayOutputStream();
        out.write(("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y " + height + " +X 9000\n").getBytes(StandardCharsets.US_ASCII));
        for (int y = 0; y < height; y++) {
            // A pixel of 128/256 · 2^(130 − 128) = 2, and 4499 more: 147 + 17 · 256.
            out.write(new byte[] {(byte) 128, 0, 0, (byte) 130, 1, 1, 1, (byte) 147, 1, 1, 1, 17});
            out.write(new byte[] {0, 0, 0, 0, 1, 1, 1, (byte) 147, 1, 1, 1, 17});
        }
        return out.toByteArray();
    }

    @Test
    void largeEnvironment_lightsByMeans_andShowsAllPixels() throws Exception {
        Files.write(folder.resolve("sky.hdr"), wideHdr(1001));
        JenDocument document = read("world { environment \"sky.hdr\" }");
        EnvironmentMap map = document.scene().world().environment().orElseThrow().map();
        assertThat(map.width()).isEqualTo(4500);
        assertThat(map.height()).isEqualTo(501);
        assertThat(map.channel(0, 0, 0)).isEqualTo(2, within(1e-6f));
        assertThat(map.channel(2249, 500, 0)).as("last row, of one row of the image").isEqualTo(2, within(1e-6f));
        assertThat(map.channel(2250, 500, 0)).isZero();
        assertThat(document.notes()).isEmpty();
        // The last column of the bright half: halfway to the dark pixel next to it, two pixels of the means would be mixed.
        double[] rgb = new double[3];
        map.radiance(-1e-6, 0, -1, DomeRotation.NONE, map.detailLevel(1e-4), rgb);
        assertThat(rgb[0]).as("between two pixels").isEqualTo(1, within(0.01));
        double quarter = 2 * Math.PI / 9000 * 0.75;
        map.radiance(-Math.sin(quarter), 0, -Math.cos(quarter), DomeRotation.NONE, map.detailLevel(1e-4), rgb);
        assertThat(rgb[0]).as("in the last bright pixel").isEqualTo(2, within(1e-6));
        map.radiance(-Math.sin(quarter), 0, -Math.cos(quarter), DomeRotation.NONE, map.detailLevel(0.1), rgb);
        assertThat(rgb[0]).as("in a mean, in a picture of wide pixels").isEqualTo(1.75, within(1e-6));
    }

    @Test
    void environmentOfTooManyPixels_isLeftOut() throws Exception {
        Files.writeString(folder.resolve("sky.hdr"), "#?RADIANCE\n\n-Y 60000 +X 60000\n");
        assertThat(read("world { environment \"sky.hdr\" }").notes()).singleElement().asString()
                .contains("must have at most 134217728 pixels, has 60000×60000").endsWith("; left out");
    }
}
