package lightning.format.exchange;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import lightning.base.work.Progress;
import lightning.format.exchange.assembly.ExportedLights;
import lightning.format.exchange.assembly.ImportedScene;
import lightning.format.exchange.assembly.LightUnits;
import lightning.format.image.ImageFile;
import lightning.format.jen.JenDocument;
import lightning.format.jen.JenReader;
import lightning.format.jen.PropertyEdit;
import lightning.render.image.Film;
import lightning.render.image.ViewTransform;
import lightning.sample.PythonPrograms;
import lightning.scene.Dome;
import lightning.scene.Scene;
import lightning.scene.World;
import lightning.scene.asset.EnvironmentMap;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import lightning.scene.value.DomeRotation;
import org.assertj.core.data.Offset;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Several dome lights of a stage, and physical skies, there and back through usd-core. */
class UsdDomeTest {
    private static final String STAGE = """
            #usda 1.0
            ( upAxis = "Y" )
            def Xform "World"
            {
                def DomeLight "day"
                {
                    float inputs:intensity = 2
                    asset inputs:texture:file = @day.hdr@
                }
                def DomeLight "studio"
                {
                    float inputs:intensity = 3
                    float inputs:exposure = 1
                    asset inputs:texture:file = @studio.hdr@
                    float xformOp:rotateY = 210
                    uniform token[] xformOpOrder = ["xformOp:rotateY"]
                }
                def DomeLight "red"
                {
                    color3f inputs:color = (1, 0.5, 0.25)
                }
                def Sphere "ball" {}
            }
            """;

    @TempDir
    private Path folder;

    @BeforeEach
    void writeStage() throws IOException {
        PythonPrograms.require("pxr");
        image("day.hdr", 0.5f);
        image("studio.hdr", 0.25f);
        Files.writeString(folder.resolve("stage.usda"), STAGE);
    }

    private void image(String name, float value) throws IOException {
        float[] rgb = new float[3 * 8 * 4];
        Arrays.fill(rgb, value);
        ImageFile.write(folder.resolve(name), Film.ofScanlines(8, 4, rgb), ViewTransform.DEFAULT);
    }

    private ImportedScene read(String stage, String scene) throws Exception {
        ImportedScene read = SceneImporter.read(folder.resolve(stage), folder.resolve(scene), LightUnits.CANDELA, Progress.NONE);
        read.write();
        return read;
    }

    private JenDocument imported() throws Exception {
        read("stage.usda", "a.jen");
        return JenReader.read(folder.resolve("a.jen"));
    }

    private ExportedLights export(JenDocument document) throws IOException {
        Path layer = folder.resolve("lights.usda");
        ExportedLights export = LightExport.toUsd(document.text(), document.animatedScene(), folder.resolve("a.jen"), layer);
        Files.write(layer, export.bytes());
        for (Map.Entry<String, byte[]> file : export.files().entrySet()) {
            Files.write(folder.resolve(file.getKey()), file.getValue());
        }
        return export;
    }

    /** Imports the stage below the layer. */
    private Scene composed() throws Exception {
        Files.writeString(folder.resolve("composed.usda"), """
                #usda 1.0
                (
                    subLayers = [@lights.usda@, @stage.usda@]
                    upAxis = "Y"
                )
                """);
        read("composed.usda", "composed.jen");
        return JenReader.read(folder.resolve("composed.jen")).scene();
    }

    private static JenDocument edit(JenDocument document, String... edits) {
        Scene scene = document.scene();
        for (String edit : edits) {
            scene = PropertyEdit.apply(scene, edit);
        }
        return document.withScene(scene);
    }

    private static void assertSameDomes(World actual, World expected) {
        assertThat(actual.environments()).hasSameSizeAs(expected.environments());
        for (int i = 0; i < actual.environments().size(); i++) {
            assertThat(actual.environments().get(i).map()).isEqualTo(expected.environments().get(i).map());
            assertThat(actual.environments().get(i).intensity()).isCloseTo(expected.environments().get(i).intensity(),
                    Offset.offset(1e-6));
            assertSameRotation(actual.environments().get(i).rotation(), expected.environments().get(i).rotation());
        }
    }

    private static void assertSameRotation(DomeRotation actual, DomeRotation expected) {
        assertThat(Math.IEEEremainder(actual.rotation() - expected.rotation(), 360)).isCloseTo(0, Offset.offset(1e-4));
        assertThat(actual.tilt()).isCloseTo(expected.tilt(), Offset.offset(1e-4));
        assertThat(actual.roll()).isCloseTo(expected.roll(), Offset.offset(1e-4));
    }

    @Test
    void severalDomeLights_areTheEnvironmentAndDomes() throws Exception {
        World world = imported().scene().world();
        assertThat(world.environment().orElseThrow().file()).isEqualTo("day.hdr");
        assertThat(world.own().intensity()).isEqualTo(2);
        assertThat(world.named()).extracting(Dome::name).containsExactly("studio", "red");
        Dome studio = world.named().getFirst();
        assertThat(studio.intensity()).isEqualTo(6);
        // The image of a dome light has +z in its middle, half a turn from that of an environment.
        assertThat(Math.IEEEremainder(studio.rotation().rotation() - 30, 360)).isCloseTo(0, Offset.offset(1e-4));
        assertThat(studio.image().orElseThrow().map().channel(2, 2, 0)).isEqualTo(0.25f);
        EnvironmentMap red = world.named().getLast().image().orElseThrow().map();
        assertThat(List.of(red.channel(0, 0, 0), red.channel(0, 0, 1), red.channel(0, 0, 2))).containsExactly(1f, 0.5f, 0.25f);
    }

    @Test
    void uneditedDomes_areNotInTheLayer() throws Exception {
        ExportedLights export = export(imported());
        assertThat(new String(export.bytes(), StandardCharsets.UTF_8)).doesNotContain("over", "DomeLight");
        assertThat(export.files()).isEmpty();
        assertThat(export.notes()).isEmpty();
    }

    @Test
    void editedDomes_comeBackFromTheStage() throws Exception {
        JenDocument edited = edit(imported(), "dome:studio.intensity=0.5", "dome:studio.tilt=20", "dome:studio.roll=-10",
                "dome:red.rotation=45", "world.intensity=1.5");
        export(edited);
        assertSameDomes(composed().world(), edited.scene().world());
    }

    @Test
    void removedDome_isInactive() throws Exception {
        JenDocument document = imported();
        JenDocument edited = document.withScene(PropertyEdit.delete(document.scene(), "studio"));
        export(edited);
        assertThat(composed().world().named()).extracting(Dome::name).containsExactly("red");
    }

    @Test
    void newDome_isDefined() throws Exception {
        JenDocument document = imported();
        World world = document.scene().world();
        Dome added = world.named().getFirst().withName("added sky").withIntensity(0.75).withRotation(DomeRotation.of(70, 5, 0));
        JenDocument edited = document.withScene(
                document.scene().withWorld(world.withNamed(List.of(world.named().getFirst(), world.named().getLast(), added))));
        export(edited);
        // New lights come before those of the stage, so the order differs.
        assertThat(composed().world().environments()).anySatisfy(e -> {
            assertThat(e.map()).isEqualTo(added.image().orElseThrow().map());
            assertThat(e.intensity()).isCloseTo(0.75, Offset.offset(1e-6));
            assertSameRotation(e.rotation(), added.rotation());
        }).hasSize(4);
    }

    @Test
    void whatDomeLightsDoNotHave_isNoted() throws Exception {
        assertThat(export(edit(imported(), "dome:studio.gain=2", "dome:red.on=no", "dome:studio.solo=yes")).notes())
                .containsOnly(Map.entry("light gain of domes", 1), Map.entry("domes that are off, written with an intensity of 0", 1),
                        Map.entry("environments that a solo mutes, written as lit", 1));
    }

    /** Images of codes and of linear values both have the sky in their first row. */
    @ParameterizedTest
    @ValueSource(strings = {"day.png", "day.pfm"})
    void firstRowOfAnImage_isUp(String name) throws Exception {
        float[] rgb = new float[3 * 8 * 4];
        Arrays.fill(rgb, 0, 3 * 8, 1);
        ImageFile.write(folder.resolve(name), Film.ofScanlines(8, 4, rgb), ViewTransform.DEFAULT);
        Files.writeString(folder.resolve("stage.usda"), STAGE.replace("day.hdr", name));
        EnvironmentMap map = imported().scene().world().environment().orElseThrow().map();
        assertThat(map.channel(0, 0, 0)).isEqualTo(1);
        assertThat(map.channel(0, 3, 0)).isZero();
    }

    @Test
    void portalLights_areNotedAsNotNeeded() throws Exception {
        Files.writeString(folder.resolve("stage.usda"), STAGE.replace("def Sphere", "def PortalLight \"window\" {}\ndef Sphere"));
        assertThat(read("stage.usda", "a.jen").notes())
                .containsEntry("portal lights, not needed: openings are found without them", 1);
    }

    /** The image keeps 8 bits of the largest channel; the sun is a light without a disc in the image. */
    @Test
    void physicalSky_isADomeAndADistantLight() throws Exception {
        JenDocument sky = JenReader.read("jen 1\nsphere ball {}\nworld { ambience 0  sky yes  sky_elevation 25  sky_azimuth 60"
                + "  sky_sun_radius 0.5  intensity 0.5  rotation 30  tilt 10 }\n", "a.jen", folder);
        Files.writeString(folder.resolve("a.jen"), sky.text());
        ExportedLights export = export(sky);
        assertThat(export.files()).containsOnlyKeys("lights.sky.hdr");
        assertThat(export.notes()).containsOnly(Map.entry("discs of suns, which are distant lights", 1));
        read("lights.usda", "back.jen");
        Scene back = JenReader.read(folder.resolve("back.jen")).scene();
        World world = sky.scene().world();
        assertThat(back.world().own().intensity()).isCloseTo(world.own().intensity(), Offset.offset(1e-6));
        assertSameRotation(back.world().own().rotation(), world.own().rotation());
        assertSamePixels(back.world().own().image().orElseThrow().map(), world.environment().orElseThrow().map());
        Light expected = sky.scene().rig().effectiveLights().getLast();
        Light sun = back.light("sun").orElseThrow();
        assertThat(sun.type()).isEqualTo(LightType.DIRECTIONAL);
        assertThat(sun.area().spread()).isCloseTo(0.5, Offset.offset(1e-6));
        assertThat(sun.direction().normalized().dot(expected.direction().normalized())).isGreaterThan(1 - 1e-10);
        Light effective = back.rig().effectiveLight(sun);
        assertThat(effective.weight().r()).isCloseTo(expected.weight().r(), Offset.offset(1e-5 * expected.weight().max()));
        assertThat(effective.weight().g()).isCloseTo(expected.weight().g(), Offset.offset(1e-5 * expected.weight().max()));
        assertThat(effective.weight().b()).isCloseTo(expected.weight().b(), Offset.offset(1e-5 * expected.weight().max()));
    }

    private static void assertSamePixels(EnvironmentMap actual, EnvironmentMap expected) {
        assertThat(actual.width()).isEqualTo(expected.width());
        assertThat(actual.height()).isEqualTo(expected.height());
        for (int y = 0; y < expected.height(); y++) {
            for (int x = 0; x < expected.width(); x++) {
                float max = Math.max(expected.channel(x, y, 0), Math.max(expected.channel(x, y, 1), expected.channel(x, y, 2)));
                for (int c = 0; c < 3; c++) {
                    assertThat(actual.channel(x, y, c)).isCloseTo(expected.channel(x, y, c), Offset.offset(max / 128));
                }
            }
        }
    }

    @Test
    void skyNextToADome_keepsBoth() throws Exception {
        JenDocument document = edit(imported(), "world.sky=yes");
        ExportedLights export = export(document);
        assertThat(export.files()).hasSize(1);
        Scene back = composed();
        assertThat(back.world().environments()).hasSize(3);
        assertThat(back.light("sun")).isPresent();
        assertThat(back.world().own().image().map(e -> e.map().width())).isEqualTo(Optional.of(512));
    }
}
