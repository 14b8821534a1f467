package lightning.editor.window.timeline;

import java.util.OptionalInt;
import java.util.concurrent.atomic.AtomicBoolean;
import lightning.base.work.Workers;
import lightning.render.relight.MemoryNeed;
import lightning.render.relight.plan.Reflections;
import lightning.render.relight.tile.Options;
import lightning.scene.Picture;
import lightning.scene.Scene;
import lightning.scene.shot.Shot;
import lightning.shot.LocalKeeper;
import lightning.shot.RelitShot;
import lightning.shot.ShotListener;

/**
 * Small frames in this process, which give way to the large picture wherever that is worked at.
 *
 * @param urgent whether it is
 */
record FramesHere(RelitShot shot, AtomicBoolean urgent) implements StripFrames {
    static FramesHere of(Shot shot, Scene scene, ShotListener listener) {
        int threads = Math.max(1, Workers.available() - 1);
        var keeper = new LocalKeeper(options().withThreads(threads), bytes(scene, shot));
        var urgent = new AtomicBoolean();
        return new FramesHere(RelitShot.of(shot.first(), shot.last(), new PatientKeeper(keeper, urgent::get), listener), urgent);
    }

    private static Options options() {
        return Options.DEFAULT.withReflections(Reflections.CURRENT);
    }

    /** The most bytes that the pictures of a shot take with all that they are relit from. */
    static long bytes(Scene scene, Shot shot) {
        Scene small = FilmStrip.small(scene);
        Picture picture = small.picture();
        long each = MemoryNeed.most(small, options()) + 4L * picture.width() * picture.height();
        return each * ((long) shot.last() - shot.first() + 1);
    }

    @Override
    public Scene kept(Scene scene) {
        return FilmStrip.small(scene);
    }

    @Override
    public OptionalInt machines() {
        return OptionalInt.empty();
    }

    @Override
    public void setUrgent(boolean v) {
        urgent.set(v);
    }

    @Override
    public void close() {
        urgent.set(false);
        shot.close();
    }
}
