package lightning.format.exchange;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import lightning.base.math.Rgb;
import lightning.base.work.Progress;
import lightning.format.exchange.assembly.ImportedScene;
import lightning.format.gltf.GltfFixtures;
import lightning.format.jen.JenReader;
import lightning.format.mesh.MeshException;
import lightning.scene.Scene;
import lightning.scene.node.Solid;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Variants of materials in glTF files. */
class GltfVariantsTest {
    private static final String PRIMITIVE = "{'attributes': {'POSITION': 0, 'NORMAL': 1, 'TEXCOORD_0': 2}, 'indices': 3";
    /** Two primitives, of which the first has other materials in two of three variants. */
    private static final String JSON = GltfFixtures.SQUARE_JSON.replace(PRIMITIVE + "}", PRIMITIVE + """
            , 'material': 0, 'extensions': {'KHR_materials_variants': {'mappings': [
              {'material': 1, 'variants': [0, 2]}, {'material': 2, 'variants': [1]}]}}},\s""" + PRIMITIVE + ", 'material': 0}")
            .replace("'buffers'", """
                    'extensions': {'KHR_materials_variants': {'variants': [{'name': 'day'}, {'name': 'night'}, {'name': 'rain'}]}},
                    'extensionsUsed': ['KHR_materials_variants'],
                    'materials': [{'name': 'plain', 'emissiveFactor': [1, 0, 0]}, {'name': 'bright', 'emissiveFactor': [0, 1, 0]},
                      {'name': 'dark', 'emissiveFactor': [0, 0, 1]}], 'buffers'""");

    @TempDir
    private Path folder;

    private ImportedScene read(String json, String variant) throws Exception {
        return SceneImporter.read(Files.write(folder.resolve("a.glb"), GltfFixtures.binary(json, GltfFixtures.SQUARE)),
                folder.resolve("a.jen"), ImportOptions.DEFAULT.withVariants(variant.isEmpty() ? List.of() : List.of(variant)),
                Progress.NONE);
    }

    private static List<String> materials(ImportedScene imported) {
        return imported.scene().placedShapes().stream().map(shape -> shape.shape().material()).toList();
    }

    @Test
    void chosenVariant_givesMaterials() throws Exception {
        assertThat(materials(read(JSON, "day"))).containsExactly("bright", "plain");
        assertThat(materials(read(JSON, "night"))).containsExactly("dark", "plain");
        assertThat(materials(read(JSON, "rain"))).containsExactly("bright", "plain");
        assertThat(read(JSON, "rain").notes().keySet()).noneMatch(note -> note.contains("variant"));
    }

    @Test
    void noVariant_givesTheFilesMaterialsAndANote() throws Exception {
        ImportedScene imported = read(JSON, "");
        assertThat(materials(imported)).containsExactly("plain", "plain");
        assertThat(imported.notes())
                .containsEntry("variants of materials, imported with the file's own materials: 'day', 'night', 'rain'", 3);
        assertThat(imported.notes().keySet()).noneMatch(note -> note.contains("KHR_materials_variants"));
    }

    @Test
    void partsOfTheMesh_keepTheirNames() throws Exception {
        read(JSON, "night").write();
        Scene scene = JenReader.read(folder.resolve("a.jen")).scene();
        assertThat(scene.placedShapes()).extracting(shape -> ((Solid.TriangleMesh) shape.shape().solid()).part())
                .containsExactlyElementsOf(read(JSON, "").scene().placedShapes().stream()
                        .map(shape -> ((Solid.TriangleMesh) shape.shape().solid()).part()).toList());
        assertThat(scene.materials().get(2).glow()).isEqualTo(new Rgb(0, 0, 1));
    }

    @Test
    void textureInAnotherPlace_isNoted() throws Exception {
        String placed = JSON.replace("'name': 'dark', ", """
                'name': 'dark', 'normalTexture': {'index': 0, 'extensions': {'KHR_texture_transform': {'offset': [0.5, 0]}}},\s""")
                .replace("'buffers'", "'textures': [{'source': 0}], 'images': [{'uri': 'absent.png'}], 'buffers'");
        String note = "materials of a variant that place their textures otherwise, placed as without variants";
        assertThat(read(placed, "night").notes()).containsEntry(note, 1);
        assertThat(read(placed, "day").notes()).doesNotContainKey(note);
    }

    @Test
    void unknownVariant_isRejectedWithTheNames() throws Exception {
        assertThatThrownBy(() -> read(JSON, "snow")).isInstanceOf(MeshException.class)
                .hasMessageEndingWith("must have the variant 'snow' of its materials, has 'day', 'night', 'rain'");
        assertThatThrownBy(() -> read(GltfFixtures.SQUARE_JSON, "snow")).isInstanceOf(MeshException.class)
                .hasMessageEndingWith("must have the variant 'snow' of its materials, has none");
        Path obj = Files.writeString(folder.resolve("a.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
        assertThatThrownBy(
                () -> SceneImporter.read(obj, folder.resolve("a.jen"), ImportOptions.DEFAULT.withVariants(List.of("day")), Progress.NONE))
                .isInstanceOf(MeshException.class).hasMessageEndingWith("must be a glTF or USD file to have the variant 'day'");
    }
}
