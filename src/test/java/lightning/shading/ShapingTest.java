package lightning.shading;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Optional;
import lightning.math.Vec3;
import lightning.sample.StudioScene;
import lightning.scene.BarnDoors;
import lightning.scene.Gobo;
import lightning.scene.Light;
import lightning.scene.LightType;
import lightning.scene.Texture;
import org.junit.jupiter.api.Test;

/** Doors of a light in the eye that looks along −z, against angles that anyone can draw. */
class ShapingTest {
    private static final double TENTH = Math.tan(Math.toRadians(10));

    private static double factor(BarnDoors doors, double feather, double x, double y, double z) {
        var scene = StudioScene.of(LightType.SPOT);
        Vec3 eye = scene.camera().origin();
        Light light =
                Light.of("l", LightType.SPOT).withPosition(eye).withDirection(new Vec3(0, 0, -1)).withDoors(doors).withFeather(feather);
        return Shaping.of(Lamp.of(light, scene)).at((float) x, (float) y, (float) z);
    }

    @Test
    void eachDoor_cutsItsOwnSideOff() {
        double near = 10 * TENTH * 0.99;
        double far = 10 * TENTH * 1.01;
        var right = new BarnDoors(90, 10, 90, 90);
        assertThat(factor(right, 0, near, 0, -10)).isEqualTo(1);
        assertThat(factor(right, 0, far, 0, -10)).isZero();
        assertThat(factor(right, 0, -far, far, -10)).isEqualTo(1);
        assertThat(factor(new BarnDoors(10, 90, 90, 90), 0, -far, 0, -10)).isZero();
        assertThat(factor(new BarnDoors(10, 90, 90, 90), 0, far, 0, -10)).isEqualTo(1);
        assertThat(factor(new BarnDoors(90, 90, 10, 90), 0, 0, -far, -10)).isZero();
        assertThat(factor(new BarnDoors(90, 90, 10, 90), 0, 0, far, -10)).isEqualTo(1);
        assertThat(factor(new BarnDoors(90, 90, 90, 10), 0, 0, far, -10)).isZero();
    }

    @Test
    void doorBeyondTheAxis_cutsTheAxisOff() {
        assertThat(factor(new BarnDoors(90, -10, 90, 90), 0, 0, 0, -10)).isZero();
        assertThat(factor(new BarnDoors(90, -10, 90, 90), 0, -10 * TENTH * 1.01, 0, -10)).isEqualTo(1);
    }

    @Test
    void feather_fadesWithinTheEdge() {
        var right = new BarnDoors(90, 10, 90, 90);
        assertThat(factor(right, 20, 0, 0, -10)).as("half way").isEqualTo(0.5, within(1e-12));
        assertThat(factor(right, 20, -10 * TENTH * 1.01, 0, -10)).isEqualTo(1);
        assertThat(factor(right, 20, 10 * TENTH * 1.01, 0, -10)).isZero();
        double quarter = Math.tan(Math.toRadians(5));
        assertThat(factor(right, 20, 10 * quarter, 0, -10)).isEqualTo(0.25 * 0.25 * 2.5, within(1e-6));
    }

    @Test
    void twoDoors_multiply() {
        var both = new BarnDoors(90, 10, 90, 10);
        assertThat(factor(both, 20, 0, 0, -10)).isEqualTo(0.25, within(1e-12));
    }

    @Test
    void lightThatLooksStraightDown_hasZUpwards() {
        var scene = StudioScene.of(LightType.SPOT);
        Light light = Light.of("l", LightType.SPOT).withPosition(scene.camera().origin()).withDirection(new Vec3(0, -1, 0))
                .withDoors(new BarnDoors(90, 90, 90, 10));
        Shaping doors = Shaping.of(Lamp.of(light, scene));
        assertThat(doors.at(0, -10, 5)).isZero();
        assertThat(doors.at(0, -10, -5)).isEqualTo(1);
    }

    /** White above black, in a cone of 45 degrees: half its side is the distance. */
    @Test
    void gobo_isSpreadOverTheConeWithItsTopUp() {
        var scene = StudioScene.of(LightType.SPOT);
        var image = new Texture(1, 2, new float[] {1, 1, 1, 0, 0, 0});
        Light light = Light.of("l", LightType.SPOT).withPosition(scene.camera().origin()).withDirection(new Vec3(0, 0, -1)).withAngle(45)
                .withGobo(Optional.of(new Gobo("half.png", image)));
        Shaping gobo = Shaping.of(Lamp.of(light, scene));
        assertThat(gobo.at(0, 6, -10)).isEqualTo(1, within(1e-12));
        assertThat(gobo.at(3, -6, -10)).isZero();
        assertThat(gobo.at(0, 0, -10)).as("between the centres").isEqualTo(0.5, within(1e-12));
        assertThat(gobo.at(0, 2.5f, -10)).isEqualTo(0.75, within(1e-12));
    }

    @Test
    void redGobo_letsItsLuminanceThrough() {
        var scene = StudioScene.of(LightType.SPOT);
        Light light = Light.of("l", LightType.SPOT).withPosition(scene.camera().origin()).withDirection(new Vec3(0, 0, -1)).withAngle(0)
                .withGobo(Optional.of(new Gobo("red.png", new Texture(1, 1, new float[] {1, 0, 0}))));
        assertThat(Shaping.of(Lamp.of(light, scene)).at(0, 0, -10)).isEqualTo(0.2126, within(1e-9));
    }

    @Test
    void openDoors_areNone() {
        var scene = StudioScene.of(LightType.SPOT);
        assertThat(Shaping.of(Lamp.of(Light.of("l", LightType.SPOT).withFeather(9), scene))).isNull();
        assertThat(Shaping.of(Lamp.of(Light.of("l", LightType.POINT).withDoors(new BarnDoors(0, 0, 0, 0)), scene))).isNull();
    }
}
