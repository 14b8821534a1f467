package lightning.render.trace;

import static org.assertj.core.api.Assertions.assertThat;

import java.math.BigDecimal;
import java.util.Random;
import lightning.base.math.Ray;
import lightning.base.math.Vec3;
import lightning.render.engine.lanes.PacketTracer;
import lightning.render.engine.lanes.RayPacket;
import lightning.render.trace.solid.SolidGeometry;
import lightning.sample.Slow;
import lightning.scene.node.Solid;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Tests eyes on surfaces: such a surface hides nothing from the eye, and of a solid only the far side is visible. Compares each
 * result with one in arbitrary precision. {@code -Dlightning.places=100000} tests as many eyes for each kind of solid.
 */
@Slow
class EyeOnSurfaceTest {
    private static final int PLACEMENTS = Integer.getInteger("lightning.places", 25);
    private static final int RAYS = 12;

    private final RayPacket packet = new RayPacket();
    private int hitCount;
    private int missCount;
    private int undecidedCount;

    @ParameterizedTest
    @MethodSource("lightning.render.trace.CanonicalSolids#blunt")
    void surfaceUnderEye_hidesNothing(Solid.Canonical solid) {
        Random random = new Random(CanonicalSolids.ALL.indexOf(solid));
        for (int n = 0; n < PLACEMENTS; n++) {
            ExactPlacedSolid anyHit = ExactPlacedSolid.random(solid, random);
            Vec3 local = LightOnSurfaceTest.lightOn(solid, random);
            Vec3 eye = ExactPlacedSolid.doubles(anyHit.exact().toScene(ExactPlacedSolid.exact(local)));
            ExactPlacedSolid place = ExactPlacedSolid.create(solid, anyHit.placements(), eye);
            double error = place.geometry().primitives().eyeTolerance(0) * place.geometry().primitives().maxScale(0);
            assertThat(place.geometry().primitives().isEyeOnSurface(0)).isTrue();
            for (int r = 0; r < RAYS && error < 1e-3; r++) {
                Vec3 to = place.toRender(HardRay.direction(random));
                if (to.maxAbs() > 0) {
                    check(place, ExactPlacedSolid.exact(local), random.nextBoolean() ? to.normalized() : to.normalized().negated(), error);
                }
            }
        }
        assertThat(missCount).as("rays that must miss").isGreaterThan(PLACEMENTS * RAYS / 4);
        assertThat(hitCount).as("rays that must hit the far side")
                .isGreaterThan(solid.equals(Solid.PLANE) ? -1 : PLACEMENTS * RAYS / (CanonicalSolids.isOpen(solid) ? 40 : 4));
        assertThat(undecidedCount).as("rays that are undecidable within the bound").isLessThan(PLACEMENTS * RAYS / 20);
    }

    private void check(ExactPlacedSolid placedSolid, BigDecimal[] eye, Vec3 direction, double error) {
        double t = placedSolid.geometry().distance(0, new Ray(Vec3.ZERO, direction));
        BigDecimal[] end = placedSolid.toLocal(direction);
        BigDecimal[] start = placedSolid.toLocal(Vec3.ZERO);
        BigDecimal[] d = {end[0].subtract(start[0]), end[1].subtract(start[1]), end[2].subtract(start[2])};
        if (placedSolid.solid().equals(Solid.PLANE)) {
            assertThat(t).isEqualTo(SolidGeometry.MISS);
            missCount++;
        } else {
            ExactSolids.Interval grown = ExactSolids.convexInterval(placedSolid.solid(), eye, d, new BigDecimal(error));
            ExactSolids.Interval shrunk = ExactSolids.convexInterval(placedSolid.solid(), eye, d, new BigDecimal(-error));
            ExactSolids.Interval core = ExactSolids.convexInterval(placedSolid.solid(), eye, d, new BigDecimal(-16 * error));
            boolean side = CanonicalSolids.isOpen(placedSolid.solid());
            boolean ends = !side || ExactSolids.isBetweenRims(eye, d, core.out(), grown.out(), error);
            boolean endsNowhere =
                    side && ExactSolids.isBeyondRims(eye, d, shrunk.isEmpty() ? grown.in() : shrunk.out(), grown.out(), error);
            if (!core.isEmpty() && core.out().signum() > 0 && ends) {
                assertThat(t)
                        .as("%s solid %s from %s along %s", placedSolid.placements(), placedSolid.solid(), placedSolid.camera(), direction)
                        .isBetween(core.out().doubleValue(), grown.out().doubleValue());
                hitCount++;
            } else if (grown.isEmpty() || endsNowhere
                    || !shrunk.isEmpty() && shrunk.out().signum() <= 0 && grown.out().add(shrunk.in()).signum() <= 0
                    || grown.out().doubleValue() * ExactPlacedSolid.doubles(d).length() <= 3 * error) {
                assertThat(t)
                        .as("%s solid %s from %s along %s", placedSolid.placements(), placedSolid.solid(), placedSolid.camera(), direction)
                        .isEqualTo(SolidGeometry.MISS);
                missCount++;
            } else {
                undecidedCount++;
            }
        }
        for (int i = 0; i < RayPacket.WIDTH; i++) {
            packet.dx[i] = direction.x();
            packet.dy[i] = direction.y();
            packet.dz[i] = direction.z();
        }
        new PacketTracer(placedSolid.geometry()).findNearest(packet, RayPacket.WIDTH);
        assertThat(packet.t).containsOnly(t);
    }
}
