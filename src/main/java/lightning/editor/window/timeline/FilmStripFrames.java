package lightning.editor.window.timeline;

import java.util.OptionalInt;
import lightning.scene.Scene;
import lightning.shot.ShotRelighter;

/** Source of a film strip's frames: this process or other machines. */
interface FilmStripFrames extends AutoCloseable {
    ShotRelighter shot();

    /** Returns the scene at the size at which frames are rendered. */
    Scene frameScene(Scene scene);

    /** Returns the number of connected machines; empty if the frames are rendered locally. */
    OptionalInt machineCount();

    /** Sets whether the main picture is being rendered, which has priority. */
    void setPictureBusy(boolean v);

    /** Drops all frames. May block until running work stops. */
    @Override
    void close();
}
