package lightning.shading;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import lightning.image.Film;
import lightning.image.FilmAssert;
import lightning.jen.JenException;
import lightning.jen.JenReader;
import lightning.jen.JenWriter;
import lightning.sample.CornerScenes;
import lightning.sample.SceneArbitraries;
import lightning.scene.Scene;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.EdgeCasesMode;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Whatever scene is accepted, its picture is made of numbers: no NaN, no infinity, nothing negative. */
class FiniteFilmTest {

    @Provide
    Arbitrary<Scene> corners() {
        return CornerScenes.scenes();
    }

    @Provide
    Arbitrary<Scene> scenes() {
        return SceneArbitraries.scenes();
    }

    @Property(edgeCases = EdgeCasesMode.NONE)
    void sceneAtTheCornersOfItsLimits_hasAFinitePicture(@ForAll("corners") Scene scene) {
        assertFinite(scene);
    }

    @Property(edgeCases = EdgeCasesMode.NONE)
    void ordinaryScene_hasAFinitePicture(@ForAll("scenes") Scene scene) {
        assertFinite(scene);
    }

    @ParameterizedTest
    @ValueSource(strings = {"turned-groups", "lost-dot"})
    void sceneThatOnceFailed_hasAFinitePicture(String name) throws IOException, JenException {
        assertFinite(read(name));
    }

    /** Diffuse ½·1, specular 1: normal, eye and light in one line, and nothing mirrored. */
    @Test
    void shapeLostBetweenDoubles_facesTheEye() throws IOException, JenException {
        assertThat(new ReferenceTracer(read("lost-dot")).pixel(0, 0)).containsExactly(1.5f, 1.5f, 1.5f);
    }

    private static Scene read(String name) throws IOException, JenException {
        return JenReader.read(Path.of("src/test/resources/lightning/numerics", name + ".jen")).scene();
    }

    /** Both tracers, and they agree. */
    static void assertFinite(Scene scene) {
        try (Workers workers = new Workers(1)) {
            Film film = new ReferenceTracer(scene).trace();
            for (float value : film.toScanlines()) {
                assertThat(value >= 0 && value <= Float.MAX_VALUE).as("a value of the film is " + value).isTrue();
            }
            FilmAssert.assertSameBits(new TraditionalTracer(scene).trace(workers, Progress.NONE).film(), film, "corner");
        } catch (AssertionError | RuntimeException e) {
            throw new AssertionError(e + "\nthe scene was\n" + JenWriter.write(scene), e);
        }
    }
}
