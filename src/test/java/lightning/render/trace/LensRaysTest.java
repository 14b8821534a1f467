package lightning.render.trace;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.BitSet;
import java.util.List;
import lightning.base.math.Ray;
import lightning.base.math.Vec3;
import lightning.scene.AntialiasMode;
import lightning.scene.Camera;
import lightning.scene.PictureSettings;
import lightning.scene.SamplingSettings;
import lightning.scene.Scene;
import lightning.scene.World;
import lightning.scene.value.Lens;
import lightning.scene.value.LensShift;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.api.Test;

/** Tests the camera rays of finer samples through an open lens by the optics of a thin lens. */
class LensRaysTest {
    private static final int GRID = 8;
    private static final double TOLERANCE = 1e-5;

    private static Scene scene(Lens lens) {
        Camera camera = new Camera(new Vec3(1, 2, 9), new Vec3(0, 1, 0), Vec3.Y, 40, new LensShift(0.1, -0.2)).withLens(lens);
        return new Scene(new PictureSettings(20, 10, 0).withSampling(new SamplingSettings(AntialiasMode.EDGES, GRID)), camera,
                World.DEFAULT,
                List.of(), List.of(), List.of());
    }

    private static Vec3 forward(Scene scene) {
        return scene.camera().to().minus(scene.camera().from()).normalized();
    }

    /** Returns the point at a distance along the view direction. */
    private static Vec3 pointAt(Scene scene, Ray ray, double distance) {
        Vec3 forward = forward(scene);
        double start = ray.origin().dot(forward);
        return ray.origin().plus(ray.direction().times((distance - start) / ray.direction().dot(forward)));
    }

    private static Ray pinholeRay(Scene scene, int x, int y, int sample) {
        return new PixelRays(scene.withCamera(scene.camera().withLens(Lens.PINHOLE))).ray(x, y, sample, GRID);
    }

    /** A ray leaves the pinhole's by the lens radius times |d − f| / f at the distance d: the circle of confusion there. */
    @Property(tries = 40)
    void raysOfPixel_fillTheCircleOfConfusion(@ForAll @DoubleRange(min = 0.01, max = 2) double aperture,
            @ForAll @DoubleRange(min = 0.5, max = 20) double focus, @ForAll @DoubleRange(min = 0.5, max = 50) double distance,
            @ForAll @IntRange(max = 19) int x, @ForAll @IntRange(max = 9) int y) {
        Scene scene = scene(new Lens(aperture, focus, 0, 0));
        double confusion = aperture * Math.abs(distance - focus) / focus;
        double farthest = 0;
        for (int sample = 0; sample < GRID * GRID; sample++) {
            Vec3 sharp = pointAt(scene, pinholeRay(scene, x, y, sample), distance);
            farthest = Math.max(farthest,
                    pointAt(scene, new PixelRays(scene).ray(x, y, sample, GRID), distance).minus(sharp).length());
        }
        assertThat(farthest).isBetween(0.95 * confusion - TOLERANCE, confusion + TOLERANCE * (1 + distance));
    }

    @Property(tries = 40)
    void raysOfPixel_meetInThePlaneOfFocus(@ForAll @DoubleRange(min = 0, max = 20) double focus, @ForAll @IntRange(max = 16) int blades) {
        Scene scene = scene(new Lens(0.5, focus, blades < Lens.MIN_BLADES ? 0 : blades, 10));
        double distance = focus > 0 ? focus : scene.camera().to().minus(scene.camera().from()).length();
        for (int sample = 0; sample < GRID * GRID; sample++) {
            Vec3 sharp = pointAt(scene, pinholeRay(scene, 3, 4, sample), distance);
            Vec3 seen = pointAt(scene, new PixelRays(scene).ray(3, 4, sample, GRID), distance);
            assertThat(seen.minus(sharp).length()).isLessThan(TOLERANCE * (1 + distance));
        }
    }

    @Test
    void raysStart_inThePlaneOfTheLens() {
        Scene scene = scene(new Lens(0.5, 3, 0, 0));
        for (int sample = 0; sample < GRID * GRID; sample++) {
            assertThat(new PixelRays(scene).ray(7, 2, sample, GRID).origin().dot(forward(scene))).isCloseTo(0, within(1e-6));
        }
    }

    /** Coordinates of a sample's point: the share of the area within its radius, and its angle as a share of a turn. */
    private static double[] areaAndAngle(int x, int y, int cell, int grid) {
        double[] point = new double[2];
        new LensSamples(new Lens(2, 1, 0, 0)).write(x, y, cell, grid, point);
        double turn = Math.atan2(point[1], point[0]) / (2 * Math.PI);
        return new double[] {(point[0] * point[0] + point[1] * point[1]) / 4, turn < 0 ? turn + 1 : turn};
    }

    /** Sixteen samples are one in each of four sectors of four rings of equal area; the four first ones are in different rings and sectors. */
    @Property(tries = 50)
    void samplesOfPixel_coverTheLensEvenly(@ForAll @IntRange(max = 10_000) int x, @ForAll @IntRange(max = 10_000) int y) {
        BitSet parts = new BitSet();
        for (int cell = 0; cell < 16; cell++) {
            double[] at = areaAndAngle(x, y, cell, 4);
            parts.set(4 * (int) (4 * at[0]) + (int) (4 * at[1]));
        }
        assertThat(parts.cardinality()).isEqualTo(16);
        BitSet rings = new BitSet();
        BitSet sectors = new BitSet();
        for (int cell : SampleCells.first(4).cells()) {
            rings.set((int) (4 * areaAndAngle(x, y, cell, 4)[0]));
            sectors.set((int) (4 * areaAndAngle(x, y, cell, 4)[1]));
        }
        assertThat(rings.cardinality()).isEqualTo(4);
        assertThat(sectors.cardinality()).isEqualTo(4);
    }

    /** Neighboring pixels have other points, so that too few of them are noise and not bands. */
    @Test
    void neighbors_haveOtherPoints() {
        BitSet angles = new BitSet();
        for (int x = 0; x < 64; x++) {
            angles.set((int) (64 * areaAndAngle(x, 5, 0, 2)[1]));
        }
        assertThat(angles.cardinality()).isGreaterThan(30);
    }

    /** A triangle with a corner on top has the area within its corners: no point is beyond the side opposite to a corner. */
    @Test
    void blades_areSidesOfTheOpening() {
        LensSamples triangle = new LensSamples(new Lens(1, 1, 3, 0));
        double[] point = new double[2];
        double highest = -1;
        for (int x = 0; x < 500; x++) {
            triangle.write(x, 0, x % 16, 4, point);
            highest = Math.max(highest, point[1]);
            assertThat(point[1]).isBetween(-0.5 - 1e-12, 1.0);
            assertThat(Math.abs(point[0])).isLessThanOrEqualTo((1 - point[1]) / Math.sqrt(3) + 1e-12);
        }
        assertThat(highest).isGreaterThan(0.8);
    }
}
