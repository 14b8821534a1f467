package lightning.format.jen;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.Set;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.scene.Camera;
import lightning.scene.Dome;
import lightning.scene.IndirectSettings;
import lightning.scene.NamedCamera;
import lightning.scene.PictureSettings;
import lightning.scene.Scene;
import lightning.scene.ViewCurve;
import lightning.scene.ViewSettings;
import lightning.scene.World;
import lightning.scene.asset.Texture;
import lightning.scene.asset.TextureMap;
import lightning.scene.asset.TexturePlacement;
import lightning.scene.asset.TextureWrap;
import lightning.scene.light.Light;
import lightning.scene.light.LightGroup;
import lightning.scene.light.LightRig;
import lightning.scene.light.LightType;
import lightning.scene.material.AlphaCutout;
import lightning.scene.material.Anisotropy;
import lightning.scene.material.BumpMapping;
import lightning.scene.material.Coat;
import lightning.scene.material.Material;
import lightning.scene.material.ShadingModel;
import lightning.scene.material.ShadowCasting;
import lightning.scene.material.Sheen;
import lightning.scene.material.Transmission;
import lightning.scene.node.NodeGroup;
import lightning.scene.node.SceneNode;
import lightning.scene.node.Shape;
import lightning.scene.node.Solid;
import lightning.scene.value.Attenuation;
import lightning.scene.value.DomeRotation;
import lightning.scene.value.Placement;
import lightning.scene.value.SceneLimits;

/** Random scenes and random edits, over the full range of every number. */
final class RandomScenes {
    /** Files that random scenes reference, with different images. */
    static final List<String> TEXTURES = List.of("a.png", "sub/b c.png", "ä.png");
    /** Intensity of a light. Colors and groups multiply it by up to a million, and the sharpest highlight by a few hundred. */
    private static final double MAX_INTENSITY = 1e24;

    private final Random random;
    private final List<Texture> images;
    private final List<Texture> numbers;
    private final List<Texture> opacities;
    private final Set<String> names = new HashSet<>();

    /**
     * Creates a generator.
     *
     * @param numbers images of the same files with numeric samples
     * @param opacities images of the same files as opacity maps
     */
    RandomScenes(Random random, List<Texture> images, List<Texture> numbers, List<Texture> opacities) {
        this.opacities = opacities;
        this.random = random;
        this.images = images;
        this.numbers = numbers;
    }

    Scene scene() {
        names.clear();
        List<Material> materials = materials();
        List<SceneNode> nodes = list(4, () -> node(materials, 0));
        List<Light> lights = list(5, this::light);
        Scene scene = new Scene(picture(), camera(), world(), materials, nodes, lights);
        return withLightGroups(scene.withRig(LightRig.of(lights, list(2, () -> lightGroup(name())))).withCameras(cameras()));
    }

    private List<NamedCamera> cameras() {
        return list(2, () -> new NamedCamera(name(), camera()));
    }

    /** Returns the scene after a few random edits: values, names, order, additions, deletions. */
    Scene edited(Scene scene) {
        names.clear();
        names(scene.nodes());
        scene.lights().forEach(l -> names.add(l.name()));
        scene.rig().lightGroups().forEach(b -> names.add(b.name()));
        scene.world().named().forEach(d -> names.add(d.name()));
        scene.cameras().forEach(c -> names.add(c.name()));
        Scene s = scene;
        for (int i = random.nextInt(4); i >= 0; i--) {
            s = switch (random.nextInt(9)) {
                case 0 -> s.withPicture(switch (random.nextInt(3)) {
                    case 0 -> picture();
                    case 1 -> s.picture().withIndirect(indirect()).withDepth(random.nextInt(11));
                    default -> s.picture().withDepth(random.nextInt(11));
                });
                case 1 -> s.withCamera(camera());
                case 2 -> s.withWorld(chance() ? world() : s.world().withAmbience(positive(1e6)));
                case 3 -> s.withNodes(nodes(s.nodes(), s.materials(), 0));
                case 4 -> s.withMaterials(editedMaterials(s));
                case 5 -> withLightGroups(s);
                case 6 -> s.withRig(withEditedGroup(s.rig()));
                case 7 -> s.withCameras(changed(s.cameras(), () -> new NamedCamera(name(), camera()),
                        c -> new NamedCamera(c.name(), camera())));
                default -> s.withLights(changed(s.lights(), this::light, this::light));
            };
        }
        return s;
    }

    /** Returns the scene with some lights moved into or out of banks. */
    private Scene withLightGroups(Scene scene) {
        List<LightGroup> groups = scene.rig().lightGroups();
        return scene.withLights(scene.lights().stream()
                .map(l -> chance() ? l
                        : l.withLightGroup(groups.isEmpty() || chance() ? "" : groups.get(random.nextInt(groups.size())).name()))
                .toList());
    }

    private LightRig withEditedGroup(LightRig rig) {
        String group = rig.lightGroups().isEmpty() ? "" : rig.lightGroups().get(random.nextInt(rig.lightGroups().size())).name();
        return group.isEmpty() || random.nextInt(4) == 0 ? rig.addLightGroup(lightGroup(name())) : switch (random.nextInt(3)) {
            case 0 -> rig.removeLightGroup(group);
            case 1 -> rig.renameLightGroup(group, name());
            default -> rig.with(lightGroup(group));
        };
    }

    private Dome dome(String name) {
        return Dome.of(name).withRotation(DomeRotation.of(positive(1e6), positive(90), -positive(90))).withIntensity(positive(1000))
                .withGain(positive(1000)).withLightCount(4 + random.nextInt(60)).withSoftness(positive(1)).withOn(chance())
                .withSolo(chance());
    }

    private LightGroup lightGroup(String name) {
        return new LightGroup(name, color(1), positive(1000), chance(), chance());
    }

    private void names(List<SceneNode> nodes) {
        for (SceneNode n : nodes) {
            names.add(n.name());
            if (n instanceof NodeGroup g) {
                names(g.children());
            }
        }
    }

    private <T> List<T> changed(List<T> items, java.util.function.Supplier<T> fresh, java.util.function.UnaryOperator<T> edit) {
        List<T> list = new ArrayList<>(items);
        int i = random.nextInt(list.size() + 1);
        switch (random.nextInt(4)) {
            case 0 -> list.add(i, fresh.get());
            case 1 -> {
                if (i < list.size()) {
                    list.remove(i);
                }
            }
            case 2 -> java.util.Collections.shuffle(list, random);
            default -> {
                if (i < list.size()) {
                    list.set(i, edit.apply(list.get(i)));
                }
            }
        }
        return list;
    }

    private List<SceneNode> nodes(List<SceneNode> nodes, List<Material> materials, int depth) {
        return changed(nodes, () -> node(materials, depth), n -> switch (n) {
            case NodeGroup g -> new NodeGroup(chance() ? g.name() : name(), chance() ? g.placement() : placement(),
                    nodes(g.children(), materials, depth + 1), g.visible() ^ chance());
            case Shape s -> switch (random.nextInt(4)) {
                case 0 -> s.withMaterial(material(materials));
                case 1 -> new Shape(solid(), s.name(), s.material(), s.placement());
                case 2 -> s.withVisible(!s.visible());
                default -> s.withPlacement(placement());
            };
        });
    }

    private List<Material> editedMaterials(Scene s) {
        List<Material> materials = new ArrayList<>(s.materials());
        java.util.Collections.shuffle(materials, random);
        materials.replaceAll(m -> switch (random.nextInt(3)) {
            case 0 -> m;
            case 1 -> Material.of(m.name()).withAmbient(m.ambient()).withGlow(chance() ? m.glow() : color(1e6)).withDiffuse(m.diffuse())
                    .withSpecular(m.specular())
                    .withShininess(m.shininess()).withReflective(m.reflective()).withTexture(texture())
                    .withBumpMapping(chance() ? m.bumpMapping() : relief()).withTransmission(chance() ? m.transmission() : clarity())
                    .withCutout(chance() ? m.cutout() : cutout());
            default -> Material.of(m.name()).withAmbient(color(1e6)).withDiffuse(m.diffuse()).withSpecular(m.specular())
                    .withShininess(m.shininess()).withReflective(color(1)).withTexture(m.texture());
        });
        Set<String> usedNames = new HashSet<>();
        materials.forEach(m -> usedNames.add(m.name()));
        if (chance() && usedNames.add("extra")) {
            materials.add(random.nextInt(materials.size() + 1), material("extra"));
        }
        return materials;
    }

    private Light light(Light l) {
        return switch (random.nextInt(12)) {
            case 0 -> l.withName(name());
            case 1 -> l.withType(LightType.values()[random.nextInt(3)]);
            case 2 -> l.withColor(color(1000));
            case 3 -> l.withIntensity(positive(MAX_INTENSITY));
            case 4 -> l.withPosition(vector(1e12));
            case 5 -> l.withDirection(direction());
            case 6 -> l.withAttenuation(attenuation());
            case 7 -> l.withAngle(positive(180));
            case 8 -> l.withDropoff(positive(1e6));
            case 9 -> l.withOn(chance());
            case 10 -> l.withSolo(chance());
            default -> l.withPosition(new Vec3(l.position().x(), number(1e12), l.position().z()));
        };
    }

    private Light light() {
        Light l = Light.of(name(), LightType.values()[random.nextInt(3)]);
        return chance() ? l
                : Light.of(l.name(), l.type()).withColor(color(1000)).withIntensity(positive(MAX_INTENSITY)).withPosition(vector(1e12))
                        .withDirection(direction()).withAttenuation(attenuation()).withAngle(positive(180)).withDropoff(positive(1e6))
                        .withOn(chance()).withSolo(chance());
    }

    private Attenuation attenuation() {
        return new Attenuation(positive(1e30), positive(1e30), positive(1e30));
    }

    private List<Material> materials() {
        Set<String> usedNames = new HashSet<>();
        return list(4, () -> {
            String name = List.of("wood", "default", "x", "scale", "old oak", "\"q\"", "b\\", "ß.9").get(random.nextInt(8));
            while (!usedNames.add(name)) {
                name += "_";
            }
            return material(name);
        });
    }

    private Material material(String name) {
        return random.nextInt(3) == 0 ? principled(name) : chance()
                ? Material.of(name).withAmbient(color(1e6)).withGlow(color(1e6)).withDiffuse(color(1)).withSpecular(color(1))
                        .withShininess(positive(1e6))
                        .withReflective(color(1)).withTexture(texture()).withBumpMapping(relief()).withTransmission(clarity())
                        .withCutout(cutout())
                : Material.of(name).withTexture(texture());
    }

    /** Returns a rough material: the lights are too bright for sharper highlights. */
    private Material principled(String name) {
        return Material.of(name).withModel(ShadingModel.PRINCIPLED).withGlow(color(1e6)).withBase(color(1))
                .withMetalness(random.nextDouble())
                .withRoughness(rough()).withF0(random.nextDouble()).withSpecularTint(chance() ? Rgb.WHITE : color(1))
                .withAnisotropy(chance() ? Anisotropy.NONE : new Anisotropy(random.nextDouble(), 360 * random.nextDouble() - 180))
                .withCoat(chance() ? Coat.NONE.withRoughness(rough()) : new Coat(random.nextDouble(), rough(), 1 + 3 * random.nextDouble()))
                .withSheen(chance() ? Sheen.NONE : new Sheen(color(1), random.nextDouble()))
                .withTexture(texture()).withTransmission(clarity());
    }

    private double rough() {
        return 1 - 0.2 * random.nextDouble();
    }

    private Transmission clarity() {
        return new Transmission(color(1), chance() ? 1.5 : 1 + 3 * random.nextDouble(), chance(), color(1),
                chance() ? 1 : Math.abs(scale(1e-9, 1e9)),
                ShadowCasting.values()[random.nextInt(4)]);
    }

    private AlphaCutout cutout() {
        return new AlphaCutout(map(opacities), chance() ? 0.5 : random.nextDouble());
    }

    private BumpMapping relief() {
        return new BumpMapping(map(numbers), chance() ? 0.05 : scale(1e-6, 1e9), map(numbers), chance() ? 1 : scale(1e-6, 1e6));
    }

    private Optional<TextureMap> texture() {
        return map(images);
    }

    private Optional<TextureMap> map(List<Texture> images) {
        int i = random.nextInt(TEXTURES.size());
        return random.nextInt(3) == 0 ? Optional.of(new TextureMap(TEXTURES.get(i), chance() ? 1 : scale(1e-6, 1e6),
                scale(1e-6, 1e6), images.get(i), TextureWrap.ALL.get(chance() ? 0 : random.nextInt(TextureWrap.ALL.size())),
                chance() ? TexturePlacement.NONE : new TexturePlacement(scale(1e-6, 1e6), scale(1e-6, 1e6), scale(1e-3, 360))))
                : Optional.empty();
    }

    private SceneNode node(List<Material> materials, int depth) {
        String name = name();
        return depth < 3 && random.nextInt(3) == 0 ? new NodeGroup(name, placement(), list(4, () -> node(materials, depth + 1)))
                : new Shape(solid(), name, material(materials), placement());
    }

    private Solid solid() {
        return switch (random.nextInt(5)) {
            case 0 -> Solid.SPHERE;
            case 1 -> new Solid.Cone(chance());
            case 2 -> new Solid.Cylinder(chance());
            case 3 -> new Solid.Frustum(positive(1e6), chance());
            default -> Solid.PLANE;
        };
    }

    private String material(List<Material> materials) {
        return materials.isEmpty() || chance() ? "default" : materials.get(random.nextInt(materials.size())).name();
    }

    private Placement placement() {
        return chance() ? Placement.IDENTITY : new Placement(vector(1e12), vector(1e6),
                new Vec3(scale(0.01, 100), scale(0.01, 100), chance() ? 1 : scale(0.01, 100)));
    }

    private PictureSettings picture() {
        return chance() ? PictureSettings.DEFAULT
                : new PictureSettings(1 + random.nextInt(16384), 1 + random.nextInt(16384), random.nextInt(11)).withIndirect(indirect())
                        .withView(view());
    }

    private ViewSettings view() {
        return chance() ? ViewSettings.DEFAULT
                : new ViewSettings(ViewCurve.values()[random.nextInt(ViewCurve.values().length)], 128 * random.nextDouble() - 64);
    }

    private Optional<IndirectSettings> indirect() {
        return chance() ? Optional.empty() : Optional.of(new IndirectSettings(1 + random.nextInt(IndirectSettings.MAX_BOUNCES),
                IndirectSettings.RAY_COUNTS.get(random.nextInt(IndirectSettings.RAY_COUNTS.size())),
                chance() ? IndirectSettings.DEFAULT.spacing() : 2 + random.nextInt(63), chance()));
    }

    private World world() {
        World world = chance() ? World.DEFAULT : new World(positive(1e6), color(1e6));
        return world.withNamed(list(2, () -> dome(name())));
    }

    private Camera camera() {
        try {
            return chance() ? Camera.DEFAULT
                    : new Camera(vector(1e12), vector(1e12), direction(), 0.01 + positive(169));
        } catch (IllegalArgumentException e) {
            return Camera.DEFAULT;
        }
    }

    private String name() {
        String[] words = {"key", "fill", "on", "light", "ä", "_", "A-1", "𝒜", "material", "jen", "key light", "1.5", "a=b", "\"", "\\",
            "old oak {", "#", "ä\u0308", "नाम", "\u3042 \u3044", "👩\u200D🎨", "don't", "picture", "none"};
        String name = words[random.nextInt(words.length)];
        while (!names.add(name)) {
            name += random.nextInt(10);
        }
        return name;
    }

    private <T> List<T> list(int max, java.util.function.Supplier<T> item) {
        List<T> list = new ArrayList<>();
        for (int i = random.nextInt(max + 1); i > 0; i--) {
            list.add(item.get());
        }
        return list;
    }

    private Vec3 vector(double max) {
        return new Vec3(number(max), number(max), number(max));
    }

    private Vec3 direction() {
        Vec3 v = vector(SceneLimits.MAX_COORDINATE);
        return v.maxAbs() >= 1e-12 ? v : new Vec3(0, -0.0, -1);
    }

    private Rgb color(double max) {
        return new Rgb(positive(max), positive(max), positive(max));
    }

    private double scale(double min, double max) {
        double v = Math.max(positive(max), min);
        return chance() ? v : -v;
    }

    private double number(double max) {
        double v = positive(max);
        return chance() ? v : -v;
    }

    /** Returns any double from 0 to {@code max}: zeros of both signs, the smallest, the largest, all exponents, round ones. */
    private double positive(double max) {
        return switch (random.nextInt(7)) {
            case 0 -> 0;
            case 1 -> -0.0;
            case 2 -> max;
            case 3 -> Double.MIN_VALUE;
            case 4 -> Math.min(max, random.nextInt(200) / 10.0);
            case 5 -> random.nextDouble() * max;
            default -> {
                double v = Math.abs(Double.longBitsToDouble(random.nextLong()));
                yield v <= max ? v : random.nextDouble();
            }
        };
    }

    private boolean chance() {
        return random.nextBoolean();
    }
}
