package lightning.base.work;

import static lightning.model.Schedules.explore;
import static lightning.model.Schedules.law;

import java.util.concurrent.CancellationException;
import java.util.concurrent.atomic.AtomicInteger;
import lightning.model.Schedules;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** Tiles shared by threads, whatever these do when. */
@Tag("model")
class WorkersModelTest {
    private static final int TILES = 2;

    /** A picture of tiles, each written once, and by nobody after the run. */
    private static final class Tiles implements Workers.Task {
        private final int[] writes = new int[TILES];
        private volatile boolean over;

        @Override
        public void run(int worker, int tile) {
            law(!over, "nobody works on after the run");
            writes[tile]++;
            law(!over, "nobody works on after the run");
        }

        boolean isWhole() {
            for (int count : writes) {
                if (count != 1) {
                    return false;
                }
            }
            return true;
        }

        boolean isAnyTwice() {
            for (int count : writes) {
                if (count > 1) {
                    return true;
                }
            }
            return false;
        }
    }

    /** A progress that can be stopped, and counts. */
    private static final class Stop implements Progress {
        private volatile boolean asked;
        private final AtomicInteger last = new AtomicInteger();

        @Override
        public void tiles(int done, int total) {
            last.accumulateAndGet(done, Math::max);
        }

        @Override
        public boolean isCancelled() {
            return asked;
        }
    }

    @Test
    void run_doesEveryTileOnceAndTellsOfTheLast() {
        explore(() -> {
            var tiles = new Tiles();
            var heard = new Stop();
            try (var workers = new Workers(2)) {
                workers.run(TILES, tiles, heard);
                tiles.over = true;
                law(tiles.isWhole(), "every tile is done once");
                law(heard.last.get() == TILES, "the last tile is told of");
            }
        });
    }

    @Test
    void stopped_isWholeOrSaysThatItIsNot() {
        explore(() -> {
            var tiles = new Tiles();
            var stop = new Stop();
            Schedules.Beside other = Schedules.beside(() -> stop.asked = true);
            try (var workers = new Workers(2)) {
                workers.run(TILES, tiles, stop);
                tiles.over = true;
                law(tiles.isWhole(), "what is handed on is whole");
            } catch (CancellationException e) {
                tiles.over = true;
                law(!tiles.isAnyTwice(), "no tile is done twice");
            }
            other.end();
        });
    }

    @Test
    void failure_isHandedOnWhenNobodyWorksAnyMore() {
        explore(() -> {
            var tiles = new Tiles();
            var problem = new IllegalStateException("a tile's own");
            try (var workers = new Workers(2)) {
                workers.run(TILES, (worker, tile) -> {
                    tiles.run(worker, tile);
                    if (tile == 0) {
                        throw problem;
                    }
                }, Progress.NONE);
                law(false, "a failure is handed on");
            } catch (IllegalStateException e) {
                tiles.over = true;
                law(e == problem, "the failure itself is handed on");
            }
        });
    }
}
