package lightning.render.trace;

import java.io.IOException;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Random;
import java.util.function.ToDoubleFunction;
import lightning.base.math.PowerFunction;
import lightning.base.math.Ray;
import lightning.base.math.Transform;
import lightning.base.math.Vec3;
import lightning.render.trace.primitive.SurfaceHit;
import lightning.scene.node.Solid;
import lightning.scene.value.Placement;

/**
 * Benchmark of the robust formulas of docs/numerics.md against those of the textbook: nanoseconds each, scalar, for the distant
 * rays of {@link HardRay}. Both run in alternation and the medians are reported, so that other load affects both equally. Run
 * it alone: {@code mvn -q test-compile exec:exec@test-main -Dlightning.main=lightning.render.trace.RobustCost}.
 */
final class RobustCost {
    private static final int CASES = 4096;
    private static final int TURNS = 12_001;

    private static double sink;
    private static String selectedCase;

    private RobustCost() {}

    /**
     * @param args word of the formula to measure; none for all, each in its own JVM, since one formula's profile slows the next
     */
    public static void main(String[] args) throws IOException, InterruptedException {
        if (args.length == 0) {
            System.out.println("formula                                          textbook  Lightning");
            for (String one : List.of("sphere", "cylinder", "cone", "stored", "V·R", "power", "inverse")) {
                new ProcessBuilder(ProcessHandle.current().info().command().orElseThrow(), "--add-modules", "jdk.incubator.vector",
                        "-cp", System.getProperty("java.class.path"), RobustCost.class.getName(), one)
                        .redirectOutput(ProcessBuilder.Redirect.INHERIT).start().waitFor();
            }
            return;
        }
        selectedCase = args[0];
        compare("ray and sphere", rays(Solid.SPHERE), r -> NaiveSolids.sphere(r[0], r[1], r[2], r[3], r[4], r[5]),
                r -> CanonicalSolids.sphere(r[0], r[1], r[2], r[3], r[4], r[5]));
        compare("ray and cylinder", rays(Solid.CYLINDER), r -> NaiveSolids.cylinder(r[0], r[1], r[2], r[3], r[4], r[5]),
                r -> CanonicalSolids.cylinder(r[0], r[1], r[2], r[3], r[4], r[5]));
        compare("ray and cone", rays(Solid.CONE), r -> NaiveSolids.cone(r[0], r[1], r[2], r[3], r[4], r[5]),
                r -> CanonicalSolids.cone(r[0], r[1], r[2], r[3], r[4], r[5]));
        compare("stored point: rounded, or offset by its bound", rays(Solid.SPHERE), RobustCost::roundedPoint, RobustCost::offsetPoint);
        compare("V·R: plain, or normalized", rays(Solid.SPHERE), RobustCost::dot, RobustCost::unitDot);
        compare("power: Math.pow, or Lightning's own", powers(), r -> Math.pow(r[0], r[1]), r -> PowerFunction.pow(r[0], r[1]));
        Placement[] placements = placements();
        compare("inverse placement: by cofactors, or by rotation", indices(),
                r -> cofactors(placements[(int) r[0]].transform()).m00(), r -> placements[(int) r[0]].directionsToLocal().m00());
    }

    private static void compare(String name, double[][] cases, ToDoubleFunction<double[]> textbook, ToDoubleFunction<double[]> robust) {
        if (!name.contains(selectedCase)) {
            return;
        }
        double[] textbooks = new double[TURNS];
        double[] robusts = new double[TURNS];
        for (int rotation = 0; rotation < TURNS; rotation++) {
            textbooks[rotation] = nanoseconds(cases, textbook);
            robusts[rotation] = nanoseconds(cases, robust);
        }
        // The first half is warm-up.
        System.out.printf(Locale.ROOT, "%-52s %5.1f %10.1f%n", name, median(textbooks), median(robusts));
    }

    private static double nanoseconds(double[][] cases, ToDoubleFunction<double[]> formula) {
        long start = System.nanoTime();
        double sum = 0;
        for (double[] one : cases) {
            sum += formula.applyAsDouble(one);
        }
        sink += sum;
        return (System.nanoTime() - start) / (double) cases.length;
    }

    private static double median(double[] times) {
        double[] sorted = Arrays.copyOfRange(times, TURNS / 2, TURNS);
        Arrays.sort(sorted);
        return sorted[sorted.length / 2];
    }

    private static double[][] rays(Solid.Canonical solid) {
        Random random = new Random(CanonicalSolids.BASIC.indexOf(solid));
        double[][] rays = new double[CASES][];
        for (int i = 0; i < CASES; i++) {
            Ray ray = HardRay.FROM_AFAR.create(solid, random);
            Vec3 o = ray.origin();
            Vec3 d = ray.direction();
            rays[i] = new double[] {o.x(), o.y(), o.z(), d.x(), d.y(), d.z()};
        }
        return rays;
    }

    private static double[][] powers() {
        Random random = new Random(1);
        double[][] powers = new double[CASES][];
        Arrays.setAll(powers, _ -> new double[] {random.nextDouble(), 100 * random.nextDouble()});
        return powers;
    }

    private static double[][] indices() {
        double[][] indices = new double[CASES][];
        Arrays.setAll(indices, i -> new double[] {i % 64});
        return indices;
    }

    private static Placement[] placements() {
        Random random = new Random(1);
        Placement[] placements = new Placement[64];
        Arrays.setAll(placements, _ -> new Placement(HardRay.direction(random), HardRay.direction(random).times(90),
                new Vec3(1 + random.nextDouble(), 1 + random.nextDouble(), 1 + random.nextDouble())));
        return placements;
    }

    /** Rounds the three coordinates of a point to floats. */
    private static double roundedPoint(double[] r) {
        return (float) r[0] + (float) r[1] + (float) r[2];
    }

    /** Offsets a point as {@link SurfaceHit#compute} does, with the direction as the normal. */
    private static double offsetPoint(double[] r) {
        double off = (Math.abs(r[0] * r[3]) + Math.abs(r[1] * r[4]) + Math.abs(r[2] * r[5])) * SurfaceHit.OFFSET
                + ((Math.abs(r[0]) + Math.abs(r[1]) + Math.abs(r[2])) * SurfaceHit.HIT_ERROR + SurfaceHit.HIT_ERROR);
        return (float) (r[0] + r[3] * off) + (float) (r[1] + r[4] * off) + (float) (r[2] + r[5] * off);
    }

    private static double dot(double[] r) {
        return r[0] * r[3] + r[1] * r[4] + r[2] * r[5];
    }

    private static double unitDot(double[] r) {
        double lengths = (r[0] * r[0] + r[1] * r[1] + r[2] * r[2]) * (r[3] * r[3] + r[4] * r[4] + r[5] * r[5]);
        return dot(r) / Math.sqrt(lengths);
    }

    /** Inverts a transform without its translation by the textbook formula. */
    private static Transform cofactors(Transform m) {
        double a = m.m11() * m.m22() - m.m12() * m.m21();
        double b = m.m12() * m.m20() - m.m10() * m.m22();
        double c = m.m10() * m.m21() - m.m11() * m.m20();
        double d = 1 / (m.m00() * a + m.m01() * b + m.m02() * c);
        return new Transform(a * d, (m.m02() * m.m21() - m.m01() * m.m22()) * d, (m.m01() * m.m12() - m.m02() * m.m11()) * d, 0,
                b * d, (m.m00() * m.m22() - m.m02() * m.m20()) * d, (m.m02() * m.m10() - m.m00() * m.m12()) * d, 0,
                c * d, (m.m01() * m.m20() - m.m00() * m.m21()) * d, (m.m00() * m.m11() - m.m01() * m.m10()) * d, 0);
    }
}
