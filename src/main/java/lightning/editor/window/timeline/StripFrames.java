package lightning.editor.window.timeline;

import java.util.OptionalInt;
import lightning.scene.Scene;
import lightning.shot.RelitShot;

/** Where the frames of a film strip are kept. */
interface StripFrames extends AutoCloseable {
    RelitShot shot();

    /** A scene as its frames are kept. */
    Scene kept(Scene scene);

    /** How many other machines hold them; empty where they are kept here. */
    OptionalInt machines();

    /** Whether the large picture is worked at. */
    void setUrgent(boolean v);

    /** Drops all; may wait for what is under way. */
    @Override
    void close();
}
