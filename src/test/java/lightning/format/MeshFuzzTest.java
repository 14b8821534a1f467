package lightning.format;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.Stream;
import lightning.base.text.PrintableText;
import lightning.base.work.Progress;
import lightning.format.gltf.GltfFixtures;
import lightning.format.mesh.MeshException;
import lightning.format.mesh.NamedMesh;
import lightning.format.mesh.ply.PlyEncoder;
import lightning.sample.ByteFuzzer;
import lightning.sample.Slow;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/**
 * Mesh files with a few errors: the reader returns meshes or throws its own exception, with a one-line message, in bounded
 * time; {@link ByteFuzzer} documents the options.
 */
@Slow
class MeshFuzzTest {
    private static final int TRIES = ByteFuzzer.tryCount(4_000);
    private static final String PLY = """
            ply
            format ascii 1.0
            element vertex 4
            property float x
            property double y
            property short z
            property float nx
            property float ny
            property float nz
            property uchar red
            property uchar green
            property uchar blue
            element face 1
            property list uchar int vertex_indices
            element tristrips 1
            property list int int vertex_indices
            end_header
            0 0 0 0 0 1 1 2 3
            1 0 0 0 0 1 4 5 6
            1 1 0 0 0 1 7 8 9
            0 1 0 0 0 1 0 0 0
            4 0 1 2 3
            5 0 1 2 -1 3
            """;

    private static final String OBJ = """
            mtllib a.mtl
            o house
            v 0 0 0
            v 1 0 0 1 0.5 0
            v 1 1 0
            v 0 1 0
            vt 0 0
            vt 1 1
            vn 0 0 1
            usemtl red
            f 1/1/1 2/2/1 3/1/1 4/2/1
            s 1
            g roof
            f -1 -2 -3
            f 1 2 3
            s off
            f 2 3 4
            """;

    private static final String NFF = """
            v
            from 1 2 3
            at 0 0 0
            up 0 0 1
            angle 45
            hither 1
            resolution 512 512
            b 0.1 0.2 0.3
            l 4 3 2
            l 1 -4 4 1 0.5 0
            f 1 0.75 0.33 0.8 0.2 8 0.9 1.5
            s 0 0 0 0.5
            # a remark
            c
            0 0 0 1
            0 1 0 0.5
            f 1 0 0 1 0 0 0 0
            p 4
            0 0 0
            1 0 0
            1 1 0
            0 1 0
            pp 3
            0 0 0 0 0 1
            1 0 0 0 1 1
            0 1 0 1 0 1
            """;

    @TempDir
    private Path folder;

    @Test
    @Timeout(300)
    void mutatedPly_isReadOrRejected() throws IOException {
        List<byte[]> pool =
                Stream.of("ascii", "binary_little_endian", "binary_big_endian").map(form -> PlyEncoder.encode(form, PLY)).toList();
        assertReadOrRejected("a.ply", pool, "end_header", "element x 2147483647\n", "property list uint double y\n",
                "format binary_big_endian 1.0\n",
                "1000000000", "-1", "nan", "\n", "\r", " ", "\u0000\u0000\u0000\u0000", "ÿÿÿ\u007f", "1e999", "\u001B[31m");
    }

    @Test
    @Timeout(300)
    void mutatedObj_isReadOrRejected() throws IOException {
        List<byte[]> pool =
                Stream.of(OBJ, OBJ.replace(" 1/1/1", " 1//1").replace("\n", "\r\n")).map(text -> text.getBytes(StandardCharsets.UTF_8))
                        .toList();
        assertReadOrRejected("a.obj", pool, "\n", "\\\n", "f ", "s 7\n", "-9", "/", "//", "1e300", "nan", "\no \u0007\n", "g g\n", "#",
                "99999999999",
                "v 0 0 0\n", "\u001B[31m", " ".repeat(50));
    }

    @Test
    @Timeout(300)
    void mutatedNff_isReadOrRejected() throws IOException {
        assertReadOrRejected("a.nff", List.of(NFF.getBytes(StandardCharsets.UTF_8)), "\n", "\r", "p ", "pp ", "c ", "1000000000", "-1",
                "nan",
                "1e999", "#", "f 1 1 1\n", "l 0 0 0\n", "s 0 0 0 1\n", "tess 4\n", "\u0000", "\u001B[31m", "1e300 ");
    }

    @Test
    @Timeout(300)
    void mutatedGltf_isReadOrRejected() throws IOException {
        List<byte[]> pool = List.of(GltfFixtures.text(GltfFixtures.SQUARE_JSON, GltfFixtures.SQUARE),
                GltfFixtures.binary(GltfFixtures.SQUARE_JSON, GltfFixtures.SQUARE));
        assertReadOrRejected("a.gltf", pool, "{", "}", "[", "]", "\"", ",", "-1", "99999999999", "1e999", "null", "5121",
                "\"count\": 60000000,",
                "\"byteStride\": 4,", "\"mode\": 5,", "\"sparse\": {\"count\": 1},", "\u0000\u0000\u0000\u0000", "\u001B[31m",
                "[[[[[[".repeat(50));
    }

    private void assertReadOrRejected(String name, List<byte[]> pool, String... hostile) throws IOException {
        List<byte[]> insertions = Stream.of(hostile).map(bit -> bit.getBytes(StandardCharsets.ISO_8859_1)).toList();
        List<String> rejections = new ArrayList<>();
        for (int i = 0; i < TRIES; i++) {
            SplittableRandom random = ByteFuzzer.random(i);
            Path file = Files.write(folder.resolve(name), ByteFuzzer.mutate(pool, random, insertions));
            try {
                List<NamedMesh> parts = MeshFormat.meshes(file, Progress.NONE);
                assertThat(parts).isNotEmpty();
                assertThat(parts.stream().map(NamedMesh::name)).doesNotHaveDuplicates()
                        .allMatch(part -> !part.isBlank() && PrintableText.isPrintable(part));
            } catch (MeshException e) {
                assertThat(e.getMessage()).as("try " + i).startsWith(file + ": ").matches(PrintableText::isPrintable, "is visible")
                        .hasSizeLessThan(2000);
                rejections.add(e.getMessage());
            } catch (IOException | RuntimeException | Error e) {
                throw new AssertionError("try " + i, e);
            }
        }
        assertThat(rejections.size()).isBetween(TRIES / 10, TRIES - 1);
        assertThat(rejections.stream().map(m -> m.replaceAll("'.*'|[0-9]+", "")).distinct().count()).as("kinds of refusals")
                .isGreaterThan(5);
    }
}
