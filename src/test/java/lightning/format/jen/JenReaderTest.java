package lightning.format.jen;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.format.jen.asset.JenLimits;
import lightning.scene.Camera;
import lightning.scene.PictureSettings;
import lightning.scene.Scene;
import lightning.scene.World;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import lightning.scene.material.Material;
import lightning.scene.node.NodeGroup;
import lightning.scene.node.Shape;
import lightning.scene.node.Solid;
import lightning.scene.value.Attenuation;
import lightning.scene.value.Placement;
import lightning.scene.value.SceneLimits;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class JenReaderTest {
    @TempDir
    Path folder;

    @Test
    void fullScene_isReadIntoRecords() throws Exception {
        Scene scene = read("""
                jen 1   # the version
                picture { size 300 200  depth 5  antialias off }
                camera { fov 35  up 0 1 0  to 0 1 0  from 0 2 9 }
                world { ambience 0.5  background 0 0 0.1 }
                material floor { ambient 0.1 0.1 0.1 diffuse 1 1 1 specular 0.2 0.2 0.2 shininess 20 reflective 0.3 0.3 0.3 }
                plane ground { material floor  scale 20 1 20 }
                group bird at 0 1 0 {
                  cone beak { material floor  at 0 1 0.8  rotate 90 0 0  scale 0.2 0.5 0.2 }
                  rotate 0 30 0
                }
                light key spot {
                  color 1 0.9 0.8  intensity 1.2  at 3 5 2  direction -3 -4 -2
                  attenuation 0.1 1 0.1  angle 25  dropoff 4  on no  solo yes
                }
                """);
        assertThat(scene.picture()).isEqualTo(new PictureSettings(300, 200, 5));
        assertThat(scene.camera()).isEqualTo(new Camera(new Vec3(0, 2, 9), new Vec3(0, 1, 0), Vec3.Y, 35));
        assertThat(scene.world()).isEqualTo(new World(0.5, new Rgb(0, 0, 0.1)));
        assertThat(scene.materials()).containsExactly(Material.of("floor").withAmbient(Rgb.gray(0.1)).withDiffuse(Rgb.WHITE)
                .withSpecular(Rgb.gray(0.2)).withShininess(20).withReflective(Rgb.gray(0.3)));
        assertThat(scene.nodes()).containsExactly(
                new Shape(Solid.PLANE, "ground", "floor", new Placement(Vec3.ZERO, Vec3.ZERO, new Vec3(20, 1, 20))),
                new NodeGroup("bird", new Placement(new Vec3(0, 1, 0), new Vec3(0, 30, 0), Vec3.ONE), List.of(
                        new Shape(Solid.CONE, "beak", "floor",
                                new Placement(new Vec3(0, 1, 0.8), new Vec3(90, 0, 0), new Vec3(0.2, 0.5, 0.2))))));
        assertThat(scene.lights()).containsExactly(Light.of("key", LightType.SPOT).withColor(new Rgb(1, 0.9, 0.8)).withIntensity(1.2)
                .withPosition(new Vec3(3, 5, 2)).withDirection(new Vec3(-3, -4, -2)).withAttenuation(new Attenuation(0.1, 1, 0.1))
                .withAngle(25).withDropoff(4).withOn(false).withSolo(true));
    }

    @Test
    void emptyScene_hasDefaults() throws Exception {
        assertThat(read("jen 1"))
                .isEqualTo(new Scene(PictureSettings.DEFAULT, Camera.DEFAULT, World.DEFAULT, List.of(), List.of(), List.of()));
    }

    @Test
    void lightWithoutProperties_hasTypeDefaults() throws Exception {
        assertThat(read("jen 1 light a directional {}").lights()).containsExactly(Light.of("a", LightType.DIRECTIONAL));
    }

    @Test
    void byteOrderMarkAndWindowsLineEnds_areRead() throws Exception {
        assertThat(read("\uFEFFjen 1\r\n# c\r\nlight ä point { intensity 2 }\r\n").lights())
                .containsExactly(Light.of("ä", LightType.POINT).withIntensity(2));
    }

    @Test
    void keywords_canBeNames() throws Exception {
        Scene scene = read("jen 1 material material {} sphere at { material material scale 1 2 3 } light light point {}");
        assertThat(scene.nodes()).containsExactly(
                new Shape(Solid.SPHERE, "at", "material", new Placement(Vec3.ZERO, Vec3.ZERO, new Vec3(1, 2, 3))));
        assertThat(scene.lights()).containsExactly(Light.of("light", LightType.POINT));
    }

    @ParameterizedTest
    @CsvSource({"1,1", "-0,-0.0", "+.5,0.5", "5.,5", "1e3,1000", "1E-3,0.001", "-1.5e+2,-150", "0.1,0.1", "4.9e-324,4.9e-324",
        "1e-999,0"})
    void numbers_areReadAsDoubles(String text, double value) throws Exception {
        assertThat(read("jen 1 camera { to " + text + " 0 0 }").camera().to().x()).isEqualTo(value);
    }

    @ParameterizedTest
    @ValueSource(strings = {"1..2", "1f", "0x1p3", "1e", "--1", ".", "-", "1-2", "1,5", "1_000", "-inf", "nan", "Infinity", "\"1\"", "x"})
    void invalidNumber_isRejectedWithLocation(String text) {
        assertThat(problems("jen 1\nworld { ambience " + text + " }").getFirst()).startsWith("s.jen:2:");
    }

    @Test
    void everyProblem_isReportedWithLocation() {
        assertThat(problems("""
                jen 1
                camra { fov 500 }
                world { ambience nan  ambience 1 }
                material m { diffuse 1 1 }
                material m { diffuse 2 0 0  difuse 1 1 1 }
                sphere s { material n  scale 0 1 1 }
                light key spt { intensty 3  intensity -3  on maybe  direction 0 0 0 }
                light key point { at 1 2 3 4  color 1e999 1 1 }
                blob
                """)).containsExactly(
                "s.jen:2:1: expected a block (bank, camera, cone, cylinder, dome, frustum, group, light, material, mesh, picture, plane, shot, sphere, world), found 'camra', did you mean 'camera'?",
                "s.jen:2:13: camera: fov must be from 0.01 to 170, was 500",
                "s.jen:3:18: world: ambience must be a number, found 'nan'",
                "s.jen:3:23: world: ambience must be written once, found it again",
                "s.jen:4:14: material 'm': diffuse must have 3 numbers, found 2",
                "s.jen:5:10: material 'm': names must be unique, found a material with this name before",
                "s.jen:5:22: material 'm': diffuse red must be from 0 to 1, was 2",
                "s.jen:5:29: material 'm': unknown property 'difuse', did you mean 'diffuse'?",
                "s.jen:6:21: sphere 's': there is no material 'n'",
                "s.jen:6:30: sphere 's': scale must be at least 1e-9 in absolute value on every axis, was 0",
                "s.jen:7:11: light 'key': type must be directional, point, spot, rect, disc, tube or object, was 'spt', did you mean 'spot'?",
                "s.jen:7:17: light 'key': unknown property 'intensty', did you mean 'intensity'?",
                "s.jen:7:39: light 'key': intensity must be ≥ 0, was -3",
                "s.jen:7:46: light 'key': on must be yes or no, was 'maybe'",
                "s.jen:7:63: light 'key': direction must not be zero, was 0 0 0",
                "s.jen:8:7: light 'key': names must be unique, found a light with this name before",
                "s.jen:8:19: light 'key': at must have 3 numbers, found 4",
                "s.jen:8:37: light 'key': color must be a number within ±1.8e308, found '1e999'",
                "s.jen:9:1: expected a block (bank, camera, cone, cylinder, dome, frustum, group, light, material, mesh, picture, plane, shot, sphere, world), found 'blob'");
    }

    @Test
    void fileOfAnotherKind_isOneProblem() {
        assertIsNoScene("import os\nfor x in [1, (2)]:\n    print(x)\n",
                "1:1: not a scene file, which begins with 'jen 1'; found 'import'");
        assertIsNoScene("#!/usr/bin/python\n\nfrom x import (y)\n", "3:1: not a scene file, which begins with 'jen 1'; found 'from'");
        assertIsNoScene("{ \"asset\": [1, 2] }", "1:1: not a scene file, which begins with 'jen 1'; found '{'");
        assertIsNoScene("3 4", "1:1: not a scene file, which begins with 'jen 1'; found '3'");
    }

    private static void assertIsNoScene(String text, String problem) {
        assertThatExceptionOfType(JenException.class).isThrownBy(() -> JenReader.read(text, "s.jen", Path.of(".")))
                .satisfies(e -> assertThat(e.problems()).singleElement().asString().isEqualTo("s.jen:" + problem));
    }

    @Test
    void pictureInPlaceOfAScene_isOneProblem(@TempDir Path folder) throws IOException {
        Path file = Files.write(folder.resolve("a.jen"),
                new byte[] {(byte) 0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n', (byte) 0xe7, (byte) 0xe8});
        assertThatExceptionOfType(JenException.class).isThrownBy(() -> JenReader.read(file))
                .satisfies(e -> assertThat(e.problems()).singleElement().asString()
                        .contains(": not a scene file, which begins with 'jen 1'; "));
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "'' | 1:1: a scene file must begin with 'jen 1', found the end of the file",
        "light a point {} | 1:1: a scene file must begin with 'jen 1', found 'light'",
        "jen 2 anything | 1:5: expected version 1 of the format, found '2'",
        "jen 1 } | 1:7: found a '}' without a '{' before it",
        "jen 1 { } | 1:7: expected a block, found '{'",
        "jen 1 light | 1:12: light: expected a name, found the end of the file",
        "jen 1 light a object { shape b } | 1:30: light 'a': shape: there is no shape or group 'b'",
        "jen 1 group g { at 5e11 0 0 sphere b { at 6e11 0 0 } } light a object { shape b } | 1:62: light 'a': position x must be from -1e12 to 1e12, was 1.1e12",
        "jen 1 light a { } | 1:15: light 'a': expected directional, point, spot, rect, disc, tube or object, found '{'",
        "jen 1 light a point | 1:20: light 'a': expected '{', found the end of the file",
        "jen 1 light a point { | 1:22: light 'a': expected '}', found the end of the file",
        "jen 1 light a point { { } } | 1:23: light 'a': expected a property, found '{'",
        "jen 1 light a point { 5 } | 1:23: light 'a': expected a property, found '5'",
        "jen 1 light a point { on } | 1:26: light 'a': on: expected yes or no, found '}'",
        "jen 1 picture { size 1.5 2 } | 1:22: picture: size width must be a whole number, was 1.5",
        "jen 1 picture { depth 11 } | 1:23: picture: depth must be from 0 to 10, was 11",
        "jen 1 picture { antialias on } | 1:27: picture: antialias must be off, edges or every, was 'on'",
        "jen 1 picture { samples 9 } | 1:25: picture: samples must be from 2 to 8, was 9",
        "jen 1 world {} world {} | 1:16: world must be written once, found it again",
        "jen 1 camera { from 1 2 3 to 1 2 3 } | 1:7: camera: from and to must be different points",
        "jen 1 material m { repeat 2 2 } | 1:20: material 'm': repeat needs a texture, found none",
        "jen 1 world { ambience 1 $ } | 1:26: expected a word, a number or a brace, found '$'",
        "jen 1 world { ambience 1\u00a0} | 1:25: expected a space, found U+00A0",
        "jen 1 group g { light l point {} } | 1:17: group 'g': a light cannot stand in a group, expected '}' or one of sphere, cone, cylinder, frustum, plane, mesh, group",
    })
    void invalidText_reportsExpectedAndFound(String text, String problem) {
        assertThat(problems(text)).containsExactly("s.jen:" + problem);
    }

    @Test
    void missingBrace_isReportedOnce() {
        assertThat(problems("jen 1\nsphere a { at 0 0 0\nlight b point { intensity -1 }")).containsExactly(
                "s.jen:3:1: sphere 'a': expected '}' before the next block, found 'light'",
                "s.jen:3:27: light 'b': intensity must be ≥ 0, was -1");
    }

    @Test
    void columns_countCodePoints() {
        assertThat(problems("jen 1 material 𝒜 { shininess -1 }")).containsExactly(
                "s.jen:1:30: material '𝒜': shininess must be ≥ 0, was -1");
    }

    @Test
    void longSupplementaryWords_areShortenedInMessages() {
        String word = "𝐀".repeat(150);
        String shortened = "'" + "𝐀".repeat(99) + "…'";
        assertThat(problems("jen 1 " + word + " {}").getFirst()).endsWith("found " + shortened);
        assertThat(problems("jen 1 world { " + word + " 1 }").getFirst()).contains("unknown property " + shortened);
        assertThat(problems("jen 1 world { ambience " + "𝐀".repeat(21) + " }")).containsExactly(
                "s.jen:1:24: world: ambience must be a number, found '" + "𝐀".repeat(21) + "'");
    }

    @Test
    void malformedUtf8_isReportedOnce() throws Exception {
        Path file = folder.resolve("bad.jen");
        byte[] bytes = "jen 1 # ?\nlight a point { intensity -1 }".getBytes(StandardCharsets.UTF_8);
        bytes[8] = (byte) 0xFF;
        Files.write(file, bytes);
        assertThat(JenReaderTest.<JenException>catching(() -> JenReader.read(file)).problems()).extracting(Problem::toString)
                .containsExactly(
                        file + ":1:9: the file must be UTF-8 text, found the malformed byte 0xFF",
                        file + ":2:27: light 'a': intensity must be ≥ 0, was -1");
    }

    @Test
    void unpairedSurrogate_isAProblem() {
        assertThat(problems("jen 1 # \ud800")).containsExactly("s.jen:1:9: found an unpaired surrogate, U+D800");
    }

    @Test
    void problems_stopAtTheLimit() {
        List<String> problems = problems("jen 1 " + "x { }\n".repeat(1000));
        assertThat(problems).hasSize(JenLimits.PROBLEMS + 1);
        assertThat(problems.getLast()).contains("more than 100 problems");
    }

    @Test
    void tooDeepGroups_areAProblem() throws Exception {
        String open = "group g%d {";
        StringBuilder text = new StringBuilder("jen 1 ");
        for (int i = 0; i < SceneLimits.MAX_NESTING; i++) {
            text.append(String.format(Locale.ROOT, open, i));
        }
        assertThat(read(text + "}".repeat(SceneLimits.MAX_NESTING)).nodes()).hasSize(1);
        text.append(String.format(Locale.ROOT, open, 99));
        assertThat(problems(text + "}".repeat(SceneLimits.MAX_NESTING + 1))).singleElement().asString().contains("nested 32 deep");
    }

    @Test
    void hugeNesting_isAProblem() {
        assertThat(problems("jen 1 " + "group g {".repeat(100_000))).isNotEmpty();
        assertThat(problems("jen 1 " + "{".repeat(100_000))).isNotEmpty();
    }

    @Test
    void longToken_isAProblem() {
        assertThat(problems("jen 1 light " + "a".repeat(JenLimits.TOKEN_LENGTH + 1) + " point {}").getFirst())
                .contains("at most 1000 characters, found 1001");
    }

    @Test
    void tooManyLights_areAProblem() {
        var text = new StringBuilder("jen 1\n");
        for (int i = 0; i <= SceneLimits.MAX_LIGHTS; i++) {
            text.append("light l").append(i).append(" point {}\n");
        }
        assertThat(problems(text.toString())).containsExactly("s.jen:1002:7: a scene may have at most 1000 lights, found 1001");
    }

    @Test
    void vanishingCombinedScale_isAProblem() {
        assertThat(problems("jen 1 group a { scale 1e-6 1 1 sphere s { scale 1 1e-6 1 } }")).singleElement().asString()
                .contains("sphere 's': scale times that of its groups");
    }

    @Test
    void tooLargeFile_isRejectedUnread() throws Exception {
        Path file = folder.resolve("large.jen");
        try (var f = new java.io.RandomAccessFile(file.toFile(), "rw")) {
            f.setLength(JenLimits.FILE_BYTES + 1L);
        }
        assertThat(JenReaderTest.<JenException>catching(() -> JenReader.read(file)))
                .hasMessageContaining("may have at most 268435456 bytes");
    }

    private Scene read(String text) throws JenException {
        return JenReader.read(text, "s.jen", folder).scene();
    }

    private List<String> problems(String text) {
        JenException e = catching(() -> read(text));
        return e.problems().stream().map(Problem::toString).toList();
    }

    @SuppressWarnings("unchecked")
    static <E extends Throwable> E catching(org.assertj.core.api.ThrowableAssert.ThrowingCallable code) {
        Throwable t = org.assertj.core.api.Assertions.catchThrowable(code);
        assertThat(t).isInstanceOf(JenException.class);
        return (E) t;
    }
}
