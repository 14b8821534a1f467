package lightning.render.trace.tree;

import static org.assertj.core.api.Assertions.assertThat;

import lightning.base.math.Vec3;
import lightning.render.trace.solid.SolidGeometry;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests rays against the box −1…1: false hits are allowed, false misses are not. */
class BoxRayTest {
    private static final float[] BOX = {-1, -1, -1, 1, 1, 1};

    private static boolean hits(Vec3 origin, Vec3 direction, double limit) {
        BoxRay ray = new BoxRay();
        ray.setRay(origin.x(), origin.y(), origin.z(), direction.x(), direction.y(), direction.z());
        return ray.hits(BOX, 0, limit);
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.0, -0.0})
    void rayAlongFace_hitsBoxOnlyInsideFace(double zero) {
        double side = Math.nextDown(1.0);
        for (double at : new double[] {-side, side}) {
            assertThat(hits(new Vec3(at, 0, 5), new Vec3(zero, zero, -1), SolidGeometry.MISS)).isTrue();
            assertThat(hits(new Vec3(0, at, 5), new Vec3(zero, zero, -1), SolidGeometry.MISS)).isTrue();
            assertThat(hits(new Vec3(5, 0, at), new Vec3(-1, zero, zero), SolidGeometry.MISS)).isTrue();
        }
        assertThat(hits(new Vec3(1.001, 0, 5), new Vec3(zero, zero, -1), SolidGeometry.MISS)).isFalse();
    }

    /** A shape in the box may be hit at exactly that distance, and have the lower index. */
    @Test
    void boxAtLimit_isHit_andBeyondLimitIsMissed() {
        assertThat(hits(new Vec3(0, 0, 5), new Vec3(0, 0, -1), 4)).isTrue();
        assertThat(hits(new Vec3(0, 0, 5), new Vec3(0, 0, -1), Math.nextDown(4.0))).isFalse();
        assertThat(hits(new Vec3(0, 0, 5), new Vec3(0, 0, -2), 2)).isTrue();
    }

    @Test
    void boxBehindOrNextToRay_isMissed() {
        assertThat(hits(new Vec3(0, 0, 5), new Vec3(0, 0, 1), SolidGeometry.MISS)).isFalse();
        assertThat(hits(new Vec3(0, 0, 5), new Vec3(0, 1, -1), SolidGeometry.MISS)).isFalse();
        assertThat(hits(new Vec3(0, 0, 0), new Vec3(0, 1, -1), SolidGeometry.MISS)).as("from inside").isTrue();
    }
}
