package lightning.editor.loop;

import lightning.base.work.Progress;
import lightning.render.relight.tile.Options;
import lightning.scene.Scene;

/**
 * What a render loop shall do next: of each kind of work the newest, so that edits made while a picture is rendered cost
 * one update and not one each. Safe for several threads.
 */
final class RenderQueue {
    /** One piece of work. */
    public sealed interface Work {
        record Render(Scene scene) implements Work {}

        record Reflections() implements Work {}

        /** The finer samples that a picture lacks. */
        record Finish() implements Work {}

        record Verify() implements Work {}

        /** All that is known of the picture is dropped for a document of that number. */
        record Forget(long number) implements Work {}

        /** The picture that there is, to be looked at in another way. */
        public record Looks() implements Work {}

        /** Another renderer, then {@code scene}; null where nothing was rendered yet. */
        record Reopen(Options options, Scene scene) implements Work {}
    }

    /** Hears how far it is. */
    interface Tiles {
        void tiles(int done, int total);
    }

    /** Stops one piece of work. */
    static final class Stop implements Progress {
        private final Tiles hears;
        private volatile boolean asked;
        private volatile boolean gaveWay;

        Stop(Tiles hears) {
            this.hears = hears;
        }

        void ask() {
            gaveWay = false;
            asked = true;
        }

        /** Stops a work that is taken up again after another: nobody needs to hear of it. */
        void giveWay() {
            gaveWay = !asked;
            asked = true;
        }

        boolean gaveWay() {
            return gaveWay;
        }

        @Override
        public void tiles(int done, int total) {
            hears.tiles(done, total);
        }

        @Override
        public boolean isCancelled() {
            return asked;
        }
    }

    private Scene scene;
    private Options options;
    private boolean reflections;
    private boolean finish;
    private boolean verify;
    private boolean look;
    private boolean forget;
    private long opened;
    private boolean closed;
    private Work running;
    private Scene rendered;
    private Stop stop;

    synchronized void render(Scene wanted) {
        scene = wanted;
        if (wanted != rendered) {
            finishLater();
        }
        if (isUselessFor(wanted)) {
            // The mirrors are still wanted, of the newer scene.
            reflections |= running instanceof Work.Reflections;
            stop.ask();
        }
        notifyAll();
    }

    /** An update is left to finish, or dragging would starve the picture; a trace of another picture is not. */
    private boolean isUselessFor(Scene wanted) {
        return switch (running) {
            case null -> false;
            case Work.Render r -> !r.scene().hasSameView(wanted);
            case Work.Reopen r -> r.scene() != null && !r.scene().hasSameView(wanted);
            case Work.Reflections _ -> true;
            case Work.Finish _,Work.Verify _,Work.Looks _,Work.Forget _ -> false;
        };
    }

    synchronized void reflections() {
        reflections = true;
        notifyAll();
    }

    /** The picture lacks samples: they are made when nothing else of it is to be done. */
    synchronized void finish() {
        finish = true;
        notifyAll();
    }

    /** Other work comes before samples, which nobody can see to be begun. */
    private void finishLater() {
        if (running instanceof Work.Finish) {
            finish = true;
            stop.giveWay();
        }
    }

    synchronized void verify() {
        verify = true;
        notifyAll();
    }

    synchronized void look() {
        look = true;
        finishLater();
        notifyAll();
    }

    /** What waits, what runs and what is known is of no use any more. */
    synchronized void open(Scene wanted, long number) {
        cancel();
        forget = true;
        opened = number;
        render(wanted);
    }

    synchronized void reopen(Options wanted) {
        options = wanted;
        finishLater();
        notifyAll();
    }

    /** At once, so that nobody sees the old scene in the new way between. */
    synchronized void reopen(Options wanted, Scene wantedScene) {
        reopen(wanted);
        render(wantedScene);
    }

    /** Forgets what waits and stops what runs; returns whether a scene waited, of which nobody else hears. */
    synchronized boolean cancel() {
        boolean waited = scene != null;
        scene = null;
        reflections = false;
        finish = false;
        verify = false;
        if (stop != null) {
            stop.ask();
        }
        return waited;
    }

    synchronized void close() {
        closed = true;
        cancel();
        notifyAll();
    }

    synchronized boolean isBusy() {
        return running != null || isWaiting();
    }

    /** Whether a verification waits or is about to be handed on. */
    synchronized boolean isVerifying() {
        return verify || running instanceof Work.Verify;
    }

    private boolean isWaiting() {
        return scene != null || options != null || reflections || look || finish || verify || forget;
    }

    /** Waits for work; returns null when the queue was closed. */
    synchronized Work take(Stop newStop) throws InterruptedException {
        while (!closed && !isWaiting()) {
            wait();
        }
        if (closed) {
            return null;
        }
        stop = newStop;
        running = next();
        return running;
    }

    private Work next() {
        if (forget) {
            forget = false;
            return new Work.Forget(opened);
        }
        if (options != null) {
            var work = new Work.Reopen(options, scene == null ? rendered : scene);
            options = null;
            scene = null;
            return work;
        }
        if (scene != null) {
            var work = new Work.Render(scene);
            scene = null;
            return work;
        }
        if (reflections) {
            reflections = false;
            return new Work.Reflections();
        }
        if (look) {
            look = false;
            return new Work.Looks();
        }
        if (finish) {
            finish = false;
            return new Work.Finish();
        }
        verify = false;
        return new Work.Verify();
    }

    /**
     * The work is over.
     *
     * @param nowRendered the scene that the picture shows now; null where there is none
     * @return whether nothing is left
     */
    synchronized boolean done(Scene nowRendered) {
        running = null;
        stop = null;
        rendered = nowRendered;
        return !isWaiting();
    }
}
