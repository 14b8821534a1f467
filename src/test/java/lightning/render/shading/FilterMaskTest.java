package lightning.render.shading;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Objects;
import lightning.base.math.Vec3;
import lightning.scene.light.FilterShape;
import lightning.scene.light.Light;
import lightning.scene.light.LightFilter;
import lightning.scene.light.LightFlag;
import lightning.scene.light.LightType;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import org.junit.jupiter.api.Test;

class FilterMaskTest {
    private static final Vec3 ABOVE = new Vec3(0, 4, 0);
    /** Lies flat, at half the height of the light. */
    private static final LightFlag CARD =
            LightFlag.NONE.with(f -> f.on(true).position(new Vec3(0, 2, 0)).rotation(new Vec3(90, 0, 0)).width(2).height(1));
    private static final LightFilter BOX =
            LightFilter.NONE.with(f -> f.shape(FilterShape.BOX).position(new Vec3(1, 0, 0)).size(new Vec3(2, 4, 6)));

    private static double factor(LightFlag flag, LightFilter filter, Vec3 point) {
        Light light = Light.of("l", LightType.POINT).withFlag(flag).withFilter(filter);
        return Objects.requireNonNull(FilterMask.of(light, Vec3.ZERO, false)).factor(point.x(), point.y(), point.z(), ABOVE.x(), ABOVE.y(),
                ABOVE.z());
    }

    private static double behind(LightFlag flag, double x, double z) {
        return factor(flag, LightFilter.NONE, new Vec3(x, 0, z));
    }

    private static double in(LightFilter filter, double x, double y, double z) {
        return factor(LightFlag.NONE, filter, new Vec3(x, y, z));
    }

    /** At half the way, the card's shadow on the floor is twice as large: 4 × 2. */
    @Test
    void flag_blocksItsShadow() {
        assertThat(behind(CARD, 0, 0)).isZero();
        assertThat(behind(CARD, 1.99, 0.99)).isZero();
        assertThat(behind(CARD, 2.01, 0)).isOne();
        assertThat(behind(CARD, 0, 1.01)).isOne();
    }

    @Test
    void flagBehindThePoint_orBehindTheLight_blocksNothing() {
        assertThat(factor(CARD, LightFilter.NONE, new Vec3(0, 3, 0))).isOne();
        assertThat(factor(CARD.withPosition(new Vec3(0, 5, 0)), LightFilter.NONE, Vec3.ZERO)).isOne();
    }

    @Test
    void flagEdgeOn_blocksNothing() {
        assertThat(behind(CARD.withRotation(Vec3.ZERO), 0.5, 0)).isOne();
    }

    @Property
    void density_isTheShareThatTheFlagTakes(@ForAll @DoubleRange(min = 0, max = 1) double density) {
        assertThat(behind(CARD.withDensity(density), 0, 0)).isEqualTo(1 - density);
    }

    /** Halfway through the soft edge, half of the light passes. */
    @Test
    void softEdge_isHalfInItsMiddle() {
        assertThat(behind(CARD.withSoftness(0.5), 0.75 * 2, 0)).isCloseTo(0.5, within(1e-12));
    }

    @Test
    void flagOfDirectionalLight_blocksAlongItsDirection() {
        Light light = Light.of("l", LightType.DIRECTIONAL).withFlag(CARD);
        FilterMask mask = Objects.requireNonNull(FilterMask.of(light, Vec3.ZERO, true));
        Vec3 toward = new Vec3(0.6, 0.8, 0);
        assertThat(mask.factor(-1.5, 0, 0, toward.x(), toward.y(), toward.z())).isZero();
        assertThat(mask.factor(0, 0, 0, toward.x(), toward.y(), toward.z())).isOne();
        assertThat(mask.factor(-1.5, 2.1, 0, toward.x(), toward.y(), toward.z())).isOne();
    }

    @Test
    void box_dimsWhatIsInIt() {
        assertThat(in(BOX, 1, 0, 0)).isZero();
        assertThat(in(BOX, 1.99, 1.99, 2.99)).isZero();
        assertThat(in(BOX, 2.01, 0, 0)).isOne();
        assertThat(in(BOX, 1, 2.01, 0)).isOne();
        assertThat(in(BOX, 1, 0, -3.01)).isOne();
    }

    @Test
    void invertedBox_cutsTheLightToIt() {
        LightFilter cut = BOX.withInverted(true);
        assertThat(in(cut, 1, 0, 0)).isOne();
        assertThat(in(cut, 5, 0, 0)).isZero();
    }

    @Test
    void sphere_isAnEllipsoidInTheBox() {
        LightFilter sphere = BOX.withShape(FilterShape.SPHERE);
        assertThat(in(sphere, 1, 1.99, 0)).isZero();
        assertThat(in(sphere, 1.8, 1.8, 0)).isOne();
        assertThat(in(sphere.withSoftness(1), 1, 1, 0)).isCloseTo(0.5, within(1e-12));
    }

    @Property
    void ramp_fadesFromTopToBottom(@ForAll @DoubleRange(min = -3, max = 3) double y, @ForAll @DoubleRange(min = -100, max = 100) double x) {
        double t = Math.clamp((2 - y) / 4, 0, 1);
        assertThat(in(BOX.withShape(FilterShape.RAMP), x, y, 0)).isCloseTo(1 - t * t * (3 - 2 * t), within(1e-12));
    }

    @Test
    void filterWithoutSize_dimsNothing() {
        assertThat(in(BOX.withSize(Vec3.ZERO), 1, 0, 0)).isOne();
        assertThat(in(BOX.withShape(FilterShape.SPHERE).withSize(Vec3.ZERO), 1, 0, 0)).isOne();
    }
}
