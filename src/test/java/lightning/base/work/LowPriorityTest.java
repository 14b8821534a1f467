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
class LowPriorityTest {
    private static final int MAX_NICE = 19;

    @Test
    void lowPriorityExecutor_hasLowerPriority() throws Exception {
        int ownNice = niceValue();
        try (ExecutorService executor = DedicatedThread.lowPriorityExecutor("behind")) {
            for (int i = 0; i < 2; i++) {
                assertThat(executor.submit(LowPriorityTest::niceValue).get(Await.TIMEOUT_SECONDS, TimeUnit.SECONDS))
                        .isEqualTo(Math.min(MAX_NICE, ownNice + 10));
            }
        }
    }

    @Test
    void otherThreads_areUnaffected() throws Exception {
        int ownNice = niceValue();
        try (ExecutorService executor = DedicatedThread.lowPriorityExecutor("behind")) {
            executor.submit(LowPriorityTest::niceValue).get(Await.TIMEOUT_SECONDS, TimeUnit.SECONDS);
        }
        var rank = new CompletableFuture<Integer>();
        DedicatedThread.create("beside", () -> rank.complete(niceValue())).start();
        assertThat(rank.get(Await.TIMEOUT_SECONDS, TimeUnit.SECONDS)).isEqualTo(ownNice);
        assertThat(niceValue()).isEqualTo(ownNice);
    }

    /** Returns the nice value of the calling thread: field 19 of its stat file, the 17th after its name. */
    private static int niceValue() {
        try {
            String state = Files.readString(Path.of("/proc/thread-self/stat"));
            return Integer.parseInt(state.substring(state.lastIndexOf(')') + 2).split(" ")[16]);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
