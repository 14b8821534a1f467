package lightning.render.trace;

import static org.assertj.core.api.Assertions.assertThat;

import java.math.BigDecimal;
import java.util.Random;
import lightning.base.math.Ray;
import lightning.base.math.Vec3;
import lightning.render.engine.lanes.PacketTracer;
import lightning.render.engine.lanes.RayPacket;
import lightning.render.trace.solid.Form;
import lightning.sample.Slow;
import lightning.scene.Solid;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * A surface on which the eye lies does not hide what is before it; through the solid under it, its far side is seen. Each answer
 * is compared with one of many digits. {@code -Dlightning.places=100000} takes as many eyes for each solid of shape.
 */
@Slow
class EyeOnSurfaceTest {
    private static final int PLACES = Integer.getInteger("lightning.places", 50);
    private static final int RAYS = 12;

    private final RayPacket p = new RayPacket();
    private int seen;
    private int missed;
    private int open;

    @ParameterizedTest
    @MethodSource("lightning.render.trace.CanonicalSolids#blunt")
    void surfaceUnderTheEye_hidesNothing(Solid.Canonical solid) {
        Random random = new Random(CanonicalSolids.ALL.indexOf(solid));
        for (int n = 0; n < PLACES; n++) {
            ExactPlace any = ExactPlace.random(solid, random);
            Vec3 own = LightOnSurfaceTest.lightOn(solid, random);
            Vec3 eye = ExactPlace.doubles(any.exact().toScene(ExactPlace.exact(own)));
            ExactPlace place = ExactPlace.at(solid, any.placements(), eye);
            double error = place.geometry().primitives().offEye(0) * place.geometry().primitives().rate(0);
            assertThat(place.geometry().primitives().isUnderEye(0)).isTrue();
            for (int r = 0; r < RAYS && error < 1e-3; r++) {
                Vec3 to = place.toRender(HardRay.direction(random));
                if (to.maxAbs() > 0) {
                    check(place, ExactPlace.exact(own), random.nextBoolean() ? to.normalized() : to.normalized().negated(), error);
                }
            }
        }
        assertThat(missed).as("rays that must meet nothing").isGreaterThan(PLACES * RAYS / 4);
        assertThat(seen).as("rays that must meet the far side")
                .isGreaterThan(solid.equals(Solid.PLANE) ? -1 : PLACES * RAYS / (CanonicalSolids.isOpen(solid) ? 40 : 4));
        assertThat(open).as("rays of which the bound lets nobody tell").isLessThan(PLACES * RAYS / 20);
    }

    private void check(ExactPlace place, BigDecimal[] eye, Vec3 direction, double error) {
        double t = place.geometry().distance(0, new Ray(Vec3.ZERO, direction));
        BigDecimal[] end = place.toOwn(direction);
        BigDecimal[] start = place.toOwn(Vec3.ZERO);
        BigDecimal[] d = {end[0].subtract(start[0]), end[1].subtract(start[1]), end[2].subtract(start[2])};
        if (place.solid().equals(Solid.PLANE)) {
            assertThat(t).isEqualTo(Form.MISS);
            missed++;
        } else {
            ExactSolids.Interval grown = ExactSolids.convex(place.solid(), eye, d, new BigDecimal(error));
            ExactSolids.Interval shrunk = ExactSolids.convex(place.solid(), eye, d, new BigDecimal(-error));
            ExactSolids.Interval core = ExactSolids.convex(place.solid(), eye, d, new BigDecimal(-16 * error));
            boolean side = CanonicalSolids.isOpen(place.solid());
            boolean ends = !side || ExactSolids.isBetweenRims(eye, d, core.out(), grown.out(), error);
            boolean endsNowhere =
                    side && ExactSolids.isBeyondRims(eye, d, shrunk.isEmpty() ? grown.in() : shrunk.out(), grown.out(), error);
            if (!core.isEmpty() && core.out().signum() > 0 && ends) {
                assertThat(t).as("%s solid %s from %s along %s", place.placements(), place.solid(), place.camera(), direction)
                        .isBetween(core.out().doubleValue(), grown.out().doubleValue());
                seen++;
            } else if (grown.isEmpty() || endsNowhere
                    || !shrunk.isEmpty() && shrunk.out().signum() <= 0 && grown.out().add(shrunk.in()).signum() <= 0
                    || grown.out().doubleValue() * ExactPlace.doubles(d).length() <= 3 * error) {
                assertThat(t).as("%s solid %s from %s along %s", place.placements(), place.solid(), place.camera(), direction)
                        .isEqualTo(Form.MISS);
                missed++;
            } else {
                open++;
            }
        }
        for (int i = 0; i < RayPacket.WIDTH; i++) {
            p.dx[i] = direction.x();
            p.dy[i] = direction.y();
            p.dz[i] = direction.z();
        }
        new PacketTracer(place.geometry()).nearest(p, RayPacket.WIDTH);
        assertThat(p.t).containsOnly(t);
    }
}
