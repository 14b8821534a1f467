package lightning.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import lightning.format.image.ImageFile;
import lightning.render.image.Film;
import lightning.render.image.ViewTransform;
import lightning.sample.Slow;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Commands check, compare, explain, export, effects and tour. */
@Slow
class OtherCommandsTest {
    @TempDir
    Path folder;
    private Path scene;

    @BeforeEach
    void write() throws Exception {
        scene = CliResult.scene(folder);
    }

    private Path picture(String name, float red) throws Exception {
        Film film = Film.black(4, 3);
        film.red(0)[0] = red;
        Path file = folder.resolve(name);
        ImageFile.write(file, film, ViewTransform.DEFAULT);
        return file;
    }

    @Test
    void check_validScene_isDescribed() {
        assertThat(CliResult.run("check", scene).assertSuccess().out()).contains("no problems", "3 objects (1 cone, 1 plane, 1 sphere)",
                "3 lights (1 directional, 1 point, 1 spot)", "2 materials, 0 textures", "48 x 32 pixels, depth 2");
    }

    @Test
    void check_countsImagesOfAllKinds() throws Exception {
        for (String name : List.of("color", "glow", "bump", "normal", "cutout", "screen")) {
            ImageFile.write(folder.resolve(name + ".png"), Film.black(4, 3), ViewTransform.DEFAULT);
        }
        Files.writeString(scene, """
                jen 1
                material m { texture "color.png"  glow 1 1 1  glow_map "glow.png"  bump "bump.png" }
                material n { texture "color.png"  normal_map "normal.png"  cutout "cutout.png" }
                sphere a { material m }
                sphere b { material n }
                light screen rect { texture "screen.png" }
                """);
        assertThat(CliResult.run("check", scene).assertSuccess().out()).contains("2 materials, 6 textures");
    }

    @Test
    void check_missingImage_isAProblem() throws Exception {
        Files.writeString(scene, "jen 1\nmaterial m { texture \"none.png\" }\n");
        CliResult.run("check", scene).assertRejected(":2:22: material 'm': there is no texture 'none.png'");
    }

    @Test
    void render_missingImage_isNoted() throws Exception {
        Files.writeString(scene, "jen 1\nmaterial m { texture \"none.png\" }\n");
        assertThat(CliResult.run("render", scene, "-o", folder.resolve("a.png")).assertSuccess().err())
                .contains(":2:22: material 'm': there is no texture 'none.png' in the folder ").contains("; left out\n");
    }

    @Test
    void check_ambienceAndIndirectLight_areReported() throws Exception {
        Files.writeString(scene, "jen 1\npicture { indirect {} }\nmaterial m { ambient 1 1 1 }\nsphere a { material m }\n");
        CliResult checked = CliResult.run("check", scene).assertSuccess();
        assertThat(checked.out()).contains("no problems").hasLineCount(1);
        assertThat(checked.err()).isEqualTo(scene + ": ambience and indirect light count twice: set ambience to 0\n");
    }

    @Test
    void explainEffectsRelight_nameTheCostOfIndirectLight() throws Exception {
        Files.writeString(scene, """
                jen 1
                picture { size 24 24  depth 0  indirect { rays 16 } }
                material m {}
                sphere a { material m }
                sphere b { material m  at 1 1 0  scale 0.5 0.5 0.5 }
                light key point { at 0 3 3 }
                """);
        assertThat(CliResult.run("explain", scene, "12,12").assertSuccess().out())
                .containsPattern("indirect light of the picture: \\d+ gather points, \\d+ surfels?, \\d+ rays, \\d+ bytes");
        assertThat(CliResult.run("effects", scene, "--repetitions", "1").assertSuccess().out())
                .containsPattern("paths of indirect light +[1-9]")
                .containsPattern("weights of gather points +[1-9]").containsPattern("reflected images +0 bytes");
        assertThat(CliResult.run("relight", scene, "-o", scene.resolveSibling("out.pfm"), "--set", "a.at=0 -1 0").assertSuccess().out())
                .containsPattern("rays of indirect light");
    }

    @Test
    void check_everyProblem_hasLocation() throws Exception {
        Files.writeString(scene, "jen 1\nsphere a { scale 1 0 1 }\nlight b laser {}\n");
        CliResult refused = CliResult.run("check", scene);
        refused.assertRejected(scene + ":2:", "sphere 'a': scale", scene + ":3:9: light 'b': type");
    }

    @Test
    void compareEqual_exitsWith0() throws Exception {
        assertThat(CliResult.run("compare", picture("a.pfm", 0.5f), picture("b.pfm", 0.5f)).assertSuccess().out())
                .isEqualTo("equal: all 36 values are bit-identical\n");
    }

    @Test
    void compareDifferent_exitsWith1AndWritesDifference() throws Exception {
        Path where = folder.resolve("d.png");
        CliResult compared = CliResult.run("compare", picture("a.pfm", 0.5f), picture("b.pfm", 0.75f), "-o", where);
        assertThat(compared.exit()).isEqualTo(1);
        assertThat(compared.out())
                .startsWith("different: 1 of 12 pixels, 1 of 36 values\nlargest difference  0.250000 linear at pixel 0,0;");
        Film shown = ImageFile.read(where);
        assertThat(shown.red(0, 0)).isPositive();
        assertThat(shown.red(1, 0)).isZero();
    }

    @Test
    void compareDifferentDisplays_printsFlip() throws Exception {
        assertThat(CliResult.run("compare", picture("a.png", 0), picture("b.png", 1)).out())
                .containsPattern("PSNR \\d.*, SSIM 0\\.\\d+, FLIP 0\\.\\d+\n");
    }

    @Test
    void compareDisplays_countsLevels() throws Exception {
        String dark = CliResult.run("compare", picture("a.png", 0), picture("b.png", 1)).out();
        assertThat(dark).contains("at most 255 of 255 levels").doesNotContain("ulp");
        assertThat(CliResult.run("compare", picture("a.pfm", 0), picture("b.png", 1)).out()).contains("255 of 255 levels")
                .doesNotContain("ulp");
        assertThat(CliResult.run("compare", picture("a.exr", 0), picture("b.exr", 1)).out()).contains("255 of 255 levels")
                .doesNotContain("ulp");
    }

    @Test
    void compareFloats_countsUlps() throws Exception {
        assertThat(CliResult.run("compare", picture("a.pfm", 0.5f), picture("b.pfm", Math.nextUp(0.5f))).out())
                .contains("; at most 1 ulp").doesNotContain("levels");
    }

    @Test
    void compareInvalid_exitsWith2() throws Exception {
        Path a = picture("a.pfm", 0);
        CliResult.run("compare", a, folder.resolve("no.png")).assertRejected("no.png: no such file");
        CliResult.run("compare", a, scene).assertRejected("a.jen: an image's name must end in");
        CliResult.run("compare", a).assertRejected("b.png");
        CliResult.run("compare", a, a, "-o", folder.resolve("d.txt")).assertRejected("d.txt");
        Path small = folder.resolve("small.pfm");
        ImageFile.write(small, Film.black(1, 1), ViewTransform.DEFAULT);
        CliResult.run("compare", a, small).assertRejected("4 x 3 pixels", "1 x 1");
        Files.writeString(small, "PF but not really");
        CliResult.run("compare", a, small).assertRejected("small.pfm: ");
    }

    @Test
    void explain_listsShapeLightsAndMirror() {
        String out = CliResult.run("explain", scene, "24,26").assertSuccess().out();
        assertThat(out).contains("ground of material floor", "at ", "normal ", "lamp", "sun", "stage", "reflected ray hits", "%");
    }

    @Test
    void explainedColor_matchesRender() throws Exception {
        Path picture = folder.resolve("a.pfm");
        CliResult.run("render", scene, "-o", picture).assertSuccess();
        Film film = ImageFile.read(picture);
        for (int x = 0; x < 48; x += 7) {
            assertThat(CliResult.run("explain", scene, x + ",20").assertSuccess().out().lines().toList().getLast())
                    .startsWith("pixel: linear " + film.red(x, 20) + " " + film.green(x, 20) + " " + film.blue(x, 20) + ",");
        }
    }

    /** A mirror of 0.25 shows 0.75 of its glow, and reflects a black background. */
    @Test
    void explainedGlow_isItsOwnPart() throws Exception {
        Files.writeString(scene, """
                jen 1
                picture { size 9 9 depth 1 }
                camera { from 0 0 5 to 0 0 0 fov 20 }
                material neon { ambient 0.5 0 0  glow 1 2 4  reflective 0.25 0.25 0.25 }
                sphere ball { material neon }
                """);
        assertThat(CliResult.run("explain", scene, "4,4").assertSuccess().out()).contains(
                "ambient      adds  0.375000  0.000000  0.000000 (",
                "glow         adds  0.750000  1.500000  3.000000 (", "sum          is    1.125000  1.500000  3.000000");
    }

    @Test
    void explainedBumps_showEachStep() throws Exception {
        Files.copy(Path.of("textures/brick.png"), folder.resolve("brick.png"));
        Files.writeString(scene, """
                jen 1
                picture { size 48 32 }
                camera { from 0 5 6 to 0 0 0 fov 40 }
                material brick { bump "brick.png" height 0.4 bump_repeat 9 9 }
                plane floor { material brick scale 9 1 9 }
                light low directional { direction -1 0.05 0 }
                """);
        StringBuilder all = new StringBuilder();
        for (int x = 0; x < 48; x++) {
            all.append(CliResult.run("explain", scene, x + ",20").assertSuccess().out());
        }
        assertThat(all.toString()).contains("    geometric            0.00000 1.00000 0.00000\n", "    bump, normal map     ",
                "shadowed by floor, cosine ",
                ", below the horizon\n");
    }

    /** Edge pixels are means of several rays; the center's ray is explained. */
    @Test
    void explainedEdge_showsCenterAndRenderedColor() throws Exception {
        Path picture = folder.resolve("a.pfm");
        CliResult.run("render", scene, "-o", picture, "--antialias", "edges").assertSuccess();
        Film film = ImageFile.read(picture);
        Set<Boolean> edges = new HashSet<>();
        for (int x = 0; x < 48; x += 3) {
            List<String> lines = CliResult.run("explain", scene, x + ",20", "--antialias", "edges").assertSuccess().out().lines().toList();
            assertThat(lines.getLast())
                    .startsWith("pixel: linear " + film.red(x, 20) + " " + film.green(x, 20) + " " + film.blue(x, 20) + ",");
            edges.add(lines.get(lines.size() - 2).startsWith("center: linear "));
        }
        assertThat(edges).containsExactlyInAnyOrder(true, false);
    }

    @Test
    void explainBackground_isNamed() {
        assertThat(CliResult.run("explain", scene, "0,0").assertSuccess().out()).contains("nothing: the background");
    }

    @Test
    void explainOutside_isRejected() {
        CliResult.run("explain", scene, "48,0").assertRejected("pixel 48,0 is outside the image, expected 0,0 to 47,31");
        CliResult.run("explain", scene, "5").assertRejected("expected X,Y such as 150,230, found '5'");
        CliResult.run("explain", scene).assertRejected("X,Y");
    }

    @Test
    void export_writesSceneAndListsLosses() throws Exception {
        Path pov = folder.resolve("a.pov");
        CliResult exported = CliResult.run("export", scene, "-o", pov).assertSuccess();
        assertThat(exported.err()).contains("light lamp: attenuation", "without the limit 1");
        assertThat(Files.readString(pov)).contains("// Not exported exactly: light lamp: attenuation", "max_trace_level 3", "sphere {");
    }

    @Test
    void exportToOtherExtension_isRejected() {
        CliResult.run("export", scene, "-o", folder.resolve("a.png")).assertRejected("must end in .pov");
        CliResult.run("export", scene, "-o", folder.resolve("no/a.pov")).assertRejected("folder not found");
    }

    @Test
    void effects_listsUsersAndBytes() {
        String out = CliResult.run("effects", scene, "--size", "20x15", "--repetitions", "1").assertSuccess().out();
        assertThat(out.lines().map(line -> line.replaceAll(" +", " ")))
                .anyMatch(line -> line.matches("shadows( ~?-?[0-9.]+){4} lamp, sun, stage"))
                .anyMatch(line -> line.matches("reflections( ~?-?[0-9.]+){4} up to 2 bounces: floor"))
                .anyMatch(line -> line.matches("textures( ~?-?[0-9.]+){4} ?"))
                .contains("cylinders - - - -")
                .anyMatch(line -> line.startsWith(" total "));
    }

    @Test
    void effectsWithoutPointLight_moveAnotherLight() throws Exception {
        Files.writeString(scene, "jen 1\nsphere ball {}\nlight key rect { at 0 3 3  direction 0 -1 -1 }\n");
        assertThat(CliResult.run("effects", scene, "--size", "8x6", "--repetitions", "1").assertSuccess().out())
                .containsPattern("; update [0-9.]+ ms: key: full recompute\n");
    }

    @Test
    void effects_listEachColumnKindOnce() {
        String out = CliResult.run("effects", scene, "--size", "8x6", "--repetitions", "1").assertSuccess().out();
        assertThat(out.lines().filter(line -> line.contains(" bytes ")).map(line -> line.substring(0, 30))).doesNotHaveDuplicates();
    }

    @Test
    void effectsWithUnknownCase_isRejected() {
        CliResult.run("effects", scene, "--case", "nothing").assertRejected("--case nothing: expected one of color,");
    }

    @Test
    void tour_writesPictureForEachEdit() throws Exception {
        Path tour = folder.resolve("tour");
        String out =
                CliResult.run("tour", scene, "-o", tour, "--size", "20x15", "--repetitions", "1", "--threads", "2").assertSuccess().out();
        assertThat(out).contains("first pass", "color ", "angle-larger ", "delete ", "composite-2 ", "equal").doesNotContain(" NO");
        for (String name : new String[] {"first-pass", "color", "angle-larger", "delete", "composite-2"}) {
            assertThat(ImageFile.read(tour.resolve(name + ".png")).width()).isEqualTo(20);
        }
    }

    @Test
    void tour_staleReflections_updateMirrorsSeparately() throws Exception {
        String[] small = {"--size", "20x15", "--repetitions", "1", "-o", folder.resolve("tour").toString()};
        CliResult.run("tour", scene, small[0], small[1], small[2], small[3], small[4], small[5], "--reflections", "stale").assertSuccess();
        assertThat(folder.resolve("tour/position-mirrored.png")).exists();
        String out = CliResult.run("tour", scene, small[0], small[1], small[2], small[3], small[4], small[5]).assertSuccess().out();
        assertThat(out).contains(", reflections ").doesNotContain("its mirrors", " NO");
    }

    @Test
    void tourWithInvalidInput_isRejected() throws Exception {
        CliResult.run("tour", scene, "--repetitions", "0").assertRejected("--repetitions must be from 1 to 1000, was 0");
        CliResult.run("tour", folder.resolve("no.jen")).assertRejected("no.jen: file not found");
        CliResult.run("tour", scene, "-o", scene).assertRejected("a.jen: already exists and is not a folder");
    }
}
