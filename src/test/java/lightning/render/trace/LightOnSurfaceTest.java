package lightning.render.trace;

import static org.assertj.core.api.Assertions.assertThat;

import java.math.BigDecimal;
import java.util.Random;
import lightning.base.math.Vec3;
import lightning.render.engine.lanes.PacketTracer;
import lightning.render.engine.lanes.RayPacket;
import lightning.render.trace.primitive.PrimitiveTable;
import lightning.render.trace.tree.ShadowRayTarget;
import lightning.sample.Slow;
import lightning.scene.node.Solid;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Tests lights on surfaces: such a surface does not block at the end of a shadow ray, but anything before it does. Compares
 * each result with one in arbitrary precision, computed from the numbers of the scene. It must be correct for a solid that is
 * larger or smaller by at most the bound of {@link PrimitiveTable#placementError}. {@code -Dlightning.places=100000} tests
 * as many lights for each kind of solid.
 */
@Slow
class LightOnSurfaceTest {
    private static final int PLACEMENTS = Integer.getInteger("lightning.places", 25);
    private static final int ROWS = 12;

    private final RayPacket packet = new RayPacket();
    private int blockedCount;
    private int clearCount;
    private int undecidedCount;

    static Vec3 lightOn(Solid.Canonical solid, Random random) {
        if (CanonicalSolids.isOpen(solid)) {
            return random.nextInt(4) == 0 ? new Vec3(1, 0, 0) : HardRay.pointOnSurface(solid, random);
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
            default -> HardRay.pointOnSurface(solid, random);
        };
    }

    @ParameterizedTest
    @MethodSource("lightning.render.trace.CanonicalSolids#blunt")
    void surfaceUnderLight_doesNotBlock(Solid.Canonical solid) {
        Random random = new Random(CanonicalSolids.ALL.indexOf(solid));
        for (int n = 0; n < PLACEMENTS; n++) {
            ExactPlacedSolid place = ExactPlacedSolid.random(solid, random);
            Vec3 local = lightOn(solid, random);
            Vec3 light = ExactPlacedSolid.doubles(place.exact().toScene(ExactPlacedSolid.exact(local))).minus(place.camera());
            ShadowRayTarget end = place.geometry().shadowRayTarget(light);
            for (int r = 0; r < ROWS; r++) {
                Vec3 row = row(place, local, random);
                double far = ExactPlacedSolid.absSum(light) + ExactPlacedSolid.absSum(row);
                double error = error(place, far);
                if (error < 1e-3) {
                    check(place, end, row, onSurface(solid, place.toLocal(row), ExactPlacedSolid.exact(local), error));
                }
            }
        }
        assertThat(clearCount).as("shadow rays that must be free").isGreaterThan(PLACEMENTS * ROWS / 4);
        assertThat(blockedCount).as("shadow rays that must be blocked")
                .isGreaterThan(solid.equals(Solid.PLANE) ? -1 : PLACEMENTS * ROWS / (CanonicalSolids.isOpen(solid) ? 40 : 4));
        assertThat(undecidedCount).as("shadow rays that are undecidable within the bound").isLessThan(PLACEMENTS * ROWS / 20);
    }

    /** A surface well away from the light blocks like any other. */
    @ParameterizedTest
    @MethodSource("lightning.render.trace.CanonicalSolids#blunt")
    void surfaceNearLight_blocks(Solid.Canonical solid) {
        Random random = new Random(CanonicalSolids.ALL.indexOf(solid));
        for (int n = 0; n < PLACEMENTS; n++) {
            ExactPlacedSolid place = ExactPlacedSolid.random(solid, random);
            Vec3 on = HardRay.pointOnSurface(solid, random);
            double error = error(place, 2 * ExactPlacedSolid.absSum(place.toRender(on)));
            Vec3 away = solid.equals(Solid.PLANE) ? Vec3.Y : on.minus(new Vec3(0.01, solid.equals(Solid.SPHERE) ? 0.01 : 0.3, 0));
            Vec3 light = place.toRender(on.plus(away.times((random.nextBoolean() ? 1 : -1) * error * 100)));
            ShadowRayTarget end = place.geometry().shadowRayTarget(light);
            for (int r = 0; r < ROWS; r++) {
                Vec3 row = row(place, on, random);
                double max = error(place, ExactPlacedSolid.absSum(light) + ExactPlacedSolid.absSum(row));
                if (max < 5 * error && max < 1e-6) {
                    check(place, end, row, offSurface(solid, place.toLocal(row), place.toLocal(light), max));
                }
            }
        }
        assertThat(clearCount).as("shadow rays that must be free").isGreaterThan(PLACEMENTS);
        assertThat(blockedCount).as("shadow rays that must be blocked").isGreaterThan(PLACEMENTS);
        assertThat(undecidedCount).as("shadow rays that are undecidable within the bound").isLessThan((clearCount + blockedCount) / 20);
    }

    /** Returns the error bound in local units. */
    private static double error(ExactPlacedSolid placedSolid, double far) {
        PrimitiveTable shapes = placedSolid.geometry().primitives();
        return shapes.lightTolerance(0, far) * shapes.maxScale(0);
    }

    /** Returns a row, as floats in render space: around the shape, inside it, and near the light. */
    private static Vec3 row(ExactPlacedSolid placedSolid, Vec3 light, Random random) {
        Vec3 local = switch (random.nextInt(4)) {
            case 0 -> HardRay.direction(random).times(Math.pow(10, 2 * random.nextDouble()));
            case 1 -> HardRay.direction(random).times(0.3);
            case 2 -> light.plus(HardRay.direction(random).times(0.1));
            default -> HardRay.direction(random).times(2);
        };
        Vec3 row = placedSolid.toRender(local);
        return new Vec3((float) row.x(), (float) row.y(), (float) row.z());
    }

    /** @param expected 1 blocked, −1 free, 0 either */
    private void check(ExactPlacedSolid placedSolid, ShadowRayTarget target, Vec3 row, int expected) {
        boolean answer = BruteForce.isBlocked(placedSolid.geometry(), row, target);
        if (expected == 0) {
            undecidedCount++;
        } else {
            assertThat(answer).as("%s solid %s, light %s, row %s", placedSolid.placements(), placedSolid.solid(), target.point(), row)
                    .isEqualTo(expected > 0);
            blockedCount += expected > 0 ? 1 : 0;
            clearCount += expected < 0 ? 1 : 0;
        }
        packet.target = target;
        for (int i = 0; i < RayPacket.WIDTH; i++) {
            packet.ox[i] = row.x();
            packet.oy[i] = row.y();
            packet.oz[i] = row.z();
            packet.dx[i] = target.point().x() - row.x();
            packet.dy[i] = target.point().y() - row.y();
            packet.dz[i] = target.point().z() - row.z();
            packet.limit[i] = 1;
        }
        assertThat(new PacketTracer(placedSolid.geometry()).findBlocked(packet, RayPacket.WIDTH))
                .isEqualTo(answer ? -1 >>> -RayPacket.WIDTH : 0);
    }

    private static int onSurface(Solid.Canonical solid, BigDecimal[] row, BigDecimal[] light, double error) {
        if (solid.equals(Solid.PLANE)) {
            return -1;
        }
        BigDecimal[] d = minus(light, row);
        ExactSolids.Interval grown = ExactSolids.convexInterval(solid, row, d, new BigDecimal(error));
        ExactSolids.Interval shrunk = ExactSolids.convexInterval(solid, row, d, new BigDecimal(-error));
        ExactSolids.Interval core = ExactSolids.convexInterval(solid, row, d, new BigDecimal(-16 * error));
        boolean open = CanonicalSolids.isOpen(solid);
        if (open && ExactSolids.isBeyondRims(row, d, grown.in(), shrunk.isEmpty() ? grown.out() : shrunk.in(), error)) {
            return -1;
        }
        boolean within = !shrunk.isEmpty() && shrunk.in().signum() <= 0 && shrunk.out().signum() >= 0;
        boolean without = grown.isEmpty() || grown.in().signum() > 0;
        boolean tip = (shrunk.isEmpty() || shrunk.in().compareTo(BigDecimal.ONE) >= 0)
                && (1 - grown.in().doubleValue()) * ExactPlacedSolid.doubles(d).length() <= 3 * error;
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
            return throughSquare(ExactPlacedSolid.doubles(row), ExactPlacedSolid.doubles(light), error);
        }
        if (CanonicalSolids.isOpen(solid)) {
            return throughSide(solid, row, d, error);
        }
        ExactSolids.Interval grown = ExactSolids.insideInterval(solid, row, d, new BigDecimal(error));
        ExactSolids.Interval shrunk = ExactSolids.insideInterval(solid, row, d, new BigDecimal(-error));
        boolean within = !shrunk.isEmpty() && shrunk.in().signum() <= 0 && shrunk.out().signum() >= 0;
        if (grown.isEmpty() || grown.in().compareTo(BigDecimal.ONE) >= 0 || grown.out().signum() <= 0
                || within && shrunk.out().compareTo(BigDecimal.ONE) >= 0) {
            return -1;
        }
        boolean enters = !shrunk.isEmpty() && grown.in().signum() > 0 && shrunk.in().compareTo(BigDecimal.ONE) < 0;
        return enters || within && grown.out().compareTo(BigDecimal.ONE) < 0 ? 1 : 0;
    }

    private static int throughSide(Solid.Canonical solid, BigDecimal[] row, BigDecimal[] d, double error) {
        ExactSolids.Interval grown = ExactSolids.sideInterval(solid, row, d, new BigDecimal(error));
        ExactSolids.Interval shrunk = ExactSolids.sideInterval(solid, row, d, new BigDecimal(-error));
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

    private static int throughSquare(Vec3 row, Vec3 light, double error) {
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
