package lightning.format.nff;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.base.work.Progress;
import lightning.format.mesh.ByteSource;
import lightning.format.mesh.ConversionNotes;
import lightning.format.mesh.MeshException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** NFF files by the specification; extensions of other dialects are noted. */
class NffReaderTest {
    @TempDir
    private Path folder;
    private final ConversionNotes notes = new ConversionNotes();

    @Test
    void view_matchesTheFile() throws Exception {
        NffFile file =
                read("v\nfrom 1 2 3\nat 4 5 6 # a remark\nup 0 0 1\nangle 30\nhither 1\nresolution 512 256\nb 0.1 0.2 0.3\ns 0 0 0 1\n");
        assertThat(file.view()).contains(new NffFile.View(new Vec3(1, 2, 3), new Vec3(4, 5, 6), new Vec3(0, 0, 1), 30, 512, 256));
        assertThat(file.background()).isEqualTo(new Rgb(0.1, 0.2, 0.3));
    }

    @Test
    void lightColor_isOptional() throws Exception {
        assertThat(read("l 1 2 3\nl 4 5 6 0.5 0.25 0 # last\ns 0 0 0 1\n").lights()).containsExactly(
                new NffFile.Light(new Vec3(1, 2, 3), Optional.empty()),
                new NffFile.Light(new Vec3(4, 5, 6), Optional.of(new Rgb(0.5, 0.25, 0))));
    }

    @Test
    void fill_appliesToFollowingShapes() throws Exception {
        NffFile file = read(
                "s 0 0 0 1\nf 1 0 0 0.5 0.25 8 0.9 1.5\ns 0 0 0 2\nf 0 1 0 1 0 1 0 1\nc\n0 0 0 1\n0 1 0 0.5\nf 1 0 0 0.5 0.25 8 0.9 1.5\n"
                        + "s 0 0 0 3\n");
        assertThat(file.fills()).containsExactly(new NffFile.Fill(new Rgb(1, 0, 0), 0.5, 0.25, 8, 0.9, 1.5),
                new NffFile.Fill(new Rgb(0, 1, 0), 1, 0, 1, 0, 1));
        assertThat(file.solids()).containsExactly(new NffSolid.Sphere(-1, Vec3.ZERO, 1), new NffSolid.Sphere(0, Vec3.ZERO, 2),
                new NffSolid.Cone(1, Vec3.ZERO, 1, Vec3.Y, 0.5), new NffSolid.Sphere(0, Vec3.ZERO, 3));
    }

    @Test
    void polygonsWithOneFill_shareOneMesh() throws Exception {
        NffFile file = read("p 4\n0 0 0\n1 0 0\n1 1 0\n0 1 0\np 3\n1 1 0 1 0 -0 2 0 0\n");
        assertThat(file.meshes()).hasSize(1);
        assertThat(file.meshes().getFirst().mesh().triangleCount()).isEqualTo(3);
        assertThat(file.meshes().getFirst().mesh().vertexCount()).isEqualTo(5);
        assertThat(file.meshes().getFirst().mesh().normals()).isNull();
    }

    @Test
    void patchNormals_areNormalized() throws Exception {
        NffFile file = read("pp 3\n0 0 0 0 0 2\n1 0 0 0 3 0\n0 1 0 0 0 0\n");
        assertThat(file.meshes().getFirst().name()).isEqualTo("patches");
        assertThat(file.meshes().getFirst().mesh().normals()).containsExactly(0, 0, 1, 0, 1, 0, 0, 0, 1);
    }

    @Test
    void otherDialects_areSkippedAndNoted() throws Exception {
        NffFile file = read("tess 4\nf 0.3 0.3 0.3 1 1\ns 0 0 0 -5\nf 1 1 1 1 0 1 0 1 earth.png\nl 0 0 0 shadows\n");
        assertThat(file.solids()).containsExactly(new NffSolid.Sphere(0, Vec3.ZERO, 5));
        assertThat(notes.counts()).containsEntry("entities tess", 1).containsEntry("fills with fewer than eight numbers", 1)
                .containsEntry("extra words after fills (another dialect)", 1)
                .containsEntry("extra words after lights (another dialect)", 1)
                .containsEntry("inside-out shapes, imported as two-sided", 1);
    }

    @Test
    void invalidFile_isReportedWithLine() {
        assertRejected("s 0 0 0 1\ns 1 2 x 4\n", "line 2: a number of s must be a decimal number, was 'x'");
        assertRejected("p 1000000000\n0 0 0\n", "line 3: expected a number of p, found the end of the file");
        assertRejected("p -3\n0 0 0\n", "line 1: a number of p must be a whole number from 0 to 2147483647, was '-3'");
        assertRejected("s 1e13 0 0 1\n", "line 1: a coordinate must be at most 1e12 in absolute value, was 1e13");
        assertRejected("tet 0 0 0 5\n", "must have shapes (c, s, p or pp)");
    }

    private void assertRejected(String text, String message) {
        assertThatExceptionOfType(MeshException.class).isThrownBy(() -> read(text)).withMessageEndingWith("a.nff: " + message);
    }

    private NffFile read(String text) throws IOException, MeshException {
        Path file = Files.writeString(folder.resolve("a.nff"), text);
        try (ByteSource source = ByteSource.open(file, Progress.NONE)) {
            return NffReader.read(source, notes);
        }
    }
}
