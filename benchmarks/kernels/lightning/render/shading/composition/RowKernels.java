package lightning.render.shading.composition;

import java.nio.file.Path;
import java.util.concurrent.TimeUnit;
import lightning.base.math.PowerFunction;
import lightning.format.jen.JenReader;
import lightning.render.engine.choice.Engines;
import lightning.render.engine.lanes.PowerLanes;
import lightning.render.relight.paper.RatioKernel;
import lightning.render.relight.paper.RatioRows;
import lightning.render.shading.FilmParts;
import lightning.render.shading.KernelReferenceRows;
import lightning.render.shading.TermKernel;
import lightning.render.shading.WeightedLight;
import lightning.render.shading.layer.ColumnAllocator;
import lightning.render.shading.layer.ConeChange;
import lightning.render.shading.layer.LightKernel;
import lightning.render.shading.layer.LightLayer;
import lightning.render.shading.layer.LightRows;
import lightning.render.trace.BounceKind;
import lightning.render.trace.Geometry;
import lightning.render.trace.HitRows;
import lightning.render.trace.TileVisibility;
import lightning.render.trace.Tracer;
import lightning.scene.Scene;
import lightning.scene.effects.ViewEffects;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OperationsPerInvocation;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;

/** Benchmark in nanoseconds per row of the kernels that edits run on the rows of a full tile, in the CPU cache. */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
@Warmup(iterations = 5, time = 1)
@Measurement(iterations = 5, time = 1)
@Fork(1)
public class RowKernels {
    private static final int ROWS = 1024;
    private static final double EXPONENT = 37.25;

    @Param({"bird", "balls"})
    public String scene;

    private final TermKernel terms = Engines.LANES.terms();
    private final float[] falloff = new float[ROWS];
    private final double[] bases = new double[ROWS];
    private final double[] powers = new double[ROWS];
    private Scene loadedScene;
    private HitRows rows;
    private TileComposer composer;
    private FilmMixer mixer;
    private FilmParts parts;
    private final FilmColors films = new FilmColors();
    private final FilmColors[] images = {new FilmColors(), new FilmColors()};
    private final float[][] colors = new float[3][ROWS];
    private LightKernel light;
    private RatioKernel ratio;
    private LightLayer[] layers;
    private float[][] mirrored;
    private WeightedLight spot;
    private WeightedLight brighter;
    private RatioRows contributions;

    /** Finds a tile, and fails if a kernel disagrees with the scalar code. */
    @Setup
    public void prepare() throws Exception {
        loadedScene = JenReader.read(Path.of("scenes", scene + ".jen")).scene();
        Geometry geometry = Geometry.of(loadedScene);
        Tracer tracer = Engines.LANES.tracer(geometry);
        composer = new TileComposer(loadedScene, geometry.materials(), Engines.LANES.sums(), ViewEffects.ALL);
        light = new LightKernel(geometry, tracer, Engines.LANES.terms(), ViewEffects.ALL);
        ratio = new RatioKernel(light);
        parts = FilmParts.of(loadedScene);
        mixer = new FilmMixer(parts, null, -1);
        WeightedLight[] lights = parts.lights();
        Light first = loadedScene.lights().stream().filter(l -> l.type() == LightType.SPOT).findFirst().orElseThrow();
        spot = WeightedLight.of(first, loadedScene);
        brighter = WeightedLight.of(first.withIntensity(1.25 * first.intensity()), loadedScene);
        findTile(new TileVisibility(geometry, loadedScene, tracer));
        layers = new LightLayer[lights.length];
        for (int i = 0; i < lights.length; i++) {
            layers[i] = light.recompute(rows, lights[i].source(), ColumnAllocator.NEW_ARRAYS);
        }
        mirrored = new float[3][HitRows.paddedLength(rows.count)];
        for (int i = 0; i < ROWS; i++) {
            bases[i] = (i + 0.5) / ROWS;
            mirrored[i % 3][i] = i / 1024f;
        }
        for (FilmColors image : images) {
            image.clear(parts.count());
        }
        for (int film = 0; film < parts.count(); film++) {
            for (int c = 0; c < 3; c++) {
                System.arraycopy(mirrored[c], 0, images[BounceKind.MIRRORED.ordinal()].toWrite(film)[c], 0, ROWS);
            }
        }
        new KernelReferenceRows(rows, geometry).require(this);
    }

    /** Finds the first tile of 1024 rows that the spot light illuminates partly. */
    private void findTile(TileVisibility visibility) {
        for (int y = 0; y + 32 <= loadedScene.picture().height(); y += 32) {
            for (int x = 0; x + 32 <= loadedScene.picture().width(); x += 32) {
                rows = visibility.traceEyeRays(x, y, 32, (count, textured, clear) -> new HitRows(count, textured, clear, false, false));
                if (rows.count == ROWS) {
                    contributions = ratio.recompute(rows, spot);
                    if (contributions.litCount() > ROWS / 4 && contributions.litCount() < ROWS) {
                        return;
                    }
                }
            }
        }
        throw new IllegalStateException(scene + " has no full tile that its spot light illuminates partly");
    }

    public WeightedLight spot() {
        return spot;
    }

    public FilmParts parts() {
        return parts;
    }

    public LightLayer[] layers() {
        return layers;
    }

    public float[][] mirrored() {
        return mirrored;
    }

    public RatioRows contributions() {
        return contributions;
    }

    public float intensityRatio() {
        return brighter.diffuse().red() / spot.diffuse().red();
    }

    public double power(int i) {
        return PowerFunction.pow(bases[i], EXPONENT);
    }

    /** Composes all films and adds them to linear colors. */
    @Benchmark
    @OperationsPerInvocation(ROWS)
    public Object compose() {
        films.clear(mixer.films());
        composer.composeLevel(rows, parts, parts.shining(), layers, null, images, films);
        mixer.mix(films::get, colors);
        return colors;
    }

    public float[][] composed() {
        compose();
        return colors;
    }

    /** Computes the falloff column of a spot light: attenuation and dropoff. */
    @Benchmark
    @OperationsPerInvocation(ROWS)
    public float[] attenuation() {
        terms.aim(rows, spot.source());
        terms.computeConeCosines(rows, spot.source());
        terms.falloffs(rows, spot.source(), falloff);
        return falloff;
    }

    /** Computes a spot light's whole layer, including shadow rays. */
    @Benchmark
    @OperationsPerInvocation(ROWS)
    public LightRows reshade() {
        return light.recompute(rows, spot.source(), ColumnAllocator.NEW_ARRAYS);
    }

    /** Computes x to the power 37.25. */
    @Benchmark
    @OperationsPerInvocation(ROWS)
    public double[] power() {
        System.arraycopy(bases, 0, powers, 0, ROWS);
        PowerLanes.of(powers, 0, ROWS, EXPONENT);
        return powers;
    }

    /** Scales contributions by a ratio, as the paper's update of an intensity does. */
    @Benchmark
    @OperationsPerInvocation(ROWS)
    public RatioRows ratioScaling() {
        return ratio.update(rows, spot, brighter, contributions, ConeChange.NONE, false);
    }
}
