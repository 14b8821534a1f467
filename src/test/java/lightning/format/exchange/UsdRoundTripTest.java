package lightning.format.exchange;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.data.Offset.offset;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import javax.imageio.ImageIO;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.base.work.Progress;
import lightning.format.exchange.assembly.ImportedScene;
import lightning.format.exchange.assembly.LightUnits;
import lightning.format.jen.JenDocument;
import lightning.format.jen.JenReader;
import lightning.sample.PythonPrograms;
import lightning.scene.Scene;
import lightning.scene.light.Falloff;
import lightning.scene.light.IntensityUnit;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import lightning.scene.value.LensShift;
import lightning.scene.value.ShapeLinks;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A stage with every kind of light, there and back through usd-core. */
class UsdRoundTripTest {
    private static final String PROFILE = """
            IESNA:LM-63-2002
            TILT=NONE
            1 1000 1 3 1 1 2 0 0 0
            1 1 10
            0 45 90
            0
            100 50 0
            """;
    @TempDir
    private Path folder;

    @BeforeEach
    void requireUsd() throws IOException {
        PythonPrograms.require("pxr");
        for (String name : List.of("rig.usda", "compare_lights.py")) {
            try (InputStream in = UsdRoundTripTest.class.getResourceAsStream(name)) {
                Files.copy(in, folder.resolve(name));
            }
        }
        Files.writeString(folder.resolve("lamp.ies"), PROFILE);
        ImageIO.write(new BufferedImage(3, 2, BufferedImage.TYPE_INT_RGB), "png", folder.resolve("window.png").toFile());
    }

    private JenDocument imported() throws Exception {
        Path scene = folder.resolve("rig.jen");
        ImportedScene read = SceneImporter.read(folder.resolve("rig.usda"), scene, LightUnits.CANDELA, Progress.NONE);
        read.write();
        return JenReader.read(scene);
    }

    /** Exports lights as a layer over the stage; returns how that differs from the stage. */
    private String differences(JenDocument document) throws IOException {
        Path layer = folder.resolve("lights.usda");
        Files.write(layer, LightExport.toUsd(document.text(), document.animatedScene(), folder.resolve("rig.jen"), layer).bytes());
        Files.writeString(folder.resolve("composed.usda"), """
                #usda 1.0
                (
                    subLayers = [@lights.usda@, @rig.usda@]
                    timeCodesPerSecond = 24
                    startTimeCode = 1
                    endTimeCode = 24
                    upAxis = "Z"
                    metersPerUnit = 0.01
                )
                """);
        return PythonPrograms.script(folder, List.of("compare_lights.py", "rig.usda", "composed.usda"));
    }

    @Test
    void lensShiftBeyondTenPictures_isNoted() throws Exception {
        Path stage = folder.resolve("rig.usda");
        Files.writeString(stage, Files.readString(stage).replace("24: -4.05", "24: -405"));
        ImportedScene read = SceneImporter.read(stage, folder.resolve("rig.jen"), LightUnits.CANDELA, Progress.NONE);
        assertThat(read.notes()).containsEntry("lens shifts beyond 10 pictures, imported without shift", 1);
        assertThat(read.scene().camera().shift()).isEqualTo(LensShift.NONE);
        assertThat(read.shot().orElseThrow().sceneAt(read.scene(), 24).camera().from()).isEqualTo(new Vec3(1, 5, 8));
        assertThat(read.shot().orElseThrow().sceneAt(read.scene(), 24).camera().shift()).isEqualTo(LensShift.NONE);
    }

    @Test
    void everyLight_comesBackWithEqualValues() throws Exception {
        assertThat(differences(imported())).isEqualTo("9 lights\n");
        assertThat(Files.readString(folder.resolve("lights.usda"))).doesNotContain("over");
    }

    /** Without the values of the import, the layer has all attributes. */
    @Test
    void everyLightOfAnEarlierImport_comesBackWithEqualValues() throws Exception {
        imported();
        Path scene = folder.resolve("rig.jen");
        Files.writeString(scene, String.join("\n", Files.readString(scene).lines()
                .filter(s -> !s.startsWith("# usd values: ") && !s.startsWith("# usd dome intensity: ")).toList()));
        assertThat(differences(JenReader.read(scene))).isEqualTo("9 lights\n");
        assertThat(Files.readString(folder.resolve("lights.usda"))).contains("over \"sun\"", "over \"sky\"");
    }

    @Test
    void lights_areWhatTheStageSays() throws Exception {
        Scene scene = imported().scene();
        Light sun = scene.light("sun").orElseThrow();
        assertThat(sun.type()).isEqualTo(LightType.DIRECTIONAL);
        assertThat(sun.emission().unit()).isEqualTo(IntensityUnit.NIT);
        assertThat(sun.area().spread()).isEqualTo(0.75);
        Light bulb = scene.light("bulb").orElseThrow();
        assertThat(bulb.falloff()).isEqualTo(Falloff.INVERSE_SQUARE);
        assertThat(bulb.emission().temperature()).isEqualTo(2700);
        assertThat(bulb.influence().diffuse()).isEqualTo(0.5);
        assertThat(bulb.influence().specular()).isZero();
        // The world is at (1, 2, 3) with z up, the bulb 10 above.
        assertThat(bulb.position()).isEqualTo(new Vec3(1, 13, -2));
        assertThat(scene.light("point").orElseThrow().influence().castsShadows()).isFalse();
        Light spot = scene.light("spot").orElseThrow();
        assertThat(spot.type()).isEqualTo(LightType.SPOT);
        assertThat(spot.angle()).isEqualTo(25);
        assertThat(spot.dropoff()).isEqualTo(3);
        assertThat(spot.profile()).isPresent();
        assertThat(spot.illuminates()).isEqualTo(ShapeLinks.only("props"));
        assertThat(spot.shadowedBy()).isEqualTo(ShapeLinks.except("hero"));
        assertThat(scene.light("window").orElseThrow().texture().orElseThrow().image().width()).isEqualTo(3);
        assertThat(scene.light("tube").orElseThrow().on()).isFalse();
        assertThat(scene.world().environment()).isPresent();
        assertThat(scene.world().meters()).isEqualTo(0.01);
        assertThat(scene.picture().width() * 9).isEqualTo(scene.picture().height() * 16);
    }

    /** A ball of luminance L and radius r, seen from distance d, gives L · πr² / d² of irradiance, and white paper a share of 1/π of it. */
    @Test
    void intensity_isLuminance() throws Exception {
        JenDocument document = imported();
        Light bulb = document.animatedScene().sceneAt(1).rig().effectiveLights().get(1);
        double tint = bulb.color().luminance();
        assertThat(bulb.intensity() * tint).isCloseTo(100 * 0.3 * 0.3, offset(1e-9));
        // A normalized rect: the same power whatever its area.
        Light window = document.scene().rig().effectiveLights().get(6);
        assertThat(window.intensity()).isCloseTo(12 / Math.PI, offset(1e-9));
    }

    @Test
    void animation_isKeyed() throws Exception {
        JenDocument document = imported();
        assertThat(document.shot().orElseThrow().last()).isEqualTo(24);
        assertThat(document.animatedScene().sceneAt(12).light("bulb").orElseThrow().intensity()).isEqualTo(250);
        assertThat(document.animatedScene().sceneAt(24).stage().node("crate").orElseThrow().placement().position())
                .isEqualTo(new Vec3(4, 10, 0));
        assertThat(document.animatedScene().sceneAt(24).camera().from()).isEqualTo(new Vec3(1, 5, 8));
        assertThat(document.animatedScene().sceneAt(1).camera().shift()).isEqualTo(new LensShift(0.1, 0));
        assertThat(document.animatedScene().sceneAt(24).camera().shift()).isEqualTo(new LensShift(0.1, -0.2));
    }

    @Test
    void edits_areInTheLayer() throws Exception {
        JenDocument document = imported();
        Scene scene = document.scene();
        Light disk = scene.light("disk").orElseThrow();
        List<Light> lights = scene.lights().stream().filter(l -> !l.name().equals("sun"))
                .map(l -> l.name().equals("disk") ? disk.withIntensity(31).withColor(new Rgb(1, 0.5, 0.25)) : l).toList();
        List<Light> edited = new ArrayList<>(lights);
        edited.add(Light.of("new key", LightType.RECT).withFalloff(Falloff.INVERSE_SQUARE).withIlluminates(ShapeLinks.only("hero")));
        String text = differences(document.withAnimatedScene(document.animatedScene().withScene(scene.withLights(edited))));
        assertThat(text).contains("/World/lights/disk inputs:intensity at 1 was 30.0 is 31.0")
                .contains("9 lights");
        assertThat(Files.readString(folder.resolve("lights.usda"))).contains("active = false", "def RectLight \"new_key\"",
                "rel collection:lightLink:includes = [</World/hero>]", "(1, 0.5, 0.25)");
    }
}
