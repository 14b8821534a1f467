package lightning.sample;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.UnaryOperator;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.scene.AntialiasMode;
import lightning.scene.Camera;
import lightning.scene.Contribution;
import lightning.scene.IndirectSettings;
import lightning.scene.PictureSettings;
import lightning.scene.SamplingSettings;
import lightning.scene.Scene;
import lightning.scene.ViewCurve;
import lightning.scene.ViewSettings;
import lightning.scene.World;
import lightning.scene.asset.Environment;
import lightning.scene.asset.EnvironmentMap;
import lightning.scene.asset.Gobo;
import lightning.scene.asset.IesProfile;
import lightning.scene.asset.LightTexture;
import lightning.scene.asset.Texture;
import lightning.scene.asset.TextureChannel;
import lightning.scene.asset.TextureMap;
import lightning.scene.asset.TexturePlacement;
import lightning.scene.asset.TextureWrap;
import lightning.scene.light.AreaShape;
import lightning.scene.light.Beam;
import lightning.scene.light.Emission;
import lightning.scene.light.FaceVisibility;
import lightning.scene.light.Falloff;
import lightning.scene.light.FilterShape;
import lightning.scene.light.IntensityUnit;
import lightning.scene.light.Light;
import lightning.scene.light.LightFilter;
import lightning.scene.light.LightFlag;
import lightning.scene.light.LightGroup;
import lightning.scene.light.LightType;
import lightning.scene.material.AlphaCutout;
import lightning.scene.material.Anisotropy;
import lightning.scene.material.Bulb;
import lightning.scene.material.Coat;
import lightning.scene.material.Material;
import lightning.scene.material.ShadingModel;
import lightning.scene.material.ShadowCasting;
import lightning.scene.material.Sheen;
import lightning.scene.material.SurfaceMaps;
import lightning.scene.material.Transmission;
import lightning.scene.node.NodeGroup;
import lightning.scene.node.SceneNode;
import lightning.scene.node.Shape;
import lightning.scene.node.Solid;
import lightning.scene.sky.Sky;
import lightning.scene.value.Attenuation;
import lightning.scene.value.BarnDoors;
import lightning.scene.value.DomeRotation;
import lightning.scene.value.Fog;
import lightning.scene.value.Lens;
import lightning.scene.value.LensShift;
import lightning.scene.value.Photometry;
import lightning.scene.value.Placement;
import lightning.scene.value.ShapeGains;
import lightning.scene.value.ShapeLinks;

/**
 * Features of scenes for {@link FeatureSets}. Each is added to a small base scene: a floor and a ball with two lights. They apply in the
 * order of the constants, so those that change all lights or nodes come after those that add some. No feature hides another, except for the
 * {@link #excludes pairs} of which a scene has one at most.
 */
public enum SceneFeature {
    MESH(scene -> add(scene, new Shape(SampleMeshes.solid(SampleMeshes.withVertexColors(SampleMeshes.beveledCube(0.2))), "block", "paint",
            placement(new Vec3(1.7, -0.4, 0.3), 0.6)))),
    MIRROR(scene -> floor(scene, floor -> floor.withReflective(new Rgb(0.5, 0.6, 0.4)))),
    METALLIC(scene -> floor(scene, floor -> floor.withModel(ShadingModel.METALLIC).withBase(new Rgb(0.8, 0.6, 0.3)).withMetalness(0.7)
            .withRoughness(0.35))),
    GLASS(scene -> lens(scene, "glass", new Vec3(-1.6, -0.2, 1.2), material -> material
            .withTransmission(new Transmission(new Rgb(0.9, 1, 0.8), 1.5, false, Rgb.gray(0.8), 1, ShadowCasting.FULL)))),
    THIN_GLASS(scene -> lens(scene, "thin", new Vec3(1, 0.3, 2), material -> material
            .withTransmission(new Transmission(new Rgb(0.8, 0.9, 1), 1.3, true, Rgb.WHITE, 1, ShadowCasting.TINTED)))),
    FROSTED_GLASS(scene -> lens(scene, "frosted", new Vec3(0.2, -0.4, 1.8), material -> material.withModel(ShadingModel.PRINCIPLED)
            .withRoughness(0.4).withTransmission(Transmission.NONE.withColor(Rgb.gray(0.9)).withShadows(ShadowCasting.TINTED)))),
    BLURRED_REFLECTION(SceneFeature::principled),
    ANISOTROPY(scene -> paint(principled(scene), paint -> paint.withMetalness(0.8).withAnisotropy(new Anisotropy(0.7, 30)))),
    COAT(scene -> paint(principled(scene), paint -> paint.withCoat(new Coat(0.7, 0.2, 1.6)))),
    SHEEN(scene -> paint(principled(scene), paint -> paint.withSheen(new Sheen(new Rgb(0.6, 0.3, 0.4), 0.4)))),
    SURFACE_MAPS(scene -> paint(principled(scene), paint -> paint.withSurfaceMaps(SurfaceMaps.NONE.withRoughness(map())
            .withMetalness(map()).withMetalnessChannel(TextureChannel.RED)))),
    TEXTURE(scene -> scene.withMaterials(scene.materials().stream().map(material -> material.withTexture(map())).toList())),
    BUMP(scene -> paint(scene, paint -> paint.withBumpMapping(paint.bumpMapping().withBump(map()).withHeight(0.2)))),
    NORMAL_MAP(scene -> scene.withMaterials(scene.materials().stream().map(material -> material
            .withBumpMapping(material.bumpMapping().withNormalMap(map()).withStrength(0.4))).toList())),
    CUTOUT(scene -> paint(scene, paint -> paint.withCutout(new AlphaCutout(map(), 0.6)))),
    GLOW(scene -> paint(scene, paint -> paint.withGlow(new Rgb(0.1, 0.3, 0.2)).withBulb(Bulb.NONE.withLight("key").withExposure(-3)))),
    BLOCKER(scene -> lens(scene, "blocker", new Vec3(1.2, 2, 1), material -> material
            .withTransmission(Transmission.NONE.withShadows(ShadowCasting.ONLY)))),
    NODE_GROUP(scene -> scene.withNodes(List.of(scene.nodes().getFirst(), new NodeGroup("group",
            new Placement(new Vec3(0.1, 0.1, 0), new Vec3(5, 20, 10), new Vec3(1, 1.1, 0.9)),
            scene.nodes().subList(1, scene.nodes().size()),
            true)))),
    SPOT_WITH_DOORS(scene -> spot(scene, spot -> spot.withDoors(new BarnDoors(15, 90, 12, 90)).withFeather(4))),
    GOBO(scene -> spot(scene, spot -> spot.withGobo(Optional.of(new Gobo("gobo.png", checker()))))),
    IES_PROFILE(scene -> key(scene, key -> key.withProfile(Optional.of(new IesProfile("lamp.ies",
            new Photometry(Photometry.Type.C, new double[] {0, 40, 90}, new double[] {0, 60, 180},
                    new double[] {9, 5, 1, 8, 2, 0, 7, 7, 3})))))),
    AREA_LIGHT(scene -> panel(scene, panel -> panel.withBeam(new Beam(60, 0.5, 80)))),
    VISIBLE_LIGHT(scene -> panel(scene, panel -> panel.withArea(panel.area().withVisibility(FaceVisibility.GLOWING))
            .withTexture(Optional.of(new LightTexture("face.png", checker()))))),
    TUBE_LIGHT(scene -> add(scene, light("tube", LightType.TUBE).withPosition(new Vec3(-1, 2, -2)).withDirection(new Vec3(1, 0.2, 0))
            .withArea(AreaShape.DEFAULT.withRadius(0.05).withHeight(2).withSamples(4)))),
    OBJECT_LIGHT(scene -> add(add(scene, new Shape(Solid.SPHERE, "lamp", "floor", placement(new Vec3(-1.5, 1.8, 0.5), 0.3))),
            light("object", LightType.OBJECT).withArea(AreaShape.DEFAULT.withShape("lamp").withSamples(4)))),
    SUN(scene -> add(scene, light("sun", LightType.DIRECTIONAL).withDirection(new Vec3(-1, -2, -0.5))
            .withArea(AreaShape.DEFAULT.withSpread(5).withSamples(4)))),
    FLAG_AND_FILTER(scene -> key(scene, key -> key
            .withFlag(new LightFlag(true, new Vec3(1.2, 2, 1), new Vec3(90, 0, 0), 1.5, 1, 0.2, 0.8))
            .withFilter(new LightFilter(FilterShape.SPHERE, Vec3.ZERO, Vec3.ZERO, new Vec3(2, 2, 2), 0.5, 0.7, false)))),
    LIGHT_LINKS(scene -> key(add(scene, light("linked", LightType.POINT).withPosition(new Vec3(-3, 3, 1))
            .withIlluminates(ShapeLinks.except("floor"))), key -> key.withShadowedBy(ShapeLinks.except("ball")))),
    GAINS(scene -> lights(scene, light -> light
            .withInfluence(light.influence().withDiffuse(0.8).withSpecular(1.3).withFog(0.6).withGains(ShapeGains.of("ball", 0.5))))),
    INVERSE_SQUARE(scene -> lights(scene, light -> light.withFalloff(Falloff.INVERSE_SQUARE).withIntensity(6 * light.intensity()))),
    UNITS(scene -> lights(scene.withWorld(World.METERS.with(scene.world(), 0.5)), light -> light
            .withEmission(new Emission(4, light.type().hasPosition() ? IntensityUnit.LUMEN : IntensityUnit.LUX, 4000)))),
    ENVIRONMENT(scene -> world(scene,
            world -> world.withEnvironment(Optional.of(sky("sky.hdr", 0.4f))).withOwn(own -> own.withRotation(DomeRotation.of(30, 0, 0))))),
    SKY(scene -> world(scene, world -> world.withSky(Sky.NONE.withOn(true)))),
    DOME(scene -> world(scene,
            world -> world.withNamed(List.of(JenScenes.dome("dome", 0.5).withImage(Optional.of(sky("dome.hdr", 0.8f))))))),
    FOG(scene -> world(scene, world -> world.withFog(Fog.NONE.withDensity(0.06).withColor(new Rgb(0.7, 0.8, 0.9)).withAnisotropy(0.3)
            .withAmbient(Rgb.gray(0.05)).withFalloff(0.3)))),
    LIGHT_GROUP(scene -> scene.withRig(scene.rig().addLightGroup(new LightGroup("group of lights", new Rgb(1, 0.8, 0.6), 0.7, true, false))
            .withLights(scene.lights().stream().map(light -> light.name().equals("fill") ? light : light.withLightGroup("group of lights"))
                    .toList()))),
    /** All lights but the weakest, which is then dark. */
    SOLO(scene -> lights(withSoloEnvironments(scene), light -> light.withSolo(!light.name().equals("fill")))),
    ANTIALIASED_EDGES(scene -> picture(scene, picture -> picture.withSampling(new SamplingSettings(AntialiasMode.EDGES, 2)))),
    ANTIALIASED_PIXELS(scene -> picture(scene, picture -> picture.withSampling(new SamplingSettings(AntialiasMode.EVERY, 2)))),
    INDIRECT(scene -> picture(scene, picture -> picture.withIndirect(Optional.of(new IndirectSettings(2, 16, 8, true))))),
    LENS_SHIFT(scene -> scene.withCamera(Camera.SHIFT.with(scene.camera(), new LensShift(0.1, -0.15)))),
    /** A lens blurs only pictures with finer samples. */
    DEPTH_OF_FIELD(scene -> picture(scene.withCamera(scene.camera().withLens(new Lens(0.2, 4, 5, 10))),
            picture -> picture.sampling().isSupersampled()
                    ? picture : picture.withSampling(new SamplingSettings(AntialiasMode.EDGES, 2)))),
    VIEW(scene -> picture(scene, picture -> picture.withView(new ViewSettings(ViewCurve.AGX, 0.5))));

    private static Scene withSoloEnvironments(Scene scene) {
        Scene solo = scene;
        for (Contribution environment : Contribution.environments(scene)) {
            solo = environment.with(solo, v -> v.withSolo(true));
        }
        return solo;
    }

    private static final List<List<SceneFeature>> EXCLUSIVE =
            List.of(List.of(ENVIRONMENT, SKY), List.of(ANTIALIASED_EDGES, ANTIALIASED_PIXELS));

    private final UnaryOperator<Scene> change;

    SceneFeature(UnaryOperator<Scene> change) {
        this.change = change;
    }

    /** Returns whether a scene can have only one of two features. */
    boolean excludes(SceneFeature other) {
        return this != other && EXCLUSIVE.stream().anyMatch(pair -> pair.contains(this) && pair.contains(other));
    }

    /** Returns the base scene with some features, 12 × 9 pixels. */
    public static Scene scene(Iterable<SceneFeature> features) {
        List<SceneFeature> ordered = new ArrayList<>();
        features.forEach(ordered::add);
        Scene scene = base();
        for (SceneFeature feature : ordered.stream().sorted().toList()) {
            scene = feature.change.apply(scene);
        }
        return scene;
    }

    private static Scene base() {
        return new Scene(new PictureSettings(12, 9, 3).withReflectionRays(4), new Camera(new Vec3(0, 1.6, 6), Vec3.ZERO, Vec3.Y, 32),
                new World(0.3, new Rgb(0.1, 0.1, 0.2)), List.of(material("floor"), material("paint").withDiffuse(new Rgb(0.7, 0.4, 0.3))),
                List.of(new Shape(Solid.PLANE, "floor", "floor", placement(new Vec3(0, -1, 0), 6)),
                        new Shape(Solid.SPHERE, "ball", "paint", placement(Vec3.ZERO, 1))),
                List.of(light("key", LightType.POINT).withPosition(new Vec3(2, 4, 2)).withIntensity(0.8),
                        light("fill", LightType.DIRECTIONAL).withDirection(new Vec3(2, -1, -2)).withIntensity(0.2)));
    }

    private static Material material(String name) {
        return Material.of(name).withAmbient(Rgb.gray(0.2)).withDiffuse(Rgb.gray(0.6)).withSpecular(Rgb.gray(0.3)).withShininess(12)
                .withBase(new Rgb(0.7, 0.5, 0.4)).withRoughness(0.4);
    }

    private static Light light(String name, LightType type) {
        return Light.of(name, type).withIntensity(0.5).withColor(new Rgb(1, 0.9, 0.8)).withAttenuation(new Attenuation(0.5, 0.1, 0.01))
                .withArea(AreaShape.DEFAULT.withWidth(0).withHeight(0).withSamples(4));
    }

    private static Placement placement(Vec3 at, double scale) {
        return new Placement(at, new Vec3(0, 25, 0), new Vec3(scale, scale, scale));
    }

    private static Scene add(Scene scene, SceneNode node) {
        List<SceneNode> nodes = new ArrayList<>(scene.nodes());
        nodes.add(node);
        return scene.withNodes(nodes);
    }

    private static Scene add(Scene scene, Light light) {
        List<Light> lights = new ArrayList<>(scene.lights());
        lights.add(light);
        return scene.withLights(lights);
    }

    /** Adds a small ball with a material of its own. */
    private static Scene lens(Scene scene, String name, Vec3 at, UnaryOperator<Material> change) {
        List<Material> materials = new ArrayList<>(scene.materials());
        materials.add(change.apply(material(name)));
        return add(scene.withMaterials(materials), new Shape(Solid.SPHERE, name, name, placement(at, 0.5)));
    }

    private static Scene floor(Scene scene, UnaryOperator<Material> change) {
        return scene.withMaterial(change.apply(scene.material("floor").orElseThrow()));
    }

    private static Scene paint(Scene scene, UnaryOperator<Material> change) {
        return scene.withMaterial(change.apply(scene.material("paint").orElseThrow()));
    }

    private static Scene principled(Scene scene) {
        return paint(scene, paint -> paint.withModel(ShadingModel.PRINCIPLED));
    }

    private static Scene key(Scene scene, UnaryOperator<Light> change) {
        return scene.withLight(change.apply(scene.light("key").orElseThrow()));
    }

    /** Changes the spot, which it adds first if there is none. */
    private static Scene spot(Scene scene, UnaryOperator<Light> change) {
        Scene lit = scene.light("spot").isPresent() ? scene
                : add(scene, light("spot", LightType.SPOT).withPosition(new Vec3(-2, 3, 3)).withDirection(new Vec3(2, -3, -3)).withAngle(25)
                        .withDropoff(2).withIntensity(1));
        return lit.withLight(change.apply(lit.light("spot").orElseThrow()));
    }

    /** Changes the rectangle, which it adds first if there is none. */
    private static Scene panel(Scene scene, UnaryOperator<Light> change) {
        Scene lit = scene.light("panel").isPresent() ? scene
                : add(scene, light("panel", LightType.RECT).withPosition(new Vec3(1.5, 1.6, -1)).withDirection(new Vec3(-1, -1, 0.8))
                        .withArea(AreaShape.DEFAULT.withWidth(1.5).withHeight(1).withSamples(4)));
        return lit.withLight(change.apply(lit.light("panel").orElseThrow()));
    }

    private static Scene lights(Scene scene, UnaryOperator<Light> change) {
        return scene.withLights(scene.lights().stream().map(change).toList());
    }

    private static Scene world(Scene scene, UnaryOperator<World> change) {
        return scene.withWorld(change.apply(scene.world()));
    }

    private static Scene picture(Scene scene, UnaryOperator<PictureSettings> change) {
        return scene.withPicture(change.apply(scene.picture()));
    }

    private static Optional<TextureMap> map() {
        return Optional.of(new TextureMap("checker.png", 3, 2, checker(), TextureWrap.REPEAT, TexturePlacement.NONE));
    }

    /** Returns an image of three texels along each side: slopes of bumps are differences of every second texel. */
    private static Texture checker() {
        return new Texture(3, 3, new float[] {0.1f, 0.2f, 1, 0.9f, 0.7f, 0.6f, 0.8f, 1, 0.5f, 0.3f, 0, 0.9f, 0.2f, 0.9f, 0.4f, 1, 0.8f, 1,
            0.6f, 0.1f, 0.2f, 1, 1, 0.7f, 0.1f, 0.3f, 0.1f});
    }

    /** Returns an image with one bright pixel, which is a light with a shadow. */
    private static Environment sky(String file, float brightness) {
        float[] rgb = new float[3 * 16 * 8];
        for (int i = 0; i < rgb.length; i++) {
            rgb[i] = brightness * (1 - i / 3 / 16 / 8f) * (0.6f + 0.2f * (i % 3));
        }
        Arrays.fill(rgb, 3 * 37, 3 * 38, 60 * brightness);
        return new Environment(file, new EnvironmentMap(16, 8, rgb));
    }
}
