package lightning.base.work;

import static lightning.modelcheck.ScheduleExplorer.check;
import static lightning.modelcheck.ScheduleExplorer.explore;

import java.util.concurrent.CancellationException;
import java.util.concurrent.atomic.AtomicInteger;
import lightning.modelcheck.ScheduleExplorer;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** Model-checks the distribution of tiles to threads in all schedules. */
@Tag("model")
class WorkerPoolModelTest {
    private static final int TILES = 2;

    /** Counts writes per tile: each is written once, and never after the run. */
    private static final class TileCounter implements WorkerPool.TileTask {
        private final int[] writes = new int[TILES];
        private volatile boolean over;

        @Override
        public void run(int worker, int tile) {
            check(!over, "no thread works after the run");
            writes[tile]++;
            check(!over, "no thread works after the run");
        }

        boolean isComplete() {
            for (int count : writes) {
                if (count != 1) {
                    return false;
                }
            }
            return true;
        }

        boolean hasDuplicates() {
            for (int count : writes) {
                if (count > 1) {
                    return true;
                }
            }
            return false;
        }
    }

    /** Progress that can be canceled and counts polls. */
    private static final class CancelFlag implements Progress {
        private volatile boolean asked;
        private final AtomicInteger last = new AtomicInteger();

        @Override
        public void report(int done, int total) {
            last.accumulateAndGet(done, Math::max);
        }

        @Override
        public boolean isCanceled() {
            return asked;
        }
    }

    @Test
    void run_processesEveryTileOnceAndReportsTheLast() {
        explore(() -> {
            var tiles = new TileCounter();
            var heard = new CancelFlag();
            try (var workers = new WorkerPool(2)) {
                workers.run(TILES, tiles, heard);
                tiles.over = true;
                check(tiles.isComplete(), "every tile runs once");
                check(heard.last.get() == TILES, "the last tile is reported");
            }
        });
    }

    @Test
    void canceledRun_isCompleteOrThrows() {
        explore(() -> {
            var tiles = new TileCounter();
            var stop = new CancelFlag();
            ScheduleExplorer.ConcurrentRun other = ScheduleExplorer.startConcurrently(() -> stop.asked = true);
            try (var workers = new WorkerPool(2)) {
                workers.run(TILES, tiles, stop);
                tiles.over = true;
                check(tiles.isComplete(), "a finished run is complete");
            } catch (CancellationException e) {
                tiles.over = true;
                check(!tiles.hasDuplicates(), "no tile runs twice");
            }
            other.end();
        });
    }

    @Test
    void failure_isRethrownAfterAllWorkersStop() {
        explore(() -> {
            var tiles = new TileCounter();
            var problem = new IllegalStateException("a tile's own");
            try (var workers = new WorkerPool(2)) {
                workers.run(TILES, (worker, tile) -> {
                    tiles.run(worker, tile);
                    if (tile == 0) {
                        throw problem;
                    }
                }, Progress.NONE);
                check(false, "a failure is rethrown");
            } catch (IllegalStateException e) {
                tiles.over = true;
                check(e == problem, "the original failure is rethrown");
            }
        });
    }
}
