package lightning.render.trace.tree;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.Random;
import lightning.base.math.Ray;
import lightning.base.math.Vec3;
import lightning.render.trace.Geometry;
import lightning.render.trace.LocalSpace;
import lightning.render.trace.TraceScenes;
import lightning.render.trace.primitive.PrimitiveTable;
import lightning.render.trace.solid.SolidGeometry;
import lightning.render.trace.solid.SolidKind;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.api.Test;

/** Tests that no shadow ray hits a culled primitive, with every rounding error. */
class HorizonCullingTest {
    private final HorizonCulling culling = new HorizonCulling();

    /** Uses scales from 10⁻³ to 10⁶ and stretched solids, with points and lights near their ends, most of them barely outside. */
    @Property
    void culledPrimitive_isHitByNoShadowRay(@ForAll @IntRange(min = 1, max = 12) int shapes, @ForAll long seed) {
        Geometry geometry = Geometry.of(switch (Math.floorMod(seed, 3)) {
            case 0 -> TraceScenes.randomScene(shapes, seed);
            case 1 -> TraceScenes.skewedShapes(shapes, seed);
            default -> TraceScenes.cloud(shapes, seed);
        });
        PrimitiveTable primitives = geometry.primitives();
        Random random = new Random(seed);
        for (int bundle = 0; bundle < 40; bundle++) {
            int s = random.nextInt(primitives.count);
            float[][] points = points(primitives, s, random);
            boolean ends = random.nextBoolean();
            Vec3[] targets = targets(primitives, s, ends, random);
            ShadowRayTarget[] at =
                    ends ? Arrays.stream(targets).map(geometry::shadowRayTarget).toArray(ShadowRayTarget[]::new) : new ShadowRayTarget[0];
            culling.setRays(box(points), minCorner(targets), minCorner(negated(targets)).negated(), ends,
                    shape -> Arrays.stream(at).anyMatch(end -> end.indexOf(shape) >= 0));
            if (culling.isCulled(primitives, s)) {
                for (Vec3 target : targets) {
                    assertMissed(geometry, s, points, target, ends);
                }
            }
        }
    }

    private void assertMissed(Geometry geometry, int s, float[][] points, Vec3 target, boolean toPoints) {
        for (int corner = 0; corner < 8 + points[0].length; corner++) {
            Vec3 from = corner < 8 ? corner(box(points), corner)
                    : new Vec3(points[0][corner - 8], points[1][corner - 8], points[2][corner - 8]);
            Vec3 shadowRay = toPoints ? new Vec3(target.x() - from.x(), target.y() - from.y(), target.z() - from.z()) : target;
            assertThat(geometry.distance(s, new Ray(from, shadowRay))).isEqualTo(SolidGeometry.MISS);
        }
    }

    /** Returns one point or direction, or several nearby: positions of an area light. */
    private static Vec3[] targets(PrimitiveTable primitives, int s, boolean toPoints, Random random) {
        Vec3 first = toPoints ? LocalSpace.toRender(primitives, s, near(random)) : direction(primitives, s, random);
        Vec3[] all = new Vec3[random.nextBoolean() ? 1 : 4];
        double spread = first.length() * Math.pow(10, -9 * random.nextDouble());
        Arrays.setAll(all, i -> i == 0 ? first
                : first.plus(new Vec3(random.nextGaussian(), random.nextGaussian(), random.nextGaussian()).times(spread)));
        return all;
    }

    private static Vec3 minCorner(Vec3[] corners) {
        return Arrays.stream(corners).reduce(corners[0],
                (a, b) -> new Vec3(Math.min(a.x(), b.x()), Math.min(a.y(), b.y()), Math.min(a.z(), b.z())));
    }

    private static Vec3[] negated(Vec3[] all) {
        return Arrays.stream(all).map(Vec3::negated).toArray(Vec3[]::new);
    }

    /** Uses heights and directions of all magnitudes, many of them at an end of the solid. */
    @Property
    void certainMiss_isNeverHit(@ForAll long seed) {
        Random random = new Random(seed);
        double[] data = new double[SolidGeometry.MAP_SIZE + 2];
        data[SolidGeometry.MAP_SIZE] = random.nextInt(3) / 2.0;
        data[SolidGeometry.MAP_SIZE + 1] = random.nextInt(2);
        for (int i = 0; i < 100; i++) {
            double y = height(random);
            double dy = random.nextInt(4) == 0 ? random.nextInt(3) - 1.0 : random.nextInt(4) == 0 ? -0.0 : size(random);
            for (SolidKind kind : SolidKind.values()) {
                if (kind == SolidKind.CYLINDER && data[SolidGeometry.MAP_SIZE] != 1
                        || kind == SolidKind.FRUSTUM && data[SolidGeometry.MAP_SIZE] == 1) {
                    continue;
                }
                if (kind.geometry().isCertainMiss(y, y, dy, dy)) {
                    double t = kind.geometry().distance(data, 0, size(random), y, size(random), size(random), dy, size(random));
                    assertThat(t).as("%s at %s along %s", kind, y, dy).isEqualTo(SolidGeometry.MISS);
                }
            }
        }
    }

    @Test
    void floorBelowPointsAndLight_isCulled() {
        assertThat(cullsFloor(new Vec3(0, 3, -5), true)).isTrue();
        assertThat(cullsFloor(new Vec3(1, 0, 0), false)).isTrue();
    }

    @Test
    void floorBetweenPointsAndLight_isNotCulled() {
        assertThat(cullsFloor(new Vec3(0, -3, -5), true)).isFalse();
        assertThat(cullsFloor(new Vec3(1, -1, 0), false)).isFalse();
    }

    @Test
    void floorUnderLight_isNotCulled() {
        assertThat(cullsFloor(new Vec3(0.5, -1, -5), true)).isFalse();
    }

    /** Uses a ball on a floor, and points just above the floor around it. */
    private boolean cullsFloor(Vec3 source, boolean toPoints) {
        Geometry geometry = Geometry.of(TraceScenes.ballOnFloor());
        ShadowRayTarget end = toPoints ? geometry.shadowRayTarget(source) : ShadowRayTarget.OFF_SURFACE;
        culling.setRays(box(new float[][] {{-1, 1}, {-0.99f, -0.9f}, {-6, -4}}), source, source, toPoints, s -> end.indexOf(s) >= 0);
        assertThat(culling.isCulled(geometry.primitives(), 0)).isFalse();
        return culling.isCulled(geometry.primitives(), 1);
    }

    private static float[][] points(PrimitiveTable primitives, int s, Random random) {
        Vec3 middle = near(random);
        double spread = Math.pow(10, -9 * random.nextDouble());
        boolean level = random.nextBoolean();
        float[][] points = new float[3][6];
        for (int i = 0; i < 6; i++) {
            Vec3 local =
                    middle.plus(new Vec3(random.nextGaussian(), level ? 0 : random.nextGaussian(), random.nextGaussian()).times(spread));
            Vec3 p = LocalSpace.toRender(primitives, s, local);
            points[0][i] = (float) p.x();
            points[1][i] = (float) p.y();
            points[2][i] = (float) p.z();
        }
        return points;
    }

    private static Vec3 near(Random random) {
        return new Vec3(2 * random.nextDouble() - 1, height(random), 2 * random.nextDouble() - 1);
    }

    /** Returns a height near 0 or 1, by 10⁻¹⁷ to 10, or exactly there. */
    private static double height(Random random) {
        double off = random.nextInt(5) == 0 ? 0 : size(random);
        return random.nextInt(2) + (random.nextInt(20) == 0 ? 0x1p-1030 * off : off);
    }

    private static double size(Random random) {
        return (random.nextBoolean() ? 1 : -1) * Math.pow(10, 18 * random.nextDouble() - 17);
    }

    /** Returns a direction that is horizontal in the solid's local space, almost horizontal, or any. */
    private static Vec3 direction(PrimitiveTable primitives, int s, Random random) {
        Vec3 from = LocalSpace.toRender(primitives, s, Vec3.ZERO);
        double rise = random.nextInt(3) == 0 ? 0 : size(random);
        return LocalSpace.toRender(primitives, s, new Vec3(random.nextGaussian(), rise, random.nextGaussian())).minus(from);
    }

    private static PointBox box(float[][] points) {
        PointBox box = new PointBox();
        for (int axis = 0; axis < 3; axis++) {
            float low = points[axis][0];
            float high = low;
            for (float value : points[axis]) {
                low = Math.min(low, value);
                high = Math.max(high, value);
            }
            box.set(axis, low, high);
        }
        return box;
    }

    private static Vec3 corner(PointBox box, int corner) {
        return new Vec3((corner & 1) == 0 ? box.low(0) : box.high(0), (corner & 2) == 0 ? box.low(1) : box.high(1),
                (corner & 4) == 0 ? box.low(2) : box.high(2));
    }
}
