package lightning.format.exchange;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.CancellationException;
import lightning.base.math.Vec3;
import lightning.base.work.Progress;
import lightning.format.exchange.assembly.ImportedScene;
import lightning.format.exchange.assembly.LightUnits;
import lightning.format.jen.JenReader;
import lightning.format.mesh.MeshException;
import lightning.sample.Slow;
import lightning.scene.Scene;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import lightning.scene.node.Solid;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Files that Assimp converts in a process of its own. */
@Slow
class AssimpImportTest {
    private static final String TRIANGLE = """
            solid a
            facet normal 0 0 1
            outer loop
            vertex 0 0 0
            vertex 4 0 0
            vertex 0 3 0
            endloop
            endfacet
            endsolid a
            """;
    /** A spot of 60° at (1, 2, 3), a camera with a horizontal angle of 90° at (0, 0, 5), and a triangle, in centimeters. */
    private static final String COLLADA =
            """
                    <?xml version="1.0" encoding="utf-8"?>
                    <COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
                      <asset><unit name="centimeter" meter="0.01"/><up_axis>Y_UP</up_axis></asset>
                      <library_cameras><camera id="c" name="eye"><optics><technique_common><perspective>
                        <xfov>90</xfov><aspect_ratio>2</aspect_ratio><znear>1</znear><zfar>100</zfar>
                      </perspective></technique_common></optics></camera></library_cameras>
                      <library_lights><light id="l" name="key"><technique_common><spot>
                        <color>8 4 2</color><constant_attenuation>0</constant_attenuation><linear_attenuation>0</linear_attenuation>
                        <quadratic_attenuation>1</quadratic_attenuation><falloff_angle>60</falloff_angle><falloff_exponent>0.15</falloff_exponent>
                      </spot></technique_common></light></library_lights>
                      <library_geometries><geometry id="g" name="flat"><mesh>
                        <source id="p"><float_array id="pa" count="9">0 0 0 400 0 0 0 300 0</float_array><technique_common>
                          <accessor source="#pa" count="3" stride="3"><param name="X" type="float"/><param name="Y" type="float"/>
                          <param name="Z" type="float"/></accessor></technique_common></source>
                        <vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
                        <triangles count="1"><input semantic="VERTEX" source="#v" offset="0"/><p>0 1 2</p></triangles>
                      </mesh></geometry></library_geometries>
                      <library_visual_scenes><visual_scene id="s">
                        <node id="eye"><translate>0 0 500</translate><instance_camera url="#c"/></node>
                        <node id="key"><translate>100 200 300</translate><instance_light url="#l"/></node>
                        <node id="flat"><instance_geometry url="#g"/></node>
                      </visual_scene></library_visual_scenes>
                      <scene><instance_visual_scene url="#s"/></scene>
                    </COLLADA>
                    """;

    @TempDir
    Path folder;
    private Path from;

    @BeforeEach
    void makeFolder() throws Exception {
        from = Files.createDirectory(folder.resolve("from"));
    }

    private ImportedScene read(String name, String text) throws Exception {
        return SceneImporter.read(Files.writeString(from.resolve(name), text), folder.resolve("a.jen"), LightUnits.CANDELA, Progress.NONE);
    }

    private Scene scene(ImportedScene imported) throws Exception {
        imported.write();
        return JenReader.read(folder.resolve("a.jen")).scene();
    }

    @Test
    void meshWithoutNormals_isImported() throws Exception {
        Scene scene = scene(read("a.stl", TRIANGLE));
        assertThat(scene.placedShapes()).hasSize(1);
        Solid.TriangleMesh mesh = (Solid.TriangleMesh) scene.placedShapes().getFirst().shape().solid();
        assertThat(mesh.mesh().positions()).containsExactlyInAnyOrder(0, 0, 0, 4, 0, 0, 0, 3, 0);
    }

    @Test
    void cameraAndLight_areAtTheirNodes_inMeters() throws Exception {
        Scene scene = scene(read("a.dae", COLLADA));
        assertThat(scene.camera().from().minus(new Vec3(0, 0, 5)).length()).isLessThan(1e-6);
        // The tangent of half of the angle is 1 across, and half of it upward.
        assertThat(scene.camera().fov()).isEqualTo(2 * Math.toDegrees(Math.atan(0.5)), within(1e-4));
        Light key = scene.lights().getFirst();
        assertThat(key.type()).isEqualTo(LightType.SPOT);
        assertThat(key.position().minus(new Vec3(1, 2, 3)).length()).isLessThan(1e-6);
        assertThat(key.direction().minus(new Vec3(0, 0, -1)).length()).isLessThan(1e-6);
        assertThat(key.color().g() / key.color().r()).isEqualTo(0.5, within(1e-6));
    }

    @ParameterizedTest
    @ValueSource(strings = {"a.fbx", "a.dae", "a.3ds", "a.stl"})
    void fileThatAssimpCannotRead_isRefusedInOneSentence(String name) {
        assertThatThrownBy(() -> read(name, "nothing of this kind")).isInstanceOf(MeshException.class).message()
                .contains(name, "cannot be read by Assimp: ").doesNotContain("\n", "Exception");
    }

    @Test
    void nffOfSense8_isConverted() throws Exception {
        Scene scene = scene(read("a.nff", "nff\nversion 2.0\na\n3\n0 0 0\n1 0 0\n0 1 0\n1\n3 0 1 2\n"));
        assertThat(scene.placedShapes()).hasSize(1);
    }

    /** A triangle of AC3D in nested groups, with a subdivision. */
    private static String ac(int groups, int subdivision) {
        String group = "OBJECT group\nname \"g\"\nloc 0 0.5 0\nkids 1\n";
        return "AC3Db\nMATERIAL \"m\" rgb 1 1 1  amb 0 0 0  emis 0 0 0  spec 0 0 0  shi 1  trans 0\nOBJECT world\nkids 1\n"
                + group.repeat(groups) + "OBJECT poly\nname \"Tür\"\nsubdiv " + subdivision
                + "\nnumvert 3\n0 0 0\n1 0 0\n0 1 0\nnumsurf 1\nSURF 0x20\nmat 0\nrefs 3\n0 0 0\n1 1 0\n2 0 1\nkids 0\n";
    }

    @Test
    void namesInLatin1_areKept() throws Exception {
        Path file = Files.write(from.resolve("a.ac"), ac(0, 0).getBytes(StandardCharsets.ISO_8859_1));
        Scene scene = scene(SceneImporter.read(file, folder.resolve("a.jen"), LightUnits.CANDELA, Progress.NONE));
        assertThat(scene.placedShapes().getFirst().shape().name()).contains("Tür");
    }

    /** More groups than a scene can nest. */
    @Test
    void deepGroups_areImported() throws Exception {
        ImportedScene imported = read("a.ac", ac(100, 0));
        assertThat(imported.notes().toString()).contains("nested more than 30 deep");
        Scene scene = scene(imported);
        assertThat(scene.placedShapes().getFirst().toWorld().transformPoint(Vec3.ZERO).y()).isEqualTo(50, within(1e-4));
    }

    @Test
    void thirdTextureCoordinate_isLeftOut() throws Exception {
        String mesh = COLLADA.replace("<vertices id", """
                <source id="t"><float_array id="ta" count="9">0 0 0 1 0 0.5 0 1 0</float_array><technique_common>
                <accessor source="#ta" count="3" stride="3"><param name="S" type="float"/><param name="T" type="float"/>
                <param name="P" type="float"/></accessor></technique_common></source><vertices id""")
                .replace("<p>0 1 2</p>", "<input semantic=\"TEXCOORD\" source=\"#t\" offset=\"1\" set=\"0\"/><p>0 0 1 1 2 2</p>");
        Solid.TriangleMesh solid = (Solid.TriangleMesh) scene(read("a.dae", mesh)).placedShapes().getFirst().shape().solid();
        assertThat(solid.mesh().coordinates()).hasSize(6);
    }

    /** What a small file says it contains takes no more memory than its size justifies. */
    @Test
    void hugeContentOfSmallFile_isRefused() {
        assertThatThrownBy(() -> read("a.off", "OFF\n60000000 60000000 0\n0 0 0\n")).isInstanceOf(MeshException.class)
                .hasMessageEndingWith("a.off: cannot be read by Assimp: it would take more than 256 MiB of memory");
        assertThatThrownBy(() -> read("a.ac", ac(0, 13))).isInstanceOf(MeshException.class)
                .hasMessageEndingWith("a.ac: cannot be read by Assimp: it would take more than 256 MiB of memory");
    }

    /** The user knows the source only, not the file that it is converted to. */
    @Test
    void tooDeepGroups_areRefusedWithTheSource() {
        assertThatThrownBy(() -> read("a.ac", ac(600, 0))).isInstanceOf(MeshException.class).message()
                .contains("a.ac: converted to glTF, ", "nested at most 500 deep").doesNotContain("converted.glb");
    }

    @Test
    void canceledImport_ends() throws Exception {
        Path file = Files.writeString(from.resolve("a.stl"), TRIANGLE);
        assertThatThrownBy(() -> SceneImporter.read(file, folder.resolve("a.jen"), LightUnits.CANDELA, Progress.cancellation(() -> true)))
                .isInstanceOf(CancellationException.class);
        assertThat(folder.resolve("a.jen")).doesNotExist();
    }

    @Test
    void texturesThatAreNotConverted_areNoted() throws Exception {
        String material = """
                <library_images><image id="i"><init_from>a.png</init_from></image></library_images>
                <library_effects><effect id="e"><profile_COMMON>
                  <newparam sid="s"><surface type="2D"><init_from>i</init_from></surface></newparam>
                  <newparam sid="t"><sampler2D><source>s</source></sampler2D></newparam>
                  <technique sid="c"><phong>
                    <diffuse><color>1 0.5 0.25 1</color></diffuse>
                    <specular><texture texture="t" texcoord="UV"/></specular>
                  </phong></technique></profile_COMMON></effect></library_effects>
                <library_materials><material id="m" name="paint"><instance_effect url="#e"/></material></library_materials>
                <library_geometries>""";
        ImportedScene imported = read("a.dae", COLLADA.replace("<library_geometries>", material)
                .replace("<triangles count=\"1\">", "<triangles count=\"1\" material=\"x\">")
                .replace("<instance_geometry url=\"#g\"/>", "<instance_geometry url=\"#g\"><bind_material><technique_common>"
                        + "<instance_material symbol=\"x\" target=\"#m\"/></technique_common></bind_material></instance_geometry>"));
        assertThat(imported.notes()).containsEntry("specular textures of materials", 1);
    }
}
