package lightning.format.exchange;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import lightning.base.math.Vec3;
import lightning.base.work.Progress;
import lightning.format.exchange.assembly.ImportedScene;
import lightning.format.exchange.assembly.LightUnits;
import lightning.format.gltf.GltfFixtures;
import lightning.format.jen.JenReader;
import lightning.format.mesh.MeshException;
import lightning.scene.PlacedShape;
import lightning.scene.Scene;
import lightning.scene.light.Light;
import lightning.scene.node.Solid;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Nodes of glTF files: which are shown, where, and in which pose. */
class GltfNodesTest {
    private static final String NODES = "'nodes': [{'mesh': 0, 'name': 'floor'}]";
    /** Joint indices and weights of the square's vertices, a matrix that moves by (0, 0, 5), and displacements by (0, 0, 1) of two. */
    private static final byte[] POSES = ByteBuffer.allocate(140 + 16 + 64 + 64 + 48).order(ByteOrder.LITTLE_ENDIAN).put(GltfFixtures.SQUARE)
            .put(new byte[16]).put(floats(1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0))
            .put(floats(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 5, 1)).put(floats(0, 0, 1, 0, 0, 1, 0, 0, 0, 0, 0, 0)).array();
    private static final String POSE_JSON = GltfFixtures.SQUARE_JSON.replace("'byteLength': 12}]", """
            'byteLength': 12}, {'buffer': 0, 'byteOffset': 140, 'byteLength': 16}, {'buffer': 0, 'byteOffset': 156, 'byteLength': 64},
            {'buffer': 0, 'byteOffset': 220, 'byteLength': 64}, {'buffer': 0, 'byteOffset': 284, 'byteLength': 48}]""")
            .replace("'count': 6, 'type': 'SCALAR'}", """
                    'count': 6, 'type': 'SCALAR'},
                    {'bufferView': 2, 'componentType': 5121, 'count': 4, 'type': 'VEC4'},
                    {'bufferView': 3, 'componentType': 5126, 'count': 4, 'type': 'VEC4'},
                    {'bufferView': 4, 'componentType': 5126, 'count': 1, 'type': 'MAT4'},
                    {'bufferView': 5, 'componentType': 5126, 'count': 4, 'type': 'VEC3'}""")
            .replace("'byteLength': 140", "'byteLength': 332");

    @TempDir
    private Path folder;

    private static byte[] floats(float... values) {
        ByteBuffer bytes = ByteBuffer.allocate(4 * values.length).order(ByteOrder.LITTLE_ENDIAN);
        bytes.asFloatBuffer().put(values);
        return bytes.array();
    }

    private ImportedScene read(String json, byte[] data) throws IOException, MeshException {
        return SceneImporter.read(Files.write(folder.resolve("a.glb"), GltfFixtures.binary(json, data)),
                folder.resolve("scene/a.jen"), LightUnits.CANDELA, Progress.NONE);
    }

    private ImportedScene read(String from, String to) throws IOException, MeshException {
        return read(GltfFixtures.SQUARE_JSON.replace(from, to), GltfFixtures.SQUARE);
    }

    private Scene written(ImportedScene imported) throws Exception {
        Files.createDirectories(folder.resolve("scene"));
        imported.write();
        return JenReader.read(folder.resolve("scene/a.jen")).scene();
    }

    /** Returns a vertex of the only shape in the scene's space. */
    private static Vec3 vertex(Scene scene, int index) {
        PlacedShape shape = scene.placedShapes().getFirst();
        float[] p = ((Solid.TriangleMesh) shape.shape().solid()).mesh().positions();
        return shape.toWorld().transformPoint(new Vec3(p[3 * index], p[3 * index + 1], p[3 * index + 2]));
    }

    @Test
    void fileWithoutScenes_showsAllRoots() throws Exception {
        String json = GltfFixtures.SQUARE_JSON.replace("'scene': 0, 'scenes': [{'nodes': [0]}], ", "").replace(NODES,
                "'nodes': [{'mesh': 0}, {'children': [0]}, {'mesh': 0}]");
        assertThat(written(read(json, GltfFixtures.SQUARE)).placedShapes()).hasSize(2);
    }

    @Test
    void fileWithoutMeshes_isARig() throws Exception {
        String json = """
                {'asset': {'version': '2.0'}, 'nodes': [{'name': 'key', 'extensions': {'KHR_lights_punctual': {'light': 0}}}],
                 'extensions': {'KHR_lights_punctual': {'lights': [{'type': 'point', 'intensity': 683}]}}}""";
        Scene scene = written(read(json, new byte[4]));
        assertThat(scene.placedShapes()).isEmpty();
        assertThat(scene.lights()).extracting(Light::name).containsExactly("key");
    }

    @Test
    void invalidPrimitive_isLeftOut() throws Exception {
        ImportedScene imported = read("'indices': 3}]", "'indices': 3}, {'attributes': {'POSITION': 0}, 'indices': 9}]");
        assertThat(imported.scene().placedShapes()).hasSize(1);
        assertThat(imported.notes()).containsEntry("primitives that are invalid, left out", 1);
    }

    @Test
    void hiddenNode_isLeftOutWithItsChildren() throws Exception {
        ImportedScene imported = read(NODES,
                "'nodes': [{'children': [1], 'mesh': 0, 'extensions': {'KHR_node_visibility': {'visible': false}}}, {'mesh': 0}, {'mesh': 0}]");
        assertThat(imported.scene().placedShapes()).isEmpty();
        assertThat(imported.notes()).containsEntry("hidden nodes (KHR_node_visibility), left out with all that is in them", 1);
    }

    @Test
    void instances_areCopiesAtTheirPlaces() throws Exception {
        ImportedScene imported = read(POSE_JSON.replace(NODES, "'nodes': [{'mesh': 0, 'translation': [10, 0, 0],"
                + " 'extensions': {'EXT_mesh_gpu_instancing': {'attributes': {'TRANSLATION': 7}}}}]"), POSES);
        assertThat(written(imported).placedShapes()).extracting(shape -> shape.toWorld().transformPoint(Vec3.ZERO))
                .containsExactly(new Vec3(10, 0, 1), new Vec3(10, 0, 1), new Vec3(10, 0, 0), new Vec3(10, 0, 0));
    }

    /** The joint is at x = 1 and the matrix moves by z = 5; the node's own transform does not act. */
    @Test
    void skin_placesTheMeshByItsJoints() throws Exception {
        String json = POSE_JSON.replace("'TEXCOORD_0': 2}", "'TEXCOORD_0': 2, 'JOINTS_0': 4, 'WEIGHTS_0': 5}")
                .replace(NODES, "'skins': [{'joints': [1], 'inverseBindMatrices': 6}],"
                        + " 'nodes': [{'mesh': 0, 'skin': 0, 'translation': [50, 0, 0], 'scale': [100, 100, 100], 'children': [1]},"
                        + " {'translation': [-0.49, 0, 0], 'scale': [0.01, 0.01, 0.01]}]");
        Scene scene = written(read(json, POSES));
        assertThat(vertex(scene, 0).minus(new Vec3(1, 0, 5)).maxAbs()).isLessThan(1e-5);
        assertThat(vertex(scene, 2).minus(new Vec3(2, 1, 5)).maxAbs()).isLessThan(1e-5);
    }

    @Test
    void morphTargets_actByTheWeightsOfTheNode() throws Exception {
        String json = POSE_JSON.replace("'indices': 3}]", "'indices': 3, 'targets': [{'POSITION': 7}]}], 'weights': [0]")
                .replace(NODES, "'nodes': [{'mesh': 0, 'weights': [0.5], 'translation': [0, 0, 1]}]");
        Scene scene = written(read(json, POSES));
        assertThat(vertex(scene, 0)).isEqualTo(new Vec3(0, 0, 1.5));
        assertThat(vertex(scene, 2)).isEqualTo(new Vec3(1, 1, 1));
    }

    /** KHR_lights_punctual: the square of the cosine's share. */
    @Test
    void edgeOfASpot_hasTheLawOfTheExtension() throws Exception {
        String json = GltfFixtures.LIT_JSON.replace("'type': 'point'",
                "'type': 'spot', 'spot': {'innerConeAngle': 0.2, 'outerConeAngle': 0.5}");
        Light spot = written(read(json, GltfFixtures.SQUARE)).lights().getFirst();
        for (double angle : List.of(0.1, 0.203, 0.386, 0.469, 0.51)) {
            double share = Math.clamp((Math.cos(angle) - Math.cos(0.5)) / (Math.cos(0.2) - Math.cos(0.5)), 0, 1);
            assertThat(spot.profile().orElseThrow().photometry().sample(Math.toDegrees(angle), 0)).as("%s rad", angle)
                    .isCloseTo(share * share, within(3e-4));
        }
    }

    /** A surface of 1 nit beside a white one in 1 lux, which has 1 / π nits. */
    @Test
    void emission_countsAsNitsAgainstLux() throws Exception {
        String json = GltfFixtures.LIT_JSON.replace("'type': 'point', 'intensity': 100", "'type': 'directional', 'intensity': 1")
                .replace("'indices': 3", "'indices': 3, 'material': 0").replace("'buffers'",
                        "'materials': [{'emissiveFactor': [1, 1, 1]}], 'buffers'");
        Scene scene = read(json, GltfFixtures.SQUARE).scene();
        assertThat(scene.lights().getFirst().intensity() / scene.materials().getFirst().glow().r()).isCloseTo(1 / Math.PI, within(1e-12));
        Scene unitless = read(json, GltfFixtures.SQUARE).inUnits(LightUnits.UNITLESS).scene();
        assertThat(unitless.materials().getFirst().glow().r()).isEqualTo(1);
    }
}
