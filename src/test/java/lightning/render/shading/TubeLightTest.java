package lightning.render.shading;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.assertj.core.data.Percentage.withPercentage;

import java.util.List;
import lightning.base.math.Rgb;
import lightning.base.math.Transform;
import lightning.base.math.Vec3;
import lightning.render.shading.reference.ReferenceTracer;
import lightning.scene.Camera;
import lightning.scene.PictureSettings;
import lightning.scene.Scene;
import lightning.scene.World;
import lightning.scene.light.AreaShape;
import lightning.scene.light.FaceVisibility;
import lightning.scene.light.Falloff;
import lightning.scene.light.IntensityUnit;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import lightning.scene.material.Material;
import lightning.scene.node.Shape;
import lightning.scene.node.Solid;
import lightning.scene.value.Placement;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class TubeLightTest {
    private static final double LENGTH = 2;
    private static final double RADIUS = 0.01;

    private static Light tube(Vec3 at, Vec3 axis) {
        return Light.of("tube", LightType.TUBE).withPosition(at).withDirection(axis).withFalloff(Falloff.INVERSE_SQUARE)
                .withArea(AreaShape.DEFAULT.withRadius(RADIUS).withHeight(LENGTH).withSamples(64));
    }

    /** Returns the value of white paper at the origin that faces up. */
    private static double paper(Light light) {
        Material white = Material.of("white").withAmbient(Rgb.BLACK).withDiffuse(Rgb.WHITE).withSpecular(Rgb.BLACK);
        var plane = new Shape(Solid.PLANE, "paper", "white", new Placement(Vec3.ZERO, Vec3.ZERO, new Vec3(9, 1, 9)));
        var camera = new Camera(new Vec3(0, 0.2, 0.01), Vec3.ZERO, Vec3.Y, 0.1);
        return new ReferenceTracer(
                new Scene(new PictureSettings(1, 1, 0), camera, new World(0, Rgb.BLACK), List.of(white), List.of(plane), List.of(light)))
                .trace().red(0, 0);
    }

    /**
     * Above the paper, at height h, parallel to it, a thin tube of half length a and intensity I to its side gives the irradiance ∫ I/(2a) · sin θ · cos θ' / d²
     * dx with sin θ = cos θ' = h/d: I/(2a) · h² ∫ (x² + h²)⁻² dx = I/(2a) · (a/(a² + h²) + atan(a/h)/h).
     */
    @ParameterizedTest
    @CsvSource({"1", "2", "5"})
    void parallelTube_hasTheIrradianceOfALambertianLine(double h) {
        double a = LENGTH / 2;
        double expected = (a / (a * a + h * h) + Math.atan(a / h) / h) / (2 * a);
        assertThat(paper(tube(new Vec3(0, h, 0), new Vec3(1, 0, 0)))).isCloseTo(expected, withPercentage(0.5));
    }

    @Test
    void endOfTube_isDark() {
        double side = paper(tube(new Vec3(0, 4, 0), new Vec3(1, 0, 0)));
        assertThat(paper(tube(new Vec3(0, 4, 0), Vec3.Y))).isLessThan(0.01 * side);
    }

    /** The flux of a Lambertian line is π² times its intensity to the side. */
    @Test
    void lumen_isTheFluxOfTheSide() {
        Light light = tube(Vec3.ZERO, Vec3.Y);
        assertThat(IntensityUnit.CANDELA.relative(light, 1) / IntensityUnit.LUMEN.relative(light, 1)).isCloseTo(Math.PI * Math.PI,
                withPercentage(1e-9));
    }

    @Test
    void face_isACylinderOfItsSize() {
        Light light = tube(new Vec3(1, 2, 3), new Vec3(0, 0, 2)).withArea(tube(Vec3.ZERO, Vec3.Y).area().withRadius(0.5)
                .withVisibility(FaceVisibility.GLOWING));
        Scene scene = new Scene(new PictureSettings(1, 1, 0), Camera.DEFAULT, World.DEFAULT, List.of(), List.of(), List.of(light));
        Transform place = scene.stage().rendered().placedShapes().getFirst().toWorld();
        assertThat(place.transformPoint(Vec3.ZERO).minus(new Vec3(1, 2, 2)).length()).isCloseTo(0, within(1e-9));
        assertThat(place.transformVector(Vec3.Y).minus(new Vec3(0, 0, 2)).length()).isCloseTo(0, within(1e-9));
        assertThat(place.transformVector(new Vec3(0, 0, 1)).length()).isCloseTo(0.5, within(1e-9));
    }
}
