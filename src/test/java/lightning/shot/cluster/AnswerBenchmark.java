package lightning.shot.cluster;

import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import lightning.base.work.DedicatedThread;

/**
 * Measures how long a member takes to answer while its processors trace: once with tracing threads of normal priority, once of low
 * priority. Arguments: threads that keep the processors busy, seconds.
 */
final class AnswerBenchmark {
    private AnswerBenchmark() {}

    public static void main(String[] arguments) throws Exception {
        int busy = Integer.parseInt(arguments[0]);
        int seconds = Integer.parseInt(arguments[1]);
        Path certificate = Files.createTempDirectory("answers").resolve("shared.p12");
        SelfSignedCertificate.write(certificate);
        int port = FreePort.next();
        try (var one = new TlsNetwork(config(port, port, certificate));
                var two = new TlsNetwork(config(FreePort.next(), port, certificate))) {
            var members = new LinkedBlockingQueue<Set<ClusterMember>>();
            var answers = new LinkedBlockingQueue<byte[]>();
            one.join(new Listener(members, (_, bytes) -> answers.add(bytes)));
            two.join(new Listener(new LinkedBlockingQueue<>(), two::send));
            ClusterMember to = null;
            while (to == null) {
                to = members.take().stream().findFirst().orElse(null);
            }
            report("idle, warm-up", one, to, answers, seconds);
            report("idle", one, to, answers, seconds);
            for (int round = 0; round < 2; round++) {
                for (boolean low : new boolean[] {false, true}) {
                    ExecutorService[] threads = new ExecutorService[busy];
                    for (int i = 0; i < busy; i++) {
                        threads[i] = low ? DedicatedThread.lowPriorityExecutor("busy") : DedicatedThread.sequentialExecutor("busy");
                        threads[i].execute(() -> {
                            double x = 1;
                            while (!Thread.currentThread().isInterrupted()) {
                                x = Math.sin(x) + 1;
                            }
                        });
                    }
                    report((low ? "low" : "normal") + " priority", one, to, answers, seconds);
                    Arrays.stream(threads).forEach(ExecutorService::shutdownNow);
                }
            }
        }
    }

    private static void report(String name, TlsNetwork from, ClusterMember to, LinkedBlockingQueue<byte[]> answers, int seconds)
            throws InterruptedException {
        long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(seconds);
        double[] times = new double[1_000_000];
        int n = 0;
        while (System.nanoTime() < end) {
            long start = System.nanoTime();
            from.send(to, new byte[100]);
            if (answers.poll(30, TimeUnit.SECONDS) != null) {
                times[n++] = (System.nanoTime() - start) / 1e6;
            }
            Thread.sleep(5);
        }
        Arrays.sort(times, 0, n);
        System.out.printf(Locale.ROOT, "%-16s %5d answers, median %.2f ms, 95 %% %.2f, 99 %% %.2f, longest %.1f%n", name, n, times[n / 2],
                times[n * 95 / 100], times[n * 99 / 100], times[n - 1]);
    }

    private static NodeConfig config(int port, int join, Path certificate) {
        InetAddress loopback = InetAddress.getLoopbackAddress();
        return new NodeConfig(loopback, port, 1, List.of(new InetSocketAddress(loopback, join)), certificate, NodeConfig.Timing.DEFAULT);
    }

    private record Listener(LinkedBlockingQueue<Set<ClusterMember>> members, java.util.function.BiConsumer<ClusterMember, byte[]> received)
            implements ClusterNetwork.Listener {
        @Override
        public void messageReceived(ClusterMember from, byte[] bytes) {
            received.accept(from, bytes);
        }

        @Override
        public void membersChanged(Set<ClusterMember> others) {
            members.add(others);
        }
    }
}
