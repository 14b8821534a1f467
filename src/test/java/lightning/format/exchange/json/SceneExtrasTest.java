package lightning.format.exchange.json;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.base.work.Progress;
import lightning.format.exchange.IndirectChoice;
import lightning.format.exchange.LightExport;
import lightning.format.exchange.SceneImporter;
import lightning.format.exchange.assembly.ImportedScene;
import lightning.format.exchange.assembly.LightUnits;
import lightning.format.gltf.GltfFixtures;
import lightning.format.jen.JenDocument;
import lightning.format.jen.JenReader;
import lightning.scene.AntialiasMode;
import lightning.scene.IndirectSettings;
import lightning.scene.SamplingSettings;
import lightning.scene.Scene;
import lightning.scene.ViewCurve;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import lightning.scene.material.Material;
import lightning.scene.shot.AnimatedScene;
import lightning.scene.shot.Shot;
import lightning.scene.value.Lens;
import lightning.scene.value.LensShift;
import lightning.scene.value.ShapeLinks;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Settings of a whole scene in the extras of a glTF file. */
class SceneExtrasTest {
    @TempDir
    private Path folder;

    /** Imports the square with extras; single quotes stand for double ones. */
    private ImportedScene imported(String extras) throws Exception {
        String json = GltfFixtures.SQUARE_JSON.replace("'scene': 0,",
                "'scene': 0, 'materials': [{'name': 'paint'}], 'extras': {'lightning': " + extras + "},");
        Path gltf = Files.write(folder.resolve("a.gltf"), GltfFixtures.text(json, GltfFixtures.SQUARE));
        return SceneImporter.read(gltf, folder.resolve("a.jen"), LightUnits.CANDELA, Progress.NONE);
    }

    private JenDocument written(ImportedScene scene) throws Exception {
        scene.write();
        return JenReader.read(folder.resolve("a.jen"));
    }

    @Test
    void indirectLight_isThatOfFileUnlessChosenOtherwise() throws Exception {
        ImportedScene open = imported("{'picture': {'depth': 7, 'indirect': {'bounces': 3}}}");
        assertThat(IndirectChoice.AUTO.apply(open).scene().picture()).isEqualTo(open.scene().picture());
        assertThat(open.scene().picture().depth()).isEqualTo(7);
        assertThat(open.scene().picture().indirect()).contains(IndirectSettings.DEFAULT.withBounces(3));
        assertThat(IndirectChoice.ON.apply(open).scene().picture()).isEqualTo(open.scene().picture());
        assertThat(IndirectChoice.OFF.apply(open).hasIndirect()).isFalse();
    }

    @Test
    void senderOfScene_isComment_unlessItIsNone() throws Exception {
        String id = "0123456789abcdef".repeat(2);
        assertThat(written(imported("{'id': '" + id + "'}")).text()).contains("\n# sent from: " + id + "\n");
        for (String other : List.of("'x'", "5", "'" + id + "\\nlight a point {}'", "null")) {
            assertThat(imported("{'id': " + other + "}").text()).doesNotContain("sent from");
        }
    }

    @Test
    void editOfMaterial_countsIfFileHasValueBefore() throws Exception {
        Material plain = imported("{}").scene().materials().getLast();
        String edits = "{'f0': [" + plain.f0() + ", 0.1], 'specular_tint': [[1, 1, 1.0], [0.2, 0.3, 0.4]], 'roughness': [0.875, 0.25],"
                + " 'thin': [false, true]}";
        Material edited =
                imported("{'materials': [{'name': 'paint', 'edits': " + edits + "}]}").scene().materials().getLast();
        assertThat(edited.f0()).isEqualTo(0.1);
        assertThat(edited.specularTint()).isEqualTo(new Rgb(0.2, 0.3, 0.4));
        assertThat(edited.transmission().thin()).isTrue();
        assertThat(edited.roughness()).as("changed in the other program").isEqualTo(plain.roughness());
    }

    @Test
    void pictureWorldAndLights_areRestored() throws Exception {
        sky();
        Scene scene = written(imported("""
                {'picture': {'size': [480, 270], 'view': 'agx', 'exposure': -0.5, 'antialias': 'edges', 'samples': 5},
                 'world': {'ambience': 0, 'environment': 'sky.hdr', 'rotation': -30, 'intensity': 2},
                 'banks': [{'name': 'keys', 'intensity': 0.5}],
                 'lights': [{'name': 'key', 'type': 'rect', 'intensity': 3, 'exposure': 2, 'width': 4, 'on': false, 'bank': 'keys',
                             'illuminates': {'only': true, 'names': ['floor']}},
                            {'name': 'rim', 'type': 'directional', 'bank': 'missing', 'temperature': 3000}]}""")).scene();
        assertThat(scene.picture().width()).isEqualTo(480);
        assertThat(scene.picture().height()).isEqualTo(270);
        assertThat(scene.picture().view().curve()).isEqualTo(ViewCurve.AGX);
        assertThat(scene.picture().view().exposure()).isEqualTo(-0.5);
        assertThat(scene.picture().sampling()).isEqualTo(new SamplingSettings(AntialiasMode.EDGES, 5));
        assertThat(scene.world().ambience()).isZero();
        assertThat(scene.world().environment().orElseThrow().file()).isEqualTo("sky.hdr");
        assertThat(scene.world().own().rotation().rotation()).isEqualTo(-30);
        assertThat(scene.world().own().intensity()).isEqualTo(2);
        assertThat(scene.lights()).hasSize(2);
        Light key = scene.light("key").orElseThrow();
        assertThat(key.type()).isEqualTo(LightType.RECT);
        assertThat(key.intensity()).isEqualTo(3);
        assertThat(key.emission().exposure()).isEqualTo(2);
        assertThat(key.on()).isFalse();
        assertThat(key.illuminates()).isEqualTo(ShapeLinks.only("floor"));
        assertThat(scene.rig().lightGroup(key.lightGroup()).orElseThrow().intensity()).isEqualTo(0.5);
        assertThat(scene.light("rim").orElseThrow().lightGroup()).isEmpty();
    }

    /** Writes an environment of one color into the source's folder, from which the import copies it. */
    private void sky() throws IOException {
        var bytes = new java.io.ByteArrayOutputStream();
        bytes.write("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 2\n".getBytes(StandardCharsets.US_ASCII));
        bytes.write(new byte[] {(byte) 128, (byte) 128, (byte) 128, (byte) 129, (byte) 128, (byte) 128, (byte) 128, (byte) 129});
        Files.write(folder.resolve("sky.hdr"), bytes.toByteArray());
    }

    @Test
    void filesNextToSource_areCopied() throws Exception {
        sky();
        imported("{'world': {'environment': 'sky.hdr'}}");
        Path other = Files.createDirectory(folder.resolve("other"));
        SceneImporter.read(folder.resolve("a.gltf"), other.resolve("b.jen"), LightUnits.CANDELA, Progress.NONE).write();
        assertThat(other.resolve("sky.hdr")).exists();
        ImportedScene outside = imported("{'world': {'environment': '../secret.hdr'}}");
        assertThat(outside.notes()).containsEntry("scene settings that cannot be restored", 1);
    }

    @Test
    void noLights_areNone() throws Exception {
        assertThat(written(imported("{'lights': []}")).scene().lights()).isEmpty();
        assertThat(written(imported("{'picture': {'size': [10, 20]}}")).scene().lights()).as("one is added").hasSize(1);
    }

    @Test
    void animation_hasOnlyKeysThatMatter() throws Exception {
        JenDocument document = written(imported("""
                {'lights': [{'name': 'key', 'type': 'point'}],
                 'shot': {'frames': [1, 5], 'rate': 25, 'tracks': [
                   {'target': 'light', 'name': 'key', 'attribute': 'intensity', 'keys': [[1, 1], [2, 2], [3, 3], [4, 3], [5, 3]]},
                   {'target': 'light', 'name': 'key', 'attribute': 'on', 'keys': [[1, true], [2, true], [3, false], [4, false], [5, true]]},
                   {'target': 'node', 'name': 'floor', 'matrices': [
                     [1, [1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,1]], [5, [0,0,-1,0, 0,1,0,0, 1,0,0,0, 4,0,0,1]]]},
                   {'target': 'camera', 'attribute': 'fov', 'keys': [[1, 30], [5, 50]]},
                   {'target': 'light', 'name': 'gone', 'attribute': 'intensity', 'keys': [[1, 1], [2, 2]]}]}}"""));
        Shot shot = document.shot().orElseThrow();
        assertThat(shot.first()).isEqualTo(1);
        assertThat(shot.last()).isEqualTo(5);
        assertThat(shot.rate()).isEqualTo(25);
        assertThat(Files.readString(folder.resolve("a.jen"))).contains("intensity { 1 1  3 3 }").contains("on { 1 yes  3 no  5 yes }");
        double[] intensities = {1, 2, 3, 3, 3};
        for (int frame = 1; frame <= 5; frame++) {
            Scene scene = shot.sceneAt(document.scene(), frame);
            assertThat(scene.light("key").orElseThrow().intensity()).isEqualTo(intensities[frame - 1]);
            assertThat(scene.light("key").orElseThrow().on()).isEqualTo(frame < 3 || frame == 5);
            assertThat(scene.camera().fov()).isEqualTo(25 + 5 * frame);
        }
        var turned = shot.sceneAt(document.scene(), 5).stage().node("floor").orElseThrow().placement();
        assertThat(turned.position()).isEqualTo(new Vec3(4, 0, 0));
        assertThat(turned.transform().transformVector(new Vec3(1, 0, 0)).minus(new Vec3(0, 0, -1)).maxAbs()).isLessThan(1e-9);
        assertThat(imported("{'shot': {'frames': [9, 1], 'rate': 25}}").notes()).containsEntry("animation that cannot be used", 1);
        assertThat(imported("{'shot': {'frames': 'all', 'tracks': [{'target': 'light', 'keys': [[]]}]}}").notes())
                .containsEntry("animation that cannot be used", 1);
    }

    /** Imports the square with a camera named {@code eye} at z = 5 and extras. */
    private ImportedScene importedWithCamera(String extras) throws Exception {
        String json = GltfFixtures.SQUARE_JSON.replace("'scene': 0,", "'scene': 0, 'extras': {'lightning': " + extras + "},")
                .replace("'nodes': [0]", "'nodes': [0, 1]").replace("'name': 'floor'}]", """
                        'name': 'floor'}, {'name': 'eye', 'camera': 0, 'translation': [0, 0, 5]}],
                         'cameras': [{'type': 'perspective', 'perspective': {'yfov': 0.5, 'znear': 0.1}}]""");
        Path gltf = Files.write(folder.resolve("a.gltf"), GltfFixtures.text(json, GltfFixtures.SQUARE));
        return SceneImporter.read(gltf, folder.resolve("a.jen"), LightUnits.CANDELA, Progress.NONE);
    }

    @Test
    void lensShift_isRestoredAndAnimated() throws Exception {
        JenDocument document = written(importedWithCamera("{'camera': 'eye', 'shift': [0.25, -0.5], 'shot': {'frames': [1, 3], 'rate': 25, "
                + "'tracks': [{'target': 'camera', 'attribute': 'shift', 'keys': [[1, [0.25, -0.5]], [3, [0.5, 0]]]}]}}"));
        assertThat(document.scene().camera().shift()).isEqualTo(new LensShift(0.25, -0.5));
        assertThat(document.shot().orElseThrow().sceneAt(document.scene(), 2).camera().shift()).isEqualTo(new LensShift(0.375, -0.25));
    }

    @Test
    void lens_isRestoredAndAnimated() throws Exception {
        JenDocument document = written(importedWithCamera("{'camera': 'eye', 'lens': {'aperture': 0.1, 'focus': 4, 'blades': 6, "
                + "'blade_rotation': 15}, 'shot': {'frames': [1, 3], 'rate': 25, "
                + "'tracks': [{'target': 'camera', 'attribute': 'focus', 'keys': [[1, 4], [3, 8]]}]}}"));
        assertThat(document.scene().camera().lens()).isEqualTo(new Lens(0.1, 4, 6, 15));
        assertThat(document.shot().orElseThrow().sceneAt(document.scene(), 2).camera().lens()).isEqualTo(new Lens(0.1, 6, 6, 15));
    }

    @Test
    void lensOfTwoBlades_isNotedAndRound() throws Exception {
        ImportedScene scene = importedWithCamera("{'camera': 'eye', 'lens': {'aperture': 0.1, 'blades': 2}}");
        assertThat(scene.scene().camera().lens()).isEqualTo(new Lens(0.1, 0, 0, 0));
        assertThat(scene.notes()).containsEntry("scene settings that cannot be restored", 1);
    }

    @Test
    void lensShiftBeyondTenPictures_isNotedAndKeepsTarget() throws Exception {
        for (String shift : List.of("[10.5, 0]", "[0.25, -1e9]", "[1e999, 0]")) {
            ImportedScene scene = importedWithCamera("{'camera': 'eye', 'distance': 7, 'shift': " + shift + "}");
            assertThat(scene.scene().camera().to()).isEqualTo(new Vec3(0, 0, -2));
            assertThat(scene.scene().camera().shift()).isEqualTo(LensShift.NONE);
            assertThat(scene.notes()).containsEntry("lens shifts beyond 10 pictures, imported without shift", 1);
        }
        ImportedScene moving = importedWithCamera("{'camera': 'eye', 'shift': [0.5, 0], 'shot': {'frames': [1, 3], 'rate': 25, 'tracks': ["
                + "{'target': 'camera', 'attribute': 'fov', 'keys': [[1, 30], [3, 50]]},"
                + "{'target': 'camera', 'attribute': 'shift', 'keys': [[1, [0.5, 0]], [3, [10.5, 0]]]}]}}");
        JenDocument document = written(moving);
        assertThat(moving.notes()).containsEntry("animated properties that cannot be used", 1);
        assertThat(document.shot().orElseThrow().sceneAt(document.scene(), 3).camera().fov()).isEqualTo(50);
        assertThat(document.shot().orElseThrow().sceneAt(document.scene(), 3).camera().shift()).isEqualTo(new LensShift(0.5, 0));
    }

    @Test
    void invalidValues_areNoted() throws Exception {
        assertThat(imported("{'picture': {'antialias': 'much'}}").notes()).containsEntry("scene settings that cannot be restored", 1);
        assertThat(imported("{'picture': {'indirect': {'rays': 5}}}").notes()).containsEntry("scene settings that cannot be restored", 1);
        assertThat(imported("{'materials': [{'name': 'paint', 'edits': {'thin': [false, 3]}}]}").notes())
                .containsEntry("scene settings that cannot be restored", 1);
        assertThat(imported("{'picture': {'samples': 99}}").notes()).containsEntry("scene settings that cannot be restored", 1);
        ImportedScene scene = imported("""
                {'picture': {'size': [0, -3]}, 'world': {'intensity': 'much', 'rotation': 1e99}, 'banks': [{}, 3, {'name': 'b', 'on': 3}],
                 'lights': [{'name': 'key', 'type': 'candle', 'profile': 'none.ies'}, 7], 'camera': 5, 'shot': 3}""");
        assertThat(scene.notes().get("scene settings that cannot be restored")).isGreaterThanOrEqualTo(6);
        written(scene);
        for (String odd : new String[] {"3", "[]", "null", "'text'", "{'lights': 3, 'banks': 'x', 'picture': []}"}) {
            written(imported(odd));
        }
    }

    @Test
    void lightsExportedInto_winOverExtras() throws Exception {
        ImportedScene scene = imported("{'lights': [{'name': 'key', 'type': 'point', 'intensity': 3}]}");
        Scene edited = written(scene).scene();
        edited = edited.withLight(edited.light("key").orElseThrow().withColor(new Rgb(1, 0.5, 0)).withIntensity(7));
        Path relit = Files.write(folder.resolve("b.gltf"),
                LightExport.toGltf(folder.resolve("a.gltf"), edited, LightUnits.CANDELA, Progress.NONE).bytes());
        Scene again = SceneImporter.read(relit, folder.resolve("b.jen"), LightUnits.CANDELA, Progress.NONE).scene();
        assertThat(again.lights()).isEqualTo(edited.lights());
    }

    @Test
    void exportedJson_hasWorldAndIntensityWithoutUnit() throws Exception {
        Scene scene = written(imported("""
                {'world': {'rotation': 7, 'meters': 0.01},
                 'lights': [{'name': 'key', 'type': 'point', 'intensity': 400, 'unit': 'candela', 'falloff': 'inverse_square'}]}"""))
                .scene();
        var json = new tools.jackson.databind.json.JsonMapper().readTree(LightExport.toJson(AnimatedScene.of(scene)).bytes());
        assertThat(json.get("world").get("rotation").asDouble()).isEqualTo(7);
        // A surface at a distance of 1 m has 400 lux, and as white paper 400 / pi nits; a meter has 100 scene units.
        assertThat(json.get("lights").get(0).get("relative_intensity").asDouble()).isCloseTo(400 / Math.PI * 1e4,
                org.assertj.core.data.Percentage.withPercentage(1e-9));
    }
}
