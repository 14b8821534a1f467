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
                newmtl plain
                Tr 0
                """);
        assertThat(materials).containsOnlyKeys("old oak", "plain");
        assertThat(materials.get("old oak"))
                .isEqualTo(new MtlMaterial("old oak", new Rgb(0.5, 0.25, 0.125), Rgb.grey(0.5), new Rgb(0, 0, 2), 96.5,
                        true, Optional.of("my wood.png")));
        assertThat(materials.get("plain")).isEqualTo(MtlMaterial.of("plain"));
        assertThat(notes.counts()).containsOnlyKeys("ambient colors (Ka) of materials", "transparent materials", "options -s of pictures",
                "options -clamp of pictures", "map_Bump of materials");
    }

    @Test
    void wrongLines_areTold() {
        assertRefused("Kd 1 1 1\n", "line 1: newmtl must stand before Kd");
        assertRefused("newmtl a\nKd 1 x 1\n", "line 2: green must be a decimal number, was 'x'");
        assertRefused("newmtl a\nNs\n", "line 2: expected a number, found the end of the line");
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
