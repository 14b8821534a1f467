package lightning.render.shading;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Optional;
import lightning.base.math.Vec3;
import lightning.sample.StudioScene;
import lightning.scene.asset.Gobo;
import lightning.scene.asset.IesProfile;
import lightning.scene.asset.Texture;
import lightning.scene.light.AreaShape;
import lightning.scene.light.Beam;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import lightning.scene.value.BarnDoors;
import lightning.scene.value.Photometry;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Tests the barn doors of a light at the camera that looks along −z against known angles. */
class AngularMaskTest {
    private static final double TENTH = Math.tan(Math.toRadians(10));

    private static double factor(BarnDoors doors, double feather, double x, double y, double z) {
        var scene = StudioScene.of(LightType.SPOT);
        Vec3 eye = scene.camera().origin();
        Light light =
                Light.of("l", LightType.SPOT).withPosition(eye).withDirection(new Vec3(0, 0, -1)).withDoors(doors).withFeather(feather);
        return AngularMask.of(LightSource.of(light, scene)).factor((float) x, (float) y, (float) z);
    }

    @Test
    void eachBarnDoor_cutsItsSide() {
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

    /** The light lies on its side: its top is to the right of the camera, its right below. */
    @Test
    void rectLightBarnDoors_followItsUpVector() {
        var scene = StudioScene.of(LightType.SPOT);
        Light rect = Light.of("l", LightType.RECT).withPosition(scene.camera().origin()).withDirection(new Vec3(0, 0, -1))
                .withArea(AreaShape.DEFAULT.withUp(new Vec3(1, 0, 0))).withDoors(new BarnDoors(90, 90, 90, 10));
        AngularMask top = AngularMask.of(LightSource.of(rect, scene));
        float far = (float) (10 * TENTH * 1.01);
        assertThat(top.factor(far, 0, -10)).isZero();
        assertThat(top.factor(-far, 0, -10)).isEqualTo(1);
        assertThat(top.factor(0, far, -10)).isEqualTo(1);
        AngularMask right = AngularMask.of(LightSource.of(rect.withDoors(new BarnDoors(90, 10, 90, 90)), scene));
        assertThat(right.factor(0, -far, -10)).isZero();
        assertThat(right.factor(0, far, -10)).isEqualTo(1);
        AngularMask disc = AngularMask.of(LightSource.of(rect.withType(LightType.DISC), scene));
        assertThat(disc.factor(far, 0, -10)).as("disc").isZero();
        assertThat(disc.factor(-far, 0, -10)).as("disc").isEqualTo(1);
    }

    private static Light face(LightType type) {
        return Light.of("l", type).withPosition(StudioScene.of(type).camera().origin()).withDirection(new Vec3(0, 0, -1));
    }

    private static double factor(Light light, double x, double y, double z) {
        return AngularMask.of(LightSource.of(light, StudioScene.of(light.type()))).factor((float) x, (float) y, (float) z);
    }

    private static double tan(double degrees) {
        return Math.tan(Math.toRadians(degrees));
    }

    @ParameterizedTest
    @EnumSource(names = {"RECT", "DISC"})
    void profileOfFace_multipliesByDirection(LightType type) {
        Photometry half = new Photometry(Photometry.Type.C, new double[] {0, 40, 180}, new double[] {0}, new double[] {1, 2, 0});
        Light measured = face(type).withProfile(Optional.of(new IesProfile("p.ies", half)));
        assertThat(factor(measured, 0, 0, -10)).isEqualTo(0.5, within(1e-12));
        assertThat(factor(measured, 0, 10 * tan(20), -10)).isEqualTo(0.75, within(1e-6));
    }

    /** White above black, in a square around a cone of 45 degrees. */
    @ParameterizedTest
    @EnumSource(names = {"RECT", "DISC"})
    void goboOfFace_coversConeUpright(LightType type) {
        var image = new Texture(1, 2, new float[] {1, 1, 1, 0, 0, 0});
        Light projector = face(type).withGobo(Optional.of(new Gobo("half.png", image))).withBeam(Beam.OPEN.withCone(45));
        assertThat(factor(projector, 0, 6, -10)).isEqualTo(1, within(1e-12));
        assertThat(factor(projector, 3, -6, -10)).isZero();
        assertThat(factor(projector, 0, 2.5, -10)).isEqualTo(0.75, within(1e-12));
        Light narrow = projector.withBeam(Beam.OPEN.withCone(70).withSpread(45));
        assertThat(factor(narrow, 0, 2.5, -10)).as("the spread is narrower than the cone").isEqualTo(0.75 * 0.75, within(1e-12));
    }

    @ParameterizedTest
    @EnumSource(names = {"RECT", "DISC"})
    void hardCone_cutsOffBeyondItsAngle(LightType type) {
        Light cone = face(type).withBeam(Beam.OPEN.withCone(10));
        assertThat(factor(cone, 0, 0, -10)).isEqualTo(1);
        assertThat(factor(cone, 10 * TENTH * 0.99, 0, -10)).isEqualTo(1);
        assertThat(factor(cone, 0, -10 * TENTH * 1.01, -10)).isZero();
    }

    /** The curve of UsdLux: 1 up to 20 degrees, 0 from 40 on. */
    @Test
    void softCone_isTheSmoothCurveOfUsdLux() {
        Light cone = face(LightType.RECT).withBeam(Beam.OPEN.withCone(40).withSoftness(0.5));
        assertThat(factor(cone, tan(20) * 0.999, 0, -1)).isEqualTo(1);
        assertThat(factor(cone, tan(30), 0, -1)).isEqualTo(0.5, within(1e-6));
        assertThat(factor(cone, 0, tan(25), -1)).as("1 - t²(3 - 2t) at t = 1/4").isEqualTo(1 - 0.0625 * 2.5, within(1e-6));
        assertThat(factor(cone, tan(40) * 1.001, 0, -1)).isZero();
    }

    @Test
    void spread_isTheShareThatSlatsPass() {
        Light grid = face(LightType.DISC).withBeam(Beam.OPEN.withSpread(45));
        assertThat(factor(grid, 0, 0, -10)).isEqualTo(1);
        assertThat(factor(grid, 3, 4, -10)).as("1 - 5/10").isEqualTo(0.5, within(1e-12));
        assertThat(factor(grid, 0, 10.01, -10)).isZero();
        assertThat(factor(grid, 0, 1, 10)).as("behind").isZero();
    }

    @Test
    void openBeam_hasNoMask() {
        assertThat(AngularMask.of(LightSource.of(face(LightType.RECT), StudioScene.of(LightType.RECT)))).isNull();
        Light spot = face(LightType.SPOT).withBeam(Beam.OPEN.withCone(10));
        assertThat(AngularMask.of(LightSource.of(spot, StudioScene.of(LightType.SPOT)))).as("a spot has a cone of its own").isNull();
    }

    @Test
    void barnDoorPastAxis_cutsAxis() {
        assertThat(factor(new BarnDoors(90, -10, 90, 90), 0, 0, 0, -10)).isZero();
        assertThat(factor(new BarnDoors(90, -10, 90, 90), 0, -10 * TENTH * 1.01, 0, -10)).isEqualTo(1);
    }

    @Test
    void feather_fadesInsideEdge() {
        var right = new BarnDoors(90, 10, 90, 90);
        assertThat(factor(right, 20, 0, 0, -10)).as("midpoint").isEqualTo(0.5, within(1e-12));
        assertThat(factor(right, 20, -10 * TENTH * 1.01, 0, -10)).isEqualTo(1);
        assertThat(factor(right, 20, 10 * TENTH * 1.01, 0, -10)).isZero();
        double quarter = Math.tan(Math.toRadians(5));
        assertThat(factor(right, 20, 10 * quarter, 0, -10)).isEqualTo(0.25 * 0.25 * 2.5, within(1e-6));
    }

    @Test
    void twoBarnDoors_multiply() {
        var combined = new BarnDoors(90, 10, 90, 10);
        assertThat(factor(combined, 20, 0, 0, -10)).isEqualTo(0.25, within(1e-12));
    }

    @Test
    void downwardLight_usesZAsUp() {
        var scene = StudioScene.of(LightType.SPOT);
        Light light = Light.of("l", LightType.SPOT).withPosition(scene.camera().origin()).withDirection(new Vec3(0, -1, 0))
                .withDoors(new BarnDoors(90, 90, 90, 10));
        AngularMask mask = AngularMask.of(LightSource.of(light, scene));
        assertThat(mask.factor(0, -10, 5)).isZero();
        assertThat(mask.factor(0, -10, -5)).isEqualTo(1);
    }

    /** White above black, in a cone of 45 degrees: half its side is the distance. */
    @Test
    void gobo_coversConeUpright() {
        var scene = StudioScene.of(LightType.SPOT);
        var image = new Texture(1, 2, new float[] {1, 1, 1, 0, 0, 0});
        Light light = Light.of("l", LightType.SPOT).withPosition(scene.camera().origin()).withDirection(new Vec3(0, 0, -1)).withAngle(45)
                .withGobo(Optional.of(new Gobo("half.png", image)));
        AngularMask gobo = AngularMask.of(LightSource.of(light, scene));
        assertThat(gobo.factor(0, 6, -10)).isEqualTo(1, within(1e-12));
        assertThat(gobo.factor(3, -6, -10)).isZero();
        assertThat(gobo.factor(0, 0, -10)).as("between the centers").isEqualTo(0.5, within(1e-12));
        assertThat(gobo.factor(0, 2.5f, -10)).isEqualTo(0.75, within(1e-12));
    }

    @Test
    void redGobo_transmitsItsLuminance() {
        var scene = StudioScene.of(LightType.SPOT);
        Light light = Light.of("l", LightType.SPOT).withPosition(scene.camera().origin()).withDirection(new Vec3(0, 0, -1)).withAngle(0)
                .withGobo(Optional.of(new Gobo("red.png", new Texture(1, 1, new float[] {1, 0, 0}))));
        assertThat(AngularMask.of(LightSource.of(light, scene)).factor(0, 0, -10)).isEqualTo(0.2126, within(1e-9));
    }

    private static double profileFactor(LightType type, Vec3 direction, Photometry photometry, double x, double y, double z) {
        var scene = StudioScene.of(type);
        Light light = Light.of("l", type).withPosition(scene.camera().origin()).withDirection(direction).withAngle(180)
                .withProfile(Optional.of(new IesProfile("p.ies", photometry)));
        return AngularMask.of(LightSource.of(light, scene)).factor((float) x, (float) y, (float) z);
    }

    @Test
    void typeCProfile_usesPolarAndAzimuthAngles() {
        // Right, top, left, bottom for a light that looks along −z; 0 within 45 degrees of the backward axis.
        var p = new Photometry(Photometry.Type.C, new double[] {0, 90, 135}, new double[] {0, 90, 180, 270, 360},
                new double[] {8, 4, 0, 8, 1, 0, 8, 2, 0, 8, 3, 0, 8, 4, 0});
        Vec3 front = new Vec3(0, 0, -1);
        assertThat(profileFactor(LightType.SPOT, front, p, 0, 0, -10)).isEqualTo(1);
        assertThat(profileFactor(LightType.SPOT, front, p, 10, 0, 0)).isEqualTo(0.5, within(1e-6));
        assertThat(profileFactor(LightType.SPOT, front, p, 0, 10, 0)).isEqualTo(0.125, within(1e-6));
        assertThat(profileFactor(LightType.SPOT, front, p, -10, 0, 0)).isEqualTo(0.25, within(1e-6));
        assertThat(profileFactor(LightType.SPOT, front, p, 0, -10, 0)).isEqualTo(0.375, within(1e-6));
        assertThat(profileFactor(LightType.SPOT, front, p, 10, 0, -10)).as("half way to the right").isEqualTo(0.75, within(1e-6));
        assertThat(profileFactor(LightType.SPOT, front, p, 10, 10, 0)).as("between right and top").isEqualTo(2.5 / 8, within(1e-6));
        assertThat(profileFactor(LightType.SPOT, front, p, 1, 0, 10)).as("outside the measured range").isZero();
    }

    @Test
    void pointLightProfile_pointsDown() {
        var p = new Photometry(Photometry.Type.C, new double[] {0, 90, 180}, new double[] {0}, new double[] {4, 2, 0});
        assertThat(profileFactor(LightType.POINT, new Vec3(1, 0, 0), p, 0, -3, 0)).isEqualTo(1);
        assertThat(profileFactor(LightType.POINT, new Vec3(1, 0, 0), p, 3, 0, 0)).isEqualTo(0.5, within(1e-6));
        assertThat(profileFactor(LightType.POINT, new Vec3(1, 0, 0), p, 0, 3, 0)).isZero();
    }

    /** As documented in docs/jen-format.md: 0 towards −x, 90 towards z. */
    @Test
    void pointLightProfile_startsAtMinusX() {
        var c = new Photometry(Photometry.Type.C, new double[] {0, 90}, new double[] {0, 90, 180, 270, 360},
                new double[] {8, 8, 8, 1, 8, 2, 8, 3, 8, 8});
        assertThat(profileFactor(LightType.POINT, Vec3.Y, c, -5, 0, 0)).as("0").isEqualTo(1, within(1e-6));
        assertThat(profileFactor(LightType.POINT, Vec3.Y, c, 0, 0, 5)).as("90").isEqualTo(1 / 8.0, within(1e-6));
        assertThat(profileFactor(LightType.POINT, Vec3.Y, c, 5, 0, 0)).as("180").isEqualTo(2 / 8.0, within(1e-6));
        assertThat(profileFactor(LightType.POINT, Vec3.Y, c, 0, 0, -5)).as("270").isEqualTo(3 / 8.0, within(1e-6));
        // Planes to the left, ahead, to the right; in each downwards, ahead, upwards.
        double[] angles = {-90, 0, 90};
        var a = new Photometry(Photometry.Type.A, angles, angles, new double[] {1, 2, 3, 4, 8, 5, 6, 7, 0});
        assertThat(profileFactor(LightType.POINT, Vec3.Y, a, 0, -5, 0)).as("ahead").isEqualTo(1, within(1e-6));
        assertThat(profileFactor(LightType.POINT, Vec3.Y, a, -5, 0, 0)).as("right").isEqualTo(7 / 8.0, within(1e-6));
        assertThat(profileFactor(LightType.POINT, Vec3.Y, a, 0, 0, 5)).as("upwards").isEqualTo(5 / 8.0, within(1e-6));
    }

    @Test
    void typeAAndBProfiles_useVerticalAndHorizontalAxis() {
        double[] angles = {-90, 0, 90};
        // Planes to the left, ahead, to the right; in each downwards, ahead, upwards.
        double[] candela = {1, 2, 3, 4, 8, 5, 6, 7, 0};
        Vec3 front = new Vec3(0, 0, -1);
        for (Photometry.Type type : new Photometry.Type[] {Photometry.Type.A, Photometry.Type.B}) {
            var p = new Photometry(type, angles, angles, candela);
            assertThat(profileFactor(LightType.SPOT, front, p, 0, 0, -5)).isEqualTo(1);
            assertThat(profileFactor(LightType.SPOT, front, p, 5, 0, 0)).as("right").isEqualTo(7 / 8.0, within(1e-6));
            assertThat(profileFactor(LightType.SPOT, front, p, -5, 0, 0)).as("left").isEqualTo(2 / 8.0, within(1e-6));
            assertThat(profileFactor(LightType.SPOT, front, p, 0, 0, 5)).as("behind").isZero();
        }
        // Half to the right and half up: 45 degrees and atan(1/√2) with vertical planes, the reverse with horizontal ones.
        double small = Math.toDegrees(Math.atan(Math.sqrt(0.5))) / 90;
        double low = 8 + (7 - 8) * 0.5;
        double high = 5 + (0 - 5) * 0.5;
        assertThat(profileFactor(LightType.SPOT, front, new Photometry(Photometry.Type.A, angles, angles, candela), 5, 5, -5))
                .isEqualTo((low + (high - low) * small) / 8, within(1e-6));
        double first = 8 + (5 - 8) * 0.5;
        double second = 7 + (0 - 7) * 0.5;
        assertThat(profileFactor(LightType.SPOT, front, new Photometry(Photometry.Type.B, angles, angles, candela), 5, 5, -5))
                .isEqualTo((first + (second - first) * small) / 8, within(1e-6));
    }

    @Test
    void openBarnDoors_haveNoMask() {
        var scene = StudioScene.of(LightType.SPOT);
        assertThat(AngularMask.of(LightSource.of(Light.of("l", LightType.SPOT).withFeather(9), scene))).isNull();
        assertThat(AngularMask.of(LightSource.of(Light.of("l", LightType.POINT).withDoors(new BarnDoors(0, 0, 0, 0)), scene))).isNull();
    }
}
