package lightning.bench;

import java.io.IOException;
import java.util.Optional;
import lightning.base.work.Progress;
import lightning.base.work.Workers;
import lightning.bench.accuracy.SavingMeter;
import lightning.bench.accuracy.TurnTimes;
import lightning.format.pov.PovRay;
import lightning.format.pov.PovScene;
import lightning.render.fulltrace.TraditionalTracer;
import lightning.render.image.Film;
import lightning.render.image.ViewTransform;
import lightning.render.relight.tile.Options;
import lightning.scene.Scene;

/** Measures POV-Ray beside our full trace, and compares what the two see. */
final class PovPeer {
    static final String PROGRAM = "POV-Ray 3.7";
    private static final String MEASURE = "pixels that show the same shape (or background), each shape in a flat colour of its own";
    private static final int REPETITIONS = 3;
    /** Warming up, starting the program, and the picture of flat colours, as traces. */
    private static final int FURTHER_TRACES = 6;
    /** It is about so many times as slow as our full trace of the same scene. */
    private static final double SLOWER = 10;
    private static final double START_MS = 300;

    private final PovRay povRay;

    private PovPeer(PovRay povRay) {
        this.povRay = povRay;
    }

    /** The installed POV-Ray, if there is one. */
    static Optional<PovPeer> find() {
        return PovRay.find().map(PovPeer::new);
    }

    /** What is to be measured; where POV-Ray fails, that becomes a problem. */
    Part part(Settings settings, Ledger ledger, Ledger.Page page, NamedScene scene, PictureSize size, Pace pace) {
        int traces = REPETITIONS + FURTHER_TRACES;
        String where = scene.name() + " at " + size + ", " + PROGRAM;
        return new Part(where, traces * (SLOWER * pace.fullMs(size) + START_MS), progress -> {
            try {
                page.peer(measure(size.of(scene.scene()), settings.threads(), progress.silent()));
            } catch (IOException e) {
                ledger.problem(new Failure(Failure.Kind.UNMEASURED, where, e.getMessage()));
            }
        });
    }

    private Peer measure(Scene scene, int threads, Progress progress) throws IOException, InterruptedException {
        PovScene exported = PovScene.of(scene, "scene");
        int width = scene.picture().width();
        int height = scene.picture().height();
        try (SavingMeter meter = new SavingMeter(Options.DEFAULT.withThreads(threads), REPETITIONS, 0, 1)) {
            TurnTimes times = meter.against(scene, () -> povRay.traceMs(exported, width, height, threads), progress);
            return new Peer(PROGRAM, Samples.of(times.rival()), Samples.of(times.full()), times.ratio(),
                    agreement(FlatColors.of(scene), threads, progress), MEASURE, exported.losses());
        } catch (IOException | InterruptedException | RuntimeException e) {
            throw e;
        } catch (Exception e) {
            throw new IllegalStateException("a trace throws nothing else", e);
        }
    }

    private double agreement(Scene flat, int threads, Progress progress) throws IOException, InterruptedException {
        Film theirs = povRay.picture(PovScene.of(flat, "flat"), flat.picture().width(), flat.picture().height(), threads);
        try (Workers workers = new Workers(threads)) {
            return agreement(new TraditionalTracer(flat).trace(workers, progress).film(), theirs);
        }
    }

    /** The share of pixels, 0…1, whose display codes are nearer than two colours can be. */
    static double agreement(Film ours, Film theirs) {
        int[] a = ViewTransform.DEFAULT.toPixels(ours);
        int[] b = ViewTransform.DEFAULT.toPixels(theirs);
        int same = 0;
        for (int i = 0; i < a.length; i++) {
            same += isNear(a[i], b[i]) && isNear(a[i] >> 8, b[i] >> 8) && isNear(a[i] >> 16, b[i] >> 16) ? 1 : 0;
        }
        return (double) same / a.length;
    }

    private static boolean isNear(int a, int b) {
        return 2 * Math.abs((a & 0xFF) - (b & 0xFF)) < FlatColors.STEP;
    }
}
