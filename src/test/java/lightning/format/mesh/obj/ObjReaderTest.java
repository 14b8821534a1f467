package lightning.format.mesh.obj;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import lightning.base.work.Progress;
import lightning.format.mesh.ByteSource;
import lightning.format.mesh.ConversionNotes;
import lightning.format.mesh.MeshException;
import lightning.scene.node.Mesh;
import org.assertj.core.data.Offset;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** OBJ files, and their errors. */
class ObjReaderTest {
    private static final String CORNERS = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
    private final ConversionNotes notes = new ConversionNotes();

    @TempDir
    private Path folder;

    @Test
    void polygon_sharesItsVertices() throws IOException, MeshException {
        Mesh mesh = onlyMesh(CORNERS + "f 1 2 3 4\n");
        assertThat(mesh.positions()).containsExactly(0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0);
        assertThat(mesh.triangleCount()).isEqualTo(2);
        assertThat(mesh.normals()).isNull();
        assertThat(mesh.coordinates()).isNull();
    }

    @Test
    void negativeIndices_countBackwards() throws IOException, MeshException {
        assertThat(onlyMesh(CORNERS + "f -4 -3 -2\nv 9 9 9\nf -5 -3 -2")).isEqualTo(onlyMesh(CORNERS + "f 1 2 3\nv 9 9 9\nf 1 3 4"));
    }

    @Test
    void differingCorners_becomeSeparateVertices() throws IOException, MeshException {
        Mesh mesh = onlyMesh(CORNERS + "vt 0 0\nvt 0.5 1\nvn 0 0 2\nvn 0 3 0\nf 1/1/1 2/1/1 3/2/1\nf 1/1/1 3/1/1 4//2\n");
        assertThat(mesh.vertexCount()).isEqualTo(5);
        assertThat(mesh.triangles()).containsExactly(0, 1, 2, 0, 3, 4);
        assertThat(mesh.coordinates()).containsExactly(0, 0, 0, 0, 0.5f, 1, 0, 0, 0, 0);
        assertThat(mesh.normals()).containsExactly(0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 1, 0);
    }

    @Test
    void smoothingGroup_averagesNormalsAcrossTextureSeams() throws IOException, MeshException {
        String roof = "v 0 0 0\nv 0 0 1\nv -1 -1 0\nv 1 -1 0\nvt 0 0\nvt 1 1\n";
        Mesh mesh = onlyMesh(roof + "s 1\nf 1/1 3/1 2/1\nf 1/2 2/2 4/2\n");
        assertThat(mesh.vertexCount()).isEqualTo(6);
        for (int vertex : new int[] {0, 2, 3, 4}) {
            assertThat(mesh.normals()[3 * vertex + 1]).as("vertex " + vertex).isCloseTo(1, Offset.offset(1e-6f));
        }
        assertThat(mesh.normals()[3]).isCloseTo((float) -Math.sqrt(0.5), Offset.offset(1e-6f));
    }

    @Test
    void flatFacesNextToSmoothOnes_stayFlat() throws IOException, MeshException {
        Mesh mesh = onlyMesh("v 0 0 0\nv 0 0 1\nv -1 -1 0\nv 1 -1 0\ns 1\nf 1 3 2\ns off\nf 1 2 4\n");
        int[] t = mesh.triangles();
        for (int i = 3; i < 6; i++) {
            assertThat(mesh.normals()[3 * t[i]]).isCloseTo((float) Math.sqrt(0.5), Offset.offset(1e-6f));
        }
        assertThat(mesh.normals()[3 * t[0]]).isCloseTo((float) -Math.sqrt(0.5), Offset.offset(1e-6f));
    }

    @Test
    void objectsAndMaterials_becomeParts() throws IOException, MeshException {
        ObjFile file = read(
                "mtllib my house.mtl\n" + CORNERS + "f 1 2 3\no house \nusemtl red\nf 1 2 3\nusemtl blue\nf 1 3 4\nusemtl red\nf 2 3 4\n"
                        + "g garden\nf 1 2 3\no \u0007\nf 1 2 3");
        assertThat(file.libraries()).containsExactly("my house.mtl");
        assertThat(file.parts()).extracting(ObjFile.ObjPart::name).containsExactly("mesh", "house (red)", "house (blue)", "garden", "_");
        assertThat(file.parts()).extracting(ObjFile.ObjPart::material).containsExactly("", "red", "blue", "red", "red");
        assertThat(file.parts().get(1).mesh().triangleCount()).isEqualTo(2);
    }

    @Test
    void vertexColors_areLinear() throws IOException, MeshException {
        Mesh mesh = onlyMesh("v 0 0 0\nv 1 0 0 1 0 0.5\nv 1 1 0 1 0 0 1\nf 1 2 3\n");
        assertThat(mesh.colors()).containsExactly(1, 1, 1, 1, 0, (float) Math.pow((0.5 + 0.055) / 1.055, 2.4), 0, 0, 1);
    }

    @Test
    void commentsAndContinuedLines_areRead() throws IOException, MeshException {
        assertThat(onlyMesh("# a square\r\n" + CORNERS.replace("\n", " # corner\r\n") + "f 1 2 \\\r\n 3 4\r\n"))
                .isEqualTo(onlyMesh(CORNERS + "f 1 2 3 4\n"));
    }

    @Test
    void unsupportedStatements_areNoted() throws IOException, MeshException {
        onlyMesh(CORNERS + "l 1 2\nl 2 3\np 1\ncurv 0 1 1 2\nf 1 2\nf 1 2 3\n");
        assertThat(notes.counts()).containsExactlyInAnyOrderEntriesOf(
                Map.of("lines", 2, "points", 1, "statements curv", 1, "faces with fewer than three corners", 1));
    }

    /** Some exporters write the indices of a full corner regardless of the file's content. */
    @Test
    void indicesWithoutData_areSkippedAndNoted() throws IOException, MeshException {
        assertThat(onlyMesh(CORNERS + "f 1/1 2/2 3/7\n")).isEqualTo(onlyMesh(CORNERS + "f 1 2 3\n"));
        assertThat(onlyMesh(CORNERS + "s 1\nf 1//-1 2//2 3//9\n")).isEqualTo(onlyMesh(CORNERS + "s 1\nf 1 2 3\n"));
        assertThat(onlyMesh(CORNERS + "vn 0 0 1\nf 1/1/1 2/2/1 3/3/1\n")).isEqualTo(onlyMesh(CORNERS + "vn 0 0 1\nf 1//1 2//1 3//1\n"));
        assertThat(notes.counts()).containsExactlyInAnyOrderEntriesOf(
                Map.of("indices of missing texture coordinates", 6, "indices of missing normals",
                        3));
    }

    @Test
    void coordinatesAfterTheirFaces_areRejected() {
        assertRejected(CORNERS + "f 1/1 2/1 3/1\nvt 0 0\n", "line 6: texture coordinates must precede the faces that use them");
        assertRejected(CORNERS + "f 1//1 2 3\nvn 0 0 1\n", "line 6: normals must precede the faces that use them");
    }

    @Test
    void nanColor_becomesWhiteAndIsNoted() throws IOException, MeshException {
        Mesh mesh = onlyMesh("v 0 0 0 0 1 0\nv 1 0 0 nan nan nan\nv 1 1 0 0 NaN 0\nf 1 2 3\n");
        assertThat(mesh.colors()).containsExactly(0, 1, 0, 1, 1, 1, 1, 1, 1);
        assertThat(notes.counts()).containsExactly(Map.entry("vertex colors that are not numbers, replaced by white", 2));
    }

    @Test
    void outOfRangeColors_areClampedAndNoted() throws IOException, MeshException {
        assertThat(onlyMesh("v 0 0 0 0 1 0\nv 1 0 0 2 -1 0\nv 1 1 0 0 0 0\nf 1 2 3\n").colors()).containsExactly(0, 1, 0, 1, 0, 0, 0, 0, 0);
        assertThat(notes.counts()).containsExactly(Map.entry("vertex colors outside 0 to 1", 1));
    }

    @Test
    void invalidFiles_areReportedWithLine() {
        assertRejected("v 0 0\n", "line 1: expected 3 numbers, found 2");
        assertRejected("v 0 0 x\n", "line 1: a coordinate must be a decimal number, was 'x'");
        assertRejected("v 0 0 0 1 x 1\n", "line 1: a vertex must be a decimal number, was 'x'");
        assertRejected("v 0 nan 0\n", "must have faces");
        assertRejected("v 0 0 1e13\n", "line 1: a coordinate must be at most 1e12 in absolute value, was '1e13'");
        assertRejected(CORNERS + "f 1 2 5\n", "line 5: a corner must reference one of 4 preceding vertices, was '5'");
        assertRejected(CORNERS + "f 1 2 0\n", "line 5: a corner must reference one of 4 preceding vertices, was '0'");
        assertRejected(CORNERS + "f 1 2 -5\n", "line 5: a corner must reference one of 4 preceding vertices, was '-5'");
        assertRejected(CORNERS + "f 1 2 99999999999999999999\n",
                "line 5: a corner must reference one of 4 preceding vertices, was '99999999999999999999'");
        assertRejected(CORNERS + "vt 0 0\nf 1/2 2 3\n",
                "line 6: a corner must reference one of 1 preceding texture coordinates, was '1/2'");
        assertRejected(CORNERS + "vn 0 0 1\nf 1//2 2 3\n", "line 6: a corner must reference one of 1 preceding normals, was '1//2'");
        assertRejected(CORNERS + "f 1/x 2 3\n", "line 5: a corner must reference one of 0 preceding texture coordinates, was '1/x'");
        assertRejected(CORNERS + "vt 0 0\nvn 0 0 1\nf 1/1/1/1 2 3\n",
                "line 7: a corner must be written as 3, 3/1, 3//2 or 3/1/2, was '1/1/1/1'");
        assertRejected(CORNERS + "s one\n", "line 5: a smoothing group must be a whole number from 0 to 1073741824, was 'one'");
        assertRejected(CORNERS, "must have faces");
    }

    @Test
    void badLines_areSkippedAndNoted() throws Exception {
        Mesh mesh = onlyMesh(CORNERS + "f 1 2 x\nv 0 0 y\nvt 1 z\nf 1 2 5\nf 1 2 3\n");
        assertThat(mesh.triangleCount()).isEqualTo(1);
        assertThat(notes.counts().keySet()).containsExactly("line 5 skipped: a corner must reference one of 4 preceding vertices, was 'x'",
                "line 6 skipped: a coordinate must be a decimal number, was 'y'",
                "line 7 skipped: a coordinate must be a decimal number, was 'z'", "faces with vertices that are no numbers");
    }

    @Test
    void lineThatEndsWithABackslash_isContinued() throws Exception {
        assertThat(onlyMesh(CORNERS + "f 1 2\\\n 3 \\\r\n4\n").triangleCount()).isEqualTo(2);
    }

    @Test
    void namesOfOlderPrograms_areLatin1() throws Exception {
        byte[] file = (CORNERS + "o K\u00fcche\nf 1 2 3\n").getBytes(StandardCharsets.ISO_8859_1);
        try (ByteSource source = ByteSource.open(Files.write(folder.resolve("a.obj"), file), Progress.NONE)) {
            assertThat(ObjReader.read(source, notes).parts().getFirst().name()).isEqualTo("K\u00fcche");
        }
        assertThat(read(CORNERS + "o K\u00fcche\nf 1 2 3\n").parts().getFirst().name()).isEqualTo("K\u00fcche");
    }

    @Test
    void byteOrderMark_isSkipped() throws Exception {
        assertThat(read("\uFEFFmtllib a.mtl\n" + CORNERS + "f 1 2 3\n").libraries()).containsExactly("a.mtl");
        assertThat(notes.counts()).isEmpty();
    }

    /** By C libraries of several systems. */
    @Test
    void normalThatIsNoNumber_isThatOfTheFace() throws Exception {
        Mesh mesh = onlyMesh("v 0 0 0\nv 1 0 0\nv 1 1 0\nvn nan -nan(ind) 0\nvn 1.#QNAN 0 -1.#IND000\nvn inf 0 0\nf 1//1 2//2 3//3\n");
        assertThat(mesh.normals()).containsExactly(0, 0, 1, 0, 0, 1, 0, 0, 1);
    }

    @Test
    void coordinatesThatAreNoNumbers_areZero() throws Exception {
        assertThat(onlyMesh("v 0 0 0\nv 1 0 0\nv 1 1 0\nvt nan 1\nvt 1 1\nf 1/1 2/2 3/2\n").coordinates())
                .containsExactly(0, 0, 1, 1, 1, 1);
    }

    private void assertRejected(String file, String message) {
        assertThatExceptionOfType(MeshException.class).isThrownBy(() -> read(file)).withMessage(folder.resolve("a.obj") + ": " + message);
    }

    private Mesh onlyMesh(String file) throws IOException, MeshException {
        ObjFile objFile = read(file);
        assertThat(objFile.parts()).hasSize(1);
        return objFile.parts().getFirst().mesh();
    }

    private ObjFile read(String file) throws IOException, MeshException {
        try (ByteSource source = ByteSource.open(Files.writeString(folder.resolve("a.obj"), file), Progress.NONE)) {
            return ObjReader.read(source, notes);
        }
    }
}
