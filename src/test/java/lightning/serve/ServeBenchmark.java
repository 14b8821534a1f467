package lightning.serve;

import java.io.BufferedReader;
import java.io.BufferedWriter;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import lightning.base.work.Progress;
import lightning.document.EditOutcome;
import lightning.document.OpenDocument;
import lightning.format.jen.PropertyEdit;
import lightning.render.RenderOptions;
import lightning.render.relight.Renderer;

/** Latency of edits through {@code lightning serve}, next to the same edits of a document with its renderer in one process, as the editor's. */
final class ServeBenchmark {
    private static final int WARM_UP = 40;
    private static final int ROUNDS = 60;

    /** Edits that alternate, so that each changes the picture. */
    private record Case(String name, String first, String second) {}

    private ServeBenchmark() {}

    /** @param args scene, its size such as {@code 1920 1080}, a light, and threads */
    public static void main(String... args) throws Exception {
        Path scene = Path.of(args[0]);
        int threads = Integer.parseInt(args[3]);
        List<Case> cases = List.of(new Case("color", args[2] + ".color=1 0.9 0.8", args[2] + ".color=0.8 0.9 1"),
                new Case("position", args[2] + ".at=-2.3 3.6 2.6", args[2] + ".at=-2.2 3.7 2.6"));
        for (Case edit : cases) {
            double[][] times = measure(scene, args[1], threads, edit);
            System.out.printf(Locale.ROOT, "%s %s %s: editor %s ms; served in memory %s ms, of it update %s, writing %s%n", args[0],
                    args[1],
                    edit.name, text(times[0]), text(times[1]), text(times[2]), text(times[3]));
        }
    }

    /** Returns times of the editor's update, of the served one, and of its parts. They alternate, because other work disturbs them. */
    private static double[][] measure(Path file, String size, int threads, Case edit) throws Exception {
        OpenDocument document = OpenDocument.open(file);
        apply(document, "picture.size=" + size);
        List<String> command = new ArrayList<>(List.of(Path.of(System.getProperty("java.home"), "bin", "java").toString()));
        command.addAll(
                List.of("-Xmx1200m", "-Xms1200m", "--add-modules", "jdk.incubator.vector", "--enable-native-access=ALL-UNNAMED", "-cp",
                        System.getProperty("java.class.path"), "lightning.Main", "serve", "--threads", "" + threads));
        Process process = new ProcessBuilder(command).redirectError(ProcessBuilder.Redirect.DISCARD).start();
        double[][] times = new double[4][ROUNDS];
        try (Renderer renderer = new Renderer(RenderOptions.DEFAULT.withThreads(threads)); BufferedWriter to = process.outputWriter();
                BufferedReader from = process.inputReader()) {
            renderer.render(document.scene(), Progress.NONE);
            ask(to, from, "{'id':1,'method':'open','file':'" + file + "'}");
            ask(to, from, "{'id':1,'method':'set','scene':1,'edits':'picture.size=" + size + "'}");
            ask(to, from, "{'id':1,'method':'render','scene':1,'memory':true}");
            for (int i = -WARM_UP; i < ROUNDS; i++) {
                String words = i % 2 == 0 ? edit.first : edit.second;
                long start = System.nanoTime();
                apply(document, words);
                renderer.render(document.scene(), Progress.NONE);
                long middle = System.nanoTime();
                to.write(("{'id':1,'method':'set','scene':1,'edits':'" + words + "'}\n").replace('\'', '"'));
                to.write("{'id':2,'method':'render','scene':1,'memory':true}\n".replace('\'', '"'));
                to.flush();
                from.readLine();
                String answer = from.readLine();
                long end = System.nanoTime();
                if (i >= 0) {
                    var result = JsonLines.JSON.readTree(answer).get("result");
                    times[0][i] = (middle - start) / 1e6;
                    times[1][i] = (end - middle) / 1e6;
                    times[2][i] = result.get("milliseconds").asDouble();
                    times[3][i] = result.get("writing_milliseconds").asDouble();
                }
            }
        }
        return times;
    }

    private static void apply(OpenDocument document, String edit) {
        document.apply(new EditOutcome.Applied(PropertyEdit.apply(document.scene(), edit)));
    }

    private static void ask(BufferedWriter to, BufferedReader from, String request) throws IOException {
        to.write(request.replace('\'', '"') + "\n");
        to.flush();
        from.readLine();
    }

    /** Returns the smallest and the median time. */
    private static String text(double[] times) {
        double[] sorted = times.clone();
        Arrays.sort(sorted);
        return String.format(Locale.ROOT, "%.1f (median %.1f)", sorted[0], sorted[sorted.length / 2]);
    }
}
