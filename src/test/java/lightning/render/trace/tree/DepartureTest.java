package lightning.render.trace.tree;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.Random;
import lightning.base.math.Ray;
import lightning.base.math.Vec3;
import lightning.render.trace.Geometry;
import lightning.render.trace.OwnSpace;
import lightning.render.trace.TraceScenes;
import lightning.render.trace.primitive.PrimitiveTable;
import lightning.render.trace.solid.Form;
import lightning.render.trace.solid.Kind;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.api.Test;

/** What ways leave behind is met by none of them, to the last bit of what rays compute. */
class DepartureTest {
    private final Departure departure = new Departure();

    /** Scales from 10⁻³ to 10⁶ and stretched ones, points and lights near the ends of solids, most of them hardly off. */
    @Property
    void primitiveLeftBehind_isMetByNoWay(@ForAll @IntRange(min = 1, max = 12) int shapes, @ForAll long seed) {
        Geometry geometry = new Geometry(switch (Math.floorMod(seed, 3)) {
            case 0 -> TraceScenes.wild(shapes, seed);
            case 1 -> TraceScenes.skewed(shapes, seed);
            default -> TraceScenes.cloud(shapes, seed);
        });
        PrimitiveTable primitives = geometry.primitives();
        Random random = new Random(seed);
        for (int bundle = 0; bundle < 40; bundle++) {
            int s = random.nextInt(primitives.count);
            float[][] points = points(primitives, s, random);
            boolean ends = random.nextBoolean();
            Vec3[] targets = targets(primitives, s, ends, random);
            WayEnd[] at = ends ? Arrays.stream(targets).map(geometry::end).toArray(WayEnd[]::new) : new WayEnd[0];
            departure.take(box(points), least(targets), least(negated(targets)).negated(), ends,
                    shape -> Arrays.stream(at).anyMatch(end -> end.indexOf(shape) >= 0));
            if (departure.leaves(primitives, s)) {
                for (Vec3 target : targets) {
                    assertMissed(geometry, s, points, target, ends);
                }
            }
        }
    }

    private void assertMissed(Geometry geometry, int s, float[][] points, Vec3 target, boolean ends) {
        for (int corner = 0; corner < 8 + points[0].length; corner++) {
            Vec3 from = corner < 8 ? corner(box(points), corner)
                    : new Vec3(points[0][corner - 8], points[1][corner - 8], points[2][corner - 8]);
            Vec3 way = ends ? new Vec3(target.x() - from.x(), target.y() - from.y(), target.z() - from.z()) : target;
            assertThat(geometry.distance(s, new Ray(from, way))).isEqualTo(Form.MISS);
        }
    }

    /** One point or direction, or some near each other: places of an area. */
    private static Vec3[] targets(PrimitiveTable primitives, int s, boolean ends, Random random) {
        Vec3 first = ends ? OwnSpace.toRender(primitives, s, near(random)) : direction(primitives, s, random);
        Vec3[] all = new Vec3[random.nextBoolean() ? 1 : 4];
        double spread = first.length() * Math.pow(10, -9 * random.nextDouble());
        Arrays.setAll(all, i -> i == 0 ? first
                : first.plus(new Vec3(random.nextGaussian(), random.nextGaussian(), random.nextGaussian()).times(spread)));
        return all;
    }

    private static Vec3 least(Vec3[] all) {
        return Arrays.stream(all).reduce(all[0],
                (a, b) -> new Vec3(Math.min(a.x(), b.x()), Math.min(a.y(), b.y()), Math.min(a.z(), b.z())));
    }

    private static Vec3[] negated(Vec3[] all) {
        return Arrays.stream(all).map(Vec3::negated).toArray(Vec3[]::new);
    }

    /** Heights and directions of all sizes, many of them just an end of the solid. */
    @Property
    void passedSolid_isMissed(@ForAll long seed) {
        Random random = new Random(seed);
        double[] data = new double[Form.MAP + 2];
        data[Form.MAP] = random.nextInt(3) / 2.0;
        data[Form.MAP + 1] = random.nextInt(2);
        for (int i = 0; i < 100; i++) {
            double y = height(random);
            double dy = random.nextInt(4) == 0 ? random.nextInt(3) - 1.0 : random.nextInt(4) == 0 ? -0.0 : size(random);
            for (Kind kind : Kind.values()) {
                if (kind == Kind.CYLINDER && data[Form.MAP] != 1 || kind == Kind.FRUSTUM && data[Form.MAP] == 1) {
                    continue;
                }
                if (kind.form().isPassed(y, y, dy, dy)) {
                    double t = kind.form().distance(data, 0, size(random), y, size(random), size(random), dy, size(random));
                    assertThat(t).as("%s at %s along %s", kind, y, dy).isEqualTo(Form.MISS);
                }
            }
        }
    }

    @Test
    void floorUnderPointsAndLamp_isLeft() {
        assertThat(leavesFloor(new Vec3(0, 3, -5), true)).isTrue();
        assertThat(leavesFloor(new Vec3(1, 0, 0), false)).isTrue();
    }

    @Test
    void floorBetweenPointsAndLamp_isNotLeft() {
        assertThat(leavesFloor(new Vec3(0, -3, -5), true)).isFalse();
        assertThat(leavesFloor(new Vec3(1, -1, 0), false)).isFalse();
    }

    @Test
    void floorOnWhichTheLampLies_isNotLeft() {
        assertThat(leavesFloor(new Vec3(0.5, -1, -5), true)).isFalse();
    }

    /** A ball on a floor, and points just above the floor around it. */
    private boolean leavesFloor(Vec3 source, boolean ends) {
        Geometry geometry = new Geometry(TraceScenes.ballOnFloor());
        WayEnd end = ends ? geometry.end(source) : WayEnd.OPEN;
        departure.take(box(new float[][] {{-1, 1}, {-0.99f, -0.9f}, {-6, -4}}), source, source, ends, s -> end.indexOf(s) >= 0);
        assertThat(departure.leaves(geometry.primitives(), 0)).isFalse();
        return departure.leaves(geometry.primitives(), 1);
    }

    private static float[][] points(PrimitiveTable primitives, int s, Random random) {
        Vec3 middle = near(random);
        double spread = Math.pow(10, -9 * random.nextDouble());
        boolean level = random.nextBoolean();
        float[][] points = new float[3][6];
        for (int i = 0; i < 6; i++) {
            Vec3 own = middle.plus(new Vec3(random.nextGaussian(), level ? 0 : random.nextGaussian(), random.nextGaussian()).times(spread));
            Vec3 p = OwnSpace.toRender(primitives, s, own);
            points[0][i] = (float) p.x();
            points[1][i] = (float) p.y();
            points[2][i] = (float) p.z();
        }
        return points;
    }

    private static Vec3 near(Random random) {
        return new Vec3(2 * random.nextDouble() - 1, height(random), 2 * random.nextDouble() - 1);
    }

    /** Near 0 or 1, by 10⁻¹⁷ to 10, or just there. */
    private static double height(Random random) {
        double off = random.nextInt(5) == 0 ? 0 : size(random);
        return random.nextInt(2) + (random.nextInt(20) == 0 ? 0x1p-1030 * off : off);
    }

    private static double size(Random random) {
        return (random.nextBoolean() ? 1 : -1) * Math.pow(10, 18 * random.nextDouble() - 17);
    }

    /** Level in the solid's own space, or almost, or any. */
    private static Vec3 direction(PrimitiveTable primitives, int s, Random random) {
        Vec3 from = OwnSpace.toRender(primitives, s, Vec3.ZERO);
        double rise = random.nextInt(3) == 0 ? 0 : size(random);
        return OwnSpace.toRender(primitives, s, new Vec3(random.nextGaussian(), rise, random.nextGaussian())).minus(from);
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
