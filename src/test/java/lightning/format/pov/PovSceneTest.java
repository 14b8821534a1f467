package lightning.format.pov;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.awt.image.BufferedImage;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.IntStream;
import javax.imageio.ImageIO;
import lightning.base.math.Transform;
import lightning.base.math.Vec3;
import lightning.format.jen.JenReader;
import lightning.format.jen.asset.EnvironmentReader;
import lightning.sample.SampleMeshes;
import lightning.sample.SceneArbitraries;
import lightning.scene.Camera;
import lightning.scene.Dome;
import lightning.scene.PictureSettings;
import lightning.scene.Scene;
import lightning.scene.World;
import lightning.scene.asset.Environment;
import lightning.scene.asset.EnvironmentMap;
import lightning.scene.asset.Texture;
import lightning.scene.asset.TextureMap;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import lightning.scene.material.BumpMapping;
import lightning.scene.material.Material;
import lightning.scene.node.SceneNode;
import lightning.scene.node.Shape;
import lightning.scene.node.Solid;
import lightning.scene.value.Attenuation;
import lightning.scene.value.DomeRotation;
import lightning.scene.value.Placement;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.EdgeCasesMode;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.constraints.DoubleRange;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class PovSceneTest {
    @TempDir
    Path folder;

    @Provide
    Arbitrary<Scene> scenes() {
        return SceneArbitraries.scenes();
    }

    @Property(tries = 100, edgeCases = EdgeCasesMode.NONE)
    void text_hasEveryShapeAndActiveLight(@ForAll("scenes") Scene scene) {
        String text = PovScene.of(scene, "x").text();
        assertThat(text.chars().filter(c -> c == '{').count()).isEqualTo(text.chars().filter(c -> c == '}').count());
        assertThat(text).doesNotContain("NaN", "Infinity");
        List<Dome> environments = scene.world().environments();
        int ofEnvironments = IntStream.range(0, environments.size()).filter(scene.rig()::isEnvironmentActive)
                .map(e -> environments.get(e).map().lights(environments.get(e).lightCount()).size()).sum();
        assertThat(text.lines().filter(line -> line.startsWith("light_source"))).hasSize(
                (int) scene.lights().stream().filter(light -> scene.isActive(light) && light.type() != LightType.OBJECT).count()
                        + ofEnvironments);
        boolean isTilted = scene.world().environment().isPresent() && !scene.world().own().rotation().isUpright();
        assertThat(text.lines().filter(line -> line.startsWith("  matrix"))).hasSize(scene.placedShapes().size() + (isTilted ? 1 : 0));
    }

    @Test
    void warnings_areInTheFileHeader() throws Exception {
        PovScene pov = PovScene.of(JenReader.read(Path.of("scenes/bird.jen")).scene(), "x");
        assertThat(pov.losses()).isNotEmpty();
        pov.losses().forEach(warning -> assertThat(pov.text()).contains("// Not exported exactly: " + warning + "\n"));
    }

    @Test
    void names_stayInsideComments() throws Exception {
        Scene scene = JenReader.read("""
                jen 1
                material "*/ } oak" { specular 1 0 0 }
                sphere "ball */ {" { material "*/ } oak" }
                light "key \\"light\\" {" point { attenuation 1 1 1 }
                light "} off" point { on no }
                """, "p.jen", Path.of("")).scene();
        PovScene pov = PovScene.of(scene, "x");
        assertThat(pov.text()).contains("// ball */ {\n", "// key \"light\" {\n", "// light } off is off\n",
                "// Not exported exactly: material */ } oak: specular");
        String code = pov.text().replaceAll("//.*", "");
        assertThat(code).doesNotContain("*/", "oak", "key", "off");
        assertThat(code.chars().filter(c -> c == '{').count()).isEqualTo(code.chars().filter(c -> c == '}').count());
    }

    /** POV-Ray 3.7's manual, "Area Lights": the outermost of n samples lie on the edges, and jitter moves each by half their spacing. */
    @Test
    void areaLight_emitsFromItsOwnWidth() throws Exception {
        Scene scene = JenReader.read("""
                jen 1
                light key rect { width 4  height 8  samples 16  direction 0 0 -1 }
                """, "p.jen", Path.of("")).scene();
        assertThat(PovScene.of(scene, "x").text()).contains("area_light <3.0, -0.0, 0.0>, <0.0, 6.0, 0.0>, 4, 4 jitter");
    }

    /** A mesh of one point has no extent, and a light at it no distance to it. */
    @Test
    void lightInASceneOfOnePoint_hasAColor() {
        SceneNode dot = new Shape(SampleMeshes.solid(SampleMeshes.empty()), "dot", "matt", Placement.IDENTITY);
        Light light = Light.of("key", LightType.POINT).withPosition(Vec3.ZERO).withAttenuation(new Attenuation(0, 1, 1));
        Scene scene = new Scene(PictureSettings.DEFAULT, Camera.DEFAULT, World.DEFAULT, List.of(Material.of("matt")), List.of(dot),
                List.of(light));
        assertThat(PovScene.of(scene, "x").text()).doesNotContain("NaN", "Infinity");
    }

    @Test
    void fileName_isEscaped() throws Exception {
        PovScene pov = PovScene.of(JenReader.read(Path.of("scenes/bird.jen")).scene(), "a\"b\\c\nd");
        assertThat(pov.text()).doesNotContain("a\"b", "\\c");
    }

    /** POV-Ray 3.7's manual, "map_type 1": the image begins at x, and wraps around y toward z. */
    @Property(tries = 50, edgeCases = EdgeCasesMode.NONE)
    void environment_isRotatedAsRendered(@ForAll @DoubleRange(min = -360, max = 360) double rotation) {
        EnvironmentMap environment = new EnvironmentMap(4, 1, new float[] {1, 0, 0, 2, 0, 0, 3, 0, 0, 4, 0, 0});
        World world = World.DEFAULT.withEnvironment(Optional.of(new Environment("a\"b.hdr", environment)))
                .withOwn(own -> own.withRotation(DomeRotation.of(rotation, 0, 0)));
        String text = PovScene.of(new Scene(PictureSettings.DEFAULT, Camera.DEFAULT, world, List.of(), List.of(), List.of()), "x").text();
        assertThat(text).contains("hdr \"x-environment-a_b_hdr.hdr\" map_type 1");
        Matcher rotationText =
                Pattern.compile("(?s)sky_sphere.*?\n  rotate <0, ([^,]*), 0>").matcher(text);
        assertThat(rotationText.find()).isTrue();
        for (int column = 0; column < 4; column++) {
            // A rotation by +90 degrees about y takes z to x in POV-Ray, so an angle from x toward z becomes smaller.
            double angle = Math.toRadians(360 * (column + 0.5) / 4 - Double.parseDouble(rotationText.group(1)));
            double[] direction = new double[3];
            environment.radiance(Math.cos(angle), 0, Math.sin(angle), DomeRotation.of(rotation, 0, 0), direction);
            assertThat(direction[0]).isEqualTo(column + 1, within(1e-9));
        }
    }

    /** POV-Ray's surfaces gather no light of the sky: lights stand for all of it. */
    @Test
    void smoothEnvironment_isExportedAsLights() {
        EnvironmentMap gray =
                new EnvironmentMap(4, 2, new float[] {1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1});
        World world = World.DEFAULT.withEnvironment(Optional.of(new Environment("gray.hdr", gray))).withOwn(own -> own.withLightCount(8));
        String text = PovScene.of(new Scene(PictureSettings.DEFAULT, Camera.DEFAULT, world, List.of(), List.of(), List.of()), "x").text();
        assertThat(text.split("light_source", -1)).hasSize(1 + 8);
    }

    @Test
    void environmentImage_isWrittenNextToTheScene() throws Exception {
        Scene scene = JenReader.read(Path.of("scenes/window.jen")).scene();
        PovScene.of(scene, "x").write(folder.resolve("x.pov"));
        EnvironmentMap written = EnvironmentReader.read("sky.hdr", folder.resolve("x-environment-evening_sky_hdr.hdr"), 0, _ -> {});
        assertThat(written).isEqualTo(scene.world().environment().orElseThrow().map());
    }

    @ParameterizedTest
    @ValueSource(strings = {"window", "hall", "arbor", "stage"})
    void everyNamedImage_isWrittenNextToTheScene(String name) throws Exception {
        PovScene pov = PovScene.of(JenReader.read(Path.of("scenes", name + ".jen")).scene(), "x");
        pov.write(folder.resolve("x.pov"));
        List<String> images =
                Pattern.compile("\\b(?:png|hdr) \"([^\"]*)\"").matcher(pov.text()).results().map(m -> m.group(1)).distinct().toList();
        assertThat(images).isNotEmpty().allSatisfy(image -> assertThat(folder.resolve(image)).isNotEmptyFile());
    }

    @Test
    void meshes_areDeclaredOnce() {
        Solid.TriangleMesh cube = SampleMeshes.solid(SampleMeshes.cube());
        List<SceneNode> nodes =
                List.of(new Shape(cube, "one", "default", Placement.IDENTITY), new Shape(cube, "two", "default", Placement.IDENTITY),
                        new Shape(SampleMeshes.solid(SampleMeshes.ball(3, 4, true)), "three", "default", Placement.IDENTITY));
        PovScene pov = PovScene.of(new Scene(PictureSettings.DEFAULT, Camera.DEFAULT, World.DEFAULT, List.of(), nodes, List.of()), "x");
        assertThat(pov.text()).containsOnlyOnce("#declare mesh_0 = mesh2 {\n  vertex_vectors { 8,\n    <-1.0,-1.0,-1.0>,")
                .containsOnlyOnce("  face_indices { 12,\n    <0,2,1>,").containsOnlyOnce("normal_vectors { 10,")
                .contains("// two\nobject { mesh_0\n", "// three\nobject { mesh_1\n");
        assertThat(pov.losses()).isEmpty();
    }

    @Test
    void transparentMaterials_haveIorTransmissionAndTint() throws Exception {
        PovScene pov = PovScene.of(JenReader.read("""
                jen 1
                material glass { diffuse 0 0 0  clear 0.5 1 1  ior 1.4  tint 0.5 1 1  tint_distance 2  shadows none }
                material pane { clear 0.5 0.5 0.5  thin yes }
                sphere ball { material glass }
                plane sheet { material pane }
                """, "p.jen", Path.of("")).scene(), "x");
        assertThat(pov.text()).contains("rgbf <0.5, 1.0, 1.0, 1.0>", "fresnel on } conserve_energy", "no_shadow",
                "interior { ior 1.4 fade_color rgb <" + (1 + Math.log(0.5)) + ",", "fade_distance 2.0 fade_power 1001 }",
                "rgbf <1.0, 1.0, 1.0, 0.5>");
        assertThat(pov.losses()).containsExactly("material pane: its shadows are transparent in POV-Ray",
                "material pane: a thin sheet has no Fresnel reflection",
                "material pane: its surface color is not reduced by Fresnel reflection");
    }

    /** POV-Ray multiplies ambient by ambient_light but not emission, and both by the pigment. */
    @Test
    void glow_becomesEmission() throws Exception {
        String text = PovScene.of(JenReader.read("""
                jen 1
                world { ambience 0.5 }
                material neon { ambient 0.1 0.2 0.4  glow 1 2 0  diffuse 0.5 0.25 1 }
                material mirror { glow 1 1 1  diffuse 0.5 0.5 0.5  reflective 0.5 0.5 0.5 }
                material pane { glow 3 0 0  clear 0.5 0.5 0.5  shadows tinted }
                plane a { material neon }
                plane b { material mirror }
                plane c { material pane }
                """, "p.jen", Path.of("")).scene(), "x").text();
        assertThat(text).contains(
                "pigment { rgb <0.5, 0.25, 1.0> }\n    finish { ambient rgb <0.2, 0.8, 0.4> emission rgb <2.0, 8.0, 0.0> diffuse 1 ")
                .contains(
                        "pigment { rgb <0.25, 0.25, 0.25> }\n    finish { ambient rgb <0.0, 0.0, 0.0> emission rgb <2.0, 2.0, 2.0> diffuse 1 ")
                .contains("finish { ambient rgb <0.0, 0.0, 0.0> emission rgb <3.0, 0.0, 0.0> diffuse 0.8");
        assertThat(PovScene.of(JenReader.read("jen 1 plane p {}", "p.jen", Path.of("")).scene(), "x").text()).doesNotContain("emission");
    }

    /** A smooth surface reflects F0, and a coat of index 1.5 reflects 0.04 over it. */
    @Test
    void principledMaterial_reflectsAsAtNormalIncidence() throws Exception {
        PovScene pov = PovScene.of(JenReader.read("""
                jen 1
                material water { model principled  base 0 0 0  roughness 0  f0 0.5  specular_tint 1 0.5 0.25 }
                material paint { model principled  base 0.5 0.25 0.125  roughness 0.5  coat 1  coat_roughness 0 }
                plane a { material water }
                plane b { material paint }
                """, "p.jen", Path.of("")).scene(), "x");
        assertThat(pov.text()).contains("reflection { rgb <0.5, 0.25, 0.125> }").contains("reflection { rgb <0.04");
        assertThat(pov.losses()).containsSubsequence("material paint: a principled material is approximated by Phong's model",
                "material paint: its blurred reflections are left out");
    }

    @Test
    void glowMap_isReplacedByItsMean() throws Exception {
        ImageIO.write(new BufferedImage(1, 1, BufferedImage.TYPE_INT_RGB), "png", folder.resolve("black.png").toFile());
        PovScene pov = PovScene.of(JenReader.read("""
                jen 1
                material neon { glow 1 2 0  glow_map "black.png"  diffuse 0.5 0.25 1 }
                plane a { material neon }
                """, "p.jen", folder).scene(), "x");
        assertThat(pov.text()).doesNotContain("emission");
        assertThat(pov.losses()).containsExactly("material neon: glow map is replaced by its mean");
    }

    @Test
    void surfaceMaps_areReplacedByTheirMeans() throws Exception {
        var packed = new BufferedImage(2, 1, BufferedImage.TYPE_INT_RGB);
        packed.setRGB(0, 0, 0x00FF00);
        packed.setRGB(1, 0, 0x0000FF);
        ImageIO.write(packed, "png", folder.resolve("orm.png").toFile());
        String text = "jen 1 material m { model principled metalness %s roughness %s %s } plane a { material m }";
        PovScene mapped = PovScene.of(JenReader.read(String.format(Locale.ROOT, text, 1, 0.8,
                "roughness_map \"orm.png\" metalness_map \"orm.png\""), "p.jen", folder).scene(), "x");
        PovScene plain = PovScene.of(JenReader.read(String.format(Locale.ROOT, text, 0.5, 0.4, ""), "p.jen", folder).scene(), "x");
        assertThat(mapped.text()).endsWith(plain.text().substring(plain.text().indexOf("#version")));
        assertThat(mapped.losses())
                .contains("material m: maps of roughness, metalness, f0, specular tint and coat are replaced by their means");
        assertThat(plain.losses()).noneMatch(loss -> loss.contains("maps"));
    }

    @Test
    void glowMap_alsoCoversABulbAtTheLimit() throws Exception {
        var white = new BufferedImage(1, 1, BufferedImage.TYPE_INT_RGB);
        white.setRGB(0, 0, 0xFFFFFF);
        ImageIO.write(white, "png", folder.resolve("white.png").toFile());
        PovScene pov = PovScene.of(JenReader.read("""
                jen 1
                light key point { intensity 1000000 }
                material neon { diffuse 1 1 1  glow 1000000 0 0  bulb key  glow_map "white.png" }
                plane a { material neon }
                """, "p.jen", folder).scene(), "x");
        assertThat(pov.text()).contains("emission rgb <2000000.0, 1000000.0, 1000000.0>");
    }

    @Test
    void bumpMaps_becomeHeightPatterns() throws Exception {
        Path textures = Path.of("textures").toAbsolutePath();
        Files.copy(textures.resolve("brick.png"), folder.resolve("brick.png"));
        Scene scene = JenReader.read("""
                jen 1
                material wall { bump "brick.png" height 0.2 bump_repeat 4 2 }
                plane wall { material wall }
                """, "p.jen", folder).scene();
        PovScene pov = PovScene.of(scene, "x");
        assertThat(pov.losses()).isEmpty();
        assertThat(pov.text()).contains("normal { pigment_pattern { image_map { png \"x-bump-brick_png.png\" gamma 1.0 map_type 0 ",
                " } } 1.5 no_bump_scale accuracy ", " scale <0.25, 0.5, 1> rotate");
        pov.write(folder.resolve("p.pov"));
        Texture heights = scene.materials().getLast().bumpMapping().bump().orElseThrow().image();
        BufferedImage written = ImageIO.read(folder.resolve("x-bump-brick_png.png").toFile());
        assertThat(written.getRaster().getSample(7, 5, 1)).isEqualTo((int) Math.round(65535 * heights.luminance(7, 5, 7, 5, 0, 0)));
    }

    @Test
    void unsupportedRelief_isReportedByMaterial() {
        var image = new TextureMap("a.png", 1, 1, new Texture(1, 1, new float[3]));
        Material bumpy = Material.of("bumpy").withBumpMapping(BumpMapping.NONE.withBump(Optional.of(image)));
        Material leaning = Material.of("leaning").withBumpMapping(BumpMapping.NONE.withNormalMap(Optional.of(image)));
        List<SceneNode> nodes = List.of(new Shape(SampleMeshes.solid(SampleMeshes.cube()), "one", "bumpy", Placement.IDENTITY),
                new Shape(Solid.PLANE, "two", "leaning", Placement.IDENTITY));
        PovScene pov =
                PovScene.of(new Scene(PictureSettings.DEFAULT, Camera.DEFAULT, World.DEFAULT, List.of(bumpy, leaning), nodes, List.of()),
                        "x");
        assertThat(pov.losses()).containsExactly(
                "material bumpy: its bump map is left out on meshes, POV-Ray does not support it",
                "material leaning: its normal map is left out, POV-Ray does not support it");
        assertThat(pov.text()).doesNotContain("normal {");
    }

    @Test
    void frustumsAndUncappedSolids_becomeOpenConesAndCylinders() throws Exception {
        String text = PovScene.of(JenReader.read("jen 1 frustum f { top 0.25 } frustum g { caps no } cylinder c { caps no }", "f.jen",
                Path.of(".")).scene(), "f").text();
        assertThat(text).contains("cone { <0, 0, 0>, 1, <0, 1, 0>, 0.25\n", "cone { <0, 0, 0>, 1, <0, 1, 0>, 0.5 open\n",
                "cylinder { <0, 0, 0>, <0, 1, 0>, 1 open\n");
    }

    @Test
    void matrix_equalsTheTransform() {
        Transform transform = Transform.translation(new Vec3(1, 2, 3)).times(Transform.rotation(new Vec3(10, 20, 30)))
                .times(Transform.scaling(new Vec3(2, 3, 4)));
        Matcher numbers = Pattern.compile("<(.*)>").matcher(PovFormat.matrix(transform));
        assertThat(numbers.find()).isTrue();
        double[] m = Arrays.stream(numbers.group(1).split(", ")).mapToDouble(Double::parseDouble).toArray();
        Vec3 p = new Vec3(0.3, -0.7, 0.9);
        // The manual of POV-Ray 3.7, "matrix": a row vector times the matrix, its fourth row the translation.
        Vec3 mapped = new Vec3(
                m[0] * p.x() + m[3] * p.y() + m[6] * p.z() + m[9],
                m[1] * p.x() + m[4] * p.y() + m[7] * p.z() + m[10],
                m[2] * p.x() + m[5] * p.y() + m[8] * p.z() + m[11]);
        assertThat(mapped.minus(transform.transformPoint(p)).maxAbs()).isLessThan(1e-12);
    }

    @Property(tries = 200)
    void singleTermFade_isExactBeyondTheLimit(@ForAll @DoubleRange(min = 1, max = 5) double constant,
            @ForAll @DoubleRange(min = 0.01, max = 4) double factor, @ForAll boolean quadratic,
            @ForAll @DoubleRange(min = 0, max = 30) double distance) {
        var attenuation = new Attenuation(constant, quadratic ? 0 : factor, quadratic ? factor : 0);
        PovFade fade = PovFade.of(attenuation, 1, 10);
        double expected = 1 / (constant + factor * (quadratic ? distance * distance : distance));
        assertThat(fade.isExact()).isTrue();
        assertThat(fade.factor(distance)).isCloseTo(expected, within(1e-9));
    }

    @Property(tries = 200)
    void mixedFade_isClose(@ForAll @DoubleRange(min = 0, max = 2) double constant,
            @ForAll @DoubleRange(min = 0.1, max = 2) double linear, @ForAll @DoubleRange(min = 0.1, max = 2) double quadratic,
            @ForAll @DoubleRange(min = 3, max = 9) double distance) {
        var attenuation = new Attenuation(constant, linear, quadratic);
        PovFade fade = PovFade.of(attenuation, 3, 9);
        double expected = 1 / (constant + linear * distance + quadratic * distance * distance);
        assertThat(fade.factor(distance) / Math.min(expected, 1)).isBetween(0.9, 1.1);
    }

    @Test
    void fadeHiddenByTheLimit_isOmitted() {
        assertThat(PovFade.of(new Attenuation(0.1, 0.1, 0.1), 0.5, 2).distance()).isZero();
    }

    @Test
    void noAttenuation_hasNoFade() {
        assertThat(PovFade.of(Attenuation.NONE, 1, 10)).isEqualTo(new PovFade(1, 0, 0, true));
        assertThat(PovFade.of(new Attenuation(2, 0, 0), 1, 10).factor(7)).isEqualTo(0.5);
    }
}
