package lightning.render.shading;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.data.Percentage.withPercentage;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import lightning.base.math.Rgb;
import lightning.base.math.Transform;
import lightning.base.math.Vec3;
import lightning.render.shading.reference.ReferenceTracer;
import lightning.scene.Camera;
import lightning.scene.PictureSettings;
import lightning.scene.Scene;
import lightning.scene.World;
import lightning.scene.asset.Texture;
import lightning.scene.asset.TextureMap;
import lightning.scene.light.AreaShape;
import lightning.scene.light.Falloff;
import lightning.scene.light.IntensityUnit;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import lightning.scene.light.ObjectSurface;
import lightning.scene.material.Bulb;
import lightning.scene.material.Material;
import lightning.scene.node.Mesh;
import lightning.scene.node.Shape;
import lightning.scene.node.Solid;
import lightning.scene.value.Placement;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Lights whose surface is a shape of the scene, on white paper at the origin that faces up. */
class ObjectLightTest {
    private static final double RADIUS = 0.5;
    private static final int SIZE = 12;
    private static final int ROWS = 16;

    private static Light lamp() {
        return Light.of("lamp", LightType.OBJECT).withFalloff(Falloff.INVERSE_SQUARE)
                .withArea(AreaShape.DEFAULT.withShape("bulb").withSamples(64));
    }

    private static Scene scene(Solid solid, Placement place, Light light, Shape... others) {
        Material white = Material.of("white").withAmbient(Rgb.BLACK).withDiffuse(Rgb.WHITE).withSpecular(Rgb.BLACK);
        Material glow = white.withName("glow").withDiffuse(Rgb.BLACK).withBulb(Bulb.NONE.withLight("lamp"));
        var shapes = new ArrayList<lightning.scene.node.SceneNode>(List.of(others));
        shapes.add(new Shape(Solid.PLANE, "paper", "white", new Placement(Vec3.ZERO, Vec3.ZERO, new Vec3(9, 1, 9))));
        shapes.add(new Shape(solid, "bulb", "glow", place));
        var camera = new Camera(new Vec3(0, 0.2, 0.01), Vec3.ZERO, Vec3.Y, 5);
        return new Scene(new PictureSettings(SIZE, SIZE, 0), camera, new World(0, Rgb.BLACK), List.of(white, glow), shapes,
                List.of(light));
    }

    /** Returns the mean value of the paper near the origin, over many rotations of the samples. */
    private static double paper(Scene scene) {
        var film = new ReferenceTracer(scene).trace();
        double sum = 0;
        for (int i = 0; i < SIZE * SIZE; i++) {
            sum += film.green(i % SIZE, i / SIZE);
        }
        return sum / (SIZE * SIZE);
    }

    private static Placement ballAt(double height) {
        return new Placement(new Vec3(0, height, 0), Vec3.ZERO, Vec3.ONE.times(RADIUS));
    }

    private static Rgb glow(Scene scene) {
        return scene.stage().materialsByName().get("glow").emission();
    }

    /** The form factor of a ball of radius r at distance d is (r/d)². */
    @ParameterizedTest
    @CsvSource({"1", "2", "5"})
    void ball_hasTheIrradianceOfItsFormFactor(double height) {
        Scene scene = scene(Solid.SPHERE, ballAt(height), lamp());
        double expected = glow(scene).g() * RADIUS * RADIUS / (height * height);
        assertThat(paper(scene)).isCloseTo(expected, withPercentage(1));
    }

    /** The glow is the radiance that the power of the light needs: π times weight over area. */
    @Test
    void glow_isTheRadianceOfTheSurface() {
        Scene scene = scene(Solid.SPHERE, ballAt(2), lamp().withIntensity(3));
        assertThat(glow(scene).g()).isCloseTo(3 * Math.PI / (4 * Math.PI * RADIUS * RADIUS), withPercentage(0.2));
    }

    @Test
    void nit_isTheGlow() {
        Light light = lamp().withIntensity(7);
        Scene scene = scene(Solid.SPHERE, ballAt(2), light.withEmission(light.emission().withUnit(IntensityUnit.NIT)));
        assertThat(glow(scene).g()).isCloseTo(7, withPercentage(1e-6));
    }

    /** Form factor of a disc of radius r, parallel at distance h: r²/(r² + h²). A plane of the same size as a mesh shines to both sides. */
    @ParameterizedTest
    @CsvSource({"1", "-1"})
    void openSurface_shinesToBothSides(int sign) {
        double half = 0.01;
        float[] corners = {-1, 0, -1, 1, 0, -1, 1, 0, 1, -1, 0, 1};
        int[] triangles = sign > 0 ? new int[] {0, 1, 2, 0, 2, 3} : new int[] {0, 2, 1, 0, 3, 2};
        var mesh = new Solid.TriangleMesh("a.obj", "", new Mesh(corners, triangles, null, null, null));
        Scene scene = scene(mesh, new Placement(new Vec3(0, 1, 0), Vec3.ZERO, new Vec3(half, 1, half)), lamp());
        assertThat(paper(scene)).isCloseTo(glow(scene).g() * 4 * half * half / Math.PI, withPercentage(0.5));
    }

    /** The samples of a closed mesh lie on its outer side only, whichever way its triangles turn. */
    @ParameterizedTest
    @CsvSource({"false, 1", "true, 1", "false, -1", "true, -1"})
    void closedMesh_shinesOutwards(boolean isTurned, int mirror) {
        var surface = new ObjectSurface(cube(isTurned), Transform.scaling(new Vec3(mirror, 1, 2)), Optional.empty(), null);
        assertThat(surface.area()).isCloseTo(4 * (2 + 4 + 4), withPercentage(1e-9));
        assertThat(surface.emittingArea()).isCloseTo(surface.area(), withPercentage(1e-9));
        for (int i = 0; i < 100; i++) {
            ObjectSurface.Point point = surface.point(i / 100.0, i * 0.618 % 1, Vec3.ZERO);
            assertThat(point.bothSides()).isFalse();
            assertThat(point.normal().dot(point.position())).isPositive();
        }
    }

    private static Solid.TriangleMesh cube(boolean isTurned) {
        float[] corners = new float[24];
        for (int i = 0; i < 24; i++) {
            corners[i] = (i / 3 >> i % 3 & 1) == 0 ? -1 : 1;
        }
        int[] triangles = {0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4, 2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5};
        for (int i = 0; isTurned && i < triangles.length; i += 3) {
            int swapped = triangles[i];
            triangles[i] = triangles[i + 1];
            triangles[i + 1] = swapped;
        }
        return new Solid.TriangleMesh("cube.obj", "", new Mesh(corners, triangles, null, null, null));
    }

    /** No part of a cube shadows the light of another, so it is as bright as its lower face alone. */
    @Test
    void ownSurface_doesNotShadowWhatFacesThePaper() {
        double half = 0.01;
        Scene scene = scene(cube(false), new Placement(new Vec3(0, 1, 0), Vec3.ZERO, Vec3.ONE.times(half)), lamp());
        assertThat(paper(scene)).isCloseTo(glow(scene).g() * 4 * half * half / Math.PI, withPercentage(4));
    }

    @Test
    void otherShape_castsASoftShadow() {
        var card = new Shape(Solid.PLANE, "card", "white", new Placement(new Vec3(1, 1, 0), Vec3.ZERO, new Vec3(2, 1, 2)));
        double free = paper(scene(Solid.SPHERE, ballAt(2), lamp()));
        assertThat(paper(scene(Solid.SPHERE, ballAt(2), lamp(), card))).isBetween(0.4 * free, 0.6 * free);
    }

    @Test
    void missingShape_isDark() {
        Scene scene = scene(Solid.SPHERE, ballAt(2), lamp().withArea(lamp().area().withShape("")));
        assertThat(paper(scene)).isZero();
        assertThat(glow(scene)).isEqualTo(Rgb.BLACK);
    }

    /** The upper half of the image is on the upper half of the ball, which the paper does not see. */
    @Test
    void glowMap_colorsTheLightOfItsParts() {
        float[] rgb = new float[3 * ROWS];
        Arrays.fill(rgb, rgb.length / 2, rgb.length, 1);
        var map = new TextureMap("half.png", 1, 1, new Texture(1, ROWS, rgb));
        Scene plain = scene(Solid.SPHERE, ballAt(2), lamp());
        Scene half = withGlowMap(plain, map);
        Scene other = withGlowMap(plain, new TextureMap("half.png", 1, 1, new Texture(1, ROWS, reversed(rgb))));
        assertThat(paper(half)).isGreaterThan(0.99 * paper(plain));
        assertThat(paper(other)).isLessThan(0.01 * paper(plain));
    }

    private static float[] reversed(float[] rgb) {
        float[] reversed = new float[rgb.length];
        for (int i = 0; i < rgb.length; i++) {
            reversed[i] = rgb[rgb.length - 1 - i];
        }
        return reversed;
    }

    private static Scene withGlowMap(Scene scene, TextureMap map) {
        return scene.withStage(scene.stage().withMaterials(scene.materials().stream()
                .map(m -> m.name().equals("glow") ? m.withGlowMap(Optional.of(map)) : m).toList()));
    }

    @Test
    void points_areOnTheSurfaceAndEvenlySpread() {
        for (Solid.Canonical solid : Solid.CANONICAL) {
            var surface = new ObjectSurface(solid, Transform.scaling(new Vec3(1, 2, 3)), Optional.empty(), null);
            int upper = 0;
            int steps = 200;
            for (int i = 0; i < steps * steps; i++) {
                upper += surface.point((i / steps + 0.5) / steps, (i % steps + 0.5) / steps, Vec3.ZERO).position().x() > 0 ? 1 : 0;
            }
            assertThat(upper).as(solid.typeName()).isCloseTo(steps * steps / 2, withPercentage(2));
        }
    }

    @Test
    void renamedShape_keepsItsLight() {
        Scene scene = scene(Solid.SPHERE, ballAt(2), lamp());
        Shape renamed = ((Shape) scene.stage().node("bulb").orElseThrow()).withName("globe");
        assertThat(scene.withNode("bulb", renamed).light("lamp").orElseThrow().area().shape()).isEqualTo("globe");
        assertThat(scene.replaceNode("bulb", List.of()).light("lamp").orElseThrow().area().shape()).isEmpty();
    }
}
