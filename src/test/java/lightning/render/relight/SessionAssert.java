package lightning.render.relight;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.function.Function;
import lightning.base.work.Progress;
import lightning.format.jen.JenWriter;
import lightning.render.RenderOptions;
import lightning.render.image.Film;
import lightning.render.image.FilmAssert;
import lightning.render.measure.AccuracyGuarantee;
import lightning.sample.EditSession;
import lightning.sample.FailedSceneRecorder;
import lightning.scene.Scene;

/** Compares films of a session; a failure saves the scenes as files next to the pictures. */
final class SessionAssert {
    private SessionAssert() {}

    /**
     * Asserts that a renderer shows the reference picture after every edit, and says that it is exact.
     *
     * @param name      test name, the folder's name in {@code target/failures}
     * @param reference returns the picture of a scene
     */
    static void assertExactAfterEveryEdit(String name, EditSession session, RenderOptions options, Function<Scene, Film> reference) {
        try (Renderer renderer = new Renderer(options)) {
            for (int step : session.steps()) {
                Scene scene = session.scenes().get(step);
                UpdateResult update = renderer.render(scene, Progress.NONE);
                assertSameBits(renderer.film(), reference.apply(scene), name, session, step, update.plan().description());
                assertThat(AccuracyGuarantee.of(renderer, update).text()).isEqualTo("exact");
            }
        }
    }

    /**
     * @param name test name, the folder's name in {@code target/failures}
     * @param step index of the edit; 0 is the first picture
     */
    static void assertSameBits(Film actual, Film expected, String name, EditSession session, int step, String plan) {
        try {
            FilmAssert.assertSameBits(actual, expected, name);
        } catch (AssertionError e) {
            Scene scene = session.scenes().get(step);
            FailedSceneRecorder.save(name, "session.txt", session.toString());
            FailedSceneRecorder.save(name, "scene.jen", JenWriter.write(scene));
            throw new AssertionError("after edit " + step + " (" + plan + "): " + e.getMessage()
                    + "\nthe scene was\n" + JenWriter.write(scene) + "\nand the session" + session, e);
        }
    }
}
