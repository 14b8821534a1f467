package lightning.format.jen;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import lightning.sample.ShotArbitraries;
import lightning.scene.Scene;
import lightning.scene.SceneElement;
import lightning.scene.shot.Interpolation;
import lightning.scene.shot.Keyframe;
import lightning.scene.shot.KeyframeValue;
import lightning.scene.shot.Shot;
import lightning.scene.shot.Track;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import org.junit.jupiter.api.Test;

/** Shot blocks of scene files. */
class ShotWriterTest {
    private static final String SCENE = """
            jen 1
            group tree { sphere crown { at 0 1 0 } frustum stem { top 0.5 } }
            mesh "odd name" { file "a.ply" }
            bank "3\\" row" {} dome sky { intensity 0.5 }
            light key spot { bank "3\\" row" }
            light fill point {}
            """.replaceAll("mesh.*\n", "plane \"odd name\" {}\n");

    private static JenDocument read(String shot) throws JenException {
        return JenReader.read(SCENE + shot, "s.jen", Path.of(""));
    }

    private static List<String> problems(String shot) {
        try {
            read(shot);
            return List.of();
        } catch (JenException e) {
            return e.problems().stream().map(Problem::toString).toList();
        }
    }

    @Provide
    Arbitrary<Shot> shots() throws JenException {
        return ShotArbitraries.shots(read("").scene());
    }

    @Property
    void shot_roundTrips(@ForAll("shots") Shot shot) throws JenException {
        JenDocument result = JenReader.read(JenWriter.write(read("").scene(), shot), "s.jen", Path.of(""));
        assertThat(result.shot()).contains(shot);
        assertThat(result.scene()).isEqualTo(read("").scene());
    }

    @Property
    void insertedShot_leavesOtherTextUnchanged(@ForAll("shots") Shot first, @ForAll("shots") Shot second) throws JenException {
        JenDocument document = read("").withShot(first);
        assertThat(document.text()).startsWith(SCENE);
        document = JenReader.read(document.text() + "# the end", "s.jen", Path.of("")).withShot(second);
        assertThat(document.text()).startsWith(SCENE).endsWith("# the end");
        assertThat(JenReader.read(document.text(), "s.jen", Path.of("")).shot()).contains(second);
    }

    @Test
    void sceneWithoutShot_isUnchanged() throws JenException {
        assertThat(read("").shot()).isEmpty();
        assertThat(JenDocument.of(read("").scene()).text()).doesNotContain("shot");
    }

    @Test
    void keys_areReadWithInterpolation() throws JenException {
        Shot shot = read("""
                shot {
                  frames 1 48
                  rate 25
                  camera { fov { 1 40 smooth 24 30 stepped  48 20 linear } }
                  light key { type { 1 spot 9 point stepped } at { 1 0 3 2 } samples { 3 9 } }
                  bank "3\\" row" { on { 1 no } }
                  world { rotation { 1 0  48 90 } sky { 24 yes } }
                  dome sky { intensity { 1 0.5  48 0 } on { 30 no } }
                  group tree { rotate { 1 0 0 0  48 0 360 0 } }
                }
                """).shot().orElseThrow();
        assertThat(shot).isEqualTo(new Shot(1, 48, 25, List.of(
                new Track(SceneElement.CAMERA, "fov", List.of(key(1, Interpolation.SMOOTH, 40.0), key(24, Interpolation.STEPPED, 30.0),
                        key(48, Interpolation.LINEAR, 20.0))),
                new Track(new SceneElement.OfLight("key"), "type", List.of(word(1, "spot"), word(9, "point"))),
                new Track(new SceneElement.OfLight("key"), "at", List.of(key(1, Interpolation.LINEAR, 0.0, 3.0, 2.0))),
                new Track(new SceneElement.OfLight("key"), "samples", List.of(key(3, Interpolation.STEPPED, 9.0))),
                new Track(new SceneElement.OfLightGroup("3\" row"), "on", List.of(word(1, "no"))),
                new Track(SceneElement.WORLD, "rotation", List.of(key(1, Interpolation.LINEAR, 0.0), key(48, Interpolation.LINEAR, 90.0))),
                new Track(SceneElement.WORLD, "sky", List.of(word(24, "yes"))),
                new Track(new SceneElement.OfDome("sky"), "intensity",
                        List.of(key(1, Interpolation.LINEAR, 0.5), key(48, Interpolation.LINEAR, 0.0))),
                new Track(new SceneElement.OfDome("sky"), "on", List.of(word(30, "no"))),
                new Track(new SceneElement.OfNode("tree"), "rotate", List.of(key(1, Interpolation.LINEAR, 0.0, 0.0, 0.0),
                        key(48, Interpolation.LINEAR, 0.0, 360.0, 0.0))))));
    }

    private static Keyframe key(int frame, Interpolation interpolation, Double... numbers) {
        return new Keyframe(frame, new KeyframeValue.Numbers(List.of(numbers)), interpolation);
    }

    private static Keyframe word(int frame, String text) {
        return new Keyframe(frame, new KeyframeValue.Word(text), Interpolation.STEPPED);
    }

    @Test
    void everyProblem_isReportedWithLocation() {
        assertThat(problems("""
                shot {
                  frames 9 1
                  rate 0
                  camera { fov { 1 40 smoth } to { } }
                  light key {
                    at { 1 0 3 }
                    intensity { 1.5 2 }
                    angle { 4 20 4 30 }
                    bank { 1 "x" }
                    on { 1 maybe }
                    samples { 1 9 smooth }
                    brightness { 1 2 }
                    dropoff 3
                    shadowed_by { 1 all }
                  }
                  light kye { at { 1 0 0 0 } }
                  sphere stem { top { 1 2 } }
                  picture { size { 1 2 2 } }
                  group tree { scale { 1 0 1 1 } }
                }
                """)).containsExactly(
                "s.jen:7:1: shot: the last frame must be from 9 to 1e9, was 1",
                "s.jen:9:8: shot: rate must be from 0.001 to 1000, was 0",
                "s.jen:10:23: camera: fov: expected linear, smooth or stepped, or the frame of the next key, found 'smoth'",
                "s.jen:10:36: camera: to: expected a key such as '24 0 0 0', found '}'",
                "s.jen:12:16: light 'key': at must be 3 numbers, found '}'",
                "s.jen:13:17: light 'key': intensity: expected a frame, a whole number, found '1.5'",
                "s.jen:14:18: light 'key': angle: keys must be in the order of their frames, found '4' after 4",
                "s.jen:15:5: light 'key': bank has no keys: only numbers and words have",
                "s.jen:16:12: light 'key': on must be yes or no, was 'maybe'",
                "s.jen:17:19: light 'key': samples holds until its next key, expected stepped or nothing, found 'smooth'",
                "s.jen:18:5: light 'key': unknown property 'brightness', expected one of type, color, intensity, exposure, unit, "
                        + "temperature, at, direction, falloff, attenuation, angle, dropoff, cone, cone_softness, beam_spread, doors, feather, radius, spread, width, height, up, samples, visible, on, solo, "
                        + "casts_shadows, diffuse, specular, fog, flag, flag_at, flag_rotate, flag_width, flag_height, flag_softness, flag_density, filter, filter_at, filter_rotate, filter_size, filter_softness, filter_density, filter_invert",
                "s.jen:19:13: light 'key': dropoff: expected '{' and keys, found '3'",
                "s.jen:20:5: light 'key': shadowed_by has no keys: only numbers and words have",
                "s.jen:23:17: sphere 'stem': unknown property 'top', expected one of at, rotate, scale, visible",
                "s.jen:24:3: shot: a picture has no keys, expected '}' or one of camera, world, light, bank, dome, sphere, cone, cylinder, frustum, "
                        + "plane, mesh, group",
                "s.jen:25:26: group 'tree': scale must be at least 1e-9 in absolute value on every axis, was 0");
    }

    @Test
    void missingTarget_isReportedWithLocation() {
        assertThat(problems("shot { light kye { at { 1 0 0 0 } } sphere stem { at { 1 0 0 0 } } camera { fov { 1 2 } } camera {} }"))
                .containsExactly("s.jen:7:14: there is no light 'kye' in the scene, did you mean 'key'?",
                        "s.jen:7:44: there is no sphere 'stem' in the scene",
                        "s.jen:7:91: camera must have its keys in one block, found another");
        assertThat(problems("shot { frames 9 1 }")).singleElement().asString().startsWith("s.jen:7:1: shot: the last frame must be from 9");
        assertThat(problems("shot {} shot {}")).containsExactly("s.jen:7:9: shot must be written once, found it again");
    }

    @Test
    void everyTruncatedShot_yieldsShotOrProblem() {
        String shot = "shot { frames 1 48 camera { fov { 1 40 smooth 24 30 } } light key { on { 1 yes } } }";
        for (int end = 1; end < shot.length(); end++) {
            String text = SCENE + shot.substring(0, end);
            assertThatThrownBy(() -> JenReader.read(text, "s.jen", Path.of(""))).isInstanceOf(JenException.class);
        }
    }

    @Test
    void renaming_updatesKeysAndRetainsComments() throws JenException {
        JenDocument document = read("""
                shot {
                  frames 1 9   # short
                  light key { angle { 1 20 } }  # the angle
                  frustum stem { top { 1 0.5 } }
                  light fill { on { 1 no } }
                }
                """);
        Scene scene = PropertyEdit.apply(document.scene(), "key.name=main light");
        scene = PropertyEdit.apply(scene, "stem.name=trunk");
        scene = PropertyEdit.delete(scene, "fill");
        JenDocument edited = document.withScene(scene);
        assertThat(edited.text()).contains("  frames 1 9   # short\n  light \"main light\" { angle { 1 20 } }  # the angle\n",
                "  frustum trunk { top { 1 0.5 } }\n}").doesNotContain("fill");
        assertThat(edited.shot().orElseThrow().tracks()).extracting(Track::target)
                .containsExactly(new SceneElement.OfLight("main light"), new SceneElement.OfNode("trunk"));
        assertThat(JenReader.read(edited.text(), "s.jen", Path.of("")).shot()).isEqualTo(edited.shot());
    }

    @Test
    void savedEdit_leavesShotUnchanged() throws JenException {
        JenDocument document = read("shot { light key { angle { 1 20  # narrow\n } } }\n");
        JenDocument edited = document.withScene(PropertyEdit.apply(document.scene(), "key.angle=30"));
        assertThat(edited.text()).endsWith("shot { light key { angle { 1 20  # narrow\n } } }\n");
        assertThat(edited.shot()).isEqualTo(document.shot()).isNotEqualTo(Optional.empty());
    }
}
