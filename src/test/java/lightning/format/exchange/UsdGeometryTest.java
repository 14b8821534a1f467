package lightning.format.exchange;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.data.Offset.offset;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.OptionalDouble;
import lightning.base.work.Progress;
import lightning.format.exchange.assembly.ImportedScene;
import lightning.format.exchange.assembly.LightUnits;
import lightning.sample.PythonPrograms;
import lightning.scene.node.Mesh;
import lightning.scene.node.Solid;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Meshes of stages, through usd-core. */
class UsdGeometryTest {
    private static final String HEADER = "#usda 1.0\n(\n    upAxis = \"Y\"\n    metersPerUnit = 1\n)\n";
    /** The cube from −1 to 1. */
    private static final String CUBE = """
                int[] faceVertexCounts = [4, 4, 4, 4, 4, 4]
                int[] faceVertexIndices = [0, 2, 3, 1, 4, 5, 7, 6, 0, 1, 5, 4, 2, 6, 7, 3, 0, 4, 6, 2, 1, 3, 7, 5]
                point3f[] points = [(-1, -1, -1), (1, -1, -1), (-1, 1, -1), (1, 1, -1), (-1, -1, 1), (1, -1, 1), (-1, 1, 1), (1, 1, 1)]
            """;
    /** Three squares in a row, along x from 0 to 3, y from 0 to 1. */
    private static final String STRIP = """
                int[] faceVertexCounts = [4, 4, 4]
                int[] faceVertexIndices = [0, 1, 5, 4, 1, 2, 6, 5, 2, 3, 7, 6]
                point3f[] points = [(0, 0, 0), (1, 0, 0), (2, 0, 0), (3, 0, 0), (0, 1, 0), (1, 1, 0), (2, 1, 0), (3, 1, 0)]
            """;
    @TempDir
    private Path folder;

    @BeforeEach
    void requireUsd() {
        PythonPrograms.require("pxr");
    }

    private ImportedScene imported(String prims, int levels) throws Exception {
        Path file = Files.writeString(folder.resolve("a.usda"), HEADER + prims);
        return SceneImporter.read(file, folder.resolve("a.jen"), ImportOptions.DEFAULT.withLevels(levels), Progress.NONE);
    }

    private static String mesh(String content) {
        return "def Mesh \"thing\"\n{\n" + content + "\n}\n";
    }

    private static List<Mesh> meshes(ImportedScene scene) {
        List<Mesh> meshes = new ArrayList<>();
        for (var shape : scene.scene().placedShapes()) {
            meshes.add(((Solid.TriangleMesh) shape.shape().solid()).mesh());
        }
        return meshes;
    }

    private Mesh only(String content, int levels) throws Exception {
        return meshes(imported(mesh(content), levels)).getFirst();
    }

    private static float most(float[] values, int axis) {
        float most = Float.NEGATIVE_INFINITY;
        for (int i = axis; i < values.length; i += 3) {
            most = Math.max(most, values[i]);
        }
        return most;
    }

    /** Middles of the faces are at 68/81 of the limit surface at every level. */
    @Test
    void subdivisionSurface_isRefined() throws Exception {
        for (int levels = 1; levels <= 3; levels++) {
            Mesh mesh = only(CUBE, levels);
            assertThat(mesh.triangleCount()).isEqualTo(12 << 2 * levels);
            for (int axis = 0; axis < 3; axis++) {
                assertThat(most(mesh.positions(), axis)).isCloseTo((float) (68 / 81.0), offset(1e-6f));
            }
            for (int i = 0; i < mesh.positions().length; i += 3) {
                float outwards = mesh.positions()[i] * mesh.normals()[i] + mesh.positions()[i + 1] * mesh.normals()[i + 1]
                        + mesh.positions()[i + 2] * mesh.normals()[i + 2];
                assertThat(outwards).isGreaterThan(0.5f);
            }
        }
        ImportedScene scene = imported(mesh(CUBE), SceneImporter.DEFAULT_LEVELS);
        assertThat(meshes(scene).getFirst().triangleCount()).isEqualTo(192);
        assertThat(scene.notes().keySet()).noneMatch(note -> note.contains("subdivision"));
    }

    @Test
    void leftHandedSurface_hasNormalsOutwards() throws Exception {
        Mesh right = only(CUBE, 1);
        // The same cube inside out, so that left-handed faces look outwards.
        Mesh left = only(
                "uniform token orientation = \"leftHanded\"\n" + CUBE.replace("0, 2, 3, 1, 4, 5, 7, 6, 0, 1, 5, 4, 2, 6, 7, 3, 0, 4, 6, 2, "
                        + "1, 3, 7, 5", "1, 3, 2, 0, 6, 7, 5, 4, 4, 5, 1, 0, 3, 7, 6, 2, 2, 6, 4, 0, 5, 7, 3, 1"),
                1);
        assertThat(left.triangleCount()).isEqualTo(right.triangleCount());
        for (int i = 0; i < left.positions().length; i += 3) {
            assertThat(left.positions()[i] * left.normals()[i] + left.positions()[i + 1] * left.normals()[i + 1]
                    + left.positions()[i + 2] * left.normals()[i + 2]).isGreaterThan(0.5f);
        }
    }

    @Test
    void polygons_stayAsTheyAre() throws Exception {
        for (String polygons : List.of("uniform token subdivisionScheme = \"none\"\n" + CUBE,
                CUBE + "normal3f[] normals = [(0, 0, 1)] ( interpolation = \"constant\" )")) {
            Mesh mesh = only(polygons, 2);
            assertThat(mesh.triangleCount()).isEqualTo(12);
            assertThat(most(mesh.positions(), 0)).isEqualTo(1);
        }
        assertThat(only(CUBE, 0).triangleCount()).isEqualTo(12);
        // The scheme of a stage has precedence over normals.
        assertThat(only("uniform token subdivisionScheme = \"catmullClark\"\n" + CUBE
                + "normal3f[] normals = [(0, 0, 1)] ( interpolation = \"constant\" )", 2).triangleCount()).isEqualTo(192);
    }

    @Test
    void creasesAndCorners_staySharp() throws Exception {
        String top = "int[] creaseIndices = [4, 5, 7, 6, 4]\nint[] creaseLengths = [5]\nfloat[] creaseSharpnesses = [%s]\n";
        Mesh sharp = only(CUBE + String.format(Locale.ROOT, top, "10"), 2);
        assertThat(most(sharp.positions(), 2)).isEqualTo(1);
        // The 16 points of the crease have a normal for each side; one that is sharp for a level has one.
        assertThat(sharp.positions()).hasSize(3 * (98 + 16));
        assertThat(only(CUBE + String.format(Locale.ROOT, top, "1"), 2).positions()).hasSize(3 * 98);
        assertThat(most(only(CUBE + String.format(Locale.ROOT, top, "10, 10, 10, 10"), 2).positions(), 2)).isEqualTo(1);
        Mesh pointed = only(CUBE + "int[] cornerIndices = [7, 99]\nfloat[] cornerSharpnesses = [10, 10]\n", 2);
        for (int axis = 0; axis < 3; axis++) {
            assertThat(most(pointed.positions(), axis)).isEqualTo(1);
        }
    }

    @Test
    void boundaryRules_areThoseOfTheStage() throws Exception {
        Mesh cornered = only(STRIP, 2);
        assertThat(most(cornered.positions(), 0)).isEqualTo(3);
        assertThat(most(cornered.positions(), 1)).isEqualTo(1);
        Mesh round = only("uniform token interpolateBoundary = \"edgeOnly\"\n" + STRIP, 2);
        assertThat(most(round.positions(), 0)).isBetween(2.5f, 2.99f);
        // Each face of the strip touches the boundary.
        assertThat(imported(mesh("token interpolateBoundary = \"none\"\n" + STRIP), 2).scene().placedShapes()).isEmpty();
        // The strip without its last square.
        assertThat(only("int[] holeIndices = [2, 2]\n" + STRIP, 2).triangleCount()).isEqualTo(64);
    }

    @Test
    void coordinatesSubsetsAndColors_areKept() throws Exception {
        String content = STRIP + """
                texCoord2f[] primvars:st = [(0, 0), (1, 0), (1, 1), (0, 1)] ( interpolation = "faceVarying" )
                int[] primvars:st:indices = [0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3]
                color3f[] primvars:displayColor = [(1, 0, 0), (0, 1, 0), (0, 0, 1)] ( interpolation = "uniform" )
                def GeomSubset "last"
                {
                    uniform token elementType = "face"
                    uniform token familyName = "materialBind"
                    int[] indices = [2]
                }
                """;
        List<Mesh> parts = meshes(imported(mesh(content), 2));
        assertThat(parts).extracting(Mesh::triangleCount).containsExactly(64, 32);
        Mesh last = parts.get(1);
        for (int v = 0; v < last.positions().length / 3; v++) {
            assertThat(last.positions()[3 * v]).isGreaterThan(1.9f);
            assertThat(last.coordinates()[2 * v] * 4).isEqualTo(Math.round(last.coordinates()[2 * v] * 4));
            assertThat(last.colors()[3 * v + 2]).isEqualTo(1);
        }
        // 25 points for each texture tile, which corners of equal values share.
        assertThat(last.positions()).hasSize(75);
    }

    @Test
    void displayColorOfAnotherType_isNoted() throws Exception {
        ImportedScene scene = imported(mesh(CUBE + "float[] primvars:displayColor = [0.5] ( interpolation = \"constant\" )"), 1);
        assertThat(meshes(scene)).hasSize(1);
        assertThat(scene.notes()).containsEntry("display colors of another type", 1);
    }

    /** Prototypes that are not in the stage itself, and one that shows nothing anywhere. */
    @Test
    void prototypesOfOtherKinds_areInstanced() throws Exception {
        String prims = """
                class Xform "model"
                {
                    def Cube "cube"
                    {
                    }
                }
                over "hidden"
                {
                    def Sphere "ball"
                    {
                    }
                }
                def Xform "off" ( active = false )
                {
                }
                def PointInstancer "copies"
                {
                    int[] protoIndices = [0, 1, 2, 0]
                    point3f[] positions = [(0, 0, 0), (3, 0, 0), (6, 0, 0), (9, 0, 0)]
                    rel prototypes = [</model>, </hidden>, </off>]
                }
                """;
        assertThat(imported(prims, 1).scene().placedShapes()).hasSize(3);
    }

    /** Dense meshes get fewer levels, each for itself. */
    @Test
    void levels_areBounded() throws Exception {
        int side = 300;
        var text = new StringBuilder("int[] faceVertexCounts = [4").append(", 4".repeat(side * side - 1))
                .append("]\nint[] faceVertexIndices = [");
        for (int i = 0; i < side * side; i++) {
            int at = i / side * (side + 1) + i % side;
            text.append(i == 0 ? "" : ", ").append(at).append(", ").append(at + 1).append(", ").append(at + side + 2).append(", ")
                    .append(at + side + 1);
        }
        text.append("]\npoint3f[] points = [");
        for (int i = 0; i < (side + 1) * (side + 1); i++) {
            text.append(i == 0 ? "" : ", ").append('(').append(i % (side + 1)).append(", ").append(i / (side + 1)).append(", 0)");
        }
        ImportedScene scene = imported(mesh(text + "]") + mesh(CUBE).replace("thing", "cube"), 2);
        assertThat(meshes(scene)).extracting(Mesh::triangleCount).containsExactly(8 * side * side, 192);
        assertThat(scene.notes()).containsEntry("subdivision surfaces refined less, to keep the number of triangles in bounds", 1);
    }

    /** A ribbon along y from 0 to 2, whose upper half is bent to x at frame 1 and straight at frame 9. */
    private static final String ARM = """
            def SkelRoot "arm"
            {
                def Skeleton "skeleton" ( prepend apiSchemas = ["SkelBindingAPI"] )
                {
                    uniform token[] joints = ["a", "a/b"]
                    uniform matrix4d[] bindTransforms = [((1, 0, 0, 0), (0, 1, 0, 0), (0, 0, 1, 0), (0, 0, 0, 1)),
                        ((1, 0, 0, 0), (0, 1, 0, 0), (0, 0, 1, 0), (0, 1, 0, 1))]
                    uniform matrix4d[] restTransforms = [((1, 0, 0, 0), (0, 1, 0, 0), (0, 0, 1, 0), (0, 0, 0, 1)),
                        ((1, 0, 0, 0), (0, 1, 0, 0), (0, 0, 1, 0), (0, 1, 0, 1))]
                    rel skel:animationSource = </arm/skeleton/bend>
                    def SkelAnimation "bend"
                    {
                        uniform token[] joints = ["a", "a/b"]
                        float3[] translations = [(0, 0, 0), (0, 1, 0)]
                        half3[] scales = [(1, 1, 1), (1, 1, 1)]
                        quatf[] rotations.timeSamples = {
                            1: [(1, 0, 0, 0), (0.70710678, 0, 0, -0.70710678)],
                            9: [(1, 0, 0, 0), (1, 0, 0, 0)],
                        }
                    }
                }
                def Mesh "skin" ( prepend apiSchemas = ["SkelBindingAPI"] )
                {
                    uniform token subdivisionScheme = "none"
                    int[] faceVertexCounts = [4, 4]
                    int[] faceVertexIndices = [0, 1, 3, 2, 2, 3, 5, 4]
                    point3f[] points = [(0, 0, 0), (0, 0, 1), (0, 1, 0), (0, 1, 1), (0, 2, 0), (0, 2, 1)]
                    int[] primvars:skel:jointIndices = [0, 0, 0, 0, 1, 1] ( elementSize = 1; interpolation = "vertex" )
                    float[] primvars:skel:jointWeights = [1, 1, 1, 1, 1, 1] ( elementSize = 1; interpolation = "vertex" )
                    rel skel:skeleton = </arm/skeleton>
                }
            }
            """;

    /** Halfway, the upper bone leans by 45 degrees. */
    @Test
    void skinnedMesh_hasPoseOfChosenFrame() throws Exception {
        Path file = Files.writeString(folder.resolve("a.usda"), HEADER + ARM);
        ImportedScene scene =
                SceneImporter.read(file, folder.resolve("a.jen"), ImportOptions.DEFAULT.withFrame(OptionalDouble.of(5)), Progress.NONE);
        assertThat(most(meshes(scene).getFirst().positions(), 0)).isCloseTo((float) Math.sqrt(0.5), offset(1e-3f));
        assertThat(most(meshes(scene).getFirst().positions(), 1)).isCloseTo(1 + (float) Math.sqrt(0.5), offset(1e-3f));
        assertThat(scene.notes().keySet()).noneMatch(note -> note.contains("skeleton"));
    }

    /** Before its first sample, an attribute has the value of that. */
    @Test
    void skinnedMeshBeforeItsFirstSample_hasThatPose() throws Exception {
        Path file = Files.writeString(folder.resolve("a.usda"),
                HEADER.replace(")\n", "    startTimeCode = 0\n    endTimeCode = 9\n)\n") + ARM);
        ImportedScene scene = SceneImporter.read(file, folder.resolve("a.jen"), LightUnits.CANDELA, Progress.NONE);
        assertThat(most(meshes(scene).getFirst().positions(), 0)).isCloseTo(1, offset(1e-6f));
    }

    @Test
    void skinnedMesh_hasPoseOfFirstFrame() throws Exception {
        String range = HEADER.replace(")\n", "    startTimeCode = 1\n    endTimeCode = 9\n)\n");
        String copies = "def Xform \"copy\" ( instanceable = true )\n{\n" + ARM.replace("/arm", "/copy/arm") + "}\n"
                + "def Xform \"again\" ( instanceable = true; prepend references = </copy> )\n{\n}\n";
        for (String prims : List.of(ARM, copies)) {
            Path file = Files.writeString(folder.resolve("a.usda"), range + prims);
            ImportedScene scene = SceneImporter.read(file, folder.resolve("a.jen"), LightUnits.CANDELA, Progress.NONE);
            assertThat(meshes(scene)).hasSize(prims.equals(ARM) ? 1 : 2);
            for (Mesh mesh : meshes(scene)) {
                assertThat(most(mesh.positions(), 0)).isCloseTo(1, offset(1e-6f));
                assertThat(most(mesh.positions(), 1)).isCloseTo(1, offset(1e-6f));
            }
            String root = prims.equals(ARM) ? "/arm" : "/copy/arm";
            assertThat(scene.notes())
                    .containsEntry("moving skeletons, with meshes posed, as at the first frame (1): '" + root + "'", 1)
                    .doesNotContainKey("skeletons that cannot be evaluated");
        }
    }
}
