package lightning.shot.cluster;

import java.io.BufferedReader;
import java.io.File;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.PrintWriter;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.concurrent.atomic.AtomicLong;
import java.util.zip.Deflater;
import lightning.base.text.ReleaseInfo;
import lightning.base.work.Progress;
import lightning.format.jen.JenDocument;
import lightning.format.jen.JenReader;
import lightning.format.jen.PropertyEdit;
import lightning.render.RenderOptions;
import lightning.render.image.Film;
import lightning.shot.FrameHost;
import lightning.shot.LocalFrameHost;
import lightning.shot.ShotListener;
import lightning.shot.ShotRelighter;
import lightning.shot.ShotRevision;

/**
 * Measures an edit without rays over frames on three nodes against three processes that receive the edits through pipes; interleaved runs,
 * medians. With {@code piped} it is such a process. Prints a table.
 *
 * <p>{@code ClusterBenchmark [WIDTH HEIGHT FRAMES EDITS NODES]}
 */
final class ClusterBenchmark {
    private static final int THREADS = 1;
    private static final long MEMORY = 1L << 30;

    private ClusterBenchmark() {}

    public static void main(String[] args) throws Exception {
        if (args.length > 0 && args[0].equals("piped")) {
            piped(Path.of(args[1]), Integer.parseInt(args[2]), Integer.parseInt(args[3]));
            return;
        }
        int width = args.length > 0 ? Integer.parseInt(args[0]) : 480;
        int height = args.length > 1 ? Integer.parseInt(args[1]) : 270;
        int frames = args.length > 2 ? Integer.parseInt(args[2]) : 24;
        int edits = args.length > 3 ? Integer.parseInt(args[3]) : 60;
        int nodes = args.length > 4 ? Integer.parseInt(args[4]) : 3;
        Path folder = Files.createTempDirectory("pace");
        Path scene = folder.resolve("scene.jen");
        Path textures = Files.createDirectory(folder.resolve("textures"));
        Files.copy(Path.of("textures/wood.png"), textures.resolve("wood.png"));
        String text = Files.readString(Path.of("scenes/bird.jen"));
        JenDocument bird = JenReader.read(text, "bird", Path.of("scenes"));
        JenDocument sized = bird.withScene(bird.scene().withPicture(bird.scene().picture().withSize(width, height)));
        var from = lightning.scene.Camera.FROM.get(bird.scene().camera());
        String keys = String.format(Locale.ROOT, "%nshot { frames 1 %d camera { from { 1 %s %s %s  %d %s %s %s } } }%n", frames, from.x(),
                from.y(),
                from.z(), frames, from.x() * 0.8, from.y(), from.z());
        Files.writeString(scene, sized.text() + keys);
        run(folder, scene, frames, edits, nodes);
    }

    /** Counts the messages and bytes of a network. */
    private record CountingNetwork(ClusterNetwork network, AtomicLong messages, AtomicLong bytes) implements ClusterNetwork {
        @Override
        public void join(Listener listener) throws JoinException {
            network.join(new Listener() {
                @Override
                public void messageReceived(ClusterMember from, byte[] received) {
                    count(received);
                    listener.messageReceived(from, received);
                }

                @Override
                public void membersChanged(Set<ClusterMember> others) {
                    listener.membersChanged(others);
                }
            });
        }

        private void count(byte[] message) {
            messages.incrementAndGet();
            bytes.addAndGet(message.length);
        }

        @Override
        public void send(ClusterMember to, byte[] sent) {
            count(sent);
            network.send(to, sent);
        }

        @Override
        public void rejoin() {
            network.rejoin();
        }

        @Override
        public String addressOf(ClusterMember member) {
            return network.addressOf(member);
        }

        @Override
        public void close() {
            network.close();
        }
    }

    private static ShotRevision revision(Path scene) throws Exception {
        JenDocument document = JenReader.read(scene);
        return new ShotRevision(document.scene(), document.shot().orElseThrow());
    }

    private static ShotRevision edited(ShotRevision revision, int edit) {
        return new ShotRevision(PropertyEdit.apply(revision.scene(), "sun.intensity=" + (0.3 + 0.01 * (edit % 50))), revision.shot());
    }

    private static void run(Path folder, Path scene, int frames, int edits, int nodes) throws Exception {
        SelfSignedCertificate.write(folder.resolve("shared.p12"));
        List<Integer> ports = new ArrayList<>();
        for (int i = 0; i < nodes; i++) {
            ports.add(FreePort.next());
        }
        List<NodeProcess> processes = new ArrayList<>();
        List<PipedProcess> pipes = new ArrayList<>();
        InetAddress loopback = InetAddress.getLoopbackAddress();
        var config = new NodeConfig(loopback, NodeConfig.CLIENT_PORT, NodeConfig.CLIENT_PORTS,
                ports.stream().map(port -> new InetSocketAddress(loopback, port)).toList(), folder.resolve("shared.p12"),
                NodeConfig.Timing.DEFAULT);
        ShotRevision revision = revision(scene);
        var network = new CountingNetwork(new TlsNetwork(config), new AtomicLong(), new AtomicLong());
        try (ShotRelighter shot = ShotRelighter.of(1, frames, ShotListener.NONE);
                NodePool machines =
                        new NodePool(network, ReleaseInfo.machineText(), scene.getParent(), shot, System.out::println)) {
            for (int port : ports) {
                processes.add(new NodeProcess(port, ports, folder, "--threads", String.valueOf(THREADS)));
            }
            machines.start();
            while (machines.count() < nodes) {
                Thread.sleep(50);
            }
            System.out.println(nodes + " nodes have joined");
            shot.setRevision(revision);
            awaitAll(shot);
            for (int i = 0; i < nodes; i++) {
                pipes.add(new PipedProcess(scene, 1 + frames * i / nodes, frames * (i + 1) / nodes));
            }
            for (PipedProcess pipe : pipes) {
                pipe.in.readLine();
            }
            double[] across = new double[edits];
            double[] alone = new double[edits];
            double[] messages = new double[edits];
            double[] bytes = new double[edits];
            for (int edit = 0; edit < 2 * edits; edit++) {
                long sent = network.messages.get();
                long length = network.bytes.get();
                long start = System.nanoTime();
                shot.setRevision(edited(revision, edit));
                awaitAll(shot);
                double first = (System.nanoTime() - start) / 1e6;
                long results = network.messages.get();
                long carried = network.bytes.get();
                start = System.nanoTime();
                for (PipedProcess pipe : pipes) {
                    pipe.out.println(edit);
                }
                for (PipedProcess pipe : pipes) {
                    pipe.in.readLine();
                }
                double second = (System.nanoTime() - start) / 1e6;
                // The first half warms up the compilers.
                if (edit >= edits) {
                    messages[edit - edits] = results - sent;
                    bytes[edit - edits] = carried - length;
                    across[edit - edits] = first;
                    alone[edit - edits] = second;
                }
            }
            double[] ratios = new double[edits];
            for (int i = 0; i < edits; i++) {
                ratios[i] = across[i] / alone[i];
            }
            System.out.printf(Locale.ROOT,
                    "%d frames on %d nodes: an edit %.1f ms, the same work by pipes %.1f ms, median of ratios %.2f%n", frames,
                    nodes, median(across), median(alone), median(ratios));
            System.out.printf(Locale.ROOT, "%.0f messages to and from the nodes, %.1f kB%n", median(messages), median(bytes) / 1e3);
            awaitFilms(shot, frames);
        } finally {
            for (NodeProcess process : processes) {
                process.kill();
            }
            for (PipedProcess pipe : pipes) {
                pipe.process.destroyForcibly();
            }
        }
    }

    private static void awaitFilms(ShotRelighter shot, int frames) throws InterruptedException {
        double[] times = new double[frames];
        Film film = null;
        for (int frame = 1; frame <= frames; frame++) {
            long start = System.nanoTime();
            film = shot.film(frame).orElse(null);
            times[frame - 1] = (System.nanoTime() - start) / 1e6;
            if (film == null) {
                // Its node is lost; another traces the frame.
                awaitAll(shot);
                frame--;
            }
        }
        byte[] bytes = FilmTiles.encode(film, 0, Math.min(FilmTiles.MAX_TILES, film.tileCount()));
        var deflater = new Deflater(Deflater.BEST_SPEED);
        byte[] packed = new byte[bytes.length * 2];
        double best = Double.MAX_VALUE;
        int length = 0;
        for (int i = 0; i < 20; i++) {
            deflater.reset();
            deflater.setInput(bytes);
            deflater.finish();
            long start = System.nanoTime();
            length = deflater.deflate(packed);
            best = Math.min(best, (System.nanoTime() - start) / 1e6);
        }
        double whole = film.tileCount() * 12288.0;
        System.out.printf(Locale.ROOT, "a film of %.1f MB comes in %.1f ms (%.0f MB/s); packed to %.0f %% at %.0f MB/s%n", whole / 1e6,
                median(times),
                whole / 1e3 / median(times), 100.0 * length / bytes.length, bytes.length / 1e3 / best);
    }

    private static double median(double[] values) {
        double[] sorted = values.clone();
        Arrays.sort(sorted);
        return sorted[sorted.length / 2];
    }

    private static void awaitAll(ShotRelighter shot) throws InterruptedException {
        while (!shot.isIdle()) {
            shot.awaitIdle();
            if (!shot.isIdle()) {
                // No node is connected at the moment.
                Thread.sleep(1);
            }
        }
    }

    /** Process that renders frames without a network. */
    private static final class PipedProcess {
        private final Process process;
        private final BufferedReader in;
        private final PrintWriter out;

        PipedProcess(Path scene, int first, int last) throws IOException {
            process = new ProcessBuilder(System.getProperty("java.home") + "/bin/java", "--add-modules", "jdk.incubator.vector",
                    "-XX:+UseSerialGC", "-XX:TieredStopAtLevel=1", "-Xmx600m", "-cp", System.getProperty("java.class.path"),
                    ClusterBenchmark.class.getName(), "piped", scene.toString(), String.valueOf(first), String.valueOf(last))
                    .redirectError(new File("/dev/null")).start();
            in = process.inputReader(StandardCharsets.UTF_8);
            out = new PrintWriter(process.outputWriter(StandardCharsets.UTF_8), true);
        }
    }

    private static void piped(Path scene, int first, int last) throws Exception {
        var in = new BufferedReader(new InputStreamReader(System.in, StandardCharsets.UTF_8));
        ShotRevision revision = revision(scene);
        try (FrameHost host = new LocalFrameHost(RenderOptions.DEFAULT.withThreads(THREADS), MEMORY)) {
            for (int frame = first; frame <= last; frame++) {
                host.update(frame, revision, Progress.NONE);
            }
            System.out.println("ready");
            for (String line = in.readLine(); line != null; line = in.readLine()) {
                ShotRevision edited = edited(revision, Integer.parseInt(line));
                for (int frame = first; frame <= last; frame++) {
                    host.update(frame, edited, Progress.NONE);
                }
                System.out.println("done");
            }
        }
    }
}
