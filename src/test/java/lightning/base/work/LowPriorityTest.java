package lightning.base.work;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;

@EnabledOnOs(OS.LINUX)
class LowPriorityTest {
    @Test
    void lowPriorityExecutor_hasLowerPriority() throws Exception {
        int ownNice = NiceValue.ofThread();
        try (ExecutorService executor = DedicatedThread.lowPriorityExecutor("behind")) {
            for (int i = 0; i < 2; i++) {
                assertThat(executor.submit(NiceValue::ofThread).get(Await.TIMEOUT_SECONDS, TimeUnit.SECONDS))
                        .isEqualTo(Math.min(NiceValue.MAX, ownNice + 10));
            }
        }
    }

    @Test
    void otherThreads_areUnaffected() throws Exception {
        int ownNice = NiceValue.ofThread();
        try (ExecutorService executor = DedicatedThread.lowPriorityExecutor("behind")) {
            executor.submit(NiceValue::ofThread).get(Await.TIMEOUT_SECONDS, TimeUnit.SECONDS);
        }
        var rank = new CompletableFuture<Integer>();
        DedicatedThread.create("beside", () -> rank.complete(NiceValue.ofThread())).start();
        assertThat(rank.get(Await.TIMEOUT_SECONDS, TimeUnit.SECONDS)).isEqualTo(ownNice);
        assertThat(NiceValue.ofThread()).isEqualTo(ownNice);
    }
}
