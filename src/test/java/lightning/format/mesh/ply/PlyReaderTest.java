package lightning.format.mesh.ply;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Map;
import lightning.base.work.Await;
import lightning.base.work.Progress;
import lightning.format.mesh.ByteSource;
import lightning.format.mesh.ConversionNotes;
import lightning.format.mesh.MeshException;
import lightning.scene.node.Mesh;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** PLY files in all forms, and their errors. */
class PlyReaderTest {
    private static final String SQUARE = """
            ply
            format ascii 1.0
            comment a square
            element vertex 4
            property float x
            property float y
            property float z
            element face 1
            property list uchar int vertex_indices
            end_header
            0 0 0
            1 0 0
            1 1 0
            0 1 0
            4 0 1 2 3
            """;
    private static final String RICH = """
            ply
            format ascii 1.0
            obj_info made by hand
            element camera 2
            property float view_x
            property list uchar short more
            element vertex 3
            property uchar red
            property uchar green
            property uchar blue
            property double x
            property short y
            property char z
            property float nx
            property float ny
            property float nz
            property float s
            property float t
            property uchar alpha
            element face 2
            property uchar quality
            property list ushort uint vertex_index
            end_header
            0.5 2 -7 8
            0.25 0
            255 0 0 0.5 300 -100 0 0 2 0 0 255
            0 255 0 1.5 -300 100 0 3 0 1 0 255
            0 0 255 2.5 0 0 0 0 0 0.5 1 255
            9 3 0 1 2
            9 3 2 1 0
            """;
    private final ConversionNotes notes = new ConversionNotes();

    @TempDir
    private Path folder;

    @ParameterizedTest
    @ValueSource(strings = {"ascii", "binary_little_endian", "binary_big_endian"})
    void square_hasTwoTrianglesAndFourVertices(String format) throws IOException, MeshException {
        Mesh mesh = read(PlyEncoder.encode(format, SQUARE));
        assertThat(mesh.positions()).containsExactly(0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0);
        assertThat(mesh.triangles()).hasSize(6);
        assertThat(mesh.normals()).isNull();
        assertThat(mesh.coordinates()).isNull();
        assertThat(mesh.colors()).isNull();
        assertThat(notes.counts()).isEmpty();
    }

    @ParameterizedTest
    @ValueSource(strings = {"ascii", "binary_little_endian", "binary_big_endian"})
    void properties_areReadInAnyOrderAndType(String format) throws IOException, MeshException {
        Mesh mesh = read(PlyEncoder.encode(format, RICH));
        assertThat(mesh.positions()).containsExactly(0.5f, 300, -100, 1.5f, -300, 100, 2.5f, 0, 0);
        assertThat(mesh.triangles()).containsExactly(0, 1, 2, 2, 1, 0);
        assertThat(mesh.coordinates()).containsExactly(0, 0, 1, 0, 0.5f, 1);
        assertThat(mesh.colors()).containsExactly(1, 0, 0, 0, 1, 0, 0, 0, 1);
        assertThat(mesh.normals()).startsWith(0, 0, 1, 0, 1, 0);
        assertThat(notes.counts()).containsOnlyKeys("elements camera", "properties alpha of vertices", "properties quality of faces");
    }

    @Test
    void brokenCommentInHeader_isSkippedAndNoted() throws Exception {
        Path file =
                Files.writeString(folder.resolve("a.ply"), SQUARE.replace("comment a square", "Created by somebody, element of a square"));
        var notes = new ConversionNotes();
        try (ByteSource source = ByteSource.open(file, Progress.NONE)) {
            assertThat(PlyReader.read(source, notes).triangleCount()).isEqualTo(2);
        }
        assertThat(notes.counts()).containsExactly(Map.entry("unknown header lines", 1));
    }

    @Test
    void integerColors_areDecodedFromSrgb() throws IOException, MeshException {
        Mesh mesh = read(RICH.replace("255 0 0 0.5", "128 0 0 0.5"));
        assertThat(mesh.colors()[0]).isEqualTo((float) Math.pow((128 / 255.0 + 0.055) / 1.055, 2.4));
    }

    @Test
    void floatColors_areLinear() throws IOException, MeshException {
        Mesh mesh = read(RICH.replace("uchar red", "float red").replace("uchar green", "float green").replace("uchar blue", "float blue")
                .replace("255 0 0 0.5", "0.5 0.25 0 0.5").replace("0 255 0 1.5", "0 1 0 1.5").replace("0 0 255 2.5", "0 0 1 2.5"));
        assertThat(mesh.colors()).containsExactly(0.5f, 0.25f, 0, 0, 1, 0, 0, 0, 1);
    }

    @ParameterizedTest
    @ValueSource(strings = {"ascii", "binary_little_endian"})
    void nanColor_becomesWhiteAndIsNoted(String format) throws IOException, MeshException {
        String file = SQUARE.replace("float z\n", "float z\nproperty float r\nproperty float g\nproperty float b\n")
                .replace("0 0 0\n", "0 0 0 0 NaN 0\n").replace("1 0 0\n", "1 0 0 0.5 0 0\n").replace("1 1 0\n", "1 1 0 0 2 0\n")
                .replace("0 1 0\n4", "0 1 0 0 0 0\n4");
        try (ByteSource source = ByteSource.open(Files.write(folder.resolve("a.ply"), PlyEncoder.encode(format, file)), Progress.NONE)) {
            assertThat(PlyReader.read(source, notes).colors()).containsExactly(1, 1, 1, 0.5f, 0, 0, 0, 1, 0, 0, 0, 0);
        }
        assertThat(notes.counts()).containsOnly(Map.entry("vertex colors that are not numbers, replaced by white", 1),
                Map.entry("vertex colors outside 0 to 1", 1));
    }

    /** One old version of MeshLab wrote corner colors without declaring them in the header. */
    @Test
    void undeclaredNumbers_areSkippedPerLine() throws IOException, MeshException {
        String file =
                SQUARE.replace("element face 1", "element face 2").replace("vertex_indices\n", "vertex_indices\nproperty uchar red\n");
        try (ByteSource source = ByteSource.open(
                Files.writeString(folder.resolve("a.ply"), file.replace("4 0 1 2 3", "3 0 1 2 9 0.5 0.5\n3 0 2 3 9 0.5 0.5")),
                Progress.NONE)) {
            assertThat(PlyReader.read(source, notes).triangles()).containsExactly(0, 1, 2, 0, 2, 3);
        }
        assertThat(notes.counts()).containsEntry("extra numbers at line ends, not declared in the header", 1);
    }

    @Test
    void elementsAcrossLines_areReadByCount() throws IOException, MeshException {
        String body = SQUARE.substring(SQUARE.indexOf("0 0 0\n"));
        assertThat(read(SQUARE.replace(body, body.replace('\n', ' ')))).isEqualTo(read(SQUARE));
        assertThat(read(SQUARE.replace(body, body.replace(' ', '\n')))).isEqualTo(read(SQUARE));
    }

    @Test
    void strips_alternateWindingAndRestart() throws IOException, MeshException {
        Mesh mesh = read(SQUARE.replace("element face 1", "element tristrips 1").replace("4 0 1 2 3", "8 0 1 2 3 -1 1 2 3"));
        assertThat(mesh.triangles()).containsExactly(0, 1, 2, 2, 1, 3, 1, 2, 3);
    }

    @ParameterizedTest
    @ValueSource(strings = {"\r\n", "\r"})
    void carriageReturnLineEnds_areRead(String lineEnd) throws IOException, MeshException {
        assertThat(read(SQUARE.replace("\n", lineEnd))).isEqualTo(read(SQUARE));
        byte[] binary = PlyEncoder.encode("binary_little_endian", SQUARE);
        byte[] other = (new String(binary, 0, binary.length - body(), StandardCharsets.ISO_8859_1).replace("\n", lineEnd)
                + new String(binary, binary.length - body(), body(), StandardCharsets.ISO_8859_1)).getBytes(StandardCharsets.ISO_8859_1);
        assertThat(read(other)).isEqualTo(read(SQUARE));
    }

    @Test
    void faceWithTwoCorners_isSkippedAndNoted() throws IOException, MeshException {
        Mesh mesh = read(SQUARE.replace("element face 1", "element face 2").replace("4 0 1 2 3", "2 0 1\n3 0 1 2"));
        assertThat(mesh.triangleCount()).isEqualTo(1);
        assertThat(notes.counts()).containsExactly(Map.entry("faces with fewer than three corners", 1));
    }

    @Test
    @Timeout(Await.TIMEOUT_SECONDS)
    void oversizedCount_isRejectedBeforeAllocation() {
        assertRejected(SQUARE.replace("element vertex 4", "element vertex 1000000000"),
                "element vertex: the header declares 1000000000, at least 5999999999 bytes, but only 34 bytes follow");
        String binary = new String(PlyEncoder.encode("binary_little_endian", SQUARE), StandardCharsets.ISO_8859_1);
        assertRejected(binary.replace("comment a square", "element x 2147483647\nproperty double x").getBytes(StandardCharsets.ISO_8859_1),
                "element x: the header declares 2147483647, at least 17179869176 bytes");
        assertRejected(SQUARE.replace("4 0 1 2 3", "4000000 0 1 2 3"),
                "line 15: face 0: vertex_indices must have from 0 to 5 numbers by the file's size, was 4000000.0");
    }

    @Test
    @Timeout(10)
    void elementsWithoutProperties_areSkippedQuickly() throws IOException, MeshException {
        assertThat(read(SQUARE.replace("comment a square", "element x 2147483647")).triangleCount()).isEqualTo(2);
    }

    @Test
    void invalidNumbers_areReportedWithLocation() {
        assertRejected(SQUARE.replace("1 1 0\n", "1 one 0\n"), "line 13: a number of vertex 2 must be a decimal number, was 'one'");
        assertRejected(SQUARE.replace("1 1 0\n", "1 nan 0\n"), "line 13: a number of vertex 2 must be a decimal number, was 'nan'");
        assertRejected(SQUARE.replace("1 1 0\n", "1 1e300 0\n"),
                "vertex 2: each number of its position must be from -1e12 to 1e12, was Infinity");
        assertRejected(SQUARE.replace("4 0 1 2 3", "4 0 1 2 4"), "line 15: face 0: a vertex must be a whole number from 0 to 3, was 4");
        assertRejected(SQUARE.replace("4 0 1 2 3", "4 0 1 -2 3"), "line 15: face 0: a vertex must be a whole number from 0 to 3, was -2");
        assertRejected(RICH.replace("255 0 0 0.5", "256 0 0 0.5"),
                "line 26: vertex 0: a color must be a whole number from 0 to 255, was 256.0");
        assertRejected(SQUARE.replace("4 0 1 2 3", ""), "line 16: face 0: unexpected end of file");
        byte[] binary =
                PlyEncoder.encode("binary_big_endian",
                        SQUARE.replace("element face 1", "element face 2").replace("4 0 1 2 3", "4 0 1 2 3\n0"));
        assertRejected(Arrays.copyOf(binary, binary.length - 1), "face 1: unexpected end of file");
    }

    @Test
    void invalidHeaders_areReportedWithLine() {
        assertRejected("plyx\n", "line 1: a PLY file must begin with the word ply");
        assertRejected(SQUARE.replace("ascii", "text"),
                "line 2: the format must be ascii, binary_little_endian or binary_big_endian, was 'text'");
        assertRejected(SQUARE.replace("format ascii 1.0\n", ""), "line 9: the header must have a format");
        assertRejected(SQUARE.replace("float z", "quad z"),
                "line 7: a type must be char, uchar, short, ushort, int, uint, float, double or list, was 'quad'");
        assertRejected(SQUARE.replace("float z", "float x"), "line 7: duplicate property 'x'");
        assertRejected(SQUARE.replace("element face", "element vertex"), "line 8: duplicate element 'vertex'");
        assertRejected(SQUARE.replace("vertex 4", "vertex many"),
                "line 4: the number of elements must be a whole number from 0 to 2147483647, was 'many'");
        assertRejected(SQUARE.replace("vertex 4", "vertex"), "line 4: expected the number of elements, found the end of the line");
        assertRejected(SQUARE.replace("property float z", "remark"),
                "line 7: expected format, element, property, comment or end_header, found 'remark'");
        assertRejected("ply\nformat ascii 1.0\n", "line 3: the header must end with end_header");
        assertRejected(SQUARE.replace("list uchar", "list float"), "line 9: a list's length must have an integer type");
    }

    @Test
    void fileWithoutFaces_isRejected() {
        assertRejected(SQUARE.replace("float z", "float w"), "element vertex: must have the properties x, y and z");
        assertRejected(SQUARE.replace("element face 1", "element edge 1"),
                "must have vertices and faces");
        assertRejected(SQUARE.replace("vertex_indices", "corners"), "element face: must have a list vertex_indices");
        assertRejected("ply\nformat ascii 1.0\nelement face 1\nproperty list int int vertex_indices\nend_header\n3 0 1 2",
                "element face: must follow the element vertex");
    }

    private static int body() {
        return 4 * 3 * 4 + 1 + 4 * 4;
    }

    private void assertRejected(String file, String message) {
        assertRejected(file.getBytes(StandardCharsets.UTF_8), message);
    }

    private void assertRejected(byte[] file, String message) {
        assertThatExceptionOfType(MeshException.class).isThrownBy(() -> read(file))
                .withMessageStartingWith(folder.resolve("a.ply") + ": " + message);
    }

    private Mesh read(String file) throws IOException, MeshException {
        return read(file.getBytes(StandardCharsets.UTF_8));
    }

    private Mesh read(byte[] file) throws IOException, MeshException {
        Path path = Files.write(folder.resolve("a.ply"), file);
        try (ByteSource source = ByteSource.open(path, Progress.NONE)) {
            return PlyReader.read(source, notes);
        }
    }
}
