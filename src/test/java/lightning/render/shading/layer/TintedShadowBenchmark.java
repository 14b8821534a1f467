package lightning.render.shading.layer;

import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Locale;
import lightning.format.jen.JenReader;
import lightning.render.engine.Engine;
import lightning.render.engine.choice.Engines;
import lightning.render.image.Film;
import lightning.render.shading.AreaSamples;
import lightning.render.shading.LightSource;
import lightning.render.shading.TermKernel;
import lightning.render.shading.WeightedLight;
import lightning.render.trace.BounceKind;
import lightning.render.trace.Geometry;
import lightning.render.trace.HitRows;
import lightning.render.trace.RowShadowRays;
import lightning.render.trace.TexelColumns;
import lightning.render.trace.TileVisibility;
import lightning.render.trace.Tracer;
import lightning.scene.Scene;
import lightning.scene.effects.ViewEffects;
import lightning.scene.value.SceneLimits;

/**
 * Throughput of tinted shadow rays to the area lights of a scene, on one thread: those of all rows that a full trace without
 * anti-aliasing has, and the same rays again without those that pass through no clear shape.
 * {@code java … lightning.render.shading.layer.TintedShadowBenchmark scenes/product.jen 320 180 9 lanes}.
 */
final class TintedShadowBenchmark {
    private static final ThreadMXBean THREADS = ManagementFactory.getThreadMXBean();

    private final Scene scene;
    private final TileVisibility visibility;
    private final TermKernel terms;
    private final LightLinks links;
    private final WeightedLight[] lights;
    private final HitRows[] levels;
    private final RowShadowRays shadowRays = new RowShadowRays();
    private final int[] facing = RowBits.allocate();
    private final int[] mayFace = RowBits.allocate();
    private final int[] blocked = RowBits.allocate();
    private final int[] everyRow = RowBits.allocate();
    /** Rows with an unblocked ray for each sample, those of a single sample, and those with a ray through a clear shape. */
    private final int[][] unblocked = new int[SceneLimits.MAX_LIGHT_SAMPLES][];
    private final int[][] single = new int[SceneLimits.MAX_LIGHT_SAMPLES][];
    private final int[][] through = new int[SceneLimits.MAX_LIGHT_SAMPLES][];
    private final float[] cosine = new float[TermKernel.MAX_ROWS];
    private final double[][] sums = new double[3][TermKernel.MAX_ROWS];
    private long allRays;
    private long allTime;
    private long glassRays;
    private long glassTime;
    private double light;

    private TintedShadowBenchmark(Scene scene, Geometry geometry, WeightedLight[] lights, Engine engine) {
        this.scene = scene;
        this.lights = lights;
        Tracer tracer = engine.tracer(geometry);
        terms = engine.terms();
        links = new LightLinks(geometry, tracer, ViewEffects.ALL);
        visibility = new TileVisibility(geometry, scene, tracer);
        Arrays.fill(everyRow, -1);
        Arrays.setAll(unblocked, _ -> RowBits.allocate());
        Arrays.setAll(single, _ -> RowBits.allocate());
        Arrays.setAll(through, _ -> RowBits.allocate());
        levels = new HitRows[scene.picture().depth() + 1];
        Arrays.setAll(levels, _ -> new HitRows(Film.TILE_PIXELS, TexelColumns.COLORS, true, false, true));
    }

    /** @param args scene, width, height, rounds, {@code scalar} or {@code lanes} */
    public static void main(String[] args) throws Exception {
        Scene read = JenReader.read(Path.of(args[0])).scene();
        Scene scene = read.withPicture(read.picture().withSize(Integer.parseInt(args[1]), Integer.parseInt(args[2])));
        int rounds = Integer.parseInt(args[3]);
        var benchmark = new TintedShadowBenchmark(scene, Geometry.of(scene), WeightedLight.ofScene(scene),
                args[4].equals("lanes") ? Engines.LANES : Engines.SCALAR);
        double[] all = new double[rounds];
        double[] glass = new double[rounds];
        for (int r = -rounds / 2; r < rounds; r++) {
            benchmark.traceImage();
            if (r >= 0) {
                all[r] = 1e3 * benchmark.allRays / benchmark.allTime;
                glass[r] = 1e3 * benchmark.glassRays / benchmark.glassTime;
            }
        }
        Arrays.sort(all);
        Arrays.sort(glass);
        System.out.printf(Locale.ROOT,
                "%d rays: %.2f (%.2f to %.2f) million a second; %d of them through glass: %.2f (%.2f to %.2f); light %s%n",
                benchmark.allRays, all[rounds / 2], all[0], all[rounds - 1], benchmark.glassRays, glass[rounds / 2], glass[0],
                glass[rounds - 1], benchmark.light);
    }

    private void traceImage() {
        allRays = 0;
        allTime = 0;
        glassRays = 0;
        glassTime = 0;
        light = 0;
        for (int y = 0; y < scene.picture().height(); y += Film.TILE_SIZE) {
            for (int x = 0; x < scene.picture().width(); x += Film.TILE_SIZE) {
                visibility.traceEyeRays(x, y, Film.TILE_SIZE, (_, _, _) -> levels[0]);
                visit(0);
            }
        }
    }

    private void visit(int level) {
        HitRows rows = levels[level];
        for (WeightedLight l : lights) {
            if (rows.count > 0 && l.light().isArea()) {
                castShadowRays(rows, l.source());
            }
        }
        for (BounceKind bounce : BounceKind.values()) {
            if (level + 1 < levels.length && bounce.rowCount(rows) > 0) {
                visibility.traceBounceRays(rows, bounce, null, (_, _, _) -> levels[level + 1]);
                visit(level + 1);
            }
        }
    }

    private void castShadowRays(HitRows rows, LightSource source) {
        ShadowCaster caster = links.shadowCaster(source);
        AreaSamples samples = source.samples(rows);
        AreaSamples.writePatterns(rows, shadowRays);
        terms.addPossiblyFacing(rows, source, mayFace);
        links.retainLit(source, rows, mayFace);
        caster.aim(rows, source, shadowRays);
        for (int s = 0; caster.canBeTinted() && s < samples.samples(); s++) {
            terms.aim(rows, source, s, shadowRays, mayFace, cosine, facing);
            terms.aimShadowRays(rows, source, s, facing, shadowRays);
            for (int i = 0; i < rows.count && !shadowRays.isOffSurface; i++) {
                shadowRays.target[i] = caster.target(samples.index(s, shadowRays.pattern[i]));
            }
            caster.cast(rows, shadowRays, facing, blocked);
            for (int b = 0; b < RowBits.words(rows.count); b++) {
                facing[b] &= ~blocked[b];
            }
            System.arraycopy(facing, 0, unblocked[s], 0, RowBits.words(rows.count));
            allRays += RowBits.count(facing, rows.count);
        }
        if (!caster.canBeTinted()) {
            return;
        }
        allTime += sumTints(caster, rows, samples, unblocked);
        for (int i = 0; i < rows.count; i++) {
            light += sums[0][i] + sums[1][i] + sums[2][i];
        }
        for (int s = 0; s < samples.samples(); s++) {
            System.arraycopy(unblocked[s], 0, single[s], 0, RowBits.words(rows.count));
            sumTints(caster, rows, samples, single);
            Arrays.fill(single[s], 0);
            Arrays.fill(through[s], 0);
            for (int i = 0; i < rows.count; i++) {
                if (RowBits.contains(unblocked[s], i) && (sums[0][i] != 1 || sums[1][i] != 1 || sums[2][i] != 1)) {
                    RowBits.add(through[s], i);
                }
            }
            glassRays += RowBits.count(through[s], rows.count);
        }
        glassTime += sumTints(caster, rows, samples, through);
    }

    private long sumTints(ShadowCaster caster, HitRows rows, AreaSamples samples, int[][] rays) {
        long start = THREADS.getCurrentThreadCpuTime();
        caster.sumTints(rows, shadowRays.pattern, samples, everyRow, rays, sums);
        return THREADS.getCurrentThreadCpuTime() - start;
    }
}
