package lightning.format.exr;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import lightning.format.image.ImageFile;
import lightning.render.image.Film;
import lightning.render.image.FilmAssert;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.FloatRange;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class ExrPrimariesTest {
    private static final Map<String, ExrAttribute> NONE = Map.of();

    @TempDir
    Path folder;

    private static Film film(float red, float green, float blue) {
        return Film.ofScanlines(1, 1, new float[] {red, green, blue});
    }

    /** Writes numbers of ACEScg into a file without chromaticities, with other attributes. */
    private Film read(String name, Map<String, ExrAttribute> attributes) throws IOException {
        Path file = folder.resolve(name);
        ImageFile.writeExr(file, film(0.2f, 0.5f, 0.8f), 32, attributes);
        return ImageFile.read(file);
    }

    /** The published matrix of ACEScg from linear sRGB (Bradford), as OpenColorIO has it. */
    @Test
    void rec709Red_hasPublishedAcescg() {
        float[][] red = ExrPrimaries.ACESCG.convert(new float[][] {{1}, {0}, {0}});
        assertThat(red[0][0]).isCloseTo(0.6131f, within(1e-4f));
        assertThat(red[1][0]).isCloseTo(0.0702f, within(1e-4f));
        assertThat(red[2][0]).isCloseTo(0.0206f, within(1e-4f));
    }

    @Test
    void white_staysWhite() {
        float[][] white = ExrPrimaries.ACESCG.convert(new float[][] {{1}, {1}, {1}});
        for (float[] channel : white) {
            assertThat(channel[0]).isCloseTo(1, within(1e-6f));
        }
    }

    @Test
    void rec709_keepsEachBit() {
        float[][] rgb = {{0.1f}, {Float.NaN}, {Float.POSITIVE_INFINITY}};
        assertThat(ExrPrimaries.REC_709.convert(rgb)).isSameAs(rgb);
    }

    @Test
    void infinities_stayNumbers() {
        for (float[] channel : ExrPrimaries.ACESCG.convert(new float[][] {{Float.POSITIVE_INFINITY}, {Float.NEGATIVE_INFINITY}, {1}})) {
            assertThat(channel[0]).isNotNaN();
        }
    }

    @Test
    void acescgFile_readsAsTheSameColors() throws IOException {
        Path file = folder.resolve("a.exr");
        Film film = film(0.25f, 3, 0.01f);
        ImageFile.writeExr(file, film, 32, ExrMetadata.common(), ExrPrimaries.ACESCG);
        Film read = ImageFile.read(file);
        assertThat(read.red(0, 0)).isCloseTo(0.25f, within(2e-6f));
        assertThat(read.green(0, 0)).isCloseTo(3, within(2e-6f));
        assertThat(read.blue(0, 0)).isCloseTo(0.01f, within(2e-6f));
        try (ExrReader reader = new ExrReader(file)) {
            assertThat(reader.header().attributes().get("chromaticities")).isEqualTo(new ExrAttribute.Chromaticities(
                    List.of(0.713f, 0.293f, 0.165f, 0.83f, 0.128f, 0.044f, 0.32168f, 0.33767f)));
            assertThat(reader.header().attributes().get("colorInteropID")).isEqualTo(new ExrAttribute.Text("lin_ap1_scene"));
        }
    }

    @Test
    void rec709File_hasTheBytesOfBefore() throws IOException {
        Path before = folder.resolve("a.exr");
        Path named = folder.resolve("b.exr");
        ImageFile.writeExr(before, film(1, 2, 3), 16, ExrMetadata.common());
        ImageFile.writeExr(named, film(1, 2, 3), 16, ExrMetadata.common(), ExrPrimaries.REC_709);
        assertThat(Files.readAllBytes(named)).isEqualTo(Files.readAllBytes(before));
    }

    @Test
    void fileWithoutChromaticities_isAcescgIfItSaysSo() throws IOException {
        Film plain = read("wood.exr", NONE);
        FilmAssert.assertSameBits(plain, film(0.2f, 0.5f, 0.8f), "plain");
        Film named = read("wood_ACEScg.v2.exr", NONE);
        float[][] back = ExrPrimaries.ACESCG.convert(new float[][] {{named.red(0, 0)}, {named.green(0, 0)}, {named.blue(0, 0)}});
        assertThat(back[0][0]).isCloseTo(0.2f, within(1e-6f));
        assertThat(back[2][0]).isCloseTo(0.8f, within(1e-6f));
        FilmAssert.assertSameBits(read("id.exr", Map.of("colorInteropID", new ExrAttribute.Text("lin_ap1_scene"))), named, "identifier");
        FilmAssert.assertSameBits(read("oiio.exr", Map.of("oiio:ColorSpace", new ExrAttribute.Text("ACEScg"))), named, "OpenImageIO");
        FilmAssert.assertSameBits(read("preacescgs.exr", NONE), plain, "part of a word");
    }

    @Test
    void chromaticities_countMoreThanTheName() throws IOException {
        FilmAssert.assertSameBits(read("a_acescg.exr", ExrMetadata.common()), film(0.2f, 0.5f, 0.8f), "declared as Rec. 709");
    }

    @Property
    void convertedSum_isSumOfConverted(@ForAll @FloatRange(min = 0, max = 100) float a, @ForAll @FloatRange(min = 0, max = 100) float b) {
        float[][] first = ExrPrimaries.ACESCG.convert(new float[][] {{a}, {b}, {1}});
        float[][] second = ExrPrimaries.ACESCG.convert(new float[][] {{b}, {2}, {a}});
        float[][] sum = ExrPrimaries.ACESCG.convert(new float[][] {{a + b}, {b + 2}, {1 + a}});
        for (int c = 0; c < 3; c++) {
            assertThat(first[c][0] + second[c][0]).isCloseTo(sum[c][0], within(1e-4f));
        }
    }
}
