package lightning.scene.value;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import lightning.base.math.Transform;
import lightning.base.math.Vec3;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import org.junit.jupiter.api.Test;

class DomeRotationTest {
    private static final Vec3 X = new Vec3(1, 0, 0);
    private static final Vec3 Z = new Vec3(0, 0, 1);

    @Test
    void tilt_turnsAboutX_counterClockwise() {
        assertThat(DomeRotation.of(0, 90, 0).toWorld().transformVector(Vec3.Y)).isEqualTo(Z);
    }

    @Test
    void roll_turnsAboutZ_counterClockwise() {
        assertThat(DomeRotation.of(0, 0, 90).toWorld().transformVector(X)).isEqualTo(Vec3.Y);
    }

    /** Roll takes x to y, tilt takes y to z, and rotation takes z to x. */
    @Test
    void angles_actInOrderRollTiltRotation() {
        assertThat(DomeRotation.of(90, 90, 90).toWorld().transformVector(X)).isEqualTo(X);
    }

    @Property
    void rotation_keepsTheHorizonLevel(@ForAll @DoubleRange(min = -360, max = 360) double rotation) {
        Vec3 up = DomeRotation.of(rotation, 0, 0).toWorld().transformVector(Vec3.Y);
        assertThat(up).isEqualTo(Vec3.Y);
    }

    @Property
    void anglesOfItsMatrix_giveTheSameRotation(@ForAll @DoubleRange(min = -360, max = 360) double rotation,
            @ForAll @DoubleRange(min = -360, max = 360) double tilt, @ForAll @DoubleRange(min = -360, max = 360) double roll) {
        Transform m = DomeRotation.of(rotation, tilt, roll).toWorld();
        assertIsSame(DomeRotation.of(m.times(3)).toWorld(), m);
    }

    @Property
    void verticalImageAxis_hasItsRotation(@ForAll @DoubleRange(min = -360, max = 360) double rotation,
            @ForAll @DoubleRange(min = -360, max = 360) double roll, @ForAll boolean up) {
        Transform m = DomeRotation.of(rotation, up ? 90 : -90, roll).toWorld();
        assertIsSame(DomeRotation.of(m).toWorld(), m);
    }

    private static void assertIsSame(Transform a, Transform b) {
        for (Vec3 v : new Vec3[] {X, Vec3.Y, Z}) {
            assertThat(a.transformVector(v).minus(b.transformVector(v)).length()).isCloseTo(0, within(1e-7));
        }
    }
}
