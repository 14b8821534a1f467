package lightning.render.relight;

import lightning.format.jen.JenWriter;
import lightning.render.image.Film;
import lightning.render.image.FilmAssert;
import lightning.sample.EditSession;
import lightning.sample.FailedSceneRecorder;
import lightning.scene.Scene;

/** Compares films of a session; a failure saves the scenes as files next to the pictures. */
final class SessionAssert {
    private SessionAssert() {}

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
