package lightning.format.exchange;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.function.UnaryOperator;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.base.work.Progress;
import lightning.format.exchange.assembly.ExportedLights;
import lightning.format.exchange.assembly.LightUnits;
import lightning.format.jen.JenDocument;
import lightning.format.jen.JenReader;
import lightning.sample.PythonPrograms;
import lightning.scene.Scene;
import lightning.scene.light.IntensityUnit;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import lightning.scene.shot.AnimatedScene;
import lightning.scene.value.DomeRotation;
import lightning.scene.value.ShapeLinks;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A layer over an imported stage has opinions only about what was edited. */
class UsdSparseExportTest {
    private static final String NOTE = "lights of an import without their values, written whole; import the stage again for a sparse layer";
    private static final Comparator<Double> NEAR = (a, b) -> Math.abs(a - b) < 1e-4 ? 0 : Double.compare(a, b);
    @TempDir
    private Path folder;

    @BeforeEach
    void requireUsd() throws IOException {
        PythonPrograms.require("pxr");
        for (String name : List.of("sparse.usda", "opinions.py", "light_places.py")) {
            try (InputStream in = UsdSparseExportTest.class.getResourceAsStream(name)) {
                Files.copy(in, folder.resolve(name));
            }
        }
    }

    private JenDocument imported() throws Exception {
        Path scene = folder.resolve("sparse.jen");
        SceneImporter.read(folder.resolve("sparse.usda"), scene, LightUnits.CANDELA, Progress.NONE).write();
        return JenReader.read(scene);
    }

    /** Exports a document; returns the opinions of the layer. */
    private String opinions(JenDocument document) throws IOException {
        Path layer = folder.resolve("lights.usda");
        Files.write(layer, LightExport.toUsd(document.text(), document.animatedScene(), folder.resolve("sparse.jen"), layer).bytes());
        return PythonPrograms.script(folder, List.of("opinions.py", "lights.usda"));
    }

    private String opinions(String light, UnaryOperator<Light> edit) throws Exception {
        JenDocument document = imported();
        return opinions(edited(document, light, edit));
    }

    private static JenDocument edited(JenDocument document, String light, UnaryOperator<Light> edit) throws Exception {
        Scene scene = document.scene();
        assertThat(scene.light(light)).isPresent();
        return document.withAnimatedScene(document.animatedScene().withScene(
                scene.withLights(scene.lights().stream().map(l -> l.name().equals(light) ? edit.apply(l) : l).toList())));
    }

    /** Returns the places of all lights of the stage with the layer over it. */
    private String places(String stage) throws IOException {
        Files.writeString(folder.resolve("composed.usda"), """
                #usda 1.0
                (
                    subLayers = [@lights.usda@, @sparse.usda@]
                    upAxis = "Z"
                    metersPerUnit = 0.01
                )
                """);
        return PythonPrograms.script(folder, List.of("light_places.py", stage));
    }

    @Test
    void untouchedLights_haveNoOpinions() throws Exception {
        assertThat(opinions(imported())).isEmpty();
    }

    @Test
    void editsThatUsdHasNot_giveNoOpinions() throws Exception {
        assertThat(opinions("rect", l -> l.withArea(l.area().withSamples(64)))).isEmpty();
    }

    @Test
    void intensity_isTheOnlyOpinion_andKeepsItsMeaning() throws Exception {
        for (String name : List.of("ball", "power", "dot", "rect", "disk", "cone", "sun", "tube")) {
            assertThat(opinions(name, l -> l.withIntensity(2 * l.intensity()))).as(name)
                    .matches("/World/(rig/)?" + name + "\\.inputs:intensity\n");
            assertThat(Files.readString(folder.resolve("lights.usda"))).as(name).contains("inputs:intensity = 2000\n");
        }
    }

    @Test
    void sameLightInAnotherUnit_givesNoOpinion() throws Exception {
        assertThat(opinions("rect",
                l -> l.withEmission(l.emission().withUnit(IntensityUnit.CANDELA)).withIntensity(l.intensity() * 60 * 20 * 1e-4))).isEmpty();
    }

    @Test
    void sizes_areBeforeTheScaleOfTheRig() throws Exception {
        // The rig scales by 100.
        assertThat(opinions("rect", l -> l.withArea(l.area().withWidth(90)))).isEqualTo("/World/rig/rect.inputs:width\n");
        assertThat(Files.readString(folder.resolve("lights.usda"))).contains("inputs:width = 0.9\n");
        // A power stays as it is, and so does a luminance.
        assertThat(opinions("power", l -> l.withArea(l.area().withRadius(5)))).isEqualTo("/World/power.inputs:radius\n");
        assertThat(opinions("ball", l -> l.withArea(l.area().withRadius(5)))).isEqualTo("/World/ball.inputs:radius\n");
    }

    @Test
    void colorAndTemperature_areSeparate() throws Exception {
        assertThat(opinions("ball", l -> l.withColor(new Rgb(1, 0.5, 0.25)))).isEqualTo("/World/ball.inputs:color\n");
        assertThat(opinions("ball", l -> l.withEmission(l.emission().withTemperature(3000)))).isEqualToIgnoringNewLines(
                "/World/ball.inputs:color\n/World/ball.inputs:colorTemperature\n/World/ball.inputs:enableColorTemperature\n");
    }

    @Test
    void movedLight_staysInItsRigWithItsScale() throws Exception {
        assertThat(opinions("rect", l -> l.withPosition(l.position().plus(new Vec3(50, 0, 0)))))
                .isEqualTo("/World/rig/rect.xformOp:transform:lightning\n/World/rig/rect.xformOpOrder\n");
        assertThat(Files.readString(folder.resolve("lights.usda"))).doesNotContain("resetXformStack");
        List<String> before = places("sparse.usda").lines().toList();
        List<String> after = places("composed.usda").lines().toList();
        assertThat(after).hasSameSizeAs(before);
        for (int i = 0; i < before.size(); i++) {
            String wanted = before.get(i).startsWith("/World/rig/rect ") ? before.get(i).replace("at 100 200 300", "at 150 200 300")
                    : before.get(i);
            assertThat(after.get(i)).isEqualTo(wanted);
        }
        assertThat(after).anyMatch(line -> line.startsWith("/World/rig/rect at 150 200 300 "));
    }

    @Test
    void turnedLight_keepsItsPlaceAndScale() throws Exception {
        opinions("disk", l -> l.withDirection(new Vec3(1, 0, 0)));
        assertThat(Files.readString(folder.resolve("lights.usda"))).doesNotContain("resetXformStack");
        // z is up in the stage, and the disk is scaled by 2.
        assertThat(places("composed.usda")).contains("/World/rig/disk at 0 0 900 shines 1 0 0 scale 200 200 200\n");
    }

    @Test
    void lightUnderMovingParent_isPlacedInTheWorldWithANote() throws Exception {
        JenDocument document = edited(imported(), "onTrain", l -> l.withIntensity(2 * l.intensity()));
        assertThat(opinions(document)).isEqualTo("/World/train/onTrain.inputs:intensity\n");
        JenDocument aimed = edited(document, "onTrain", l -> l.withType(LightType.SPOT).withDirection(new Vec3(1, 0, 0)));
        Path layer = folder.resolve("lights.usda");
        ExportedLights export = LightExport.toUsd(aimed.text(), aimed.animatedScene(), folder.resolve("sparse.jen"), layer);
        assertThat(export.notes()).containsEntry("moved lights whose parents move or are flat, placed in the world", 1);
        assertThat(new String(export.bytes(), StandardCharsets.UTF_8)).contains("!resetXformStack!");
    }

    @Test
    void keyframes_areWrittenForEditedAttributesOnly() throws Exception {
        JenDocument document = imported();
        assertThat(opinions(document)).isEmpty();
        String keyed = document.text().replace("12 500", "12 600");
        assertThat(keyed).isNotEqualTo(document.text());
        Files.writeString(folder.resolve("sparse.jen"), comments(keyed, document.text()));
        assertThat(opinions(JenReader.read(folder.resolve("sparse.jen")))).isEqualTo("/World/flicker.inputs:intensity\n");
        assertThat(Files.readString(folder.resolve("lights.usda"))).contains("inputs:intensity.timeSamples").contains(": 600");
    }

    /** Returns the first text with the comments of the second. */
    private static String comments(String text, String original) {
        return String.join("\n", text.lines().filter(s -> !s.startsWith("#")).toList()) + "\n"
                + String.join("\n", original.lines().filter(s -> s.startsWith("#")).toList()) + "\n";
    }

    @Test
    void removedKeyframes_areReplacedByTheValue() throws Exception {
        JenDocument document = imported();
        var shot = document.animatedScene().shot().orElseThrow();
        var still = shot.withTracks(shot.tracks().stream().filter(t -> !t.attribute().equals("intensity")).toList());
        assertThat(opinions(document.withAnimatedScene(new AnimatedScene(document.scene(), Optional.of(still)))))
                .isEqualTo("/World/flicker.inputs:intensity\n");
        assertThat(Files.readString(folder.resolve("lights.usda"))).contains("inputs:intensity = 100\n");
    }

    @Test
    void linksShadowsAndSwitches_areSeparate() throws Exception {
        assertThat(opinions("ball", l -> l.withIlluminates(ShapeLinks.only("Floor")))).isEqualToIgnoringNewLines("""
                /World/ball.collection:lightLink:excludes
                /World/ball.collection:lightLink:includeRoot
                /World/ball.collection:lightLink:includes
                """);
        assertThat(opinions("ball", l -> l.withInfluence(l.influence().withCastsShadows(false)))).isEqualTo(
                "/World/ball apiSchemas\n/World/ball.inputs:shadow:enable\n");
        assertThat(opinions("ball", l -> l.withOn(false))).isEqualTo("/World/ball.visibility\n");
    }

    @Test
    void otherType_isDefinedInPlace() throws Exception {
        assertThat(opinions("ball", l -> l.withType(LightType.RECT).withDirection(new Vec3(0, -1, 0))))
                .contains("/World/ball def RectLight", "/World/ball.inputs:width").doesNotContain("inputs:color", "/World/rig");
    }

    @Test
    void deletedAndNewLights_areAsBefore() throws Exception {
        JenDocument document = imported();
        Scene scene = document.scene();
        List<Light> lights = new ArrayList<>(scene.lights().stream().filter(l -> !l.name().equals("ball")).toList());
        lights.add(Light.of("kicker", LightType.POINT));
        assertThat(opinions(document.withAnimatedScene(document.animatedScene().withScene(scene.withLights(lights)))))
                .contains("/World/ball active\n", "/lightning_lights/kicker def SphereLight\n").doesNotContain("/World/rig");
    }

    @Test
    void editedLightInInstance_isEditedThere() throws Exception {
        assertThat(opinions("bulb", l -> l.withIntensity(2 * l.intensity()))).isEqualTo(
                "/World/lampA instanceable\n/World/lampA/bulb.inputs:intensity\n");
    }

    @Test
    void dome_isWrittenOnlyIfEdited() throws Exception {
        JenDocument document = imported();
        Scene scene = document.scene();
        assertThat(opinions(document.withAnimatedScene(
                document.animatedScene().withScene(scene.withWorld(scene.world().withOwn(own -> own.withIntensity(0.75)))))))
                .isEqualTo("/World/sky.inputs:intensity\n");
    }

    @Test
    void physicalSky_replacesTheImageOfTheDome() throws Exception {
        JenDocument document = imported();
        Scene scene = document.scene();
        JenDocument edited = document.withAnimatedScene(document.animatedScene().withScene(
                scene.withWorld(scene.world().withSky(scene.world().sky().withOn(true)))));
        ExportedLights export =
                LightExport.toUsd(edited.text(), edited.animatedScene(), folder.resolve("sparse.jen"), folder.resolve("lights.usda"));
        assertThat(export.files()).containsOnlyKeys("lights.sky.hdr");
        assertThat(new String(export.bytes(), StandardCharsets.UTF_8)).contains("over \"sky\"", "@./lights.sky.hdr@");
    }

    /** A dome's image has its center at +z: half a turn more about y, which inverts the other angles. */
    @Test
    void tiltedDome_isImportedWithItsThreeAngles() throws Exception {
        Path stage = folder.resolve("sparse.usda");
        Files.writeString(stage, Files.readString(stage).replace("upAxis = \"Z\"", "upAxis = \"Y\"")
                .replaceFirst("(def DomeLight \"sky\"\\s*\\{)[^}]*}", """
                        $1
                            float3 xformOp:rotateZXY = (10, -150, 20)
                            uniform token[] xformOpOrder = ["xformOp:rotateZXY"]
                        }"""));
        DomeRotation dome = imported().scene().world().own().rotation();
        assertThat(List.of(dome.rotation(), dome.tilt(), dome.roll())).usingElementComparator(NEAR).containsExactly(30.0, -10.0, -20.0);
    }

    @Test
    void editedTilt_comesBack() throws Exception {
        JenDocument document = imported();
        Scene scene = document.scene();
        JenDocument edited = document.withAnimatedScene(
                document.animatedScene()
                        .withScene(scene.withWorld(scene.world().withOwn(own -> own.withRotation(DomeRotation.of(50, -20, 70))))));
        Path layer = folder.resolve("lights.usda");
        Files.write(layer, LightExport.toUsd(edited.text(), edited.animatedScene(), folder.resolve("sparse.jen"), layer).bytes());
        Files.writeString(folder.resolve("sparse2.usda"), """
                #usda 1.0
                (
                    subLayers = [@./lights.usda@, @./sparse.usda@]
                    upAxis = "Z"
                )
                """);
        Path again = folder.resolve("again.jen");
        SceneImporter.read(folder.resolve("sparse2.usda"), again, LightUnits.CANDELA, Progress.NONE).write();
        DomeRotation dome = JenReader.read(again).scene().world().own().rotation();
        assertThat(List.of(dome.rotation(), dome.tilt(), dome.roll())).usingElementComparator(NEAR).containsExactly(50.0, -20.0, 70.0);
    }

    @Test
    void sceneOfAnEarlierImport_isWrittenWholeWithANote() throws Exception {
        imported();
        Path scene = folder.resolve("sparse.jen");
        Files.writeString(scene, String.join("\n", Files.readString(scene).lines().filter(s -> !s.startsWith("# usd values: ")).toList()));
        JenDocument document = JenReader.read(scene);
        ExportedLights export = LightExport.toUsd(document.text(), document.animatedScene(), scene, folder.resolve("lights.usda"));
        assertThat(export.notes()).containsEntry(NOTE, document.scene().lights().size());
    }

    @Test
    void savedAndReadAgain_isTheSame() throws Exception {
        JenDocument document = edited(imported(), "ball", l -> l.withIntensity(7));
        Files.writeString(folder.resolve("sparse.jen"), document.text());
        assertThat(opinions(JenReader.read(folder.resolve("sparse.jen")))).isEqualTo("/World/ball.inputs:intensity\n");
    }
}
