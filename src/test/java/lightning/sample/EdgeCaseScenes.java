package lightning.sample;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.scene.Camera;
import lightning.scene.OverflowCheck;
import lightning.scene.PictureSettings;
import lightning.scene.Scene;
import lightning.scene.World;
import lightning.scene.asset.Texture;
import lightning.scene.asset.TextureMap;
import lightning.scene.light.FaceVisibility;
import lightning.scene.light.Light;
import lightning.scene.light.LightRig;
import lightning.scene.light.LightType;
import lightning.scene.material.Material;
import lightning.scene.material.ShadingModel;
import lightning.scene.material.SurfaceMaps;
import lightning.scene.node.NodeGroup;
import lightning.scene.node.SceneNode;
import lightning.scene.node.Shape;
import lightning.scene.node.Solid;
import lightning.scene.value.Attenuation;
import lightning.scene.value.Placement;
import lightning.scene.value.SceneLimits;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;

/**
 * Scenes at the limits of the file format: most numbers are the minimum, the maximum or the simplest that {@link SceneLimits} allows. The
 * camera looks at the first shape, from as near or as far as possible.
 */
public final class EdgeCaseScenes {
    /** Maps whose channels have the least and the largest factors. */
    private static final SurfaceMaps DARK_AND_LIGHT = SurfaceMaps.NONE
            .withRoughness(Optional.of(new TextureMap("m.png", 1, 1, new Texture(2, 1, new float[] {0, 0, 1, 0, 1, 0}))))
            .withMetalness(Optional.of(new TextureMap("m.png", 1, 1, new Texture(2, 1, new float[] {0, 0, 1, 0, 1, 0}))));

    private EdgeCaseScenes() {}

    /** Returns all such scenes that {@link Scene} accepts. */
    public static Arbitrary<Scene> scenes() {
        Arbitrary<List<SceneNode>> nodes = nodes().list().ofMinSize(1).ofMaxSize(4);
        Arbitrary<List<Light>> lights = lights().list().ofMaxSize(4);
        return Combinators.combine(lights, nodes, materials(), Arbitraries.of(new World(0, Rgb.BLACK),
                new World(SceneLimits.MAX_AMBIENCE, Rgb.gray(SceneLimits.MAX_EMISSION))), views(),
                Arbitraries.of(0, 1, SceneLimits.MAX_DEPTH))
                .as(EdgeCaseScenes::assemble);
    }

    /** Position of the camera relative to the first shape, and its units. */
    private record View(Vec3 direction, double distance, double fov) {}

    private static Scene assemble(List<Light> lights, List<SceneNode> nodes, Material material, World world, View view, int depth) {
        List<SceneNode> named = new ArrayList<>();
        for (SceneNode node : nodes) {
            named.add(withName(node, "n" + named.size()));
        }
        List<Light> lit = new ArrayList<>();
        for (Light light : lights) {
            lit.add(light.withName("l" + lit.size()));
        }
        PictureSettings picture = new PictureSettings(9, 7, depth);
        Scene scene = dimmed(new Scene(picture, Camera.DEFAULT, world, List.of(material), named, List.of()), LightRig.of(lit));
        Vec3 at = scene.placedShapes().getFirst().toWorld().transformPoint(Vec3.ZERO);
        Vec3 to = clamp(at);
        Vec3 from = clamp(to.plus(view.direction.times(view.distance)));
        try {
            return scene.withCamera(new Camera(from, to, new Vec3(0.1, 1, 0.2), view.fov));
        } catch (IllegalArgumentException tooNear) {
            return scene.withCamera(new Camera(new Vec3(0, 0, SceneLimits.MAX_COORDINATE), Vec3.ZERO, Vec3.Y, view.fov));
        }
    }

    /** Returns a scene with these lights and groups, dimmed if necessary to the maximum that its materials allow. */
    public static Scene dimmed(Scene scene, LightRig rig) {
        Scene dark = scene.withLights(List.of());
        LightRig lit = rig;
        for (Optional<OverflowCheck> glare = OverflowCheck.of(dark.stage(), lit); glare.isPresent();
                glare = OverflowCheck.of(dark.stage(), lit)) {
            double factor = glare.get().limit() / glare.get().sum() * 0.999999;
            lit = lit.withLights(lit.lights().stream().map(light -> light.withIntensity(light.intensity() * factor)).toList());
        }
        return dark.withRig(lit);
    }

    /**
     * Returns a scene with the lights and the world of another one. Lights have the faces of the scene, since pictures in mirrors may be
     * of a scene with other lights but not of one with other shapes.
     */
    public static Scene withLightsOf(Scene lit, Scene scene) {
        List<Light> lights = new ArrayList<>(scene.lights().stream()
                .filter(light -> light.area().visibility() != FaceVisibility.HIDDEN)
                .map(light -> light.withIntensity(0)).toList());
        lit.rig().effectiveLights().forEach(light -> lights.add(light.withName("other " + light.name())
                .withArea(light.area().withVisibility(FaceVisibility.HIDDEN))));
        return dimmed(scene, scene.rig().withLights(lights)).withWorld(lit.world());
    }

    private static Vec3 clamp(Vec3 p) {
        double max = SceneLimits.MAX_COORDINATE;
        return new Vec3(Math.clamp(p.x(), -max, max), Math.clamp(p.y(), -max, max), Math.clamp(p.z(), -max, max));
    }

    private static Arbitrary<View> views() {
        Arbitrary<Vec3> directions =
                Arbitraries.of(new Vec3(0, 0, 1), Vec3.Y, new Vec3(0, 0.5, 1), new Vec3(1, 1e-9, 0), new Vec3(1, 1, 1));
        return Combinators.combine(directions, Arbitraries.of(3.0, 0.3, 1e-9, 1e-3, 1e3, 1e6, 1e9, 1e12),
                Arbitraries.of(40.0, SceneLimits.MIN_FOV, SceneLimits.MAX_FOV)).as(View::new);
    }

    private static Arbitrary<Vec3> vectors(Double... values) {
        Arbitrary<Double> one = Arbitraries.of(values);
        return Combinators.combine(one, one, one).as(Vec3::new);
    }

    private static Arbitrary<Vec3> rotations() {
        return Arbitraries.oneOf(Arbitraries.just(Vec3.ZERO), NumberArbitraries.vectors(-180, 180),
                vectors(0.0, 45.0, 90.0, 1e-9, SceneLimits.MAX_ROTATION));
    }

    private static Arbitrary<Vec3> places() {
        return Arbitraries.oneOf(Arbitraries.just(Vec3.ZERO),
                vectors(0.0, 1.0, -1e3, 1e8, SceneLimits.MAX_COORDINATE, -SceneLimits.MAX_COORDINATE));
    }

    private static Arbitrary<SceneNode> nodes() {
        Arbitrary<Vec3> scales =
                Arbitraries.oneOf(Arbitraries.just(Vec3.ONE),
                        vectors(1.0, -1.0, 1e-3, 1e6, 1e-6, SceneLimits.MIN_SCALE, SceneLimits.MAX_SCALE));
        Arbitrary<SceneNode> shapes = Combinators.combine(solids(), places(), rotations(), scales)
                .as((solid, at, turn, scale) -> new Shape(solid, "s", "m", new Placement(at, turn, scale)));
        return Arbitraries.oneOf(shapes, skewedNodes());
    }

    private static Arbitrary<Solid> solids() {
        return Arbitraries.oneOf(SolidArbitraries.solids(),
                Arbitraries.of(0.0, 1.0, SceneLimits.MAX_TOP).map(top -> new Solid.Frustum(top, true)));
    }

    /** Returns a shape in groups that stretch it along skewed axes, nested as deeply as allowed. */
    private static Arbitrary<SceneNode> skewedNodes() {
        Arbitrary<Vec3> half = vectors(1.0, 3e4, 1 / 3e4, 1e3, 1e-3);
        Arbitrary<Vec3> nodes = vectors(1.0, SceneLimits.MIN_SCALE, SceneLimits.MAX_SCALE);
        return Combinators.combine(solids(), places(), rotations(), Arbitraries.oneOf(
                Combinators.combine(half, half).as(List::of), nodes.map(w -> List.of(w, Vec3.ONE))), rotations())
                .as((solid, at, turn, scales, outerTurn) -> new NodeGroup("outer", new Placement(at, outerTurn, scales.getFirst()),
                        List.of(new Shape(solid, "s", "m", new Placement(Vec3.ZERO, turn, scales.getLast())))));
    }

    private static SceneNode withName(SceneNode node, String name) {
        return switch (node) {
            case NodeGroup g -> new NodeGroup(name, g.placement(), List.of(withName(g.children().getFirst(), name + "_0")));
            case Shape s -> s.withName(name);
        };
    }

    private static Arbitrary<Material> materials() {
        return Arbitraries.oneOf(phong(), metallic());
    }

    private static Arbitrary<Material> metallic() {
        Arbitrary<Rgb> factors = Arbitraries.of(Rgb.BLACK, Rgb.WHITE, new Rgb(0, 1, 0.5));
        Arbitrary<Double> shares = Arbitraries.of(0.0, 1e-300, 0.5, 1.0);
        return Combinators
                .combine(Arbitraries.of(0.0, SceneLimits.MAX_EMISSION), Arbitraries.of(0.0, 1e-300, SceneLimits.MAX_EMISSION), factors,
                        shares, shares, shares, factors)
                .as((ambient, glow, base, metalness, roughness, f0, reflective) -> Material.of("m")
                        .withModel(reflective.isBlack() ? ShadingModel.PRINCIPLED : ShadingModel.METALLIC)
                        .withAmbient(Rgb.gray(ambient)).withGlow(Rgb.gray(glow)).withBase(base).withMetalness(metalness)
                        .withRoughness(roughness).withF0(f0)
                        .withReflective(reflective).withSurfaceMaps(f0 == 0 ? DARK_AND_LIGHT : SurfaceMaps.NONE));
    }

    private static Arbitrary<Material> phong() {
        Arbitrary<Rgb> factors = Arbitraries.of(Rgb.BLACK, Rgb.WHITE, new Rgb(0, 1, 0.5));
        return Combinators
                .combine(Arbitraries.of(0.0, SceneLimits.MAX_EMISSION), Arbitraries.of(0.0, 1e-300, SceneLimits.MAX_EMISSION), factors,
                        factors,
                        Arbitraries.of(0.0, 1e-300, 0.5, 16.0, SceneLimits.MAX_SHININESS), factors)
                .as((ambient, glow, diffuse, specular, shininess, reflective) -> Material.of("m").withAmbient(Rgb.gray(ambient))
                        .withGlow(Rgb.gray(glow))
                        .withDiffuse(diffuse).withSpecular(specular).withShininess(shininess).withReflective(reflective));
    }

    private static Arbitrary<Light> lights() {
        Arbitrary<Double> factors = Arbitraries.of(0.0, 1e-300, 1e-30, 1.0, SceneLimits.MAX_ATTENUATION);
        Arbitrary<Light> plain = Combinators.combine(Arbitraries.of(LightType.class),
                Arbitraries.of(0.0, 1e-300, 1e-38, 1.0, SceneLimits.MAX_INTENSITY),
                Arbitraries.of(0.0, 1e-7, 90.0, SceneLimits.MAX_ANGLE), Arbitraries.of(0.0, 0.1, 128.0, SceneLimits.MAX_DROPOFF))
                .as((type, intensity, angle, dropoff) -> Light.of("l", type).withIntensity(intensity).withAngle(angle)
                        .withDropoff(dropoff));
        return Combinators
                .combine(plain, Arbitraries.of(Rgb.WHITE, Rgb.gray(SceneLimits.MAX_LIGHT_COLOR), new Rgb(0, 1e-300, 1000)), places(),
                        vectors(1.0, -1.0, 1e-9, SceneLimits.MAX_COORDINATE),
                        Combinators.combine(factors, factors, factors).as(Attenuation::new))
                .as((light, color, at, direction, attenuation) -> light.withColor(color).withPosition(at)
                        .withDirection(direction).withAttenuation(attenuation));
    }
}
