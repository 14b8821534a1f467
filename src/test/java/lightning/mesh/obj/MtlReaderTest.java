package lightning.mesh.obj;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.Optional;
import lightning.math.Rgb;
import lightning.mesh.ByteSource;
import lightning.mesh.MeshException;
import lightning.mesh.Notes;
import lightning.work.Progress;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Materials beside OBJ files. */
class MtlReaderTest {
    private final Notes notes = new Notes();

    @TempDir
    private Path folder;

    @Test
    void material_isWhatItsLinesSay() throws IOException, MeshException {
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
                map_Kd -s 2 2 -clamp on my wood.png
                map_Bump bumps.png
                map_d holes.png
                newmtl plain
                Tr 0
                """);
        assertThat(materials).containsOnlyKeys("old oak", "plain");
        assertThat(materials.get("old oak"))
                .isEqualTo(new MtlMaterial("old oak", new Rgb(0.5, 0.25, 0.125), Rgb.grey(0.5), new Rgb(0, 0, 2), 96.5,
                        true, 0.5, Rgb.WHITE, 1.5, false, Optional.of("my wood.png"), Optional.of("holes.png")));
        assertThat(materials.get("plain"))
                .isEqualTo(new MtlMaterial("plain", Rgb.grey(0.8), Rgb.BLACK, Rgb.BLACK, 0, false, 1, Rgb.WHITE, 1.5, false,
                        Optional.empty(), Optional.empty()));
        assertThat(notes.counts()).containsOnlyKeys("ambient colours (Ka) of materials", "options -s of pictures",
                "options -clamp of pictures", "map_Bump of materials");
    }

    @ParameterizedTest
    @CsvSource({"d 0.25, 0.25", "d -halo 0.25, 0.25", "Tr 0.75, 0.25", "Tr 1, 1", "Tr 1|illum 4, 0", "d 1|Tr 1, 1", "d 0.25|Tr 0.25, 0.25",
        "Tf 0.5 0.5 1|illum 7, 0", "Tf 0.5 0.5 1|illum 2, 1", "d 0.25|Tf 1 0 0|illum 6, 0.25"})
    void opacity_isReadAsWritersMeanIt(String lines, double opacity) throws Exception {
        assertThat(read("newmtl a\n" + lines.replace('|', '\n') + "\n").get("a").opacity()).isEqualTo(opacity);
    }

    @Test
    void glass_hasItsIndexAndFilter() throws Exception {
        MtlMaterial glass = read("newmtl a\nTf 0.5 0.75 1\nNi 1.33\nillum 6\n").get("a");
        assertThat(glass.refracts()).isTrue();
        assertThat(glass.ior()).isEqualTo(1.33);
        assertThat(glass.filter()).isEqualTo(new Rgb(0.5, 0.75, 1));
        assertThat(read("newmtl a\nd 0.5\nillum 4\n").get("a").refracts()).isFalse();
    }

    @Test
    void wrongLines_areTold() {
        assertRefused("Kd 1 1 1\n", "line 1: newmtl must stand before Kd");
        assertRefused("newmtl a\nKd 1 x 1\n", "line 2: green must be a decimal number, was 'x'");
        assertRefused("newmtl a\nNs\n", "line 2: expected a number, found the end of the line");
        assertRefused("newmtl a\nd\n", "line 2: expected a number, found the end of the line");
        assertRefused("newmtl a\nd -halo\n", "line 2: expected a number, found the end of the line");
    }

    private void assertRefused(String file, String message) {
        assertThatExceptionOfType(MeshException.class).isThrownBy(() -> read(file)).withMessage(folder.resolve("a.mtl") + ": " + message);
    }

    private Map<String, MtlMaterial> read(String file) throws IOException, MeshException {
        try (ByteSource source = ByteSource.open(Files.writeString(folder.resolve("a.mtl"), file), Progress.NONE)) {
            return MtlReader.read(source, notes);
        }
    }
}
