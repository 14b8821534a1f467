package lightning.editor.window.timeline;

import java.util.Optional;
import java.util.function.BooleanSupplier;
import lightning.base.work.Progress;
import lightning.render.image.Film;
import lightning.shot.FrameKeeper;
import lightning.shot.FrameUpdate;
import lightning.shot.KeeperGoneException;
import lightning.shot.KeptBytes;
import lightning.shot.Take;

/**
 * A keeper of frames that rests, between two tiles, as long as something else is more urgent.
 *
 * @param urgent asked on the keeper's threads
 */
record PatientKeeper(FrameKeeper keeper, BooleanSupplier urgent) implements FrameKeeper {
    private static final long REST_MS = 5;

    @Override
    public FrameUpdate bring(int frame, Take take, Progress progress) throws KeeperGoneException {
        return keeper.bring(frame, take, new Progress() {
            @Override
            public void tiles(int done, int total) {
                progress.tiles(done, total);
            }

            @Override
            public boolean isCancelled() {
                while (urgent.getAsBoolean() && !progress.isCancelled()) {
                    try {
                        Thread.sleep(REST_MS);
                    } catch (InterruptedException e) {
                        Thread.currentThread().interrupt();
                        return true;
                    }
                }
                return progress.isCancelled();
            }
        });
    }

    @Override
    public Optional<Film> film(int frame) {
        return keeper.film(frame);
    }

    @Override
    public void focus(int frame) {
        keeper.focus(frame);
    }

    @Override
    public void forget(int frame) {
        keeper.forget(frame);
    }

    @Override
    public KeptBytes bytes() {
        return keeper.bytes();
    }

    @Override
    public void close() {
        keeper.close();
    }
}
