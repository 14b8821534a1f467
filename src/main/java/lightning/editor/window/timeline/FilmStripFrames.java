package lightning.editor.window.timeline;

import java.util.OptionalInt;
import lightning.scene.Scene;
import lightning.shot.ShotRelighter;

/** Where the frames of a film strip are kept. */
interface FilmStripFrames extends AutoCloseable {
    ShotRelighter shot();

    /** A scene as its frames are kept. */
    Scene frameScene(Scene scene);

    /** How many other machines hold them; empty where they are kept here. */
    OptionalInt machineCount();

    /** Whether the large picture is worked at. */
    void setPictureBusy(boolean v);

    /** Drops all; may wait for what is under way. */
    @Override
    void close();
}
