package lightning.format.jen;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.regex.Pattern;
import java.util.stream.IntStream;
import javax.imageio.ImageIO;
import lightning.format.jen.asset.TextureFolder;
import lightning.sample.TryFolder;
import lightning.scene.Scene;
import lightning.scene.asset.Texture;
import lightning.scene.asset.TextureUsage;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.lifecycle.AfterContainer;
import net.jqwik.api.lifecycle.BeforeContainer;
import org.assertj.core.api.Assertions;

/** Invariants of writing and saving, over random scenes and edits. */
class SavingInvariantsTest {
    private static TryFolder files;
    private static List<Texture> images;
    private static List<Texture> numbers;
    private static List<Texture> opacities;

    @BeforeContainer
    static void writeTextures() throws Exception {
        files = new TryFolder();
        images = new ArrayList<>();
        numbers = new ArrayList<>();
        opacities = new ArrayList<>();
        var loader = new TextureFolder(files.path());
        for (int i = 0; i < RandomScenes.TEXTURES.size(); i++) {
            Path file = files.file(RandomScenes.TEXTURES.get(i));
            Files.createDirectories(file.getParent());
            var image = new BufferedImage(1 + i, 2, BufferedImage.TYPE_INT_RGB);
            image.setRGB(0, 1, 0x102030 * (i + 1));
            ImageIO.write(image, "png", file.toFile());
            images.add(loader.load(RandomScenes.TEXTURES.get(i), TextureUsage.COLOR, Assertions::fail));
            numbers.add(loader.load(RandomScenes.TEXTURES.get(i), TextureUsage.DATA, Assertions::fail));
            opacities.add(loader.load(RandomScenes.TEXTURES.get(i), TextureUsage.OPACITY, Assertions::fail));
        }
    }

    @AfterContainer
    static void removeTextures() throws IOException {
        files.close();
    }

    @Property
    void scene_roundTrips(@ForAll long seed) throws JenException {
        Scene scene = new RandomScenes(new Random(seed), images, numbers, opacities).scene();
        assertThat(read(JenWriter.write(scene))).isEqualTo(scene);
    }

    @Property
    void savedEdit_roundTrips(@ForAll long seed) throws JenException {
        var random = new Random(seed);
        var scenes = new RandomScenes(random, images, numbers, opacities);
        Scene scene = scenes.scene();
        JenDocument document = JenReader.read(new TextReformatter(random).reformat(JenWriter.write(scene)), "s.jen", files.path());
        assertThat(document.scene()).isEqualTo(scene);
        for (int i = 0; i < 3; i++) {
            scene = scenes.edited(scene);
            document = document.withScene(scene);
            assertThat(document.scene()).isEqualTo(scene);
            assertThat(read(document.text())).isEqualTo(scene);
        }
    }

    @Property
    void nonDeletingEdit_retainsComments(@ForAll long seed) throws JenException {
        var random = new Random(seed);
        var scenes = new RandomScenes(random, images, numbers, opacities);
        Scene scene = scenes.scene();
        JenDocument document = JenReader.read(new TextReformatter(random).reformat(JenWriter.write(scene)), "s.jen", files.path());
        List<lightning.scene.light.Light> lights = new ArrayList<>(scene.lights());
        java.util.Collections.shuffle(lights, random);
        lights.replaceAll(l -> l.withIntensity(l.intensity() + 1).withSolo(!l.solo()));
        lights.add(random.nextInt(lights.size() + 1), lightning.scene.light.Light.of("new-one", lightning.scene.light.LightType.SPOT));
        String edited = document.withScene(scene.withLights(lights).withWorld(scene.world().withAmbience(7))).text();
        assertThat(comments(edited)).containsExactlyInAnyOrderElementsOf(comments(document.text()));
    }

    @Property
    void editedNumber_changesOneToken(@ForAll long seed) throws JenException {
        var random = new Random(seed);
        Scene scene = new RandomScenes(random, images, numbers, opacities).scene();
        scene = scene.withWorld(scene.world().withAmbience(0.25));
        JenDocument document = JenReader.read(new TextReformatter(random).reformat(JenWriter.write(scene)), "s.jen", files.path());
        String before = document.text();
        String after = document.withScene(scene.withWorld(scene.world().withAmbience(123.75))).text();
        TokenList tokens = Lexer.tokens(before, new ProblemList());
        int changed = IntStream.range(0, tokens.size()).filter(i -> tokens.text(i).equals("ambience")).findFirst().orElseThrow() + 1;
        assertThat(after).isEqualTo(before.substring(0, tokens.start(changed)) + "123.75" + before.substring(tokens.end(changed)));
    }

    private static Scene read(String text) throws JenException {
        return JenReader.read(text, "s.jen", files.path()).scene();
    }

    private static List<String> comments(String text) {
        return Pattern.compile("# comment[^\n]*").matcher(text).results().map(r -> r.group().strip()).toList();
    }
}
