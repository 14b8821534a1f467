package lightning.render.trace;

import static org.assertj.core.api.Assertions.assertThat;

import java.math.BigDecimal;
import java.util.Random;
import lightning.base.math.Vec3;
import lightning.render.engine.lanes.PacketTracer;
import lightning.render.engine.lanes.RayPacket;
import lightning.render.trace.primitive.PrimitiveTable;
import lightning.render.trace.tree.WayEnd;
import lightning.sample.Slow;
import lightning.scene.Solid;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * A surface on which a light lies does not come between at that end; what lies before it does. Each answer is compared with one
 * of many digits, made from the numbers of the scene: it must be right for a solid that is larger or smaller by no more than the
 * bound of {@link PrimitiveTable#off}. {@code -Dlightning.places=100000} takes as many lights for each solid of shape.
 */
@Slow
class LightOnSurfaceTest {
    private static final int PLACES = Integer.getInteger("lightning.places", 25);
    private static final int ROWS = 12;

    private final RayPacket p = new RayPacket();
    private int blocked;
    private int clear;
    private int open;

    static Vec3 lightOn(Solid.Canonical solid, Random random) {
        if (CanonicalSolids.isOpen(solid)) {
            return random.nextInt(4) == 0 ? new Vec3(1, 0, 0) : HardRay.onSurface(solid, random);
        }
        if (solid instanceof Solid.Frustum f && random.nextInt(4) == 0) {
            return new Vec3(0.6, 0, 0.8).times(0.5 + 0.5 * f.top()).plus(new Vec3(0, 0.5, 0));
        }
        return switch (random.nextInt(6)) {
            case 0 -> solid.equals(Solid.SPHERE) || solid.equals(Solid.CONE) ? Vec3.Y : Vec3.ZERO;
            case 1 ->
                    solid.equals(Solid.SPHERE) ? new Vec3(0, 0, -1) : solid.equals(Solid.PLANE) ? new Vec3(0.5, 0, 0.25)
                            : new Vec3(1, 0, 0);
            case 2 -> solid.equals(Solid.SPHERE) ? new Vec3(0.6, 0, 0.8) : solid.equals(Solid.CONE) ? new Vec3(0, 0.75, 0.25) : Vec3.ZERO;
            default -> HardRay.onSurface(solid, random);
        };
    }

    @ParameterizedTest
    @MethodSource("lightning.render.trace.CanonicalSolids#blunt")
    void surfaceUnderTheLight_doesNotComeBetween(Solid.Canonical solid) {
        Random random = new Random(CanonicalSolids.ALL.indexOf(solid));
        for (int n = 0; n < PLACES; n++) {
            ExactPlace place = ExactPlace.random(solid, random);
            Vec3 own = lightOn(solid, random);
            Vec3 light = ExactPlace.doubles(place.exact().toScene(ExactPlace.exact(own))).minus(place.camera());
            WayEnd end = place.geometry().end(light);
            for (int r = 0; r < ROWS; r++) {
                Vec3 row = row(place, own, random);
                double far = ExactPlace.sum(light) + ExactPlace.sum(row);
                double error = error(place, far);
                if (error < 1e-3) {
                    check(place, end, row, onSurface(solid, place.toOwn(row), ExactPlace.exact(own), error));
                }
            }
        }
        assertThat(clear).as("ways that must be clear").isGreaterThan(PLACES * ROWS / 4);
        assertThat(blocked).as("ways that must be blocked")
                .isGreaterThan(solid.equals(Solid.PLANE) ? -1 : PLACES * ROWS / (CanonicalSolids.isOpen(solid) ? 40 : 4));
        assertThat(open).as("ways of which the bound lets nobody tell").isLessThan(PLACES * ROWS / 20);
    }

    /** Well off the surface, the surface is one like any other. */
    @ParameterizedTest
    @MethodSource("lightning.render.trace.CanonicalSolids#blunt")
    void surfaceBesideTheLight_doesComeBetween(Solid.Canonical solid) {
        Random random = new Random(CanonicalSolids.ALL.indexOf(solid));
        for (int n = 0; n < PLACES; n++) {
            ExactPlace place = ExactPlace.random(solid, random);
            Vec3 on = HardRay.onSurface(solid, random);
            double error = error(place, 2 * ExactPlace.sum(place.toRender(on)));
            Vec3 away = solid.equals(Solid.PLANE) ? Vec3.Y : on.minus(new Vec3(0.01, solid.equals(Solid.SPHERE) ? 0.01 : 0.3, 0));
            Vec3 light = place.toRender(on.plus(away.times((random.nextBoolean() ? 1 : -1) * error * 100)));
            WayEnd end = place.geometry().end(light);
            for (int r = 0; r < ROWS; r++) {
                Vec3 row = row(place, on, random);
                double most = error(place, ExactPlace.sum(light) + ExactPlace.sum(row));
                if (most < 5 * error && most < 1e-6) {
                    check(place, end, row, offSurface(solid, place.toOwn(row), place.toOwn(light), most));
                }
            }
        }
        assertThat(clear).as("ways that must be clear").isGreaterThan(PLACES);
        assertThat(blocked).as("ways that must be blocked").isGreaterThan(PLACES);
        assertThat(open).as("ways of which the bound lets nobody tell").isLessThan((clear + blocked) / 20);
    }

    /** The bound in the shape's own units. */
    private static double error(ExactPlace place, double far) {
        PrimitiveTable shapes = place.geometry().primitives();
        return shapes.offLight(0, far) * shapes.rate(0);
    }

    /** A row, as rows are: floats in render space; about the shape, within it, and near the light. */
    private static Vec3 row(ExactPlace place, Vec3 light, Random random) {
        Vec3 own = switch (random.nextInt(4)) {
            case 0 -> HardRay.direction(random).times(Math.pow(10, 2 * random.nextDouble()));
            case 1 -> HardRay.direction(random).times(0.3);
            case 2 -> light.plus(HardRay.direction(random).times(0.1));
            default -> HardRay.direction(random).times(2);
        };
        Vec3 row = place.toRender(own);
        return new Vec3((float) row.x(), (float) row.y(), (float) row.z());
    }

    /** @param expected 1 blocked, −1 clear, 0 either */
    private void check(ExactPlace place, WayEnd end, Vec3 row, int expected) {
        boolean answer = place.geometry().blockedByAny(row, end);
        if (expected == 0) {
            open++;
        } else {
            assertThat(answer).as("%s solid %s, light %s, row %s", place.placements(), place.solid(), end.point(), row)
                    .isEqualTo(expected > 0);
            blocked += expected > 0 ? 1 : 0;
            clear += expected < 0 ? 1 : 0;
        }
        p.end = end;
        for (int i = 0; i < RayPacket.WIDTH; i++) {
            p.ox[i] = row.x();
            p.oy[i] = row.y();
            p.oz[i] = row.z();
            p.dx[i] = end.point().x() - row.x();
            p.dy[i] = end.point().y() - row.y();
            p.dz[i] = end.point().z() - row.z();
            p.limit[i] = 1;
        }
        assertThat(new PacketTracer(place.geometry()).blocked(p, RayPacket.WIDTH)).isEqualTo(answer ? -1 >>> -RayPacket.WIDTH : 0);
    }

    private static int onSurface(Solid.Canonical solid, BigDecimal[] row, BigDecimal[] light, double error) {
        if (solid.equals(Solid.PLANE)) {
            return -1;
        }
        BigDecimal[] d = minus(light, row);
        ExactSolids.Interval grown = ExactSolids.convex(solid, row, d, new BigDecimal(error));
        ExactSolids.Interval shrunk = ExactSolids.convex(solid, row, d, new BigDecimal(-error));
        ExactSolids.Interval core = ExactSolids.convex(solid, row, d, new BigDecimal(-16 * error));
        boolean open = CanonicalSolids.isOpen(solid);
        if (open && ExactSolids.isBeyondRims(row, d, grown.in(), shrunk.isEmpty() ? grown.out() : shrunk.in(), error)) {
            return -1;
        }
        boolean within = !shrunk.isEmpty() && shrunk.in().signum() <= 0 && shrunk.out().signum() >= 0;
        boolean without = grown.isEmpty() || grown.in().signum() > 0;
        boolean tip = (shrunk.isEmpty() || shrunk.in().compareTo(BigDecimal.ONE) >= 0)
                && (1 - grown.in().doubleValue()) * ExactPlace.doubles(d).length() <= 3 * error;
        if (within || grown.isEmpty() || without && tip || !shrunk.isEmpty() && without && shrunk.in().compareTo(BigDecimal.ONE) >= 0
                && grown.in().add(shrunk.out()).compareTo(BigDecimal.TWO) >= 0) {
            return -1;
        }
        return without && !core.isEmpty() && core.in().signum() > 0 && core.in().compareTo(BigDecimal.ONE) < 0
                && (!open || ExactSolids.isBetweenRims(row, d, grown.in(), core.in(), error)) ? 1 : 0;
    }

    private static int offSurface(Solid.Canonical solid, BigDecimal[] row, BigDecimal[] light, double error) {
        BigDecimal[] d = minus(light, row);
        if (solid.equals(Solid.PLANE)) {
            return throughThePatch(ExactPlace.doubles(row), ExactPlace.doubles(light), error);
        }
        if (CanonicalSolids.isOpen(solid)) {
            return throughTheSide(solid, row, d, error);
        }
        ExactSolids.Interval grown = ExactSolids.inside(solid, row, d, new BigDecimal(error));
        ExactSolids.Interval shrunk = ExactSolids.inside(solid, row, d, new BigDecimal(-error));
        boolean within = !shrunk.isEmpty() && shrunk.in().signum() <= 0 && shrunk.out().signum() >= 0;
        if (grown.isEmpty() || grown.in().compareTo(BigDecimal.ONE) >= 0 || grown.out().signum() <= 0
                || within && shrunk.out().compareTo(BigDecimal.ONE) >= 0) {
            return -1;
        }
        boolean enters = !shrunk.isEmpty() && grown.in().signum() > 0 && shrunk.in().compareTo(BigDecimal.ONE) < 0;
        return enters || within && grown.out().compareTo(BigDecimal.ONE) < 0 ? 1 : 0;
    }

    private static int throughTheSide(Solid.Canonical solid, BigDecimal[] row, BigDecimal[] d, double error) {
        ExactSolids.Interval grown = ExactSolids.side(solid, row, d, new BigDecimal(error));
        ExactSolids.Interval shrunk = ExactSolids.side(solid, row, d, new BigDecimal(-error));
        if (grown.isEmpty()) {
            return -1;
        }
        BigDecimal in = shrunk.isEmpty() ? grown.out() : shrunk.in();
        BigDecimal out = shrunk.isEmpty() ? grown.in() : shrunk.out();
        boolean enters = grown.in().signum() > 0 && in.compareTo(BigDecimal.ONE) < 0
                && ExactSolids.isBetweenRims(row, d, grown.in(), in, error);
        boolean leaves = out.signum() > 0 && grown.out().compareTo(BigDecimal.ONE) < 0
                && ExactSolids.isBetweenRims(row, d, out, grown.out(), error);
        if (!shrunk.isEmpty() && (enters || leaves)) {
            return 1;
        }
        boolean entersNowhere = in.signum() <= 0 || grown.in().compareTo(BigDecimal.ONE) >= 0
                || ExactSolids.isBeyondRims(row, d, grown.in(), in, error);
        boolean leavesNowhere = grown.out().signum() <= 0 || out.compareTo(BigDecimal.ONE) >= 0
                || ExactSolids.isBeyondRims(row, d, out, grown.out(), error);
        return entersNowhere && leavesNowhere ? -1 : 0;
    }

    private static int throughThePatch(Vec3 row, Vec3 light, double error) {
        if (row.y() * light.y() > 0) {
            return -1;
        }
        double t = row.y() / (row.y() - light.y());
        Vec3 d = light.minus(row);
        double beside = Math.max(Math.abs(row.x() + t * d.x()), Math.abs(row.z() + t * d.z())) - 0.5;
        double margin = 2 * error * (1 + d.length() / Math.abs(d.y()));
        return Math.abs(row.y()) <= error || Math.abs(beside) <= margin ? 0 : beside < 0 ? 1 : -1;
    }

    private static BigDecimal[] minus(BigDecimal[] a, BigDecimal[] b) {
        return new BigDecimal[] {a[0].subtract(b[0]), a[1].subtract(b[1]), a[2].subtract(b[2])};
    }
}
