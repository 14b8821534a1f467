package lightning.format.mesh.obj;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import lightning.base.math.Rgb;
import lightning.base.work.Progress;
import lightning.format.mesh.ByteSource;
import lightning.format.mesh.ConversionNotes;
import lightning.format.mesh.MeshException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Material files of OBJ. */
class MtlReaderTest {
    private final ConversionNotes notes = new ConversionNotes();

    @TempDir
    private Path folder;

    @Test
    void material_hasTheValuesOfItsLines() throws IOException, MeshException {
        Map<String, MtlMaterial> materials = read("""
                # two of them
                newmtl old oak
                Ka 1 1 1
                Kd 0.5 0.25 0.125
                Ks 0.5
                Ke 0 0 2
                Ns 96.5
                d 0.5
                illum 3
                map_Kd -s 2 2 -o 0.5 -clamp on my wood.png
                map_Bump -bm 0.25 bumps.png
                map_Ke lamps.png
                map_d holes.png
                newmtl plain
                Tr 0
                """);
        assertThat(materials).containsOnlyKeys("old oak", "plain");
        assertThat(materials.get("old oak"))
                .isEqualTo(new MtlMaterial("old oak", IlluminationModel.REFLECTION, new Rgb(0.5, 0.25, 0.125), Rgb.gray(0.5),
                        new Rgb(0, 0, 2), OptionalDouble.of(96.5), 0.5, Rgb.WHITE, 1.5,
                        Optional.of(new MtlImage("my wood.png", false, 1, 2, 2, 0.5, 0, true)),
                        Optional.of(new MtlImage("lamps.png")), Optional.of(new MtlImage("holes.png")),
                        Optional.of(new MtlImage("bumps.png", false, 0.25, 1, 1, 0, 0, false)), Optional.empty()));
        assertThat(materials.get("plain"))
                .isEqualTo(new MtlMaterial("plain", IlluminationModel.HIGHLIGHT, Rgb.gray(0.8), Rgb.BLACK, Rgb.BLACK,
                        OptionalDouble.empty(), 1,
                        Rgb.WHITE, 1.5, Optional.empty(), Optional.empty(), Optional.empty(), Optional.empty(), Optional.empty()));
        assertThat(notes.counts()).containsOnlyKeys("ambient colors (Ka) of materials");
    }

    @ParameterizedTest
    @CsvSource({"d 0.25, 0.25", "d -halo 0.25, 0.25", "Tr 0.75, 0.25", "Tr 1, 1", "Tr 1|illum 4, 0", "d 1|Tr 1, 1", "d 0.25|Tr 0.25, 0.25",
        "Tf 0.5 0.5 1|illum 7, 0", "Tf 0.5 0.5 1|illum 2, 1", "d 0.25|Tf 1 0 0|illum 6, 0.25"})
    void opacityAndTransparency_areInterpretedLikeExporters(String lines, double opacity) throws Exception {
        assertThat(read("newmtl a\n" + lines.replace('|', '\n') + "\n").get("a").opacity()).isEqualTo(opacity);
    }

    @Test
    void glass_hasItsIorAndFilter() throws Exception {
        MtlMaterial glass = read("newmtl a\nTf 0.5 0.75 1\nNi 1.33\nillum 6\n").get("a");
        assertThat(glass.illumination().isRefractive()).isTrue();
        assertThat(glass.ior()).isEqualTo(1.33);
        assertThat(glass.filter()).isEqualTo(new Rgb(0.5, 0.75, 1));
        assertThat(read("newmtl a\nd 0.5\nillum 4\n").get("a").illumination().isRefractive()).isFalse();
    }

    /** By the MTL specification, models 2 to 9 have highlights, 3 and 5 to 8 reflection, 6 and 7 refraction. */
    @ParameterizedTest
    @CsvSource({"0, false, false, false", "1, false, false, false", "2, true, false, false", "3, true, true, false",
        "4, true, false, false",
        "5, true, true, false", "6, true, true, true", "7, true, true, true", "8, true, true, false", "9, true, false, false",
        "10, false, false, false", "11, true, false, false", "1.5, true, false, false", "-1, true, false, false"})
    void illuminationModel_setsHighlightReflectionAndRefraction(String number, boolean hasHighlights, boolean isReflective,
            boolean isRefractive)
            throws Exception {
        MtlMaterial material = read("newmtl a\nKs 1 1 1\nNs 10\nillum " + number + "\n").get("a");
        assertThat(material.hasHighlights()).isEqualTo(hasHighlights);
        assertThat(material.illumination().isReflective()).isEqualTo(isReflective);
        assertThat(material.illumination().isRefractive()).isEqualTo(isRefractive);
        double model = Double.parseDouble(number);
        assertThat(notes.counts().containsKey("illumination models (illum) of materials that are not 0 to 9"))
                .isEqualTo(!(model >= 0 && model <= 9 && model == Math.rint(model)));
    }

    @ParameterizedTest
    @CsvSource({"Ns 0, false", "Ns 0.5, false", "Ns -1, false", "Ns 1, true", "'', true"})
    void exponentBelowOne_hasNoHighlight(String line, boolean hasHighlights) throws Exception {
        assertThat(read("newmtl a\nKs 1 1 1\n" + line + "\nillum 2\n").get("a").hasHighlights()).isEqualTo(hasHighlights);
    }

    @Test
    void invalidLines_areSkippedAndNoted() throws Exception {
        assertSkipped("Kd 1 1 1\n", "line 1 skipped: newmtl must stand before Kd");
        assertSkipped("newmtl a\nKd 1 x 1\n", "line 2 skipped: green must be a decimal number, was 'x'");
        assertSkipped("newmtl a\nNs\n", "line 2 skipped: expected a number, found the end of the line");
        assertSkipped("newmtl a\nd\n", "line 2 skipped: expected a number, found the end of the line");
        assertSkipped("newmtl a\nd -halo\n", "line 2 skipped: expected a number, found the end of the line");
    }

    private void assertSkipped(String file, String message) throws Exception {
        assertThat(read(file + "newmtl good\nNs 5\n").get("good").shininess()).hasValue(5);
        assertThat(notes.counts()).containsKey("a.mtl, " + message);
    }

    @Test
    void byteOrderMark_isSkipped() throws Exception {
        assertThat(read("\uFEFFnewmtl a\n")).containsOnlyKeys("a");
    }

    @Test
    void physicalStatements_setRoughnessAndMetalness() throws Exception {
        assertThat(read("newmtl a\nPr 0.25\nPm 1\n").get("a").physical()).contains(new MtlMaterial.Physical(0.25, 1, 0, 0, 0));
        assertThat(read("newmtl a\nPm 1\n").get("a").physical()).contains(new MtlMaterial.Physical(0.5, 1, 0, 0, 0));
        assertThat(read("newmtl a\nPr 0.25\nPc 0.5\nPcr 0.125\n").get("a").physical())
                .contains(new MtlMaterial.Physical(0.25, 0, 0.5, 0.125, 0));
        assertThat(read("newmtl a\n").get("a").physical()).isEmpty();
    }

    @Test
    void sheen_makesMaterialPhysical() throws Exception {
        assertThat(read("newmtl a\nPs 0.5\n").get("a").physical()).contains(new MtlMaterial.Physical(0.5, 0, 0, 0, 0.5));
        assertThat(read("newmtl a\nPs 0\n").get("a").physical()).isEmpty();
    }

    @Test
    void anisotropy_hasARotationInTurns() throws Exception {
        MtlMaterial.Physical surface = read("newmtl a\nPm 1\naniso 0.25\nanisor 0.5\n").get("a").physical().orElseThrow();
        assertThat(surface.anisotropy()).isEqualTo(0.25);
        assertThat(surface.anisotropyRotation()).isEqualTo(0.5);
        assertThat(read("newmtl b\naniso 0\n").get("b").physical()).isEmpty();
    }

    @Test
    void normalMap_winsOverBumpMap() throws Exception {
        assertThat(read("newmtl a\nmap_Bump b.png\nnorm n.png\nbump c.png\n").get("a").bump())
                .contains(new MtlImage("n.png", true, 1, 1, 1, 0, 0, false));
    }

    private Map<String, MtlMaterial> read(String file) throws IOException, MeshException {
        try (ByteSource source = ByteSource.open(Files.writeString(folder.resolve("a.mtl"), file), Progress.NONE)) {
            return MtlReader.read(source, notes);
        }
    }
}
