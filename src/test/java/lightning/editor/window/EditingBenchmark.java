package lightning.editor.window;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Random;
import java.util.concurrent.Callable;
import java.util.concurrent.FutureTask;
import java.util.function.IntConsumer;
import java.util.function.IntToDoubleFunction;
import java.util.stream.IntStream;
import javafx.application.Platform;
import javafx.stage.Stage;
import lightning.base.math.Vec3;
import lightning.base.work.Progress;
import lightning.document.FileThread;
import lightning.document.LightEdits;
import lightning.document.NodeEdits;
import lightning.document.OpenDocument;
import lightning.document.RecoveryFolder;
import lightning.editor.Command;
import lightning.editor.window.command.FilePrompt;
import lightning.editor.window.model.EditorModel;
import lightning.editor.window.model.Preferences;
import lightning.editor.window.widget.ColorTheme;
import lightning.render.RenderOptions;
import lightning.render.relight.Renderer;
import lightning.scene.Camera;
import lightning.scene.Scene;
import lightning.scene.effects.PreviewScene;
import lightning.scene.effects.ViewEffects;
import lightning.scene.value.Placement;

/**
 * Measures the cost of editing in the real editor for scenes of any size, one line of results per edit. Arguments: number of shapes, number
 * of lights. Measures the processor time of the window's thread only, so that other work on the machine has little effect. {@code lightning
 * bench --editing} measures the code below the window.
 */
public final class EditingBenchmark {
    private static final int SAMPLES = 41;
    private static final int WARM_UPS = 40;
    private static final long PAUSE_MS = 120;

    private final int shapes;
    private final int lights;
    private final Path folder;

    private EditingBenchmark(int shapes, int lights) throws Exception {
        this.shapes = shapes;
        this.lights = lights;
        folder = Files.createTempDirectory("lightning-pace");
    }

    public static void main(String[] args) throws Exception {
        new EditingBenchmark(Integer.parseInt(args[0]), Integer.parseInt(args[1])).run();
        System.exit(0);
    }

    private void run() throws Exception {
        Path file = Files.writeString(folder.resolve("scene.jen"), text());
        OpenDocument document = OpenDocument.open(file);
        Scene scene = document.scene();
        if (lights <= 10) {
            orbit(scene);
        }
        measureWindow(document);
    }

    private static void orbit(Scene scene) {
        PreviewScene.Request request = new PreviewScene().request(scene, scene.lights().getFirst().name(), ViewEffects.PREVIEW, true);
        try (var preview = new Renderer(RenderOptions.DEFAULT.withView(request.effects()))) {
            Camera camera = scene.camera();
            print("orbit frame of the preview", median(i -> timed(() -> preview.render(request.scene().withCamera(
                    camera.withView(camera.from().plus(new Vec3(0.01 * (i + WARM_UPS + 1), 0, 0)), camera.to(), camera.up())
                            .withOrigin(camera.origin())),
                    Progress.NONE))),
                    "ms");
        }
    }

    private void measureWindow(OpenDocument document) throws Exception {
        Platform.startup(() -> {});
        var thread = new FileThread(Platform::runLater);
        Editor editor = onFxThread(() -> {
            ColorTheme.DARK.apply();
            var stage = new Stage();
            var preferences = new Preferences(folder.resolve("own"), thread);
            var sight = TestEditors.startupSession(document, TestEditors.layout(document.file()), preferences,
                    new RecoveryFolder(folder.resolve("kept")),
                    thread);
            return new Editor(stage, sight, preferences, thread, FilePrompt.ofSystem(stage), 1400, 900);
        });
        EditorModel model = editor.model();
        while (onFxThread(() -> model.editor().editorStateProperty().get().hasPendingEdits()
                || model.editor().editorStateProperty().get().sceneInProgress().isPresent())) {
            Thread.sleep(PAUSE_MS);
        }
        Thread.sleep(20 * PAUSE_MS);
        String light = model.editor().scene().lights().getFirst().name();
        measure("a light's intensity", model,
                i -> model.editor().edit(scene -> LightEdits.edit(scene, light, l -> l.withIntensity(1 + 0.01 * i))));
        String ball = "b" + shapes / 2;
        onFxThread(() -> {
            model.editor().selection().selectNode(ball);
            return null;
        });
        measure("a shape moved", model, i -> model.editor().edit(scene -> NodeEdits.setPlacement(scene, ball,
                p -> new Placement(p.position().plus(new Vec3(0, 0.0001, 0)), p.rotation(), p.scale()))));
        measure("hidden or shown", model, i -> model.editor().edit(scene -> NodeEdits.setVisible(scene, ball, i % 2 == 0)));
        measure("renamed", model,
                i -> model.editor().edit(scene -> NodeEdits.rename(scene, i == 0 ? ball : ball + "_" + (i - 1), ball + "_" + i)));
        String renamed = ball + "_" + (SAMPLES + WARM_UPS - 1);
        measure("copied", model, _ -> model.editor().selection().selectNode(renamed), _ -> model.commands().run(Command.DUPLICATE_SHAPE));
        measure("deleted", model, i -> model.editor().selection().selectNode("b" + (shapes / 3 + i)),
                _ -> model.commands().run(Command.DELETE_SHAPE));
        measure("another selected", model, i -> model.editor().selection().selectNode("b" + (shapes / 4 + i)));
    }

    /**
     * Measures an edit.
     *
     * @param edit receives the index of the edit, from 0
     */
    private static void measure(String title, EditorModel model, IntConsumer edit) throws Exception {
        measure(title, model, _ -> {}, edit);
    }

    /**
     * Measures an edit with a setup.
     *
     * @param setup runs before each edit and is not measured
     */
    private static void measure(String title, EditorModel model, IntConsumer setup, IntConsumer edit) throws Exception {
        long id = onFxThread(() -> Thread.currentThread().threadId());
        var threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
        double[] handler = new double[SAMPLES];
        double[] all = new double[SAMPLES];
        for (int i = -WARM_UPS; i < SAMPLES; i++) {
            int number = i + WARM_UPS;
            onFxThread(() -> {
                setup.accept(number);
                return null;
            });
            Thread.sleep(PAUSE_MS);
            long start = threads.getThreadCpuTime(id);
            long end = onFxThread(() -> {
                edit.accept(number);
                return threads.getThreadCpuTime(id);
            });
            Thread.sleep(PAUSE_MS);
            handler[Math.max(i, 0)] = (end - start) / 1e6;
            all[Math.max(i, 0)] = (threads.getThreadCpuTime(id) - start) / 1e6;
        }
        print(title + ", the edit itself", median(handler), "ms of processor time");
        print(title + ", with layout and pictures", median(all), "ms of processor time");
    }

    private static <T> T onFxThread(Callable<T> task) throws Exception {
        var future = new FutureTask<>(task);
        Platform.runLater(future);
        return future.get();
    }

    private static void print(String title, double value, String unit) {
        System.out.printf(Locale.ROOT, "%-55s %10.3f %s%n", title, value, unit);
    }

    private static double elapsedMs(long start) {
        return (System.nanoTime() - start) / 1e6;
    }

    private static double timed(Runnable work) {
        long start = System.nanoTime();
        work.run();
        return elapsedMs(start);
    }

    /**
     * Returns the median of several samples.
     *
     * @param sample receives the sample's index; indices below 0 are warm-ups
     */
    private static double median(IntToDoubleFunction sample) {
        double[] times = new double[SAMPLES];
        for (int i = -WARM_UPS; i < SAMPLES; i++) {
            times[Math.max(i, 0)] = sample.applyAsDouble(i);
        }
        return median(times);
    }

    private static double median(double[] values) {
        return Arrays.stream(values).sorted().toArray()[values.length / 2];
    }

    /** Returns a scene of spheres that fill a tenth of a block above a floor, under lights of all types. */
    private String text() {
        var random = new Random(1);
        double radius = Math.cbrt(0.1 * 108 / (Math.max(shapes - 1, 1) * 4 / 3.0 * Math.PI));
        var text = new StringBuilder("jen 1\npicture { size 300 300  depth 2 }\ncamera { from 0 3 9  to 0 1.5 0  up 0 1 0  fov 40 }\n")
                .append("plane floor { scale 20 1 20 }\n");
        IntStream.range(1, shapes).forEach(i -> text.append(String.format(Locale.ROOT,
                "sphere b%d { at %.3f %.3f %.3f  scale %.4f %.4f %.4f }%n", i, 6 * (random.nextDouble() - 0.5),
                radius + 3 * random.nextDouble(), 6 * (random.nextDouble() - 0.5), radius, radius, radius)));
        IntStream.range(0, lights).forEach(i -> text.append(String.format(Locale.ROOT,
                "light light%d %s { intensity %.5f  at %.3f %.3f %.3f  direction 0 -1 0.1  attenuation 0.5 0.05 0.01 }%n", i,
                List.of("point", "directional", "spot").get(i % 3), 2.0 / lights, 10 * (random.nextDouble() - 0.5),
                4 + 4 * random.nextDouble(), 10 * (random.nextDouble() - 0.3))));
        return text.toString();
    }
}
