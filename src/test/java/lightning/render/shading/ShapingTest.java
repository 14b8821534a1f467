package lightning.render.shading;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Optional;
import lightning.base.math.Vec3;
import lightning.sample.StudioScene;
import lightning.scene.Area;
import lightning.scene.BarnDoors;
import lightning.scene.Gobo;
import lightning.scene.Light;
import lightning.scene.LightType;
import lightning.scene.Photometry;
import lightning.scene.Profile;
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

    /** That lies on its side: its top is to the right of the eye, its right below. */
    @Test
    void doorsOfARectangle_goByItsOwnUp() {
        var scene = StudioScene.of(LightType.SPOT);
        Light rect = Light.of("l", LightType.RECT).withPosition(scene.camera().origin()).withDirection(new Vec3(0, 0, -1))
                .withArea(Area.DEFAULT.withUp(new Vec3(1, 0, 0))).withDoors(new BarnDoors(90, 90, 90, 10));
        Shaping top = Shaping.of(Lamp.of(rect, scene));
        float far = (float) (10 * TENTH * 1.01);
        assertThat(top.at(far, 0, -10)).isZero();
        assertThat(top.at(-far, 0, -10)).isEqualTo(1);
        assertThat(top.at(0, far, -10)).isEqualTo(1);
        Shaping right = Shaping.of(Lamp.of(rect.withDoors(new BarnDoors(90, 10, 90, 90)), scene));
        assertThat(right.at(0, -far, -10)).isZero();
        assertThat(right.at(0, far, -10)).isEqualTo(1);
        Photometry half = new Photometry(Photometry.Type.C, new double[] {0, 10, 180}, new double[] {0}, new double[] {1, 2, 0});
        Light measured = rect.withProfile(Optional.of(new Profile("p.ies", half)));
        assertThat(Shaping.of(Lamp.of(measured, scene)).at(0, 0, -10)).as("nor has it a profile").isEqualTo(1);
        assertThat(Shaping.of(Lamp.of(rect.withType(LightType.DISC), scene))).as("a disc has none").isNull();
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

    private static double measured(LightType type, Vec3 direction, Photometry photometry, double x, double y, double z) {
        var scene = StudioScene.of(type);
        Light light = Light.of("l", type).withPosition(scene.camera().origin()).withDirection(direction).withAngle(180)
                .withProfile(Optional.of(new Profile("p.ies", photometry)));
        return Shaping.of(Lamp.of(light, scene)).at((float) x, (float) y, (float) z);
    }

    @Test
    void profileOfTypeC_isOneOfTheAngleFromTheAxisAndOfThatAroundIt() {
        // Right, top, left, bottom of what looks along -z; nothing below 45 degrees of the axis backwards.
        var p = new Photometry(Photometry.Type.C, new double[] {0, 90, 135}, new double[] {0, 90, 180, 270, 360},
                new double[] {8, 4, 0, 8, 1, 0, 8, 2, 0, 8, 3, 0, 8, 4, 0});
        Vec3 ahead = new Vec3(0, 0, -1);
        assertThat(measured(LightType.SPOT, ahead, p, 0, 0, -10)).isEqualTo(1);
        assertThat(measured(LightType.SPOT, ahead, p, 10, 0, 0)).isEqualTo(0.5, within(1e-6));
        assertThat(measured(LightType.SPOT, ahead, p, 0, 10, 0)).isEqualTo(0.125, within(1e-6));
        assertThat(measured(LightType.SPOT, ahead, p, -10, 0, 0)).isEqualTo(0.25, within(1e-6));
        assertThat(measured(LightType.SPOT, ahead, p, 0, -10, 0)).isEqualTo(0.375, within(1e-6));
        assertThat(measured(LightType.SPOT, ahead, p, 10, 0, -10)).as("half way to the right").isEqualTo(0.75, within(1e-6));
        assertThat(measured(LightType.SPOT, ahead, p, 10, 10, 0)).as("between right and top").isEqualTo(2.5 / 8, within(1e-6));
        assertThat(measured(LightType.SPOT, ahead, p, 1, 0, 10)).as("beyond what was measured").isZero();
    }

    @Test
    void profileOfAPointLight_hangsStraightDown() {
        var p = new Photometry(Photometry.Type.C, new double[] {0, 90, 180}, new double[] {0}, new double[] {4, 2, 0});
        assertThat(measured(LightType.POINT, new Vec3(1, 0, 0), p, 0, -3, 0)).isEqualTo(1);
        assertThat(measured(LightType.POINT, new Vec3(1, 0, 0), p, 3, 0, 0)).isEqualTo(0.5, within(1e-6));
        assertThat(measured(LightType.POINT, new Vec3(1, 0, 0), p, 0, 3, 0)).isZero();
    }

    /** As docs/jen-format.md says: 0 towards −x, 90 towards z. */
    @Test
    void profileOfAPointLight_beginsTowardsMinusX() {
        var c = new Photometry(Photometry.Type.C, new double[] {0, 90}, new double[] {0, 90, 180, 270, 360},
                new double[] {8, 8, 8, 1, 8, 2, 8, 3, 8, 8});
        assertThat(measured(LightType.POINT, Vec3.Y, c, -5, 0, 0)).as("0").isEqualTo(1, within(1e-6));
        assertThat(measured(LightType.POINT, Vec3.Y, c, 0, 0, 5)).as("90").isEqualTo(1 / 8.0, within(1e-6));
        assertThat(measured(LightType.POINT, Vec3.Y, c, 5, 0, 0)).as("180").isEqualTo(2 / 8.0, within(1e-6));
        assertThat(measured(LightType.POINT, Vec3.Y, c, 0, 0, -5)).as("270").isEqualTo(3 / 8.0, within(1e-6));
        // By planes to the left, ahead, to the right; in each downwards, ahead, upwards.
        double[] angles = {-90, 0, 90};
        var a = new Photometry(Photometry.Type.A, angles, angles, new double[] {1, 2, 3, 4, 8, 5, 6, 7, 0});
        assertThat(measured(LightType.POINT, Vec3.Y, a, 0, -5, 0)).as("ahead").isEqualTo(1, within(1e-6));
        assertThat(measured(LightType.POINT, Vec3.Y, a, -5, 0, 0)).as("right").isEqualTo(7 / 8.0, within(1e-6));
        assertThat(measured(LightType.POINT, Vec3.Y, a, 0, 0, 5)).as("upwards").isEqualTo(5 / 8.0, within(1e-6));
    }

    @Test
    void profilesOfTypesAAndB_haveTheirPlanesAboutAnUprightAndALyingAxis() {
        double[] angles = {-90, 0, 90};
        // By planes to the left, ahead, to the right; in each downwards, ahead, upwards.
        double[] candela = {1, 2, 3, 4, 8, 5, 6, 7, 0};
        Vec3 ahead = new Vec3(0, 0, -1);
        for (Photometry.Type type : new Photometry.Type[] {Photometry.Type.A, Photometry.Type.B}) {
            var p = new Photometry(type, angles, angles, candela);
            assertThat(measured(LightType.SPOT, ahead, p, 0, 0, -5)).isEqualTo(1);
            assertThat(measured(LightType.SPOT, ahead, p, 5, 0, 0)).as("right").isEqualTo(7 / 8.0, within(1e-6));
            assertThat(measured(LightType.SPOT, ahead, p, -5, 0, 0)).as("left").isEqualTo(2 / 8.0, within(1e-6));
            assertThat(measured(LightType.SPOT, ahead, p, 0, 0, 5)).as("behind").isZero();
        }
        // Half to the right and half up: 45 degrees and atan(1/√2) by upright planes, the other way round by lying ones.
        double small = Math.toDegrees(Math.atan(Math.sqrt(0.5))) / 90;
        double low = 8 + (7 - 8) * 0.5;
        double high = 5 + (0 - 5) * 0.5;
        assertThat(measured(LightType.SPOT, ahead, new Photometry(Photometry.Type.A, angles, angles, candela), 5, 5, -5))
                .isEqualTo((low + (high - low) * small) / 8, within(1e-6));
        double first = 8 + (5 - 8) * 0.5;
        double second = 7 + (0 - 7) * 0.5;
        assertThat(measured(LightType.SPOT, ahead, new Photometry(Photometry.Type.B, angles, angles, candela), 5, 5, -5))
                .isEqualTo((first + (second - first) * small) / 8, within(1e-6));
    }

    @Test
    void openDoors_areNone() {
        var scene = StudioScene.of(LightType.SPOT);
        assertThat(Shaping.of(Lamp.of(Light.of("l", LightType.SPOT).withFeather(9), scene))).isNull();
        assertThat(Shaping.of(Lamp.of(Light.of("l", LightType.POINT).withDoors(new BarnDoors(0, 0, 0, 0)), scene))).isNull();
    }
}
