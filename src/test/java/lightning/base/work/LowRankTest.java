package lightning.base.work;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;

@EnabledOnOs(OS.LINUX)
class LowRankTest {
    private static final int LOWEST = 19;

    @Test
    void whatNobodyWaitsFor_hasALowerRank() throws Exception {
        int own = rank();
        try (ExecutorService behind = OwnThread.inTurnBehind("behind")) {
            for (int i = 0; i < 2; i++) {
                assertThat(behind.submit(LowRankTest::rank).get(Wait.MOST_SECONDS, TimeUnit.SECONDS)).isEqualTo(Math.min(LOWEST, own + 10));
            }
        }
    }

    @Test
    void otherThreads_keepTheirRank() throws Exception {
        int own = rank();
        try (ExecutorService behind = OwnThread.inTurnBehind("behind")) {
            behind.submit(LowRankTest::rank).get(Wait.MOST_SECONDS, TimeUnit.SECONDS);
        }
        var rank = new CompletableFuture<Integer>();
        OwnThread.of("beside", () -> rank.complete(rank())).start();
        assertThat(rank.get(Wait.MOST_SECONDS, TimeUnit.SECONDS)).isEqualTo(own);
        assertThat(rank()).isEqualTo(own);
    }

    /** The calling thread's: the 19th field of its state, the 17th behind its name. */
    private static int rank() {
        try {
            String state = Files.readString(Path.of("/proc/thread-self/stat"));
            return Integer.parseInt(state.substring(state.lastIndexOf(')') + 2).split(" ")[16]);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
